// Bodies and robots that move, as a value; step_world.h moves it on.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/named_enum.h"
#include "sim/base/range.h"
#include "sim/base/settings.h"
#include "sim/motion/contact_memory.h"
#include "sim/motion/rigid_motion.h"
#include "sim/motion/robot_model.h"
#include "sim/scene/friction_table.h"
#include "sim/scene/surface_material.h"

namespace prehend {

// A body of the world. One that is fixed keeps its pose, with or without a mass.
struct WorldBody {
  std::string name;
  CollisionBody shape;  // body frame
  Material material = Material::plastic;
  bool is_fixed = false;
  Inertial inertial = {};  // body frame; of bodies that move
  RigidMotion motion = {};
  double restitution = 0.0;  // 0 to 1: of the normal velocity of an impact; of a pair, the larger
  Vector3 force_W = Vector3::Zero();   // at the centre of mass, besides gravity [N]
  Vector3 torque_W = Vector3::Zero();  // about the centre of mass [N m]
  double rest_time = 0.0;              // for how long it has not moved noticeably [s]
  bool asleep = false;                 // it rests, and is not moved until something touches it
  SurfaceMaterials surface = {};       // where it is not of the material all over
};

struct Drive {
  static constexpr AboutSettings kAbout{
      "Drive", "What moves a degree of freedom of a robot; several may act on one."};
  int dof = 0;
  // Both act as they are at the end of the step, so that stiff drives stay stable.
  double stiffness = 0.0;
  double damping = 0.0;
  double target = 0.0;
  double target_rate = 0.0;
  bool holds_rate = false;
  double max_effort = std::numeric_limits<double>::infinity();
};

template <SettingsOf<Drive> Options, typename Visit>
void for_each_setting(Options& drive, const Visit& visit) {
  auto& [dof, stiffness, damping, target, target_rate, holds_rate, max_effort] = drive;
  visit("dof", dof, kIndex, "", "Number of the degree of freedom.");
  visit("stiffness", stiffness, kGain, "N m/rad or N/m", "Effort for each unit of target - value.");
  visit("damping", damping, kGain, "N m s/rad or N s/m",
        "Effort for each unit of target_rate - rate.");
  visit("target", target, kAnyNumber, "rad or m", "Value that the stiffness pulls to.");
  visit("target_rate", target_rate, kAnyNumber, "rad/s or m/s", "Rate that the damping pulls to.");
  visit("holds_rate", holds_rate,
        "Keeps the rate at target_rate with whatever effort that takes; stiffness, damping and "
        "target are not used.");
  visit("max_effort", max_effort, Range{.with_infinity = true}, "N m or N",
        "The largest; infinite without a limit.");
}

// A robot of the world. Its base is not free: it stands, or is moved at a velocity that is given.
struct WorldRobot {
  std::string name;
  std::shared_ptr<const RobotModel> model;
  Pose X_WB = Pose::Identity();
  Vector3 base_angular = Vector3::Zero();  // of the base, world axes [rad/s]
  Vector3 base_linear = Vector3::Zero();   // of the origin of B [m/s]
  Eigen::VectorXd x = {};                  // coordinates (RobotModel)
  Eigen::VectorXd rate = {};               // of the coordinates
  Eigen::VectorXd effort =
      {};  // on each degree of freedom besides the drives, empty: none [N m or N]
  std::vector<Drive> drives = {};
  // Efforts that hold the robot against gravity, the springs of its joints and the motion of its
  // own links act on it, as a good controller's feed-forward would.
  bool is_balanced = false;
  // The last step's, of the base, of the impulses in joints and of gears: only steps use them.
  Vector3 last_base_angular = Vector3::Zero();
  Vector3 last_base_linear = Vector3::Zero();
  std::vector<double> joint_impulses = {};
  std::vector<double> gear_stops = {};  // of each clutch (joint_conditions.h); empty: at the joints
};

// A robot at the values of its degrees of freedom (and joints, see coordinates_at), at rest.
WorldRobot make_world_robot(std::string name, std::shared_ptr<const RobotModel> model,
                            const Pose& X_WB, const std::vector<double>& dofs,
                            const std::vector<double>& joints = {});

// The values of a robot's joints [rad or m].
Eigen::VectorXd joints_of(const WorldRobot& robot);

// A contact of a step, with the impulse on the first of its two solids.
struct WorldContact {
  SolidId a = {};
  SolidId b = {};
  Vector3 position_W = Vector3::Zero();  // between the surfaces
  Vector3 normal_W = Vector3::UnitZ();   // unit, from b into a
  Vector3 impulse_W = Vector3::Zero();   // [N s]
  double spin_impulse = 0.0;             // about the normal [N m s]
  double gap = 0.0;                      // at the beginning of the step [m]
  // Tangential speed at the end of the step, of one that sticks besides its way back to where it
  // stuck [m/s].
  double slip = 0.0;
};

// How contacts of the world behave.
struct ContactLaws {
  FrictionTable friction = {};                // static
  std::optional<FrictionTable> kinetic = {};  // of contacts that slide; none: as static
  CompliantDepths compliant_depths = {};      // of soft materials, which resist spin
  // Torque about the normal over the normal force that contacts of robots bear [m]; none: as soft
  // materials do.
  std::optional<double> torsion = {};
};

struct World {
  std::vector<WorldBody> bodies;
  std::vector<WorldRobot> robots;
  Vector3 gravity = Vector3(0.0, 0.0, -9.81);  // [m/s^2]
  ContactLaws laws;
  // Of the last step: its contacts, how long it was, and what the next one need not search again.
  std::vector<WorldContact> contacts;
  double last_step = 0.0;  // [s]
  ContactMemory memory;
};

}  // namespace prehend
