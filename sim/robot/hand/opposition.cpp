#include "sim/robot/hand/opposition.h"

#include <algorithm>
#include <cmath>

#include "sim/base/index.h"

namespace prehend {
namespace {

constexpr int kLooks = 32;            // postures of a closing motion that are looked at
constexpr double kLeastRange = 0.6;   // of a posing degree of freedom [rad]
constexpr double kReluctance = 0.05;  // score that moving one over its whole range has to gain
constexpr double kClearlyBetter = 1e-6;
constexpr double kNearlyAsWell = 0.6;  // score below that of the best
constexpr double kOtherPlace = 0.24;   // of a posing degree of freedom's range

double reluctance(const Robot& robot, const std::vector<std::size_t>& posing,
                  const std::vector<double>& dofs) {
  double sum = 0.0;
  for (const std::size_t d : posing) {
    const DegreeOfFreedom& dof = robot.dofs[d];
    sum += kReluctance * std::abs(dofs[d] - dof.initial) / (dof.upper - dof.lower);
  }
  return sum;
}

struct Considered {
  Opposition opposition;
  double worth = 0.0;
};

}  // namespace

std::vector<Vector3> tips_at(const Robot& robot, const HandParts& parts,
                             const std::vector<double>& dofs) {
  std::vector<Pose> X_BL;
  link_poses(robot, joint_values(robot, dofs), X_BL);
  std::vector<Vector3> tips;
  for (const Finger& finger : parts.fingers) {
    tips.push_back(X_BL[index(finger.tip_link)] * finger.tip);
  }
  return tips;
}

Vector3 mean_of_others(const std::vector<Vector3>& tips, std::size_t thumb) {
  Vector3 sum = Vector3::Zero();
  for (std::size_t f = 0; f < tips.size(); ++f) {
    if (f != thumb) sum += tips[f];
  }
  return sum / static_cast<double>(tips.size() - 1);
}

Opposition opposition_of(const Robot& robot, const HandParts& parts, const ClosingDofs& closing,
                         std::size_t thumb, const std::vector<double>& dofs) {
  Opposition result{.thumb = thumb, .dofs = dofs};
  const double end = closing_time(robot, closing);
  const std::vector<Vector3> open = tips_at(robot, parts, dofs);
  const Vector3 apart = mean_of_others(open, thumb) - open[thumb];
  std::vector<Vector3> nearest = open;
  double least = apart.norm();
  for (int k = 1; k <= kLooks; ++k) {
    const double time = end * k / kLooks;
    const std::vector<Vector3> tips = tips_at(robot, parts, closed_for(robot, closing, time, dofs));
    const double gap = (mean_of_others(tips, thumb) - tips[thumb]).norm();
    if (gap >= least) continue;
    least = gap;
    nearest = tips;
    result.meeting = time;
  }
  const double width = apart.norm();
  if (!(width > 0.0)) {
    result.score = -2.0;
    return result;
  }
  const Vector3 u = apart / width;
  const double by_thumb = u.dot(nearest[thumb] - open[thumb]);
  const double by_others = -u.dot(mean_of_others(nearest, thumb) - mean_of_others(open, thumb));
  result.score = std::min({by_thumb, by_others, 0.5 * width}) / (0.5 * width) - 2.0 * least / width;
  return result;
}

std::vector<std::size_t> posing_dofs(const Robot& robot, const HandParts& parts,
                                     const ClosingDofs& closing) {
  std::vector<std::size_t> dofs;
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    const bool in_finger =
        std::any_of(parts.fingers.begin(), parts.fingers.end(), [&](const Finger& finger) {
          return std::any_of(finger.joints.begin(), finger.joints.end(), [&](int joint) {
            const Joint& j = robot.joints[index(joint)];
            return index(j.dof) == d && j.type == JointType::revolute;
          });
        });
    const bool far = robot.dofs[d].upper - robot.dofs[d].lower > kLeastRange;
    if (in_finger && far && !closing.closes(d)) dofs.push_back(d);
  }
  return dofs;
}

namespace {

// All oppositions that a search of the posing degrees of freedom, one at a time, looks at: the best
// first.
std::vector<Considered> searched(const Robot& robot, const HandParts& parts,
                                 const ClosingDofs& closing) {
  const std::vector<std::size_t> posing = posing_dofs(robot, parts, closing);
  std::vector<Considered> all;
  const auto consider = [&](std::size_t thumb, const std::vector<double>& dofs) {
    Opposition found = opposition_of(robot, parts, closing, thumb, dofs);
    const double worth = found.score - reluctance(robot, posing, dofs);
    all.push_back({std::move(found), worth});
    return worth;
  };
  // Thumbs tend to come last in files; of fingers that are alike the last one counts as the thumb.
  for (std::size_t thumb = parts.fingers.size(); thumb-- > 0;) {
    std::vector<double> at = closing.open;
    double worth = consider(thumb, at);
    for (int round = 0; round < 2; ++round) {
      for (const std::size_t d : posing) {
        for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
          std::vector<double> other = at;
          const DegreeOfFreedom& dof = robot.dofs[d];
          other[d] = dof.lower + part * (dof.upper - dof.lower);
          const double its = consider(thumb, other);
          if (its <= worth + kClearlyBetter) continue;
          worth = its;
          at = other;
        }
      }
    }
  }
  // Of those that are as good but for rounding, the one that was looked at first.
  std::stable_sort(all.begin(), all.end(), [](const Considered& a, const Considered& b) {
    return std::round(a.worth / kClearlyBetter) > std::round(b.worth / kClearlyBetter);
  });
  return all;
}

}  // namespace

Opposition best_opposition(const Robot& robot, const HandParts& parts, const ClosingDofs& closing) {
  return std::move(searched(robot, parts, closing).front().opposition);
}

std::vector<Opposition> good_oppositions(const Robot& robot, const HandParts& parts,
                                         const ClosingDofs& closing, std::size_t most) {
  const std::vector<Considered> all = searched(robot, parts, closing);
  const std::vector<std::size_t> posing = posing_dofs(robot, parts, closing);
  const auto differ = [&](const Opposition& a, const Opposition& b) {
    return std::any_of(posing.begin(), posing.end(), [&](std::size_t d) {
      const double range = robot.dofs[d].upper - robot.dofs[d].lower;
      return std::abs(a.dofs[d] - b.dofs[d]) > kOtherPlace * range;
    });
  };
  std::vector<Opposition> good;
  for (const Considered& considered : all) {
    if (good.size() == most || considered.worth < all.front().worth - kNearlyAsWell) break;
    const Opposition& other = considered.opposition;
    const bool is_new = std::all_of(good.begin(), good.end(), [&](const Opposition& known) {
      return other.thumb == known.thumb && differ(known, other);
    });
    if (is_new) good.push_back(other);
  }
  return good;
}

}  // namespace prehend
