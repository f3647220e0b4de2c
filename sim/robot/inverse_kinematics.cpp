#include "sim/robot/inverse_kinematics.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "sim/base/index.h"
#include "sim/base/random.h"
#include "sim/robot/spherical_wrist.h"
#include "sim/robot/ur_arm.h"

namespace prehend {
namespace {

// Numerical inverse kinematics by damped least squares: in each iteration the pose errors of all
// targets are linearised in the degrees of freedom (geometric Jacobian), and the step solves
//   (J^T J + lambda I) step = J^T error,  lambda = |error|^2 / 2 + kLeastDamping
// (Sugihara, "Solvability-unconcerned inverse kinematics by the Levenberg-Marquardt method", 2011).
// The damping is large far from the target, where the linearisation is poor, and vanishes at it, so
// that convergence is fast there. Positions [m] and angles [rad] count alike in the error.

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

// Damping that remains at the solution. It keeps the equations solvable at singular postures and
// is small enough to leave convergence fast.
constexpr double kLeastDamping = 1e-9;
// Largest step of a rotary degree of freedom in one iteration [rad]: beyond about 40 degrees the
// linearisation says little, and the search would jump between branches.
constexpr double kLargestTurn = 0.7;
// A degree of freedom of a redundant robot moves away from a limit that is nearer than this part of
// its range, in at most kRelaxSteps steps.
constexpr double kNearLimit = 0.15;
constexpr int kRelaxSteps = 12;
// Random starts lie within this of the given start [rad or m]. Limits may be far wider: those of a
// mobile base can span a whole hall, and hardly any start drawn from there would converge.
constexpr double kNearby = 4.0;
// Solutions that differ by less in every degree of freedom count as the same [rad or m].
constexpr double kSame = 1e-3;

// What is to be solved: the robot, its targets, and the unknowns.
struct Task {
  const Robot& robot;
  const std::vector<IkTarget>& targets;
  std::vector<int> dofs;    // that move any target
  std::vector<bool> turns;  // whether each of those drives revolute joints
};

Task make_task(const Robot& robot, const std::vector<IkTarget>& targets) {
  Task task{robot, targets, {}, {}};
  for (const IkTarget& target : targets) {
    for (const int dof : dofs_to(robot, target.joint)) {
      if (std::find(task.dofs.begin(), task.dofs.end(), dof) == task.dofs.end()) {
        task.dofs.push_back(dof);
      }
    }
  }
  for (const int dof : task.dofs) {
    task.turns.push_back(std::any_of(
        robot.joints.begin(), robot.joints.end(),
        [&](const Joint& joint) { return joint.dof == dof && joint.type == JointType::revolute; }));
  }
  return task;
}

// The pose errors of the targets and their derivative by the degrees of freedom.
struct Linearized {
  Vector error;     // per target: translation [m], rotation [rad], base frame
  Matrix jacobian;  // a column for each of task.dofs
  double position_error = 0.0;
  double angle_error = 0.0;
};

// Axis times angle of a rotation, the angle in [0, pi].
Vector3 rotation_vector(const Matrix3& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

// Computes errors and Jacobian; keeps its memory from call to call.
class Linearizer {
 public:
  explicit Linearizer(const Task& task) : task_(task) {
    for (const IkTarget& target : task.targets) {
      paths_.push_back(joints_to(task.robot, target.joint));
    }
    column_.assign(task.robot.dofs.size(), -1);
    for (std::size_t c = 0; c < task.dofs.size(); ++c) {
      column_[index(task.dofs[c])] = static_cast<int>(c);
    }
    const auto rows = static_cast<Eigen::Index>(6 * task.targets.size());
    at_.error.resize(rows);
    at_.jacobian.resize(rows, static_cast<Eigen::Index>(task.dofs.size()));
  }

  const Linearized& operator()(const DofValues& values) {
    joint_poses(task_.robot, joint_values(task_.robot, values), X_BJ_);
    at_.jacobian.setZero();
    at_.position_error = at_.angle_error = 0.0;
    for (std::size_t t = 0; t < task_.targets.size(); ++t) add_target(t);
    return at_;
  }

 private:
  void add_target(std::size_t t) {
    const IkTarget& target = task_.targets[t];
    const auto row = static_cast<Eigen::Index>(6 * t);
    const Pose X_BT = X_BJ_[index(target.joint)] * target.X_JT;
    const Vector3 shift = target.X_BT.translation() - X_BT.translation();
    const Vector3 turn = rotation_vector(target.X_BT.linear() * X_BT.linear().transpose());
    at_.error.segment<3>(row) = shift;
    at_.error.segment<3>(row + 3) = turn;
    at_.position_error = std::max(at_.position_error, shift.norm());
    at_.angle_error = std::max(at_.angle_error, turn.norm());
    for (const int j : paths_[t]) add_joint(j, row, X_BT.translation());
  }

  // The joint's column of the geometric Jacobian for the point p_T [m, base frame], added to that
  // of its degree of freedom, which may drive several joints.
  void add_joint(int j, Eigen::Index row, const Vector3& p_T) {
    const Joint& joint = task_.robot.joints[index(j)];
    const Pose X_BF = joint.parent < 0 ? joint.X_PJ : X_BJ_[index(joint.parent)] * joint.X_PJ;
    const Vector3 axis = X_BF.linear() * joint.axis;
    auto column = at_.jacobian.col(column_[index(joint.dof)]);
    if (joint.type == JointType::prismatic) {
      column.segment<3>(row) += joint.ratio * axis;
    } else {
      column.segment<3>(row) += joint.ratio * axis.cross(p_T - X_BF.translation());
      column.segment<3>(row + 3) += joint.ratio * axis;
    }
  }

  const Task& task_;
  std::vector<std::vector<int>> paths_;
  std::vector<int> column_;  // of each degree of freedom, -1: not moved
  std::vector<Pose> X_BJ_;
  Linearized at_;
};

// True where a value is at a limit and the step would push it beyond.
bool is_stuck(const DegreeOfFreedom& dof, double value, double step) {
  return (value <= dof.lower && step < 0.0) || (value >= dof.upper && step > 0.0);
}

// The damped least-squares step inside the limits (an active-set method). Only clamping the result
// would lose the motion that blocked degrees of freedom were meant to make. Instead their columns
// are set to 0, which makes their step 0, and the equations are solved again so that the others
// take over; that may block more of them, so this repeats, at most once for each.
Vector damped_step(const Task& task, const Linearized& at, const DofValues& values) {
  const Eigen::Index n = at.jacobian.cols();
  const double damping = 0.5 * at.error.squaredNorm() + kLeastDamping;
  Matrix jacobian = at.jacobian;
  Vector step = Vector::Zero(n);
  for (Eigen::Index round = 0; round < n; ++round) {
    Matrix normal = jacobian.transpose() * jacobian;
    normal.diagonal().array() += damping;
    step = normal.ldlt().solve(jacobian.transpose() * at.error);
    bool all_free = true;
    for (Eigen::Index c = 0; c < n; ++c) {
      const int dof = task.dofs[static_cast<std::size_t>(c)];
      if (!is_stuck(task.robot.dofs[index(dof)], values[index(dof)], step[c])) continue;
      if (jacobian.col(c).isZero(0.0)) {
        step[c] = 0.0;
        continue;
      }
      jacobian.col(c).setZero();
      all_free = false;
    }
    if (all_free) break;
  }
  // The whole step is scaled, not only its largest part, so that its direction stays.
  double largest = 0.0;
  for (Eigen::Index c = 0; c < n; ++c) {
    if (task.turns[static_cast<std::size_t>(c)]) largest = std::max(largest, std::abs(step[c]));
  }
  if (largest > kLargestTurn) step *= kLargestTurn / largest;
  return step;
}

void move(const Task& task, const Vector& step, DofValues& values) {
  for (std::size_t c = 0; c < task.dofs.size(); ++c) {
    const DegreeOfFreedom& dof = task.robot.dofs[index(task.dofs[c])];
    double& value = values[index(task.dofs[c])];
    value = std::clamp(value + step[static_cast<Eigen::Index>(c)], dof.lower, dof.upper);
  }
}

// Iterates from `values` until all targets are within tolerance; false when that takes too long.
bool arrive(const Task& task, Linearizer& linearize, const IkOptions& options, DofValues& values) {
  for (int i = 0; i < options.max_iterations; ++i) {
    const Linearized& at = linearize(values);
    if (at.position_error <= options.position_tolerance &&
        at.angle_error <= options.angle_tolerance) {
      return true;
    }
    move(task, damped_step(task, at, values), values);
  }
  return false;
}

// A direction away from near limits: for each degree of freedom +-1 at a limit, falling linearly to
// 0 at kNearLimit of the range away from it.
Vector away_from_limits(const Task& task, const DofValues& values) {
  Vector push = Vector::Zero(static_cast<Eigen::Index>(task.dofs.size()));
  for (std::size_t c = 0; c < task.dofs.size(); ++c) {
    const DegreeOfFreedom& dof = task.robot.dofs[index(task.dofs[c])];
    const double value = values[index(task.dofs[c])];
    const double margin = kNearLimit * std::min(dof.upper - dof.lower, kNearby);
    if (margin <= 0.0) continue;
    const auto i = static_cast<Eigen::Index>(c);
    push[i] += std::max(0.0, 1.0 - (value - dof.lower) / margin);
    push[i] -= std::max(0.0, 1.0 - (dof.upper - value) / margin);
  }
  return push;
}

// Moves the posture of a redundant robot away from its limits without moving the targets: the push
// is projected into the null space of the Jacobian (self-motion), push - J^+ J push. The projection
// is exact to first order only, so each small step ends with iterations back onto the targets. Ends
// when a step does not arrive there again or gains no margin.
void relax(const Task& task, Linearizer& linearize, const IkOptions& options, DofValues& values) {
  if (task.dofs.size() <= 6 * task.targets.size()) return;
  for (int i = 0; i < kRelaxSteps; ++i) {
    const Vector push = away_from_limits(task, values);
    if (push.isZero(0.0)) return;
    const Matrix& jacobian = linearize(values).jacobian;
    Matrix across = jacobian * jacobian.transpose();
    across.diagonal().array() += kLeastDamping;
    const Vector free = push - jacobian.transpose() * across.ldlt().solve(jacobian * push);
    DofValues moved = values;
    move(task, 0.1 * free, moved);
    if (!arrive(task, linearize, options, moved)) return;
    if (limit_margin(task.robot, task.dofs, moved) <= limit_margin(task.robot, task.dofs, values)) {
      return;
    }
    values = moved;
  }
}

// Uniformly random values inside the limits and within kNearby of `start`.
DofValues random_start(const Task& task, const DofValues& start, Random& random) {
  DofValues values = start;
  for (const int d : task.dofs) {
    const DegreeOfFreedom& dof = task.robot.dofs[index(d)];
    const double lower = std::max(dof.lower, start[index(d)] - kNearby);
    const double upper = std::min(dof.upper, start[index(d)] + kNearby);
    values[index(d)] = lower + (upper - lower) * random.uniform();
  }
  return values;
}

// Collects different solutions, up to options.max_solutions.
class Collector {
 public:
  Collector(const Task& task, const IkOptions& options) : task_(task), options_(options) {}

  void add(const DofValues& values) {
    if (full()) return;
    const bool known = std::any_of(found_.begin(), found_.end(), [&](const DofValues& other) {
      return std::all_of(task_.dofs.begin(), task_.dofs.end(), [&](int d) {
        return std::abs(other[index(d)] - values[index(d)]) <= kSame;
      });
    });
    if (!known) found_.push_back(values);
  }

  bool full() const { return found_.size() >= static_cast<std::size_t>(options_.max_solutions); }
  bool empty() const { return found_.empty(); }

  // Sorted by the sum of the distances that the degrees of freedom move from `start`.
  std::vector<DofValues> nearest_first(const DofValues& start) {
    const auto way = [&](const DofValues& values) {
      double sum = 0.0;
      for (const int d : task_.dofs) sum += std::abs(values[index(d)] - start[index(d)]);
      return sum;
    };
    std::stable_sort(found_.begin(), found_.end(),
                     [&](const DofValues& a, const DofValues& b) { return way(a) < way(b); });
    return std::move(found_);
  }

 private:
  const Task& task_;
  const IkOptions& options_;
  std::vector<DofValues> found_;
};

// The chain whose closed form gives the target's frame, or nullptr: the target must be fixed to the
// chain's last joint, and each joint of the chain must have a degree of freedom of its own, which
// the closed form can set freely.
const Chain* closed_form_chain(const Robot& robot, int joint) {
  const Chain& chain = robot.chains[index(robot.joints[index(joint)].chain)];
  if (chain.closed_form == ClosedForm::none) return nullptr;
  if (joint != chain.first_joint + chain.joint_count - 1) return nullptr;
  for (int j = chain.first_joint; j <= joint; ++j) {
    const int dof = robot.joints[index(j)].dof;
    const auto shares = [&](const Joint& other) { return other.dof == dof; };
    if (std::count_if(robot.joints.begin(), robot.joints.end(), shares) != 1) return nullptr;
  }
  return &chain;
}

// All branches of the chain's closed form for the target. `X_BP`: the frame that carries the chain.
template <typename ClosedFormOf>
SixJointSolutions branches_of(const Robot& robot, const Chain& chain, const IkTarget& target,
                              const Pose& X_BP, const SixJoints& near) {
  const ClosedFormOf arm(robot, chain);
  const Pose X_BC = X_BP * arm.X_PC();
  return arm.solve(X_BC.inverse() * target.X_BT * target.X_JT.inverse(), near);
}

// Adds all branches of the chain's closed form that are inside the limits. The degrees of freedom
// before the chain (a rail, a mobile base) stay as in `values`.
void add_branches(const Robot& robot, const Chain& chain, const IkTarget& target,
                  const DofValues& values, Collector& found) {
  std::vector<Pose> X_BJ;
  joint_poses(robot, joint_values(robot, values), X_BJ);
  const int parent = robot.joints[index(chain.first_joint)].parent;
  const Pose X_BP = parent < 0 ? Pose::Identity() : X_BJ[index(parent)];
  SixJoints near{};
  for (std::size_t k = 0; k < near.size(); ++k) {
    const Joint& joint = robot.joints[index(chain.first_joint) + k];
    near[k] = joint.ratio * values[index(joint.dof)] + joint.offset;
  }
  const SixJointSolutions branches =
      chain.closed_form == ClosedForm::ur
          ? branches_of<UrArm>(robot, chain, target, X_BP, near)
          : branches_of<SphericalWrist>(robot, chain, target, X_BP, near);
  for (int b = 0; b < branches.count; ++b) {
    DofValues branch = values;
    bool inside = true;
    for (std::size_t k = 0; k < near.size(); ++k) {
      const Joint& joint = robot.joints[index(chain.first_joint) + k];
      const DegreeOfFreedom& dof = robot.dofs[index(joint.dof)];
      const double value = (branches.joints[index(b)][k] - joint.offset) / joint.ratio;
      // The closed form knows the limits of the joints; those of the degrees of freedom may be
      // narrower.
      inside = inside && within_limits(dof, value);
      branch[index(joint.dof)] = std::clamp(value, dof.lower, dof.upper);
    }
    if (inside) found.add(branch);
  }
}

}  // namespace

std::vector<int> dofs_to(const Robot& robot, int joint) {
  std::vector<int> dofs;
  for (const int j : joints_to(robot, joint)) {
    const int dof = robot.joints[index(j)].dof;
    if (std::find(dofs.begin(), dofs.end(), dof) == dofs.end()) dofs.push_back(dof);
  }
  return dofs;
}

double limit_margin(const Robot& robot, const std::vector<int>& dofs, const DofValues& values) {
  double margin = 1.0;
  for (const int d : dofs) {
    const DegreeOfFreedom& dof = robot.dofs[index(d)];
    const double half = 0.5 * (dof.upper - dof.lower);
    const double nearest = std::min(values[index(d)] - dof.lower, dof.upper - values[index(d)]);
    margin = std::min(margin, half > 0.0 ? nearest / half : 0.0);
  }
  return margin;
}

std::optional<DofValues> solve_near(const Robot& robot, const std::vector<IkTarget>& targets,
                                    const DofValues& start, const IkOptions& options) {
  const Task task = make_task(robot, targets);
  Linearizer linearize(task);
  DofValues values = start;
  if (!arrive(task, linearize, options, values)) return std::nullopt;
  return values;
}

std::vector<DofValues> solve_all(const Robot& robot, const std::vector<IkTarget>& targets,
                                 const DofValues& start, const IkOptions& options,
                                 const RunContext& context) {
  const Task task = make_task(robot, targets);
  const Chain* chain = targets.size() == 1 ? closed_form_chain(robot, targets[0].joint) : nullptr;
  Collector found(task, options);
  if (chain != nullptr && task.dofs.size() == 6) {
    add_branches(robot, *chain, targets[0], start, found);
    return found.nearest_first(start);
  }
  Linearizer linearize(task);
  Random random(options.seed);
  const bool redundant = task.dofs.size() > 6 * targets.size();
  for (int i = 0; i <= options.restarts && !found.full(); ++i) {
    context.cancellation.check();
    // Without redundancy there are finitely many solutions and most starts lead to the same ones,
    // so a quarter of the restarts is enough once one was found. A redundant robot has infinitely
    // many: there all restarts are used, to spread the solutions.
    if (!redundant && !found.empty() && i > options.restarts / 4) break;
    DofValues values = i == 0 ? start : random_start(task, start, random);
    if (!arrive(task, linearize, options, values)) continue;
    relax(task, linearize, options, values);
    found.add(values);
    if (chain != nullptr) add_branches(robot, *chain, targets[0], values, found);
  }
  return found.nearest_first(start);
}

}  // namespace prehend
