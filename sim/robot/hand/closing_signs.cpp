#include "sim/robot/hand/closing_signs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/base/index.h"
#include "sim/robot/hand/fingertip_gap.h"
#include "sim/robot/hand/opposition.h"

namespace prehend {
namespace {

constexpr double kSameRange = 0.02;  // of ranges that are alike [rad or m]
constexpr double kOneSided = 0.2;    // of a range: its middle is that far from the initial value
constexpr double kRangeWorth = 0.5;  // of bending over a whole range, as an opposition
constexpr double kMuchBetter = 0.3;  // opposition for which one joint bends against the others
constexpr double kAnyBetter = 1e-6;
constexpr std::size_t kMostTogether = 5;  // sets whose signs are tried together

// A degree of freedom of a finger's bending joints, and its sense about their common axis.
struct Bend {
  std::size_t dof = 0;
  int sense = 1;
};

using Bends = std::vector<Bend>;  // of one finger, the palm's end first

// The bends of each finger; a degree of freedom that moves several fingers is one of the first.
std::vector<Bends> bends_of_fingers(const Robot& robot, const HandParts& parts,
                                    const std::vector<Pose>& X_BJ) {
  std::vector<Bends> fingers;
  for (const Finger& finger : parts.fingers) {
    Bends bends;
    const Vector3 axis = axis_in_base(robot, finger.joints.back(), X_BJ);
    for (const int joint : closing_joints(robot, finger, X_BJ)) {
      const Joint& j = robot.joints[index(joint)];
      const bool known = std::any_of(bends.begin(), bends.end(),
                                     [&](const Bend& b) { return b.dof == index(j.dof); });
      const DegreeOfFreedom& dof = robot.dofs[index(j.dof)];
      if (known || !(dof.lower < dof.upper)) continue;
      const double along = j.ratio * axis_in_base(robot, joint, X_BJ).dot(axis);
      bends.push_back({index(j.dof), along < 0.0 ? -1 : 1});
    }
    fingers.push_back(std::move(bends));
  }
  return fingers;
}

// Twice the middle of its range as a part of it, from the initial value: 1 where it begins there.
double one_sidedness(const DegreeOfFreedom& dof) {
  return (dof.upper + dof.lower - 2.0 * dof.initial) / (dof.upper - dof.lower);
}

// 1: both fingers are built alike, -1: mirrored, 0: neither, or their ranges do not say which way
// is which.
int likeness(const Robot& robot, const Bends& a, const Bends& b) {
  if (a.size() != b.size() || a.empty()) return 0;
  int found = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const DegreeOfFreedom& p = robot.dofs[a[k].dof];
    const DegreeOfFreedom& q = robot.dofs[b[k].dof];
    if (slides(robot, a[k].dof) != slides(robot, b[k].dof)) return 0;
    const auto alike = [](double x, double y) { return std::abs(x - y) <= kSameRange; };
    // From the initial values: a joint's zero may be anywhere.
    const double p_lower = p.lower - p.initial;
    const double p_upper = p.upper - p.initial;
    const double q_lower = q.lower - q.initial;
    const double q_upper = q.upper - q.initial;
    const bool same = alike(p_lower, q_lower) && alike(p_upper, q_upper);
    const bool mirrored = alike(p_lower, -q_upper) && alike(p_upper, -q_lower);
    if (!same && !mirrored) return 0;
    if (std::abs(one_sidedness(p)) < kOneSided || same == mirrored) continue;
    // In terms of the senses, not of the values.
    const int sense = a[k].sense * b[k].sense * (same ? 1 : -1);
    if (found != 0 && sense != found) return 0;
    found = sense;
  }
  return found;
}

// Fingers that bend together: one sign settles those of all their degrees of freedom.
struct Together {
  std::vector<std::size_t> fingers;
  std::vector<int> sense;  // of each finger's axis
};

class SignSearch {
 public:
  SignSearch(const Robot& robot, const HandParts& parts);
  std::vector<int> search();

 private:
  void gather();
  std::vector<int> signs_of(const std::vector<int>& bits) const;
  double worth(const std::vector<int>& signs) const;
  double prior(const std::vector<int>& signs) const;
  void turn_around_single(std::vector<int>& signs) const;

  const Robot& robot_;
  const HandParts& parts_;
  std::vector<Bends> fingers_;
  std::vector<Together> sets_;
};

SignSearch::SignSearch(const Robot& robot, const HandParts& parts) : robot_(robot), parts_(parts) {
  RobotPoses poses;
  robot_poses(robot, joint_values(robot, initial_dofs(robot)), poses);
  fingers_ = bends_of_fingers(robot, parts, poses.X_BJ);
  gather();
}

// Each finger joins the first set that shares a degree of freedom with it or is built alike.
void SignSearch::gather() {
  for (std::size_t f = 0; f < fingers_.size(); ++f) {
    if (fingers_[f].empty()) continue;
    const auto joins = [&](Together& set) {
      for (std::size_t k = 0; k < set.fingers.size(); ++k) {
        const Bends& other = fingers_[set.fingers[k]];
        int sense = likeness(robot_, other, fingers_[f]);
        for (const Bend& a : other) {
          for (const Bend& b : fingers_[f]) {
            if (a.dof == b.dof) sense = a.sense * b.sense;
          }
        }
        if (sense == 0) continue;
        set.fingers.push_back(f);
        set.sense.push_back(sense * set.sense[k]);
        return true;
      }
      return false;
    };
    if (std::none_of(sets_.begin(), sets_.end(), joins)) sets_.push_back({{f}, {1}});
  }
}

std::vector<int> SignSearch::signs_of(const std::vector<int>& bits) const {
  std::vector<int> signs(robot_.dofs.size(), 0);
  for (std::size_t s = 0; s < sets_.size(); ++s) {
    for (std::size_t k = 0; k < sets_[s].fingers.size(); ++k) {
      for (const Bend& bend : fingers_[sets_[s].fingers[k]]) {
        if (signs[bend.dof] == 0) signs[bend.dof] = bits[s] * sets_[s].sense[k] * bend.sense;
      }
    }
  }
  return signs;
}

// How much of their ranges the fingers with several bending joints bend, from -1 to 1.
double SignSearch::prior(const std::vector<int>& signs) const {
  double sum = 0.0;
  double count = 0.0;
  for (const Bends& bends : fingers_) {
    if (bends.size() < 2) continue;
    for (const Bend& bend : bends) {
      if (slides(robot_, bend.dof)) continue;
      sum += signs[bend.dof] * one_sidedness(robot_.dofs[bend.dof]);
      count += 1.0;
    }
  }
  return count > 0.0 ? sum / count : 0.0;
}

double SignSearch::worth(const std::vector<int>& signs) const {
  const ClosingDofs closing = closing_towards(robot_, parts_, signs);
  if (parts_.fingers.size() > 1) {
    return best_opposition(robot_, parts_, closing).score + kRangeWorth * prior(signs);
  }
  const FingertipGap gap(robot_, parts_);
  const double end = closing_time(robot_, closing);
  double least = std::numeric_limits<double>::infinity();
  constexpr int kTimesTried = 32;
  for (int k = 0; k <= kTimesTried; ++k) {
    least =
        std::min(least, gap.at(closed_for(robot_, closing, end * k / kTimesTried, closing.open)));
  }
  return gap.at(closing.open) - least;
}

// Those of one place in all fingers of a set together.
void SignSearch::turn_around_single(std::vector<int>& signs) const {
  double best = worth(signs);
  for (const Together& set : sets_) {
    const std::size_t bends = fingers_[set.fingers.front()].size();
    for (std::size_t place = 0; bends > 1 && place < bends; ++place) {
      std::vector<int> other = signs;
      for (const std::size_t f : set.fingers) {
        if (place >= fingers_[f].size()) continue;
        const std::size_t dof = fingers_[f][place].dof;
        other[dof] = -signs[dof];
      }
      const double its = worth(other);
      if (!(its > best + kMuchBetter)) continue;
      best = its;
      signs = other;
    }
  }
}

std::vector<int> SignSearch::search() {
  std::vector<int> bits(sets_.size(), 1);
  std::vector<int> best = signs_of(bits);
  double best_worth = worth(best);
  const auto consider = [&] {
    const std::vector<int> signs = signs_of(bits);
    const double its = worth(signs);
    if (!(its > best_worth + kAnyBetter)) return false;
    best = signs;
    best_worth = its;
    return true;
  };
  if (sets_.size() <= kMostTogether) {
    for (std::size_t ways = 1; ways < (std::size_t{1} << sets_.size()); ++ways) {
      for (std::size_t s = 0; s < sets_.size(); ++s) bits[s] = ((ways >> s) & 1U) != 0U ? -1 : 1;
      consider();
    }
  } else {
    for (int round = 0; round < 2; ++round) {
      for (int& bit : bits) {
        bit = -bit;
        if (!consider()) bit = -bit;
      }
    }
  }
  turn_around_single(best);
  return best;
}

}  // namespace

std::vector<int> find_closing_signs(const Robot& robot, const HandParts& parts) {
  return SignSearch(robot, parts).search();
}

}  // namespace prehend
