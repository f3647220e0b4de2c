// Things that move: bodies, robots and their controllers in time, and what becomes of a grasp
// there. Scenes, robots and plans come from planner/prehend.h.
//
// A grasp or a scene
//   shake_grasps.h        the grasps of a plan are closed, lifted and shaken
//   form_dynamic_grasp.h  a hand that closes in time, on an object that gives way
//   object_watch.h        what becomes of the object
//   simulate.h            a scene simulated and recorded
//   simulation_file.h     its states as files
//   simulation_report.h   its report
//   shake.h               one grasp under a test procedure, and what became of it
//   test_procedure_file.h test procedures from files and from the library
// Bodies and robots
//   world.h               bodies and robots that move
//   step_world.h          moves them on, step by step
//   robot_dynamics.h      the equation of motion of a robot: mass matrix, efforts, accelerations
//   require_world.h       whether that can be done
//   energy.h              their energy
//   scene_bodies.h        a scene's bodies in a world, and how they touch
//   controller.h          what drives a robot: a function from its state to efforts
//   joint_controllers.h   PD, gravity compensation and computed torque
//   stated_gains.h        gains, efforts and set points as a robot's file states them
//   wrist_impedance.h     an arm whose wrist gives way like a spring
//   joint_motion.h        what a controller follows: a trajectory, or one posture
//   run_controlled.h      a world run with controllers, and how that ended
#pragma once

#include "planner/plan/shake_grasps.h"
#include "planner/results/simulation_file.h"
#include "planner/show/report/simulation_report.h"
#include "sim/manipulation/shake.h"
#include "sim/manipulation/simulate.h"
#include "sim/manipulation/test_procedure_file.h"
#include "sim/motion/control/controller.h"
#include "sim/motion/control/joint_controllers.h"
#include "sim/motion/control/joint_motion.h"
#include "sim/motion/control/run_controlled.h"
#include "sim/motion/control/stated_gains.h"
#include "sim/motion/control/wrist_impedance.h"
#include "sim/motion/dynamic_grasp/form_dynamic_grasp.h"
#include "sim/motion/dynamic_grasp/object_watch.h"
#include "sim/motion/energy.h"
#include "sim/motion/require_world.h"
#include "sim/motion/robot_dynamics.h"
#include "sim/motion/scene_bodies.h"
#include "sim/motion/step_world.h"
#include "sim/motion/world.h"
