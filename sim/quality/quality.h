// All of sim/quality: grasp quality from contacts alone, without a scene, a hand or a file.
//
// Contacts
//   contact.h         a contact: position, normal, friction, model
//   contact_map.h     the frame of wrenches; the map from a contact's forces to a wrench
//   friction_cone.h   the forces that friction allows, exact or as a pyramid
//   wrench.h          wrenches of contacts, as the corners of pyramids
//   suction_cup.h     what a sealed suction cup can exert
//   grasp_matrix.h    the map of all contacts, its singular values; manipulability of a hand
// The set of wrenches that contacts can exert
//   wrench_space.h    the set, for either norm of the forces; grasp_epsilon, the quality of a grasp
//   support.h         any convex set, by its support function
//   epsilon.h         the largest ball inside a set: the smallest disturbance that breaks the grasp
//   wrench_hull.h     the hull of wrenches, with its volume
//   set_hull.h        the hull of a set that is smooth, with bounds of its volume
//   point_hull.h      the hull of points in any dimension
//   wrench_slice.h    three-dimensional sections of a hull, to be looked at
// What the set is good for
//   forces.h          the contact forces that balance a wrench, and the largest such wrench
//   cup_balance.h     the same of grasps with suction cups
//   task.h            resistance to the disturbances of a task
//   robust_epsilon.h  epsilon under noise in pose, contacts and friction
//   measures.h        all measures by name
//   interval.h        lower and upper bound, the result of many of these
#pragma once

#include "sim/base/eigen_alignment.h"
#include "sim/quality/contact.h"
#include "sim/quality/contact_map.h"
#include "sim/quality/cup_balance.h"
#include "sim/quality/epsilon.h"
#include "sim/quality/forces.h"
#include "sim/quality/friction_cone.h"
#include "sim/quality/grasp_matrix.h"
#include "sim/quality/interval.h"
#include "sim/quality/measures.h"
#include "sim/quality/point_hull.h"
#include "sim/quality/robust_epsilon.h"
#include "sim/quality/set_hull.h"
#include "sim/quality/suction_cup.h"
#include "sim/quality/support.h"
#include "sim/quality/task.h"
#include "sim/quality/wrench.h"
#include "sim/quality/wrench_hull.h"
#include "sim/quality/wrench_slice.h"
#include "sim/quality/wrench_space.h"
