// What a world was like over time, and its quantities by name.
#pragma once

#include <string>
#include <vector>

#include "sim/motion/dynamic_grasp/scene_world.h"

namespace prehend {

// A world at one moment; forces are those of the step that led there.
struct WorldFrame {
  struct OfRobot {
    Pose X_WB = Pose::Identity();
    Eigen::VectorXd x;        // coordinates (RobotModel)
    Eigen::VectorXd rate;     // of the coordinates
    Eigen::VectorXd efforts;  // of the drives of each degree of freedom [N m or N]
  };
  // A contact with the force on the first of its two solids.
  struct Force {
    SolidId a = {};
    SolidId b = {};
    Vector3 p_W = Vector3::Zero();
    Vector3 normal_W = Vector3::UnitZ();  // unit, from b into a
    Vector3 force_W = Vector3::Zero();    // [N]
    double gap = 0.0;                     // [m]
    double slip = 0.0;                    // [m/s]
  };
  double time = 0.0;  // [s]
  std::vector<RigidMotion> bodies;
  std::vector<OfRobot> robots;
  std::vector<Force> forces;  // contacts that bear nothing are left out
};

// `time`: since the beginning [s].
WorldFrame frame_of(const World& world, double time);

// Keeps frames that are at least `every` seconds apart, the first one included.
class Recorder {
 public:
  explicit Recorder(double every) : every_(every) {}

  void look(const World& world, double time);
  // Keeps this moment in any case.
  void keep(const World& world, double time);

  const std::vector<WorldFrame>& frames() const { return frames_; }

 private:
  double every_;
  std::vector<WorldFrame> frames_;
};

// The names of all quantities of a world, in the order of quantities(): "time"; of each body that
// moves NAME.x, .y, .z (of its centre of mass [m]), .qw, .qx, .qy, .qz (rotation), .vx, .vy, .vz
// [m/s], .wx, .wy, .wz [rad/s]; of each degree of freedom ROBOT/DOF [rad or m], ROBOT/DOF.rate and
// ROBOT/DOF.effort [N m or N]; of each solid that may touch the object SOLID.force, with which it
// presses on it [N]; and "contacts", how many bear something.
std::vector<std::string> quantity_names(const World& world);
std::vector<double> quantities(const World& world, const WorldFrame& frame);

// The name of a body, or ROBOT/LINK of a link.
std::string solid_name(const World& world, const SolidId& solid);

}  // namespace prehend
