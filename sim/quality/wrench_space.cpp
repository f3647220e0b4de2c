#include "sim/quality/wrench_space.h"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "sim/quality/suction_cup.h"

// Support functions of the grasp wrench space (Ferrari and Canny 1992, section 3). The support
// function of a convex hull of sets is the largest of theirs, that of a Minkowski sum of sets is
// the sum of theirs. The two norms of the normal forces lead to one of the two each, and no point
// of the space has to be enumerated: the Minkowski sum of n pyramids with k edges has up to k^n
// points.
namespace prehend {
namespace {

// The wrenches of one contact with a unit normal force: the wrench of the normal force plus those
// of a disc of tangential forces (for a soft finger, an ellipsoid of tangential force and torque).
class QuadraticCone {
 public:
  QuadraticCone(const Contact& contact, const WrenchFrame& frame)
      : normal_(contact.normal.normalized()),
        arm_(frame.torque_scale * (contact.position - frame.torque_origin)),
        friction_(contact.model == ContactModel::frictionless ? 0.0 : contact.friction),
        torsion_(contact.model == ContactModel::soft_finger ? frame.torque_scale * contact.torsion
                                                            : 0.0),
        tangents_(contact_tangents(normal_)) {
    if (contact.model != ContactModel::suction) return;
    cup_ = contact;
    frame_ = frame;
  }

  // Maximises direction . wrench, which is linear in the force f and the torque t about the normal:
  //   direction . wrench = f . pull + t (turning . normal),   pull = head + turning x arm.
  // The farthest point of the disc (ellipsoid) is the one along the gradient, which is the
  // tangential part of `pull`, and `twist`, in units in which the ellipsoid is a ball. It is put
  // together from the tangents: where nothing but rounding is left of the tangential part, this is
  // still a force of the disc, which pull minus its part along the normal would not be.
  Wrench support(const Wrench& direction) const {
    if (cup_) return cup_support(*cup_, frame_, direction);
    const Eigen::Vector3d turning = direction.tail<3>();
    const Eigen::Vector3d pull = direction.head<3>() + turning.cross(arm_);
    const double along_first = pull.dot(tangents_.first);
    const double along_second = pull.dot(tangents_.second);
    const double twist = torsion_ * turning.dot(normal_);
    const double length = std::hypot(along_first, along_second, twist);
    Eigen::Vector3d force = normal_;
    double torque = 0.0;
    if (length > 0.0) {
      force +=
          friction_ / length * (along_first * tangents_.first + along_second * tangents_.second);
      torque = friction_ * torsion_ * twist / length;
    }
    Wrench wrench;
    wrench << force, arm_.cross(force) + torque * normal_;
    return wrench;
  }

 private:
  Eigen::Vector3d normal_;
  Eigen::Vector3d arm_;
  double friction_;
  double torsion_;
  Tangents tangents_;
  std::optional<Contact> cup_;  // a suction cup, and the frame of its wrenches
  WrenchFrame frame_;
};

// The convex hull of several sets, with the origin or without. Its support point is the farthest of
// theirs.
template <typename Set>
class HullOf final : public SupportMap {
 public:
  HullOf(std::vector<Set> sets, UnitForce force) : sets_(std::move(sets)), force_(force) {}

  Wrench support(const Wrench& direction) const override {
    Wrench best = Wrench::Zero();
    double value = force_ == UnitForce::at_most ? 0.0 : -std::numeric_limits<double>::infinity();
    for (const Set& set : sets_) {
      const Wrench point = set.support(direction);
      const double reached = direction.dot(point);
      if (reached > value) {
        value = reached;
        best = point;
      }
    }
    return best;
  }

 private:
  std::vector<Set> sets_;
  UnitForce force_;
};

// The Minkowski sum of several sets, each with the origin or without. Its support point is the sum
// of theirs; a set with the origin adds nothing where its own point lies behind the origin.
template <typename Set>
class SumOf final : public SupportMap {
 public:
  SumOf(std::vector<Set> sets, UnitForce force) : sets_(std::move(sets)), force_(force) {}

  Wrench support(const Wrench& direction) const override {
    Wrench sum = Wrench::Zero();
    for (const Set& set : sets_) {
      const Wrench point = set.support(direction);
      if (force_ == UnitForce::exactly || direction.dot(point) > 0.0) sum += point;
    }
    return sum;
  }

 private:
  std::vector<Set> sets_;
  UnitForce force_;
};

template <typename Set>
std::unique_ptr<SupportMap> combine(std::vector<Set> sets, const WrenchSpaceOptions& options) {
  if (options.norm == WrenchNorm::l1) {
    return std::make_unique<HullOf<Set>>(std::move(sets), options.force);
  }
  return std::make_unique<SumOf<Set>>(std::move(sets), options.force);
}

// The columns of all contacts, and the origin where forces may be smaller.
Wrenches l1_columns(std::span<const Contact> contacts, const WrenchFrame& frame,
                    const WrenchSpaceOptions& options) {
  Wrenches columns = contact_wrenches(contacts, frame, options.edges);
  if (options.force == UnitForce::at_most) {
    columns.conservativeResize(Eigen::NoChange, columns.cols() + 1);
    columns.rightCols<1>().setZero();
  }
  return columns;
}

}  // namespace

std::unique_ptr<SupportMap> wrench_space(std::span<const Contact> contacts,
                                         const WrenchFrame& frame,
                                         const WrenchSpaceOptions& options) {
  check_contacts(contacts, frame);
  if (options.cone == FrictionCone::exact) {
    std::vector<QuadraticCone> cones;
    for (const Contact& contact : contacts) cones.emplace_back(contact, frame);
    return combine(std::move(cones), options);
  }
  if (options.norm == WrenchNorm::l1) {
    return std::make_unique<ColumnSupport>(l1_columns(contacts, frame, options));
  }
  std::vector<ColumnSupport> pyramids;
  for (const Contact& contact : contacts) {
    pyramids.emplace_back(contact_wrenches({&contact, 1}, frame, options.edges));
  }
  return combine(std::move(pyramids), options);
}

EpsilonOptions epsilon_options(const WrenchSpaceOptions& space) {
  if (space.cone == FrictionCone::pyramid) return {};
  // Smooth sets: every further digit takes many times as many facets as the one before. Steps of
  // descent lower the upper bound without facets.
  return {.relative_tolerance = 1e-2, .max_facets = 20000, .descent_steps = 12};
}

EpsilonBracket grasp_epsilon(std::span<const Contact> contacts, const WrenchFrame& frame,
                             const WrenchSpaceOptions& space, const EpsilonOptions& options) {
  // A hull of columns: epsilon_l1 accepts columns of any size, and has the full hull where the
  // search stalls. The origin is not added to the columns: where it is inside the hull it changes
  // nothing, and where it is not, epsilon is 0 either way.
  if (space.norm == WrenchNorm::l1 && space.cone == FrictionCone::pyramid) {
    return epsilon_l1(contact_wrenches(contacts, frame, space.edges), options);
  }
  const std::unique_ptr<SupportMap> set = wrench_space(contacts, frame, space);
  return contacts.empty() ? EpsilonBracket{} : epsilon(*set, options);
}

EpsilonBracket grasp_epsilon(std::span<const Contact> contacts, const WrenchFrame& frame,
                             const WrenchSpaceOptions& space) {
  return grasp_epsilon(contacts, frame, space, epsilon_options(space));
}

}  // namespace prehend
