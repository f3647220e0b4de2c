#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/base/json/json_field.h"
#include "sim/robot/files/graspit_robot.h"
#include "sim/robot/files/hand_split.h"
#include "sim/robot/files/mjcf_file.h"
#include "sim/robot/files/openrave_file.h"
#include "sim/robot/files/platform_file.h"
#include "sim/robot/files/robot_file.h"
#include "sim/robot/files/sdf_file.h"
#include "sim/robot/files/urdf_file.h"
#include "sim/robot/files/xacro_file.h"
#include "sim/robot/sound_robot.h"
#include "sim/shape/proximity.h"
#include "tests/fuzz/mesh_promises.h"
#include "tests/fuzz/untrusted_files.h"

namespace prehend::fuzz {
namespace {

void check_joint(const Joint& joint, const Robot& robot) {
  promised(finite(joint.X_PJ) && finite(joint.X_JA), "the frames of a joint are finite");
  promised(std::abs(joint.axis.norm() - 1.0) < 1e-9, "the axis of a joint is unit");
  promised(joint.lower <= joint.upper, "the limits of a joint are in order");
  promised(std::isfinite(joint.zero) && std::isfinite(joint.offset) && std::isfinite(joint.ratio),
           "the numbers of a joint are finite");
  promised(joint.dof >= 0 && joint.dof < static_cast<int>(robot.dofs.size()),
           "a degree of freedom drives every joint");
}

void check_dof(const DegreeOfFreedom& dof) {
  promised(std::isfinite(dof.lower) && std::isfinite(dof.upper), "limits are finite");
  promised(dof.lower <= dof.initial && dof.initial <= dof.upper, "it starts inside its limits");
  promised(std::isfinite(dof.closing_velocity) && std::isfinite(dof.max_velocity) &&
               std::isfinite(dof.max_acceleration),
           "velocities and accelerations are finite");
}

void check_hand(const Hand& hand, const Robot& robot) {
  promised(std::abs(hand.approach.norm() - 1.0) < 1e-9, "the approach axis is unit");
  promised(hand.origin.allFinite(), "the origin is finite");
  // What a file may leave out together is derived later.
  const bool derived_later = hand.preshapes.empty() && hand.closing.isZero();
  promised(derived_later || std::abs(hand.closing.norm() - 1.0) < 1e-9, "the closing axis is unit");
  for (const Preshape& preshape : hand.preshapes) {
    promised(preshape.dofs.size() == robot.dofs.size(), "a preshape has a value for each");
    promised(0.0 <= preshape.min_width && preshape.min_width <= preshape.max_width &&
                 std::isfinite(preshape.max_width) && std::isfinite(preshape.depth),
             "widths and depth are finite and in order");
  }
}

void check_links(const Robot& robot) {
  promised(!robot.links.empty(), "a robot has a base link");
  for (const Link& link : robot.links) {
    check_usable(link.mesh);
    promised(link.joint >= -1 && link.joint < static_cast<int>(robot.joints.size()),
             "every link follows a joint");
    promised(std::isfinite(link.inertial.mass) && link.inertial.mass >= 0.0,
             "the mass of a link is a finite number");
    promised(link.inertial.center_of_mass.allFinite() && link.inertial.inertia.allFinite(),
             "the inertia of a link is finite");
  }
}

// Distances between the first and the last link at both ends of all motions, as every search asks
// for such. Links of many triangles would take the fuzzer most of its time.
void check_moves(const Robot& robot) {
  constexpr std::size_t kMostTriangles = 200;
  const auto last = robot.links.size() - 1;
  const TriangleMesh& a = robot.links.front().mesh;
  const TriangleMesh& b = robot.links.back().mesh;
  if (last == 0 || a.triangles.size() + b.triangles.size() > kMostTriangles) return;
  const ProximityMesh near_a(a);
  const ProximityMesh near_b(b);
  std::vector<double> lower;
  std::vector<double> upper;
  for (const DegreeOfFreedom& dof : robot.dofs) {
    lower.push_back(dof.lower);
    upper.push_back(dof.upper);
  }
  std::vector<Pose> X_BL;
  for (const std::vector<double>& dofs : {initial_dofs(robot), lower, upper}) {
    link_poses(robot, joint_values(robot, dofs), X_BL);
    const double distance = find_gap(near_a, near_b, X_BL.front().inverse() * X_BL.back()).upper;
    promised(std::isfinite(distance) && distance >= 0.0, "links are at finite distances");
  }
}

void check_robot(const Robot& robot) {
  require_sound(robot);
  for (const Joint& joint : robot.joints) check_joint(joint, robot);
  for (const DegreeOfFreedom& dof : robot.dofs) check_dof(dof);
  check_links(robot);
  if (robot.hand) check_hand(*robot.hand, robot);
  std::vector<Pose> X_BL;
  link_poses(robot, joint_values(robot, initial_dofs(robot)), X_BL);
  promised(std::all_of(X_BL.begin(), X_BL.end(), finite), "links are at finite places");
  check_moves(robot);
}

// As the robot of a file in another format: whole, and parted where there is a hand on an arm.
void check_tree(const JointTree& tree) {
  (void)root_of(tree);
  check_robot(to_robot(tree));
  const std::optional<int> hand = inferred_hand(tree);
  if (!hand) return;
  const Platform platform = parted(tree, *hand);
  promised(platform.robots.size() == 2, "an arm and a hand are two robots");
  for (const MountedRobot& mounted : platform.robots) check_robot(mounted.robot);
}

}  // namespace

void read_robot_file(std::string_view name, const std::string& bytes) {
  check_robot(read_robot(JsonFile(pretended_path(name, "json"), bytes)));
}

void read_platform_file(std::string_view name, const std::string& bytes) {
  const Platform platform = read_platform(JsonFile(pretended_path(name, "json"), bytes));
  promised(!platform.robots.empty(), "a platform has robots");
  for (const MountedRobot& mounted : platform.robots) check_robot(mounted.robot);
  check_robot(assemble(platform).robot);
}

// Its hand has no preshapes, which these files do not know.
void read_graspit_robot_file(std::string_view name, const std::string& bytes) {
  Robot robot = read_graspit_robot(XmlFile(pretended_path(name, "xml"), bytes));
  if (robot.hand) {
    promised(std::abs(robot.hand->approach.norm() - 1.0) < 1e-9, "the approach axis is unit");
    promised(robot.hand->origin.allFinite(), "the origin is finite");
  }
  robot.hand.reset();
  check_robot(robot);
}

void read_urdf_file(std::string_view name, const std::string& bytes) {
  check_tree(read_urdf(XmlFile(pretended_path(name, "urdf"), bytes)));
}

void read_xacro_file(std::string_view name, const std::string& bytes) {
  check_tree(read_urdf(expanded_xacro(XmlFile(pretended_path(name, "xacro"), bytes), {})));
}

void read_openrave_file(std::string_view name, const std::string& bytes) {
  check_tree(read_urdf(urdf_of_openrave(XmlFile(pretended_path(name, "xml"), bytes))));
}

void read_sdf_file(std::string_view name, const std::string& bytes) {
  check_tree(read_urdf(urdf_of_sdf(XmlFile(pretended_path(name, "sdf"), bytes))));
}

void read_mjcf_file(std::string_view name, const std::string& bytes) {
  check_tree(read_mjcf(XmlFile(pretended_path(name, "xml"), bytes)));
}

}  // namespace prehend::fuzz
