// An exported grasp in MuJoCo.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/base/pose.h"

namespace prehend::bench {

struct StartOptions {
  // The hand is opened until pieces overlap by no more than this [m], or where they overlap least,
  // at most by this part of the way to its preshape.
  double overlap = 2e-5;
  double most_opened = 0.25;
  bool open = false;  // at its preshape instead
};

// A joint that a gear keeps from being pushed back while its drive closes it.
struct JointLock {
  std::string joint;
  double closing = 1.0;  // the sign of its velocity when it closes
};

// A model of `--export mjcf` that is stepped. The base of the hand goes where it is told, as if
// nothing could hold it back, and contacts see its velocity.
class MujocoWorld {
 public:
  // Throws InputError with MuJoCo's message for a model that it refuses.
  explicit MujocoWorld(const std::string& mjcf);
  ~MujocoWorld();
  MujocoWorld(const MujocoWorld&) = delete;
  MujocoWorld& operator=(const MujocoWorld&) = delete;

  // What a protocol says of the object and the hand, to be set before start().
  void set_object_mass(double mass);   // kg; the inertia changes with it
  void set_friction(double friction);  // between hand and object
  void set_torsion(double torsion);    // of the hand's contacts [m]
  // Joints that only go on in the direction in which they close, from close() until open(): MuJoCo
  // has no such gear, but a limit that follows the joint is one.
  void set_locks(const std::vector<JointLock>& locks);
  double object_mass() const;

  // The grasp. Where pieces of hand and object overlap, because they reach a little out of the real
  // ones, the hand is opened until they hardly do. The joints keep their values until close().
  void start(const StartOptions& options = {});
  // Every drive works with all its effort to close the hand, or to hold its value.
  void close();
  // From then on a joint's drive works with this part of its effort; 0: the joint stays.
  void set_effort(const std::string& joint, double part);
  // The drives open the hand to its preshape.
  void open();
  void set_gravity(const Vector3& gravity_W);  // m/s^2
  void set_pull(const Vector3& force_W);       // on the object's centre of mass [N]

  double time_step() const;  // s
  // One step, at the end of which the base is at X_WH.
  void step_to(const Pose& X_WH);

  Pose base() const;                            // of the hand, in the world
  Pose object() const;                          // in the world
  Vector3 center_of_mass() const;               // of the object, in the world
  double object_speed() const;                  // of its centre of mass [m/s]
  bool in_contact() const;                      // a link pressed on the object in the last step
  bool presses(const std::string& link) const;  // this one did
  double joint_rate(const std::string& joint) const;  // rad/s or m/s
  double overlap() const;    // the deepest of hand and object in the last step [m]
  double opened() const;     // part of the way to the preshape by which start() opened the hand
  bool is_unstable() const;  // since start()
  Pose body(const std::string& name) const;  // in the world, after start() and before steps

  // Keeps the state, and goes back to it as often as wanted.
  void keep();
  void go_back();

  // Internal.
  struct Data;

 private:
  std::unique_ptr<Data> data_;
};

// How far the object moves when the model is loaded and stepped for so long as it is, the base of
// the hand held by its weld [m]. Throws InputError for a model that MuJoCo refuses.
double drift_as_loaded(const std::string& mjcf, double seconds);

// How far a joint of the hand moves at most when the model is stepped for so long from a keyframe
// with its controls [rad or m]. Throws as drift_as_loaded.
double joint_drift(const std::string& mjcf, const std::string& keyframe, double seconds);

}  // namespace prehend::bench
