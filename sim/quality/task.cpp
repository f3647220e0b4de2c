#include "sim/quality/task.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "sim/base/input_error.h"
#include "sim/quality/forces.h"

namespace prehend {
namespace {

ForceOptions force_options(const WrenchSpaceOptions& space) {
  ForceOptions options;
  options.measure =
      space.norm == WrenchNorm::l1 ? ForceMeasure::sum_of_normals : ForceMeasure::largest_normal;
  options.cone = space.cone;
  options.edges = space.edges;
  return options;
}

// A set seen through a linear map: x is in it when axes * x is in the set.
class SeenThrough final : public SupportMap {
 public:
  SeenThrough(const SupportMap& set, const Eigen::Matrix<double, 6, 6>& axes)
      : set_(set), inverse_(axes.inverse()) {}

  Wrench support(const Wrench& direction) const override {
    return inverse_ * set_.support(inverse_.transpose() * direction);
  }

 private:
  const SupportMap& set_;
  Eigen::Matrix<double, 6, 6> inverse_;
};

struct Resist {
  std::span<const Contact> contacts;
  const WrenchFrame& frame;
  const WrenchSpaceOptions& space;

  Interval operator()(const TaskWrenches& task) const {
    if (task.wrenches.empty()) throw InputError({.field = "task", .problem = "no wrench"});
    const double unbounded = std::numeric_limits<double>::infinity();
    Interval least{unbounded, unbounded};
    for (const Wrench& wrench : task.wrenches) {
      const Resistance one = wrench_resistance(contacts, frame, wrench, force_options(space));
      least.lower = std::min(least.lower, one.lower);
      least.upper = std::min(least.upper, one.upper);
      if (least.upper <= 0.0) break;
    }
    return least;
  }

  Interval operator()(const TaskEllipsoid& task) const {
    const Eigen::FullPivLU<Eigen::Matrix<double, 6, 6>> lu(task.axes);
    if (!task.axes.allFinite() || !lu.isInvertible()) {
      throw InputError(
          {.field = "task", .problem = "the axes of the ellipsoid must be finite and independent"});
    }
    if (contacts.empty()) return {};
    const auto set = wrench_space(contacts, frame, space);
    const EpsilonBracket bracket = epsilon(SeenThrough(*set, task.axes), epsilon_options(space));
    return {bracket.lower, bracket.upper};
  }

  Interval operator()(const TaskGravity& task) const {
    const double length = task.direction.norm();
    if (!std::isfinite(length) || length <= 0.0 || !(task.weight > 0.0)) {
      throw InputError(
          {.field = "task", .problem = "gravity needs a direction and a weight above 0"});
    }
    Wrench pull = Wrench::Zero();
    pull.head<3>() = task.weight / length * task.direction;
    return (*this)(TaskWrenches{{pull}});
  }
};

}  // namespace

Interval task_resistance(std::span<const Contact> contacts, const WrenchFrame& frame,
                         const Task& task, const WrenchSpaceOptions& space) {
  check_contacts(contacts, frame);
  return std::visit(Resist{contacts, frame, space}, task);
}

Interval object_wrench_ratio(std::span<const Contact> contacts, const WrenchFrame& frame,
                             std::span<const Contact> surface, const WrenchSpaceOptions& space) {
  const Wrenches columns = contact_wrenches(surface, frame, space.edges);
  TaskWrenches task;
  for (Eigen::Index j = 0; j < columns.cols(); ++j) task.wrenches.push_back(columns.col(j));
  return task_resistance(contacts, frame, task, space);
}

}  // namespace prehend
