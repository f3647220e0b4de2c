// Bodies that fall, slide, roll, lie on each other and are grasped by robots, stepped through time.
//
// A step finds velocities at its end that obey momentum, Signorini's condition and Coulomb's law at
// all contacts, and the limits, clutches and drives of all joints, at once (contact_problem.h; time
// stepping after Stewart and Trinkle 1996 and Anitescu and Potra 1997), and moves everything with
// them. Contacts are those of the exact meshes. Robots move in the coordinates of their joints
// (Featherstone 2008), so that joints do not drift. Bodies that would pass through each other
// within a step make it shorter.
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/base/named_enum.h"
#include "sim/base/settings.h"
#include "sim/motion/contact_memory.h"
#include "sim/motion/contact_problem.h"
#include "sim/motion/rigid_motion.h"
#include "sim/motion/robot_model.h"
#include "sim/scene/material.h"

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
  visit("dof", dof, kAtLeast0, "", "Number of the degree of freedom.");
  visit("stiffness", stiffness, kAtLeast0, "N m/rad or N/m",
        "Effort for each unit of target - value.");
  visit("damping", damping, kAtLeast0, "N m s/rad or N s/m",
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
  // The last step's, of the base and of the impulses in joints: only steps use them.
  Vector3 last_base_angular = Vector3::Zero();
  Vector3 last_base_linear = Vector3::Zero();
  std::vector<double> joint_impulses = {};
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

struct StepOptions {
  double step = 2.5e-3;  // longest step, > 0 and at most 0.1 [s]
  ContactSearchOptions contacts = {};
  // What bodies at rest keep between them, of which steps may use up all [m].
  double rest_gap = 5e-5;
  // Surfaces may cross by this much where no contact was found that keeps them apart [m].
  double shallow = 1e-5;
  // A step is not made shorter than this part of `step`.
  double shortest = 1e-6;
  // Impacts slower than this do not bounce [m/s].
  double slowest_bounce = 0.01;
  // Contacts that slid faster than this in the last step have kinetic friction [m/s].
  double sliding = 1e-3;
  // Bodies slower than this at all their points for so long fall asleep [m/s, s].
  double still = 1e-5;
  double sleep_after = 0.5;
  ContactSolverOptions solver = {};
};

// How a step ended.
enum class StepOutcome {
  moved,
  not_converged,  // the law of contact was not met to its tolerance; the bodies moved all the same
  blocked,        // no step however short was free of penetration; the bodies are where they were
  not_finite,     // velocities beyond all numbers; the bodies are where they were
};

// The name in files: the same word as the enumerator.
constexpr auto enum_names(StepOutcome /*of*/) {
  return std::to_array<std::string_view>({"moved", "not_converged", "blocked", "not_finite"});
}

struct StepResult {
  StepOutcome outcome = StepOutcome::moved;
  double time = 0.0;       // that the step took [s]
  int newton_steps = 0;    // of the solver, of all islands, in the last try
  int shortened = 0;       // how often it was made shorter because bodies met too far from contacts
  int crossings = 0;       // pairs that began to cross, by no more than StepOptions::shallow
  double violation = 0.0;  // of the law of contact, relative (ContactSolution)
};

// The names of two solids that overlap where they are, if any do.
std::optional<std::pair<std::string, std::string>> overlap_in(const World& world,
                                                              const StepOptions& options = {});

// Throws InputError for a world that cannot be stepped: a body that moves without a positive mass
// or with an inertia that no body has, a drive with negative gains or effort, numbers that are not
// finite, options out of range.
void require_quantities(const World& world, const StepOptions& options = {});

// The same, and for solids that overlap.
void require_world(const World& world, const StepOptions& options = {});

// Moves the world on by at most options.step. The same world gives the same bytes.
StepResult step_world(World& world, const StepOptions& options = {});

// Kinetic and potential energy of all bodies and robots that move, gravity's from the world's
// origin, and that of springs in joints; bases of robots count as at rest [J].
double energy_of(const World& world);

}  // namespace prehend
