#include "sim/robot/hand/closing_dofs.h"

#include <algorithm>
#include <cmath>

#include "sim/base/index.h"

namespace prehend {
namespace {

constexpr double kAlike = 0.7071;        // cosine of 45 degrees
constexpr double kTurnRate = 1.0;        // [rad/s]
constexpr double kSlideRate = 0.05;      // [m/s]
constexpr double kBentBackwards = 0.35;  // [rad]

// Joints of the finger that bend or slide it shut, tip last.
std::vector<int> closing_joints(const Robot& robot, const Finger& finger,
                                const std::vector<Pose>& X_BJ) {
  const int last = finger.joints.back();
  const JointType type = robot.joints[index(last)].type;
  const Vector3 axis = axis_in_base(robot, last, X_BJ);
  std::vector<int> joints;
  for (const int joint : finger.joints) {
    if (robot.joints[index(joint)].type != type) continue;
    if (std::abs(axis_in_base(robot, joint, X_BJ).dot(axis)) >= kAlike) joints.push_back(joint);
  }
  return joints;
}

class Signs {
 public:
  Signs(const Robot& robot, const HandParts& parts)
      : robot_(robot), parts_(parts), palm_(middle_of(robot, parts.palm_links)) {}

  // How far the tips are from each other and from the palm, in sum [m].
  double opening(const std::vector<double>& dofs) {
    robot_poses(robot_, joint_values(robot_, dofs), poses_);
    std::vector<Vector3> tips;
    for (const Finger& finger : parts_.fingers) {
      tips.push_back(poses_.X_BL[index(finger.tip_link)] * finger.tip);
    }
    double sum = 0.0;
    for (std::size_t a = 0; a < tips.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        sum += 2.0 * (tips[a] - tips[b]).norm() / static_cast<double>(tips.size());
      }
      sum += 0.5 * (tips[a] - palm_).norm();
    }
    return sum;
  }

  // 1 or -1: towards which limit of `dof` the hand closes.
  double of(std::size_t dof, std::vector<double> dofs) {
    dofs[dof] = robot_.dofs[dof].upper;
    const double at_upper = opening(dofs);
    dofs[dof] = robot_.dofs[dof].lower;
    return at_upper <= opening(dofs) ? 1.0 : -1.0;
  }

 private:
  const Robot& robot_;
  const HandParts& parts_;
  Vector3 palm_;
  RobotPoses poses_;
};

// How many joints bend the finger that this degree of freedom moves, of several the most.
std::vector<std::size_t> bends_of(const Robot& robot, const HandParts& parts,
                                  const std::vector<Pose>& X_BJ) {
  std::vector<std::size_t> bends(robot.dofs.size(), 0);
  for (const Finger& finger : parts.fingers) {
    const std::vector<int> joints = closing_joints(robot, finger, X_BJ);
    for (const int joint : joints) {
      std::size_t& most = bends[index(robot.joints[index(joint)].dof)];
      most = std::max(most, joints.size());
    }
  }
  return bends;
}

double open_value(const Robot& robot, std::size_t dof, double velocity, std::size_t bends) {
  const DegreeOfFreedom& d = robot.dofs[dof];
  const double limit = velocity > 0.0 ? d.lower : d.upper;
  if (bends < 2 || slides(robot, dof)) return limit;
  if (velocity > 0.0) return std::max(limit, d.initial - kBentBackwards);
  return std::min(limit, d.initial + kBentBackwards);
}

void infer_velocities(const Robot& robot, const HandParts& parts,
                      const std::vector<std::size_t>& bends, ClosingDofs& closing) {
  Signs signs(robot, parts);
  std::vector<double> at = initial_dofs(robot);
  // The second time with the hand half closed the way that was found.
  for (int round = 0; round < 2; ++round) {
    for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
      const DegreeOfFreedom& dof = robot.dofs[d];
      if (bends[d] == 0 || !(dof.lower < dof.upper)) continue;
      closing.velocity[d] = signs.of(d, at) * (slides(robot, d) ? kSlideRate : kTurnRate);
    }
    for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
      if (!closing.closes(d)) continue;
      const DegreeOfFreedom& dof = robot.dofs[d];
      const double open = open_value(robot, d, closing.velocity[d], bends[d]);
      at[d] = 0.5 * (open + (closing.velocity[d] > 0.0 ? dof.upper : dof.lower));
    }
  }
}

}  // namespace

Vector3 axis_in_base(const Robot& robot, int joint, const std::vector<Pose>& X_BJ) {
  const Joint& j = robot.joints[index(joint)];
  const Vector3 axis_P = j.X_PJ.linear() * j.axis;
  return j.parent < 0 ? axis_P : Vector3(X_BJ[index(j.parent)].linear() * axis_P);
}

ClosingDofs find_closing_dofs(const Robot& robot, const HandParts& parts) {
  ClosingDofs closing{.velocity = std::vector<double>(robot.dofs.size(), 0.0),
                      .open = initial_dofs(robot)};
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    closing.velocity[d] = robot.dofs[d].closing_velocity;
    closing.stated = closing.stated || closing.closes(d);
  }
  RobotPoses poses;
  robot_poses(robot, joint_values(robot, closing.open), poses);
  const std::vector<std::size_t> bends = bends_of(robot, parts, poses.X_BJ);
  if (!closing.stated) infer_velocities(robot, parts, bends, closing);
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    if (closing.closes(d)) closing.open[d] = open_value(robot, d, closing.velocity[d], bends[d]);
  }
  return closing;
}

std::vector<double> closed_for(const Robot& robot, const ClosingDofs& closing, double time,
                               const std::vector<double>& from) {
  std::vector<double> dofs = from;
  for (std::size_t d = 0; d < dofs.size(); ++d) {
    if (!closing.closes(d)) continue;
    dofs[d] = std::clamp(closing.open[d] + closing.velocity[d] * time, robot.dofs[d].lower,
                         robot.dofs[d].upper);
  }
  return dofs;
}

double closing_time(const Robot& robot, const ClosingDofs& closing) {
  double time = 0.0;
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    if (!closing.closes(d)) continue;
    const double end = closing.velocity[d] > 0.0 ? robot.dofs[d].upper : robot.dofs[d].lower;
    time = std::max(time, (end - closing.open[d]) / closing.velocity[d]);
  }
  return time;
}

}  // namespace prehend
