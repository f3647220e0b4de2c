// The judges of the soak must be able to fail: one good grasp, spoilt in one way at a time.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "planner/plan/plan.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/make_scene.h"
#include "sim/shape/basic_shapes.h"
#include "tests/support/judge_plan.h"

namespace prehend {
namespace {

using test::Fault;

// A cube and all grasps of it by a jaw that plan() finds.
struct Planned {
  test::KnownScene known;
  PlanOptions options;
  PlanResult result;
};

const Planned& planned() {
  static const Planned kPlanned = [] {
    Planned made;
    made.known.scene = make_scene(
        make_graspable("cube", make_box({0.05, 0.05, 0.05}), Material::plastic), "parallel_jaw");
    for (const Material material : kAll<Material>) {
      made.known.friction[std::string(name_of(material))] =
          FrictionTable().between(Material::plastic, material);
    }
    made.options.trial.contacts = ContactKind::hard;
    made.known.options = made.options.trial;
    made.result = plan(compile(made.known.scene), made.options);
    return made;
  }();
  return kPlanned;
}

std::vector<std::string> kinds_of(const std::vector<Fault>& faults) {
  std::vector<std::string> kinds;
  for (const Fault& fault : faults) kinds.push_back(fault.kind);
  kinds.erase(std::unique(kinds.begin(), kinds.end()), kinds.end());
  return kinds;
}

class SpoiltGrasp : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_GE(planned().result.grasps.size(), 2U);
    trial_ = planned().result.grasps.front().trial;
    known_.most_facets = 100;
  }

  std::vector<std::string> judged() const {
    const test::Surroundings around(known_.scene);
    return kinds_of(test::GraspJudge(known_, around, trial_).judge().faults);
  }

  // The kind of the first fault, "" without one.
  std::string first_kind() const {
    const std::vector<std::string> kinds = judged();
    return kinds.empty() ? "" : kinds.front();
  }

  using Kinds = std::vector<std::string>;
  // With bounds of the exact epsilon only, where a test is not about it.
  test::KnownScene known_ = planned().known;
  Trial trial_;
};

TEST_F(SpoiltGrasp, IsGoodAsItIs) {
  EXPECT_EQ(judged(), Kinds{});
  known_ = planned().known;
  EXPECT_EQ(judged(), Kinds{});
}

TEST_F(SpoiltGrasp, AHandInsideTheObjectIsSeen) {
  // The plates 1 mm farther together.
  for (std::size_t j = 0; j < trial_.joints.size(); ++j) {
    const DegreeOfFreedom& dof = known_.scene.hand.dofs[0];
    const Joint& joint = known_.scene.hand.joints[j];
    trial_.joints[j] += std::copysign(1e-3, joint.ratio * dof.closing_velocity);
  }
  const test::Surroundings around(known_.scene);
  const test::GraspJudgement judgement = test::GraspJudge(known_, around, trial_).judge();
  ASSERT_FALSE(judgement.faults.empty());
  EXPECT_EQ(judgement.faults.front().kind, "penetration");
  EXPECT_NEAR(judgement.penetration, 1e-3, 1e-4);  // less the gap
}

TEST_F(SpoiltGrasp, AHandInAWallIsSeen) {
  const Pose X_WH = known_.scene.object.X_WO * trial_.X_OH;
  add_obstacle(known_.scene, "wall", make_box({0.5, 0.5, 0.002}), X_WH);
  EXPECT_EQ(judged(), Kinds{"penetration"});
}

TEST_F(SpoiltGrasp, AHandInsideABoxIsSeen) {
  add_obstacle(known_.scene, "cave", make_box({2.0, 2.0, 2.0}));
  EXPECT_EQ(judged(), Kinds{"penetration"});
}

TEST_F(SpoiltGrasp, AJointBeyondItsLimitIsSeen) {
  const Joint& joint = known_.scene.hand.joints.front();
  trial_.joints.front() = joint.upper + 1e-6;
  EXPECT_EQ(first_kind(), "limits");
}

TEST_F(SpoiltGrasp, ValuesThatAreMissingAreSeen) {
  trial_.joints.pop_back();
  EXPECT_EQ(judged(), Kinds{"limits"});
}

TEST_F(SpoiltGrasp, AContactOffTheSurfaceIsSeen) {
  Contact& point = trial_.contacts.front().point;
  point.position -= 3e-4 * point.normal;
  EXPECT_EQ(first_kind(), "contact");
}

TEST_F(SpoiltGrasp, AContactOfAnotherLinkIsSeen) {
  // The contact that is farthest from the last one's link: where two links meet, one is of both.
  const GraspContact& last = trial_.contacts.back();
  const auto farther = [&](const GraspContact& a, const GraspContact& b) {
    return (a.point.position - last.point.position).norm() <
           (b.point.position - last.point.position).norm();
  };
  GraspContact& moved = *std::max_element(trial_.contacts.begin(), trial_.contacts.end(), farther);
  ASSERT_NE(index(moved.link), index(last.link));
  moved.link = last.link;
  const std::vector<std::string> kinds = judged();
  EXPECT_TRUE(std::find(kinds.begin(), kinds.end(), "contact") != kinds.end());
}

TEST_F(SpoiltGrasp, ANormalThatPointsOutwardIsSeen) {
  // In the middle of the region of contact: at the cube's edge neither side of the face is inside.
  Contact& point = trial_.contacts.front().point;
  Vector3 sum = Vector3::Zero();
  int corners = 0;
  for (const GraspContact& other : trial_.contacts) {
    if (other.link != trial_.contacts.front().link) continue;
    sum += other.point.position;
    ++corners;
  }
  point.position = sum / corners;
  point.normal = -point.normal;
  EXPECT_EQ(first_kind(), "contact");
}

TEST_F(SpoiltGrasp, ANormalThatIsNotUnitIsSeen) {
  trial_.contacts.front().point.normal *= 1.0 + 1e-6;
  EXPECT_EQ(first_kind(), "contact");
}

TEST_F(SpoiltGrasp, OtherFrictionIsSeen) {
  trial_.contacts.front().point.friction *= 1.0 + 1e-12;
  EXPECT_EQ(first_kind(), "friction");
}

TEST_F(SpoiltGrasp, ASoftContactOfHardFingersIsSeen) {
  trial_.contacts.front().point.model = ContactModel::soft_finger;
  EXPECT_EQ(first_kind(), "friction");
}

TEST_F(SpoiltGrasp, AnotherEpsilonIsSeen) {
  for (const double factor : {1.0 - 1e-8, 1.0 + 1e-8}) {
    SetUp();
    known_ = planned().known;
    trial_.epsilon.lower *= factor;
    trial_.epsilon.upper *= factor;
    EXPECT_EQ(judged(), Kinds{"epsilon"}) << factor;
  }
}

TEST_F(SpoiltGrasp, StableWithoutForceClosureIsSeen) {
  trial_.epsilon = {};
  EXPECT_EQ(judged(), Kinds{"epsilon"});
}

TEST_F(SpoiltGrasp, ForceClosureOfAFlatSetIsSeen) {
  trial_.contacts.resize(1);
  EXPECT_EQ(judged(), Kinds{"epsilon"});
}

class SpoiltPlan : public testing::Test {
 protected:
  std::vector<std::string> judged() const {
    return kinds_of(test::judge_plan(result_, planned().options, std::nullopt));
  }

  using Kinds = std::vector<std::string>;
  PlanResult result_ = planned().result;
};

TEST_F(SpoiltPlan, IsGoodAsItIs) { EXPECT_EQ(judged(), Kinds{}); }

TEST_F(SpoiltPlan, AnotherOrderIsSeen) {
  std::swap(result_.grasps.front(), result_.grasps.back());
  EXPECT_EQ(judged(), Kinds{"rank"});
}

TEST_F(SpoiltPlan, TheSameGraspTwiceIsSeen) {
  result_.grasps.back() = result_.grasps[result_.grasps.size() - 2];
  EXPECT_EQ(judged(), Kinds{"rank"});
}

TEST_F(SpoiltPlan, AGraspThatIsNotStableIsSeen) {
  result_.grasps.back().trial.outcome = Outcome::no_contact;
  EXPECT_EQ(judged(), Kinds{"rank"});
}

TEST_F(SpoiltPlan, AMissingVolumeIsSeen) {
  result_.grasps.back().volume.reset();
  EXPECT_EQ(judged(), Kinds{"rank"});
}

TEST_F(SpoiltPlan, ALostTrialIsSeen) {
  result_.tried.pop_back();
  EXPECT_EQ(judged(), Kinds{"counts"});
}

TEST_F(SpoiltPlan, ATrialBlockedByNobodyIsSeen) {
  --result_.outcomes[result_.tried.front().outcome];
  ++result_.outcomes[Outcome::hand_blocked];
  result_.tried.front().outcome = Outcome::hand_blocked;
  result_.tried.front().collision_of = {};
  EXPECT_EQ(judged(), Kinds{"counts"});
}

}  // namespace
}  // namespace prehend
