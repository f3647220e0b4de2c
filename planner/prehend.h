// Planning: from a mesh and a hand to ranked grasps, and each step of that by itself. Two other
// pages list the rest: planner/simulation.h what moves in time, planner/contacts.h what judges
// contacts. docs/how-to/cpp.md has an example and the conventions.
//
// The question
//   scene.h               an object, a hand, what is around them, friction: a plain value
//   surface_region.h      parts of the object that hands must not touch, or had better touch
//   scene_file.h          a scene from a scene file or a mesh file
//   scene_library.h       the scenes that come with prehend, by name
//   make_scene.h          a scene made by a program: object and hand, obstacles, an arm
//   scene_text.h          a scene as the text of a scene file
//   compiled_scene.h      compile: a scene made ready for trials, shared by threads
// What it is made of
//   pose.h                vectors, rotations, poses
//   triangle_mesh.h       a mesh as a value
//   make_mesh.h           a mesh from arrays, made sound
//   mesh_file.h           a mesh from a file
//   basic_shapes.h        boxes, cylinders, spheres, prisms as meshes
//   object_generator.h    household objects as meshes
//   mesh_checks.h         whether a mesh is closed, and which way it faces
//   mesh_repair.h         closing small holes and cracks, turning triangles, dropping dust
//   mass_properties.h     volume, centre of mass and inertia of what a mesh bounds
//   mass_parts.h          the same of an object whose parts have densities of their own
//   object_mass.h         where the mass of an object to grasp is, and who says so
//   friction_table.h      materials and the friction between them
//   robot.h               a robot, and of a hand what makes it one; where its links are
//   robot_file.h          a hand or robot by name or file
//   derive_hand.h         what makes a robot a hand, from its joints and shape
//   posture_survey.h      where the tips of a robot get, and which of its links collide
//   platform.h            robots on robots: a hand on an arm on a base
//   platform_file.h       a platform by name or file
// The answer
//   accuracy.h            options that belong together: draft, standard, fine
//   tree_model_file.h     a model that orders the candidates, learnt from earlier trials
//   plan.h                plan: grasps, ranked; evaluate: given grasps, tried and scored
//   plan_any.h            the same of several objects, and which of them must go first
//   approach_limit.h      the directions from which hands may come
//   advice.h              what may help where a plan has no grasp
//   grasp_text.h          where a grasp came from, in words
//   run_context.h         threads, progress and cancellation of all that takes long
// One step alone
//   decompose.h           an object into boxes, spheres, cylinders and cones
//   thin_parts.h          its rims and bars
//   candidates.h          where a hand may come from
//   trial.h               what a trial found
//   approach_line.h       the straight motion of its hand
//   run_trial.h           one candidate, from pre-grasp to quality
//   grasp_contacts.h      where a closed hand touches the object
//   refine_grasps.h       the best grasps improved by trials of grasps near them
//   sensitivity.h         how much that quality changes with the hand moved by next to nothing
//   inverse_kinematics.h  the degrees of freedom that bring a robot to a pose
//   move_robot.h          the same for a robot that others carry
//   reach.h               whether an arm follows the hand's approach
//   arm_path.h            the motion of an arm to a posture, without a grasp
//   grasp_path.h          the arm's whole motion to a grasp
//   lift_object.h         what comes after it: the object lifted and taken along
//   cartesian_line.h      the arm's postures with its hand on a straight line
//   plan_transfer.h       its way from one posture to another, around everything
//   trajectory.h          a motion of joints in time
//   time_path.h           the fastest motion along a path
//   check_path.h          a second look at a finished motion
//   grasp_motion.h        how a hand comes and closes, posture by posture
// What is written
//   converted.h           a robot or a mesh in another format
//   grasps_file.h         grasps.json
//   export_files.h        files for other programs
//   plan_report.h         what a report says of a plan
//   grasp_set.h           all grasps that were tried of an object, as data sets hold them
//   acronym_file.h        such a set as a file of ACRONYM, HDF5, written and read
//   graspgen_file.h       such a set as a file of GraspGen, JSON, written and read
//   grasp_table.h         such sets as one table
//   set_candidates.h      the grasps of such a set, to be tried again
//   report_html.h         a report as one file for a browser
//   posed_grasp.h         a grasp as something to look at
//   best_viewpoint.h      the viewing direction that shows most of a grasp
//   grasp_picture.h       its picture
//   contact_sheet.h       pictures of many grasps in one
//   image.h               a picture as PNG
//   output_file.h         files that are written whole or not at all
//   data_folder.h         where the robots and scenes that come with prehend are
//   input_error.h         what is thrown for a caller's mistake
#pragma once

#include "planner/plan/accuracy.h"
#include "planner/plan/advice.h"
#include "planner/plan/grasp_text.h"
#include "planner/plan/learn/tree_model_file.h"
#include "planner/plan/path/arm_path.h"
#include "planner/plan/path/check_path.h"
#include "planner/plan/path/grasp_motion.h"
#include "planner/plan/path/grasp_path.h"
#include "planner/plan/path/lift_object.h"
#include "planner/plan/path/plan_transfer.h"
#include "planner/plan/plan.h"
#include "planner/plan/plan_any.h"
#include "planner/plan/propose/approach_limit.h"
#include "planner/plan/propose/candidates.h"
#include "planner/plan/refine_grasps.h"
#include "planner/results/datasets/acronym_file.h"
#include "planner/results/datasets/grasp_set.h"
#include "planner/results/datasets/grasp_table.h"
#include "planner/results/datasets/graspgen_file.h"
#include "planner/results/datasets/set_candidates.h"
#include "planner/results/grasps_file.h"
#include "planner/show/best_viewpoint.h"
#include "planner/show/contact_sheet.h"
#include "planner/show/exports/export_files.h"
#include "planner/show/grasp_picture.h"
#include "planner/show/picture/image.h"
#include "planner/show/posed_grasp.h"
#include "planner/show/report/plan_report.h"
#include "planner/show/report/report_html.h"
#include "primitives/decompose.h"
#include "primitives/thin_parts.h"
#include "sim/base/data_folder.h"
#include "sim/base/input_error.h"
#include "sim/base/output_file.h"
#include "sim/base/pose.h"
#include "sim/base/run_context.h"
#include "sim/motion/control/time_path.h"
#include "sim/motion/control/trajectory.h"
#include "sim/robot/files/converted.h"
#include "sim/robot/files/platform_file.h"
#include "sim/robot/files/robot_file.h"
#include "sim/robot/hand/derive_hand.h"
#include "sim/robot/hand/posture_survey.h"
#include "sim/robot/inverse_kinematics.h"
#include "sim/robot/move_robot.h"
#include "sim/robot/platform.h"
#include "sim/robot/robot.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/friction_table.h"
#include "sim/scene/make_scene.h"
#include "sim/scene/object_mass.h"
#include "sim/scene/reach/cartesian_line.h"
#include "sim/scene/reach/reach.h"
#include "sim/scene/scene.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_library.h"
#include "sim/scene/scene_text.h"
#include "sim/scene/surface_region.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/shape/make_mesh.h"
#include "sim/shape/mass_parts.h"
#include "sim/shape/mass_properties.h"
#include "sim/shape/mesh_checks.h"
#include "sim/shape/mesh_repair.h"
#include "sim/shape/object_generator.h"
#include "sim/shape/triangle_mesh.h"
#include "sim/trial/approach_line.h"
#include "sim/trial/grasp_contacts.h"
#include "sim/trial/run_trial.h"
#include "sim/trial/sensitivity.h"
#include "sim/trial/trial.h"

namespace prehend {

// "MAJOR.MINOR.PATCH" of the library that the program runs with.
const char* version();

}  // namespace prehend
