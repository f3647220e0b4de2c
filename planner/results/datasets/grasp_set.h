// A set of grasps as data sets hold it: one object, one hand, and all grasps that were tried, those
// that do not hold among them. Files of data sets are made from it and read into it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/base/pose.h"
#include "sim/quality/interval.h"
#include "sim/trial/outcome.h"

namespace prehend {

// A contact of a grasp: where it is, and the normal into the object (unit).
struct GraspSetContact {
  Vector3 p_O = Vector3::Zero();  // m
  Vector3 n_O = Vector3::UnitZ();
  int link = 0;  // index into GraspSet::links
};

// By how much something moved the object in the hand.
struct ObjectShift {
  double linear = 0.0;   // m
  double angular = 0.0;  // rad
};

// A grasp that was tried.
struct GraspSetEntry {
  Pose X_OH = Pose::Identity();          // hand where the trial ended, O as the object stood before
  Pose X_OH_aim = Pose::Identity();      // where its approach was to end
  Vector3 approach_O = Vector3::Zero();  // unit; zero: not known
  // How the trial ended. Files without our names for outcomes tell held (stable) from not held
  // (not_force_closure) only.
  Outcome outcome = Outcome::no_contact;
  Interval epsilon;                       // [0, 0] without force closure
  std::vector<double> dofs;               // of the hand, closed; empty: not known [rad or m]
  std::vector<double> joints;             // the same of all its joints [rad or m]
  std::vector<GraspSetContact> contacts;  // empty where the trial ended without
  std::optional<ObjectShift> closing;     // of the object while the hand closed
  std::optional<ObjectShift> shaking;     // of the object while the hand was shaken
  std::vector<float> features;            // as many as GraspSet::feature_names, or none
};

// The object as it was grasped. Mass, centre of mass and inertia are those of the scaled mesh.
struct GraspSetObject {
  std::string file;  // its mesh, as a path that users can find again
  double scale = 1.0;
  double density = 0.0;  // kg/m^3
  double friction = 0.0;
  double mass = 0.0;                  // kg
  double volume = 0.0;                // m^3
  Vector3 com_O = Vector3::Zero();    // m
  Matrix3 inertia = Matrix3::Zero();  // about the centre of mass, axes of O [kg m^2]
};

// A set of grasps with what they have in common.
struct GraspSet {
  GraspSetObject object;
  std::string hand;                        // its name, e.g. "panda"
  std::optional<double> configuration;     // opening at which the grasps begin [m]; none: varies
  std::vector<std::string> dofs;           // names of the hand's degrees of freedom
  std::vector<std::string> joints;         // names of its joints
  std::vector<std::string> links;          // names of its links
  std::vector<std::string> feature_names;  // of GraspSetEntry::features
  std::string version;                     // of prehend, or what made the set
  std::string settings;                    // of the run, as JSON text; empty: not known
  std::vector<GraspSetEntry> grasps;       // in the order of the trials
};

}  // namespace prehend
