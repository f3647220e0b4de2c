#include "sim/robot/hand/fingers.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "sim/base/index.h"
#include "sim/shape/proximity.h"

namespace prehend {
namespace {

constexpr int kLongestSingleFinger = 2;  // joints
// A link that carries others counts as if it reached only this part as far: it is the tip where
// what it carries are levers, but not where a finger is bent at the start.
constexpr double kCarrierReach = 0.6;
constexpr double kLeverReach = 0.6;  // of the reach of a finger
// The far end of a tip link: its vertices beyond this part of its reach.
constexpr double kFarEnd = 0.85;

bool moves(const Robot& robot, int joint, int link) {
  for (int j = robot.links[index(link)].joint; j >= 0; j = robot.joints[index(j)].parent) {
    if (j == joint) return true;
  }
  return false;
}

std::vector<int> links_moved_by(const Robot& robot, int joint) {
  std::vector<int> links;
  for (int l = 0; l < static_cast<int>(robot.links.size()); ++l) {
    if (!robot.links[index(l)].mesh.empty() && moves(robot, joint, l)) links.push_back(l);
  }
  return links;
}

// Joints on `parent` beyond which there are links.
std::vector<int> branches_of(const Robot& robot, int parent) {
  std::vector<int> branches;
  for (int j = 0; j < static_cast<int>(robot.joints.size()); ++j) {
    if (robot.joints[index(j)].parent == parent && !links_moved_by(robot, j).empty()) {
      branches.push_back(j);
    }
  }
  return branches;
}

// The point of the base frame from which the reach of a tip link is measured: the axis of its last
// turning joint, or the palm where it only slides.
Vector3 root_of_tip(const Robot& robot, int joint, const std::vector<Pose>& X_BJ,
                    const Vector3& palm) {
  const Joint& last = robot.joints[index(joint)];
  if (last.type == JointType::prismatic) return palm;
  const Pose X_BP = last.parent < 0 ? Pose::Identity() : X_BJ[index(last.parent)];
  return X_BP * last.X_PJ.translation();
}

struct Tip {
  Vector3 p_B = Vector3::Zero();
  Vector3 p_L = Vector3::Zero();
};

Tip tip_of(const Robot& robot, int link, const RobotPoses& poses, const Vector3& palm) {
  const Link& body = robot.links[index(link)];
  const Pose& X_BL = poses.X_BL[index(link)];
  const Vector3 root = root_of_tip(robot, body.joint, poses.X_BJ, palm);
  double reach = 0.0;
  for (const Vector3& p : body.mesh.vertices) reach = std::max(reach, (X_BL * p - root).norm());
  Vector3 sum = Vector3::Zero();
  double count = 0.0;
  for (const Vector3& p : body.mesh.vertices) {
    if ((X_BL * p - root).norm() < kFarEnd * reach) continue;
    sum += p;
    count += 1.0;
  }
  Tip tip;
  if (count > 0.0) tip.p_L = sum / count;
  tip.p_B = X_BL * tip.p_L;
  return tip;
}

// The finger that begins with `joint`, up to the tip that is farthest from the palm.
Finger finger_at(const Robot& robot, int joint, const RobotPoses& poses, const Vector3& palm) {
  Finger finger;
  finger.links = links_moved_by(robot, joint);
  double farthest = -1.0;
  for (const int link : finger.links) {
    const Tip tip = tip_of(robot, link, poses, palm);
    const int moved_by = robot.links[index(link)].joint;
    const bool carries = std::any_of(finger.links.begin(), finger.links.end(), [&](int other) {
      return robot.links[index(other)].joint != moved_by && moves(robot, moved_by, other);
    });
    const double reach = (carries ? kCarrierReach : 1.0) * (tip.p_B - palm).norm();
    if (reach <= farthest) continue;
    farthest = reach;
    finger.tip_link = link;
    finger.tip = tip.p_L;
  }
  const int tip_joint = robot.links[index(finger.tip_link)].joint;
  for (const int link : finger.links) {
    if (robot.links[index(link)].joint == tip_joint) finger.tip_links.push_back(link);
  }
  const std::vector<int> path = joints_to(robot, tip_joint);
  finger.joints.assign(std::find(path.begin(), path.end(), joint), path.end());
  return finger;
}

std::set<int> dofs_of(const Robot& robot, const Finger& finger) {
  std::set<int> dofs;
  for (const int joint : finger.joints) dofs.insert(robot.joints[index(joint)].dof);
  return dofs;
}

// Whether links of the two fingers touch at the start and in the middle of what both can do.
bool stay_in_touch(const Robot& robot, const Finger& a, const Finger& b) {
  std::vector<double> middle;
  for (const DegreeOfFreedom& dof : robot.dofs) {
    const double mean = 0.5 * (dof.lower + dof.upper);
    middle.push_back(std::isfinite(mean) ? mean : dof.initial);
  }
  for (const std::vector<double>& dofs : {initial_dofs(robot), middle}) {
    std::vector<Pose> X_BL;
    link_poses(robot, joint_values(robot, dofs), X_BL);
    const auto touch = [&](int p, int q) {
      const ProximityMesh first(robot.links[index(p)].mesh);
      const ProximityMesh second(robot.links[index(q)].mesh);
      const Pose X_PQ = X_BL[index(p)].inverse() * X_BL[index(q)];
      return find_gap(first, second, X_PQ, {.cap = 1e-6, .hint = {}}).lower <= 0.0;
    };
    const bool touching = std::any_of(a.links.begin(), a.links.end(), [&](int p) {
      return std::any_of(b.links.begin(), b.links.end(), [&](int q) { return touch(p, q); });
    });
    if (!touching) return false;
  }
  return true;
}

// Whether a linkage joins it to a finger beside it, whose joints it passes.
bool passes_another(const Robot& robot, const Finger& finger) {
  return std::any_of(finger.joints.begin(), finger.joints.end(), [&](int joint) {
    const int across = robot.joints[index(joint)].across;
    return across >= 0 &&
           std::find(finger.joints.begin(), finger.joints.end(), across) == finger.joints.end();
  });
}

void drop_levers(const Robot& robot, const RobotPoses& poses, const Vector3& palm,
                 std::vector<Finger>& fingers) {
  const auto reach = [&](const Finger& finger) {
    return (poses.X_BL[index(finger.tip_link)] * finger.tip - palm).norm();
  };
  const std::vector<Finger> all = fingers;
  std::erase_if(fingers, [&](const Finger& finger) {
    if (passes_another(robot, finger)) return true;
    const std::set<int> own = dofs_of(robot, finger);
    return std::any_of(all.begin(), all.end(), [&](const Finger& other) {
      const std::set<int> dofs = dofs_of(robot, other);
      if (!std::includes(dofs.begin(), dofs.end(), own.begin(), own.end())) return false;
      if (reach(finger) < kLeverReach * reach(other)) return true;
      return finger.joints.size() < other.joints.size() && stay_in_touch(robot, finger, other);
    });
  });
}

}  // namespace

Vector3 middle_of(const Robot& robot, const std::vector<int>& links) {
  RobotPoses poses;
  robot_poses(robot, joint_values(robot, initial_dofs(robot)), poses);
  Vector3 sum = Vector3::Zero();
  double area = 0.0;
  for (const int link : links) {
    const TriangleMesh& mesh = robot.links[index(link)].mesh;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const double part = doubled_area_vector(mesh, t).norm();
      const auto& corner = mesh.triangles[t];
      const Vector3 middle = (mesh.vertices[index(corner[0])] + mesh.vertices[index(corner[1])] +
                              mesh.vertices[index(corner[2])]) /
                             3.0;
      sum += part * (poses.X_BL[index(link)] * middle);
      area += part;
    }
  }
  return area > 0.0 ? Vector3(sum / area) : Vector3::Zero();
}

HandParts find_hand_parts(const Robot& robot) {
  HandParts parts;
  std::vector<int> branches = branches_of(robot, -1);
  int passed = 0;
  while (branches.size() == 1) {
    const std::vector<int> next = branches_of(robot, branches.front());
    ++passed;
    if (next.empty()) break;
    parts.palm_joint = branches.front();
    branches = next;
  }
  if (branches.size() == 1) {
    if (passed > kLongestSingleFinger) return {};
    parts.palm_joint = -1;
    branches = branches_of(robot, -1);
  }
  for (int l = 0; l < static_cast<int>(robot.links.size()); ++l) {
    const bool beyond = std::any_of(branches.begin(), branches.end(),
                                    [&](int joint) { return moves(robot, joint, l); });
    if (!beyond && !robot.links[index(l)].mesh.empty()) parts.palm_links.push_back(l);
  }
  const Vector3 palm = middle_of(robot, parts.palm_links);
  RobotPoses poses;
  robot_poses(robot, joint_values(robot, initial_dofs(robot)), poses);
  for (const int joint : branches) {
    parts.fingers.push_back(finger_at(robot, joint, poses, palm));
  }
  drop_levers(robot, poses, palm, parts.fingers);
  return parts;
}

}  // namespace prehend
