#include "sim/robot/hand/closing_dofs.h"

#include <algorithm>
#include <cmath>

#include "sim/base/index.h"
#include "sim/robot/hand/closing_signs.h"

namespace prehend {
namespace {

constexpr double kAlike = 0.7071;        // cosine of 45 degrees
constexpr double kTurnRate = 1.0;        // [rad/s]
constexpr double kSlideRate = 0.05;      // [m/s]
constexpr double kBentBackwards = 0.35;  // of all joints that bend a finger [rad]
// A joint that turns over more than this is taken for one that turns without end, which bends a
// finger from its initial value by at most the second one [rad].
constexpr double kEndless = 4.0;
constexpr double kBentShut = 2.5;

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
  const bool endless = d.upper - d.lower > kEndless;
  if (slides(robot, dof) || (bends < 2 && !endless)) return limit;
  const double backwards = kBentBackwards / static_cast<double>(std::max<std::size_t>(bends, 1));
  if (velocity > 0.0) return std::max(limit, d.initial - backwards);
  return std::min(limit, d.initial + backwards);
}

// Opens what closes.
void open_hand(const Robot& robot, const HandParts& parts, ClosingDofs& closing) {
  RobotPoses poses;
  robot_poses(robot, joint_values(robot, closing.open), poses);
  const std::vector<std::size_t> bends = bends_of(robot, parts, poses.X_BJ);
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    if (closing.closes(d)) closing.open[d] = open_value(robot, d, closing.velocity[d], bends[d]);
  }
}

}  // namespace

Vector3 axis_in_base(const Robot& robot, int joint, const std::vector<Pose>& X_BJ) {
  const Joint& j = robot.joints[index(joint)];
  const Vector3 axis_P = j.X_PJ.linear() * j.axis;
  return j.parent < 0 ? axis_P : Vector3(X_BJ[index(j.parent)].linear() * axis_P);
}

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

ClosingDofs closing_towards(const Robot& robot, const HandParts& parts,
                            const std::vector<int>& signs) {
  ClosingDofs closing{.velocity = std::vector<double>(robot.dofs.size(), 0.0),
                      .open = initial_dofs(robot)};
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    closing.velocity[d] = signs[d] * (slides(robot, d) ? kSlideRate : kTurnRate);
  }
  open_hand(robot, parts, closing);
  return closing;
}

ClosingDofs find_closing_dofs(const Robot& robot, const HandParts& parts) {
  ClosingDofs closing{.velocity = std::vector<double>(robot.dofs.size(), 0.0),
                      .open = initial_dofs(robot)};
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    closing.velocity[d] = robot.dofs[d].closing_velocity;
    closing.stated = closing.stated || closing.closes(d);
  }
  if (!closing.stated) return closing_towards(robot, parts, find_closing_signs(robot, parts));
  open_hand(robot, parts, closing);
  return closing;
}

double closed_value(const Robot& robot, const ClosingDofs& closing, std::size_t dof) {
  const DegreeOfFreedom& d = robot.dofs[dof];
  const bool up = closing.velocity[dof] > 0.0;
  const double limit = up ? d.upper : d.lower;
  if (slides(robot, dof) || d.upper - d.lower <= kEndless) return limit;
  return up ? std::min(limit, d.initial + kBentShut) : std::max(limit, d.initial - kBentShut);
}

std::vector<double> closed_for(const Robot& robot, const ClosingDofs& closing, double time,
                               const std::vector<double>& from) {
  std::vector<double> dofs = from;
  for (std::size_t d = 0; d < dofs.size(); ++d) {
    if (!closing.closes(d)) continue;
    const double end = closed_value(robot, closing, d);
    dofs[d] = std::clamp(closing.open[d] + closing.velocity[d] * time,
                         std::min(closing.open[d], end), std::max(closing.open[d], end));
  }
  return dofs;
}

double closing_time(const Robot& robot, const ClosingDofs& closing) {
  double time = 0.0;
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    if (!closing.closes(d)) continue;
    time =
        std::max(time, (closed_value(robot, closing, d) - closing.open[d]) / closing.velocity[d]);
  }
  return time;
}

}  // namespace prehend
