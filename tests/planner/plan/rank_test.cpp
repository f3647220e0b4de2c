#include "planner/plan/rank.h"

#include <gtest/gtest.h>

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

TEST(Rank, AtMostTop) {
  std::vector<Trial> trials;
  for (int i = 0; i < 20; ++i) trials.push_back(stable_at({1.0 * i, 0, 0}, 0.1));
  EXPECT_EQ(rank(trials, {.top = 7}).size(), 7U);
}

}  // namespace
}  // namespace prehend
