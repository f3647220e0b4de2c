#include "planner/plan/rank.h"

#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "sim/robot/robot.h"

namespace prehend {
namespace {

Trial stable_at(const Vector3& p, double epsilon) {
  Trial trial;
  trial.outcome = Outcome::stable;
  trial.X_OH = translation(p);
  trial.epsilon.lower = trial.epsilon.upper = epsilon;
  return trial;
}

TEST(Rank, LargestEpsilonFirst) {
  const std::vector<Trial> trials = {stable_at({0, 0, 0}, 0.1), stable_at({1, 0, 0}, 0.3),
                                     stable_at({2, 0, 0}, 0.2)};
  EXPECT_EQ(rank(trials, {}), (std::vector<std::size_t>{1, 2, 0}));
}

TEST(Rank, EqualEpsilonKeepsTheOrderOfCandidates) {
  const std::vector<Trial> trials = {stable_at({0, 0, 0}, 0.2), stable_at({1, 0, 0}, 0.2)};
  EXPECT_EQ(rank(trials, {}), (std::vector<std::size_t>{0, 1}));
}

TEST(Rank, OnlyStableTrialsCount) {
  std::vector<Trial> trials = {stable_at({0, 0, 0}, 0.2), stable_at({1, 0, 0}, 0.9)};
  trials[1].outcome = Outcome::not_force_closure;
  EXPECT_EQ(rank(trials, {}), (std::vector<std::size_t>{0}));
}

TEST(Rank, TheBetterStandsForNearIdenticalGrasps) {
  const std::vector<Trial> trials = {stable_at({0, 0, 0}, 0.2), stable_at({0.005, 0, 0}, 0.3),
                                     stable_at({0.05, 0, 0}, 0.1)};
  EXPECT_EQ(rank(trials, {.same_distance = 0.01}), (std::vector<std::size_t>{1, 2}));
}

TEST(Rank, ATurnedHandAtTheSamePlaceIsAnotherGrasp) {
  std::vector<Trial> trials = {stable_at({0, 0, 0}, 0.2), stable_at({0, 0, 0}, 0.3)};
  trials[0].X_OH.rotate(Eigen::AngleAxisd(0.4, Vector3::UnitZ()));
  EXPECT_EQ(rank(trials, {.same_angle = 0.35}).size(), 2U);
  EXPECT_EQ(rank(trials, {.same_angle = 0.45}).size(), 1U);
}

TEST(Rank, GraspsThatTouchAtTheSamePointsAreOne) {
  std::vector<Trial> trials = {stable_at({0, 0, 0}, 0.2), stable_at({0, 0, 0}, 0.2)};
  trials[1].X_OH.rotate(Eigen::AngleAxisd(3.0, Vector3::UnitZ()));
  const auto touch = [](Trial& trial, const Vector3& p) {
    trial.contacts.push_back({link_id(0), {p, Vector3::UnitX(), 1.0}});
  };
  touch(trials[0], {0.03, 0, 0});
  touch(trials[0], {-0.03, 0, 0});
  touch(trials[1], {-0.0305, 0, 0});
  touch(trials[1], {0.03, 0, 0});
  EXPECT_EQ(rank(trials, {.same_contact = 1e-3}).size(), 1U);
  EXPECT_EQ(rank(trials, {.same_contact = 1e-4}).size(), 2U);
}

// A hand that approaches along z, from a place beside its base.
Hand hand_along_z() {
  Hand hand;
  hand.approach = Vector3::UnitZ();
  hand.origin = {0.0, 0.01, 0.1};
  return hand;
}

// Two fingers that touch a plate from both sides of it, and the same with the hand half a turn
// about its approach and `shift` from there.
std::vector<Trial> exchanged_fingers(const Vector3& shift) {
  std::vector<Trial> trials = {stable_at({0.2, 0.1, 0}, 0.3), stable_at({0.2, 0.1, 0}, 0.3)};
  const Matrix3 turn = Eigen::AngleAxisd(std::numbers::pi, Vector3::UnitZ()).toRotationMatrix();
  const Vector3 origin = hand_along_z().origin;
  trials[1].X_OH = trials[1].X_OH * pose_from(turn, origin - turn * origin);
  trials[1].X_OH.pretranslate(shift);
  const auto touch = [](Trial& trial, const Vector3& p, const Vector3& n, int link) {
    trial.contacts.push_back({link_id(static_cast<std::size_t>(link)), {p, n, 1.0}});
  };
  for (const double z : {0.1, 0.11}) {
    touch(trials[0], {0.2, 0.14, z}, -Vector3::UnitY(), 0);
    touch(trials[0], {0.2, 0.08, z}, Vector3::UnitY(), 1);
    touch(trials[1], Vector3(0.2, 0.08, z) + shift, Vector3::UnitY(), 0);
  }
  // In one place fewer than before: regions of contacts are not found with the same points.
  touch(trials[1], Vector3(0.2, 0.14, 0.104) + shift, -Vector3::UnitY(), 1);
  return trials;
}

TEST(Rank, AHandWithItsFingersExchangedIsTheSame) {
  const Hand hand = hand_along_z();
  EXPECT_EQ(rank(exchanged_fingers({0, 0, 0}), {}, {}, &hand).size(), 1U);
  EXPECT_EQ(rank(exchanged_fingers({0.004, 0, 0}), {}, {}, &hand).size(), 1U);
  // Nobody said which hand it is.
  EXPECT_EQ(rank(exchanged_fingers({0, 0, 0}), {}).size(), 2U);
  // It has moved along the plate.
  EXPECT_EQ(rank(exchanged_fingers({0.02, 0, 0}), {}, {}, &hand).size(), 2U);
}

TEST(Rank, AHandThatTouchesElsewhereAfterHalfATurnIsAnother) {
  const Hand hand = hand_along_z();
  // One side with another normal.
  std::vector<Trial> trials = exchanged_fingers({0, 0, 0});
  for (GraspContact& contact : trials[1].contacts) {
    if (contact.link == link_id(0)) contact.point.normal = Vector3::UnitX();
  }
  EXPECT_EQ(rank(trials, {}, {}, &hand).size(), 2U);
  // A third finger, whose place is empty after half a turn.
  trials = exchanged_fingers({0, 0, 0});
  trials[0].contacts.push_back({link_id(2), {{0.25, 0.08, 0.1}, Vector3::UnitY(), 1.0}});
  EXPECT_EQ(rank(trials, {}, {}, &hand).size(), 2U);
  std::swap(trials[0], trials[1]);
  EXPECT_EQ(rank(trials, {}, {}, &hand).size(), 2U);
  // A quarter of a turn.
  trials = exchanged_fingers({0, 0, 0});
  trials[1].X_OH.rotate(Eigen::AngleAxisd(0.5 * std::numbers::pi, Vector3::UnitZ()));
  EXPECT_EQ(rank(trials, {}, {}, &hand).size(), 2U);
}

TEST(Rank, AtMostTop) {
  std::vector<Trial> trials;
  for (int i = 0; i < 20; ++i) trials.push_back(stable_at({1.0 * i, 0, 0}, 0.1));
  EXPECT_EQ(rank(trials, {.top = 7}).size(), 7U);
}

}  // namespace
}  // namespace prehend
