#include "planner/plan/rank.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "sim/base/require_settings.h"
#include "sim/robot/robot.h"

namespace prehend {
namespace {

// Ranking is greedy: from the best grasp down, a grasp is taken unless it is the same as one that
// is already taken. "The same" is not transitive, so a chain of grasps with small steps between
// them is thinned out rather than merged into one.

bool is_same_pose(const Pose& a, const Pose& b, const RankOptions& options) {
  if ((a.translation() - b.translation()).norm() > options.same_distance) return false;
  // The angle of the rotation from one pose to the other, R_a^T R_b.
  const Eigen::AngleAxisd turn(a.linear().transpose() * b.linear());
  return std::abs(turn.angle()) <= options.same_angle;
}

using Contacts = std::vector<GraspContact>;

bool touches_near(const Contacts& contacts, const Vector3& position, double distance) {
  return std::any_of(contacts.begin(), contacts.end(), [&](const GraspContact& contact) {
    return (contact.point.position - position).norm() <= distance;
  });
}

// Whether both have equally many contacts and each of `a` has one of `b` near it. Links are not
// compared, so that a hand with its fingers exchanged counts as the same grasp.
bool are_same_contacts(const Contacts& a, const Contacts& b, double distance) {
  return !a.empty() && a.size() == b.size() &&
         std::all_of(a.begin(), a.end(), [&](const GraspContact& contact) {
           return touches_near(b, contact.point.position, distance);
         });
}

// How much farther contacts may be apart than the poses of hands that count as the same: a hand
// that turns moves what is far from its base by more than that.
constexpr double kContactsToPoses = 2.0;

// Whether each contact of `a` has one of `b` near it, with nearly the same normal.
bool touches_where(const Contacts& a, const Contacts& b, const RankOptions& options) {
  const double least = std::cos(kContactsToPoses * options.same_angle);
  return std::all_of(a.begin(), a.end(), [&](const GraspContact& of_a) {
    return std::any_of(b.begin(), b.end(), [&](const GraspContact& of_b) {
      return (of_a.point.position - of_b.point.position).norm() <=
                 kContactsToPoses * options.same_distance &&
             of_a.point.normal.dot(of_b.point.normal) >= least;
    });
  });
}

// The pose of the hand half a turn about its approach, frame H.
Pose half_turn(const Hand& hand) {
  const Matrix3 turn =
      Eigen::AngleAxisd(std::numbers::pi, hand.approach.normalized()).toRotationMatrix();
  return pose_from(turn, hand.origin - turn * hand.origin);
}

// Whether the hand has changed its fingers for each other, and is where it was otherwise. That this
// is the same to the object shows in the contacts: other hands touch elsewhere then.
bool is_twin(const Trial& a, const Trial& b, const Pose& X_HT, const RankOptions& options) {
  return is_same_pose(a.X_OH, b.X_OH * X_HT, options) && !a.contacts.empty() &&
         !b.contacts.empty() && touches_where(a.contacts, b.contacts, options) &&
         touches_where(b.contacts, a.contacts, options);
}

bool is_same(const Trial& a, const Trial& b, const RankOptions& options) {
  return is_same_pose(a.X_OH, b.X_OH, options) ||
         are_same_contacts(a.contacts, b.contacts, options.same_contact);
}

}  // namespace

std::vector<std::size_t> rank(const std::vector<Trial>& trials, const RankOptions& options,
                              const std::function<bool(std::size_t)>& wanted, const Hand* hand) {
  require_settings(options);
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (trials[i].outcome == Outcome::stable && (!wanted || wanted(i))) order.push_back(i);
  }
  // Trials are in the order of their candidates, which the stable sort keeps for equal epsilons.
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (trials[a].preferred != trials[b].preferred) return trials[a].preferred;
    return trials[a].epsilon.lower > trials[b].epsilon.lower;
  });
  const std::optional<Pose> X_HT = hand ? std::optional(half_turn(*hand)) : std::nullopt;
  std::vector<std::size_t> ranked;
  for (std::size_t i : order) {
    if (ranked.size() >= static_cast<std::size_t>(options.top)) break;
    const bool known = std::any_of(ranked.begin(), ranked.end(), [&](std::size_t better) {
      return is_same(trials[better], trials[i], options) ||
             (X_HT && is_twin(trials[better], trials[i], *X_HT, options));
    });
    if (!known) ranked.push_back(i);
  }
  return ranked;
}

}  // namespace prehend
