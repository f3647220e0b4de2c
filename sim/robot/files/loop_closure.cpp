#include "sim/robot/files/loop_closure.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "sim/base/formatted.h"
#include "sim/base/index.h"

namespace prehend {
namespace {

constexpr int kSamples = 17;          // of the drive's range
constexpr int kSteps = 60;            // of Gauss and Newton for one sample
constexpr double kClosed = 1e-4;      // distance of the points of a closed loop [m]
constexpr double kLengthUnit = 1e-3;  // distances weigh as much as that [m]
// Springs and what stays put weigh so little that they decide only what the loop leaves free.
constexpr double kSpringWeight = 0.02;
constexpr double kStayWeight = 1e-4;
constexpr double kNumericStep = 1e-6;  // [rad or m]
constexpr double kStill = 0.01;        // a follower that moves less is fixed [rad or m]

Pose motion(const TreeJoint& joint, double value) {
  if (joint.type == TreeJointType::fixed) return Pose::Identity();
  if (joint.type == TreeJointType::prismatic) return translation(value * joint.axis);
  return Pose(Eigen::AngleAxisd(value, joint.axis));
}

// Moving joints between the root and the link.
std::set<int> joints_of(const JointTree& tree, int link) {
  const std::vector<int> carriers = carriers_of(tree);
  std::set<int> joints;
  for (int j = carriers[index(link)]; j >= 0; j = carriers[index(tree.joints[index(j)].parent)]) {
    if (tree.joints[index(j)].type != TreeJointType::fixed) joints.insert(j);
  }
  return joints;
}

class LoopSolver {
 public:
  LoopSolver(const JointTree& tree, const Loop& loop, std::vector<int> followers)
      : tree_(tree), loop_(loop), followers_(std::move(followers)) {
    for (const int f : followers_) {
      stiffest_ = std::max(stiffest_, tree.joints[index(f)].spring.stiffness);
    }
  }

  // Moves the followers so that the loop closes, and returns how far it is open [m].
  double close(std::vector<double>& values) const;

 private:
  Vector3 opening(const std::vector<double>& values) const {
    return link_in_root(tree_, loop_.a, values) * loop_.p_A -
           link_in_root(tree_, loop_.b, values) * loop_.p_B;
  }

  // Residuals: the opening, and for each follower what pulls it.
  Eigen::VectorXd residuals(const std::vector<double>& values,
                            const std::vector<double>& from) const;

  const JointTree& tree_;
  const Loop& loop_;
  std::vector<int> followers_;
  double stiffest_ = 0.0;
};

Eigen::VectorXd LoopSolver::residuals(const std::vector<double>& values,
                                      const std::vector<double>& from) const {
  const auto count = static_cast<Eigen::Index>(followers_.size());
  Eigen::VectorXd r(3 + count);
  r.head<3>() = opening(values) / kLengthUnit;
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto f = index(followers_[static_cast<std::size_t>(k)]);
    const JointSpring& spring = tree_.joints[f].spring;
    const double pull = stiffest_ > 0.0 ? std::sqrt(spring.stiffness / stiffest_) : 0.0;
    r[3 + k] = pull > 0.0 ? kSpringWeight * pull * (values[f] - spring.rest)
                          : kStayWeight * (values[f] - from[f]);
  }
  return r;
}

double LoopSolver::close(std::vector<double>& values) const {
  const std::vector<double> from = values;
  const auto count = static_cast<Eigen::Index>(followers_.size());
  for (int step = 0; step < kSteps; ++step) {
    const Eigen::VectorXd r = residuals(values, from);
    Eigen::MatrixXd J(r.size(), count);
    for (Eigen::Index k = 0; k < count; ++k) {
      std::vector<double> other = values;
      other[index(followers_[static_cast<std::size_t>(k)])] += kNumericStep;
      J.col(k) = (residuals(other, from) - r) / kNumericStep;
    }
    // What is at a limit and would be pushed beyond it stays there.
    const Eigen::VectorXd slope = J.transpose() * r;
    for (Eigen::Index k = 0; k < count; ++k) {
      const auto f = index(followers_[static_cast<std::size_t>(k)]);
      const TreeJoint& joint = tree_.joints[f];
      const bool held = (values[f] <= joint.lower && slope[k] > 0.0) ||
                        (values[f] >= joint.upper && slope[k] < 0.0);
      if (held) J.col(k).setZero();
    }
    const Eigen::MatrixXd H = J.transpose() * J + 1e-12 * Eigen::MatrixXd::Identity(count, count);
    const Eigen::VectorXd way = -H.ldlt().solve(J.transpose() * r);
    double moved = 0.0;
    for (Eigen::Index k = 0; k < count; ++k) {
      const auto f = index(followers_[static_cast<std::size_t>(k)]);
      constexpr double kFarthestStep = 0.3;  // [rad or m]
      const TreeJoint& joint = tree_.joints[f];
      const double next = std::clamp(values[f] + std::clamp(way[k], -kFarthestStep, kFarthestStep),
                                     joint.lower, joint.upper);
      moved = std::max(moved, std::abs(next - values[f]));
      values[f] = next;
    }
    if (moved < 1e-10) break;
  }
  return opening(values).norm();
}

// A straight line through samples, and the largest distance from it.
struct Line {
  double slope = 0.0;
  double offset = 0.0;
  double miss = 0.0;

  double at(double x) const { return offset + slope * x; }
};

Line line_through(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  double sx = 0.0;
  double sy = 0.0;
  double sxx = 0.0;
  double sxy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sx += x[i];
    sy += y[i];
    sxx += x[i] * x[i];
    sxy += x[i] * y[i];
  }
  Line line;
  line.slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
  line.offset = (sy - line.slope * sx) / n;
  for (std::size_t i = 0; i < x.size(); ++i) {
    line.miss = std::max(line.miss, std::abs(line.at(x[i]) - y[i]));
  }
  return line;
}

// The values of the drive, and of each follower at them.
struct Course {
  std::vector<double> drive;
  std::vector<std::vector<double>> followers;
};

Line line_of(const Course& course, std::size_t follower) {
  return line_through(course.drive, course.followers[follower]);
}

// How a linkage closes further when one of its joints is stopped while the drive goes on.
struct GivingWay {
  int joint = -1;             // that is stopped, of the tree; -1: the loop leaves no freedom
  std::vector<double> ahead;  // of each follower, as Joint::ahead; 0: it does not move by that
  double miss = 0.0;          // of the straight lines [rad or m]
};

// Joints become followers of the drive. `values`: of the follower over the course.
void follow_line(int drive, const Course& course, std::size_t at, int follower,
                 const GivingWay& way, JointTree& tree) {
  TreeJoint& joint = tree.joints[index(follower)];
  const std::vector<double>& values = course.followers[at];
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const bool still = *most - *least < kStill;
  const double ahead = way.joint >= 0 && follower != way.joint ? way.ahead[at] : 0.0;
  if (still && ahead == 0.0) {
    const double value = 0.5 * (*least + *most);
    joint.X_LJ = joint.X_LJ * motion(joint, value);
    joint.type = TreeJointType::fixed;
    tree.notes.push_back("joint " + joint.name +
                         " hardly moves in its closed loop: taken as fixed");
    return;
  }
  Line line = line_of(course, at);
  if (still) line = {.slope = 0.0, .offset = 0.5 * (*least + *most), .miss = *most - *least};
  joint.mimic = Mimic{drive, line.slope, line.offset};
  joint.initial.reset();
  const std::string& leader = tree.joints[index(drive)].name;
  tree.notes.push_back(formatted(
      "joint %s follows %s in a closed loop: taken as linear, off by at most %.2g rad or m",
      joint.name.c_str(), leader.c_str(), line.miss));
  if (ahead != 0.0) {
    joint.mimic->across = way.joint;
    joint.mimic->ahead = ahead;
  } else {
    joint.lower = *least - 2.0 * line.miss;
    joint.upper = *most + 2.0 * line.miss;
  }
  if (follower == way.joint) {
    tree.notes.push_back(formatted(
        "joint %s is held by a spring in its loop: the finger closes further when it is stopped, "
        "taken as linear, off by at most %.2g rad or m",
        joint.name.c_str(), way.miss));
  } else {
    joint.spring = {};
  }
}

// The joint of the loop that is nearest to the root on the way that the drive is not on.
int first_without(const JointTree& tree, const std::set<int>& joints, const std::set<int>& of_a,
                  const std::set<int>& of_b, int drive) {
  const std::set<int>& others = of_a.contains(drive) ? of_b : of_a;
  int first = -1;
  for (const int j : joints) {
    if (!others.contains(j)) continue;
    const std::set<int> before = joints_of(tree, tree.joints[index(j)].parent);
    const bool is_first =
        std::none_of(before.begin(), before.end(), [&](int k) { return joints.contains(k); });
    if (is_first) first = j;
  }
  return first;
}

// Holds joint `held`, of the followers, where it is at each sample of the course, and moves the
// drive on to the samples beyond, in both directions, as long as the loop closes. What each
// follower then has beyond its line is, by least squares, proportional to what the held joint falls
// behind its own.
GivingWay giving_way(const Loop& loop, int drive, const std::vector<int>& followers, int held,
                     const Course& course, const JointTree& tree) {
  const auto at = std::find(followers.begin(), followers.end(), held);
  const bool sprung = std::any_of(followers.begin(), followers.end(), [&](int f) {
    return tree.joints[index(f)].spring.stiffness > 0.0;
  });
  if (at == followers.end() || !sprung) return {};
  std::vector<int> free = followers;
  free.erase(free.begin() + (at - followers.begin()));
  const LoopSolver solver(tree, loop, free);
  std::vector<Line> lines;
  for (std::size_t k = 0; k < followers.size(); ++k) lines.push_back(line_of(course, k));
  const auto own = static_cast<std::size_t>(at - followers.begin());
  std::vector<double> behind;
  std::vector<std::vector<double>> beyond(followers.size());
  for (const int step : {1, -1}) {
    for (int from = 0; from < kSamples; ++from) {
      std::vector<double> values(tree.joints.size(), 0.0);
      for (std::size_t k = 0; k < followers.size(); ++k) {
        values[index(followers[k])] = course.followers[k][index(from)];
      }
      for (int to = from + step; to >= 0 && to < kSamples; to += step) {
        values[index(drive)] = course.drive[index(to)];
        if (!(solver.close(values) < kClosed)) break;
        behind.push_back(lines[own].at(course.drive[index(to)]) - values[index(held)]);
        for (std::size_t k = 0; k < followers.size(); ++k) {
          beyond[k].push_back(values[index(followers[k])] - lines[k].at(course.drive[index(to)]));
        }
      }
    }
  }
  GivingWay way{.joint = -1, .ahead = std::vector<double>(followers.size(), 0.0)};
  for (std::size_t k = 0; k < followers.size(); ++k) {
    if (k == own || behind.empty()) continue;
    double xx = 0.0;
    double xy = 0.0;
    for (std::size_t i = 0; i < behind.size(); ++i) {
      xx += behind[i] * behind[i];
      xy += behind[i] * beyond[k][i];
    }
    if (!(std::abs(xy) > kStill * xx)) continue;
    way.joint = held;
    way.ahead[k] = xy / xx;
    for (std::size_t i = 0; i < behind.size(); ++i) {
      way.miss = std::max(way.miss, std::abs(beyond[k][i] - way.ahead[k] * behind[i]));
    }
  }
  return way;
}

// The joint whose value sets those of the loop.
int drive_of(const JointTree& tree, const std::set<int>& joints, const std::set<int>& driven) {
  for (const int j : joints) {
    if (driven.contains(j) || tree.joints[index(j)].mimic) return j;
  }
  return *joints.begin();
}

void close_loop(const Loop& loop, const std::set<int>& driven, JointTree& tree) {
  const std::set<int> of_a = joints_of(tree, loop.a);
  const std::set<int> of_b = joints_of(tree, loop.b);
  std::set<int> joints;
  std::set_symmetric_difference(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                                std::inserter(joints, joints.begin()));
  if (joints.size() < 2) return;
  const int drive = drive_of(tree, joints, driven);
  std::vector<int> followers;
  for (const int j : joints) {
    if (j != drive && !tree.joints[index(j)].mimic) followers.push_back(j);
  }
  const TreeJoint& leader = tree.joints[index(drive)];
  std::vector<double> values(tree.joints.size(), 0.0);
  for (const int f : followers) {
    values[index(f)] = std::clamp(0.0, tree.joints[index(f)].lower, tree.joints[index(f)].upper);
  }
  const LoopSolver solver(tree, loop, followers);
  Course course{.drive = {}, .followers = std::vector<std::vector<double>>(followers.size())};
  for (int i = 0; i < kSamples; ++i) {
    values[index(drive)] = leader.lower + (leader.upper - leader.lower) * i / (kSamples - 1);
    if (!(solver.close(values) < kClosed)) {
      tree.notes.push_back("a closed loop that joint " + leader.name +
                           " drives cannot be closed over its range: left out");
      return;
    }
    course.drive.push_back(values[index(drive)]);
    for (std::size_t k = 0; k < followers.size(); ++k) {
      course.followers[k].push_back(values[index(followers[k])]);
    }
  }
  const int held = first_without(tree, joints, of_a, of_b, drive);
  const GivingWay way = giving_way(loop, drive, followers, held, course, tree);
  for (std::size_t k = 0; k < followers.size(); ++k) {
    follow_line(drive, course, k, followers[k], way, tree);
  }
}

}  // namespace

Pose link_in_root(const JointTree& tree, int link, const std::vector<double>& values) {
  const std::vector<int> carriers = carriers_of(tree);
  Pose X = Pose::Identity();
  for (int j = carriers[index(link)]; j >= 0; j = carriers[index(tree.joints[index(j)].parent)]) {
    const TreeJoint& joint = tree.joints[index(j)];
    X = joint.X_LJ * motion(joint, values[index(j)]) * X;
  }
  return X;
}

void close_loops(const std::vector<Loop>& loops, const std::set<int>& driven, JointTree& tree) {
  for (const Loop& loop : loops) close_loop(loop, driven, tree);
}

}  // namespace prehend
