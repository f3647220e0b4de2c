#include "sim/quality/task.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <Eigen/LU>

#include "sim/base/input_error.h"
#include "sim/base/range.h"
#include "sim/quality/forces.h"
#include "sim/quality/ranges.h"

// How much of a task the contacts can resist is a question about the grasp wrench space, the set of
// the wrenches that forces of norm at most 1 can exert. A single wrench w is resisted k times where
// forces balance k w. The largest such k is one over the smallest norm of forces that balance w, a
// second-order cone program (wrench_resistance). A set of wrenches is resisted as well as the
// wrench that is resisted least, and so is its convex hull, since forces can be combined in the
// same way as wrenches.
//
// An ellipsoid has infinitely many extreme points and needs another way. k times the ellipsoid,
// axes * (ball of radius k), is inside the grasp wrench space exactly if the ball is inside the
// space mapped by the inverse of the axes. The largest k is therefore epsilon of the mapped space.
namespace prehend {
namespace {

// The program whose measure is the norm of the wrench space.
ForceOptions force_options(const WrenchSpaceOptions& space) {
  ForceOptions options;
  options.measure =
      space.norm == WrenchNorm::l1 ? ForceMeasure::sum_of_normals : ForceMeasure::largest_normal;
  options.cone = space.cone;
  options.edges = space.edges;
  return options;
}

// The set mapped by the inverse of `axes`: x is in it when axes * x is in the given set. Its
// support point in a direction n maximises n . inverse y = (inverse' n) . y over the points y of
// the given set: the support point of that set along inverse' n, mapped.
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

// The resistance to each kind of task.
struct Resist {
  std::span<const Contact> contacts;
  const WrenchFrame& frame;
  const WrenchSpaceOptions& space;

  Interval operator()(const TaskWrenches& task) const {
    if (task.wrenches.empty()) throw InputError({.field = "task", .problem = "no wrench"});
    bool disturbs = false;
    for (const Wrench& wrench : task.wrenches) {
      const double length = wrench.stableNorm();
      disturbs = disturbs || length > 0.0;
      // Neither holds for a length that is not a number.
      require(length == 0.0 || (length >= kSmallestTask && std::isfinite(length)),
              {.field = "task", .problem = "a wrench must be 0 or 1e-18 at least, and finite"});
    }
    require(disturbs, {.field = "task", .problem = "all wrenches are 0: resisted in any size"});
    const double unbounded = std::numeric_limits<double>::infinity();
    // The smallest of the lower bounds and of the upper bounds enclose the smallest resistance. A
    // wrench that cannot be resisted at all decides the result.
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
    // The axes are scaled to size 1, and the result back: the inverse of very short or very long
    // ones would leave the range of doubles.
    const double size = task.axes.cwiseAbs().maxCoeff();
    const bool sized = task.axes.allFinite() && size >= kSmallestTask;
    if (!sized || !Eigen::FullPivLU<Eigen::Matrix<double, 6, 6>>(task.axes / size).isInvertible()) {
      throw InputError({.field = "task",
                        .problem = "the axes of the ellipsoid must be finite and independent, the "
                                   "longest at least 1e-18"});
    }
    if (contacts.empty()) return {};
    // As for single wrenches, forces may stay below the unit.
    WrenchSpaceOptions at_most = space;
    at_most.force = UnitForce::at_most;
    const auto set = wrench_space(contacts, frame, at_most);
    const EpsilonBracket bracket =
        epsilon(SeenThrough(*set, task.axes / size), epsilon_options(at_most));
    return {bracket.lower / size, bracket.upper / size};
  }

  Interval operator()(const TaskGravity& task) const {
    const double length = task.direction.stableNorm();
    // Neither comparison holds for what is not a number.
    const auto in_range = [](double v) { return v >= kSmallestLoad && v <= kLargestLoad; };
    if (!in_range(length) || !in_range(task.weight)) {
      throw InputError({.field = "task",
                        .problem = "gravity needs a direction of a length from 1e-9 to 1e9, and a "
                                   "weight from 1e-9 to 1e9"});
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
  // Every push inside a friction pyramid is a convex combination of the pyramid's corners: to
  // resist the corners is to resist all pushes.
  check_edges(space.edges);
  std::size_t corners = 0;
  for (const Contact& contact : surface) {
    corners += static_cast<std::size_t>(pyramid_corners(contact.model, space.edges));
  }
  require(corners <= kMostPushes,
          {.field = "surface",
           .problem = "its pyramids may have " + std::to_string(kMostPushes) + " corners in all",
           .value = std::to_string(corners)});
  const Wrenches columns = contact_wrenches(surface, frame, space.edges);
  TaskWrenches task;
  for (Eigen::Index j = 0; j < columns.cols(); ++j) task.wrenches.push_back(columns.col(j));
  return task_resistance(contacts, frame, task, space);
}

}  // namespace prehend
