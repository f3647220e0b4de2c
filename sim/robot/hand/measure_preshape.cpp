#include "sim/robot/hand/measure_preshape.h"

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

#include "sim/base/index.h"

namespace prehend {
namespace {

constexpr int kTimes = 64;             // postures of a closing motion that are looked at
constexpr int kHalvings = 20;          // of a step, to find where the fingers meet
constexpr double kLeastClosing = 0.1;  // of the opening
constexpr double kLeastDepth = 0.25;   // of the opening
constexpr double kTurns = 0.2;         // of a last link, less is none [rad]
constexpr double kLean = 0.17;         // sine of 10 degrees: a last link that leans so still stands
constexpr double kTouch = 1e-6;        // distance of the only finger from the palm [m]
constexpr double kPad = 0.05;  // of a link's thickness along the closing axis: its side is the pad

struct Extent {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
  void add(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

// How far links reach along a direction [m].
Extent reach_along(const Robot& robot, const std::vector<int>& links, const std::vector<Pose>& X_BL,
                   const Vector3& direction) {
  Extent reach;
  for (const int link : links) {
    for (const Vector3& p : robot.links[index(link)].mesh.vertices) {
      reach.add(direction.dot(X_BL[index(link)] * p));
    }
  }
  return reach;
}

// The middle of the side of the links that faces along `facing`, as a height along `up` [m].
double pad_height(const Robot& robot, const std::vector<int>& links, const std::vector<Pose>& X_BL,
                  const Vector3& facing, const Vector3& up) {
  const Extent thick = reach_along(robot, links, X_BL, facing);
  Extent height;
  for (const int link : links) {
    for (const Vector3& p : robot.links[index(link)].mesh.vertices) {
      const Vector3 q = X_BL[index(link)] * p;
      if (facing.dot(q) >= thick.most - kPad * (thick.most - thick.least)) height.add(up.dot(q));
    }
  }
  return 0.5 * (height.least + height.most);
}

}  // namespace

double PreshapeMeasure::gap(const Opposition& opening, const std::vector<double>& dofs) const {
  if (tip_gap_) {
    return tip_gap_->at(dofs);
  }
  std::vector<Pose> X_BL;
  link_poses(robot_, joint_values(robot_, dofs), X_BL);
  double thumb = 0.0;
  double others = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < parts_.fingers.size(); ++f) {
    const Extent along = reach_along(robot_, parts_.fingers[f].tip_links, X_BL, hand_.closing);
    if (f == opening.thumb) {
      thumb = along.most;
    } else {
      others = std::min(others, along.least);
    }
  }
  return others - thumb;
}

// When the finger's last link stands along the approach or leans inwards, from `start` on; `start`
// for one that does not turn, or never does [s].
double PreshapeMeasure::upright(const Opposition& opening, std::size_t finger, double start) const {
  const Finger& f = parts_.fingers[finger];
  const int last = f.joints.back();
  const Vector3 inward = finger == opening.thumb ? hand_.closing : Vector3(-hand_.closing);
  Matrix3 first = Matrix3::Identity();
  RobotPoses poses;
  for (int k = 0; k <= kTimes; ++k) {
    const double time = start + (opening.meeting - start) * k / kTimes;
    robot_poses(robot_, joint_values(robot_, closed_for(robot_, closing_, time, opening.dofs)),
                poses);
    const Matrix3 R = poses.X_BL[index(f.tip_link)].linear();
    if (k == 0) first = R;
    const Joint& joint = robot_.joints[index(last)];
    if (joint.type == JointType::prismatic) return start;
    const Pose X_BP = joint.parent < 0 ? Pose::Identity() : poses.X_BJ[index(joint.parent)];
    const Vector3 along = poses.X_BL[index(f.tip_link)] * f.tip - X_BP * joint.X_PJ.translation();
    if (inward.dot(along) < -kLean * along.norm()) continue;
    const bool turns = Eigen::AngleAxisd(first.transpose() * R).angle() > kTurns;
    return turns || k == 0 ? time : start;
  }
  return start;
}

PreshapeMeasure::Sides PreshapeMeasure::sides(const Opposition& opening, double start) const {
  Sides sides{.thumb = 0.0, .others = std::numeric_limits<double>::infinity()};
  std::vector<Pose> X_BL;
  for (std::size_t f = 0; f < parts_.fingers.size(); ++f) {
    const double time = upright(opening, f, start);
    link_poses(robot_, joint_values(robot_, closed_for(robot_, closing_, time, opening.dofs)),
               X_BL);
    const Extent along = reach_along(robot_, parts_.fingers[f].tip_links, X_BL, hand_.closing);
    if (f == opening.thumb) {
      sides.thumb = along.most;
    } else {
      sides.others = std::min(sides.others, along.least);
    }
  }
  return sides;
}

double PreshapeMeasure::widest(const Opposition& opening, double start) const {
  if (tip_gap_) return gap(opening, closed_for(robot_, closing_, start, opening.dofs));
  const Sides s = sides(opening, start);
  const double middle = hand_.closing.dot(hand_.origin);
  if (!(s.thumb < middle && middle < s.others)) return s.others - s.thumb;
  return 2.0 * std::min(middle - s.thumb, s.others - middle);
}

double PreshapeMeasure::off_middle(const Opposition& opening) const {
  if (tip_gap_) return 0.0;
  const Sides s = sides(opening, 0.0);
  return 0.5 * (s.thumb + s.others) - hand_.closing.dot(hand_.origin);
}

bool PreshapeMeasure::turns(const Opposition& opening) const {
  if (tip_gap_) return false;
  std::vector<Pose> X_BL;
  std::vector<Pose> X_BL_met;
  link_poses(robot_, joint_values(robot_, opening.dofs), X_BL);
  link_poses(robot_,
             joint_values(robot_, closed_for(robot_, closing_, opening.meeting, opening.dofs)),
             X_BL_met);
  return std::any_of(parts_.fingers.begin(), parts_.fingers.end(), [&](const Finger& finger) {
    const auto l = index(finger.tip_link);
    return Eigen::AngleAxisd(X_BL[l].linear().transpose() * X_BL_met[l].linear()).angle() > kTurns;
  });
}

double PreshapeMeasure::depth(const Opposition& opening, const std::vector<double>& dofs) const {
  std::vector<Pose> X_BL;
  link_poses(robot_, joint_values(robot_, dofs), X_BL);
  const auto height = [&](const Finger& finger, const Vector3& facing) {
    return pad_height(robot_, finger.tip_links, X_BL, facing, hand_.approach);
  };
  const double thumb = height(parts_.fingers[opening.thumb], hand_.closing);
  double others = 0.0;
  for (std::size_t f = 0; f < parts_.fingers.size(); ++f) {
    if (f != opening.thumb) others += height(parts_.fingers[f], -hand_.closing);
  }
  const bool alone = parts_.fingers.size() < 2;
  const double mean =
      alone ? thumb : 0.5 * (thumb + others / static_cast<double>(parts_.fingers.size() - 1));
  return std::max(0.0, mean - hand_.approach.dot(hand_.origin));
}

// Whether the thumb touches another finger (the palm, where it is the only one).
bool PreshapeMeasure::touching(const Opposition& opening, const std::vector<double>& dofs) const {
  const Finger& thumb = parts_.fingers[opening.thumb];
  if (tip_gap_) return tip_gap_->at(dofs) <= kTouch;
  for (std::size_t f = 0; f < parts_.fingers.size(); ++f) {
    if (f != opening.thumb && collision_.meet(thumb.links, parts_.fingers[f].links, dofs)) {
      return true;
    }
  }
  return false;
}

std::optional<Preshape> PreshapeMeasure::at(const std::string& name, const Opposition& opening,
                                            double part) const {
  const double end = closing_time(robot_, closing_);
  const auto posture = [&](double time) {
    return closed_for(robot_, closing_, time, opening.dofs);
  };
  const double meeting = parts_.fingers.size() < 2 ? end : opening.meeting;
  double start = 0.0;
  // Half open is where the gap is half of that of the open hand.
  const double wanted = (1.0 - part) * widest(opening);
  while (part > 0.0 && start < meeting && gap(opening, posture(start)) > wanted) {
    start += meeting / kTimes;
  }
  const double latest = 0.5 * (start + meeting);
  while (collision_.any(posture(start))) {
    start += meeting / kTimes;
    if (start > latest) return std::nullopt;
  }
  Preshape preshape{.name = name, .dofs = posture(start)};
  preshape.max_width = widest(opening, start);
  if (!(preshape.max_width > 0.0)) return std::nullopt;
  preshape.min_width = preshape.max_width;
  double met = start;
  for (int k = 1; k <= kTimes; ++k) {
    double time = start + (end - start) * k / kTimes;
    const auto closed = [&](double t) {
      return gap(opening, posture(t)) <= 0.0 || touching(opening, posture(t));
    };
    const bool last = closed(time);
    double before = start + (end - start) * (k - 1) / kTimes;
    for (int halving = 0; last && halving < kHalvings; ++halving) {
      const double middle = 0.5 * (before + time);
      (closed(middle) ? time : before) = middle;
    }
    const double now = std::max(0.0, gap(opening, posture(last ? before : time)));
    if (now < preshape.min_width) {
      preshape.min_width = now;
      met = last ? before : time;
    }
    if (last) break;
  }
  if (!(preshape.max_width - preshape.min_width > kLeastClosing * preshape.max_width)) {
    return std::nullopt;
  }
  // Fingers that curl meet close to the palm, where no body has room that is worth their opening:
  // the middle of one of half the width is at least a quarter of it away.
  preshape.depth = std::max(depth(opening, posture(met)), kLeastDepth * preshape.max_width);
  return preshape;
}

}  // namespace prehend
