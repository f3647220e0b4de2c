#include "sim/manipulation/base_motion.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/base/random.h"

namespace prehend {
namespace {

constexpr double kStep = 1e-3;

// The motions of a phase are smooth: from rest to rest, without a jump of the velocity.
TEST(BaseMotion, StartsAndEndsAtRest) {
  Random random(4);
  const BaseStart start{random.pose(0.5), random.direction(), 0.3};
  for (const PhaseKind kind : kAll<PhaseKind>) {
    const ProcedurePhase phase{.kind = kind, .duration = 1.5, .amplitude = 0.04, .frequency = 2.0};
    Vector3 velocity = Vector3::Zero();
    Pose at = start.X_WH;
    for (int k = 1; k <= 1500; ++k) {
      const Pose next = base_pose(phase, start, k * kStep);
      const Vector3 now = (next.translation() - at.translation()) / kStep;
      EXPECT_LT((now - velocity).norm() / kStep, 25.0);
      EXPECT_LT((next.linear() - at.linear()).norm() / kStep, 2.0);
      velocity = now;
      at = next;
    }
    EXPECT_LT(velocity.norm(), 1e-3);
    const double rise = kind == PhaseKind::lift ? 0.3 : 0.0;
    EXPECT_LT((at.translation() - start.X_WH.translation() - rise * Vector3::UnitZ()).norm(), 1e-9);
    EXPECT_LT((at.linear() - start.X_WH.linear()).norm(), 1e-9);
  }
}

TEST(BaseMotion, ReachesItsAmplitude) {
  const BaseStart start{Pose::Identity(), Vector3::UnitY(), 0.0};
  const double quarter = 0.5 + 0.125;
  const ProcedurePhase swing{
      .kind = PhaseKind::swing, .duration = 2.0, .amplitude = 0.04, .frequency = 2.0};
  EXPECT_LT((base_pose(swing, start, quarter).translation() - Vector3(0, 0.04, 0)).norm(), 1e-12);
  ProcedurePhase turn = swing;
  turn.kind = PhaseKind::turn;
  const Eigen::AngleAxisd turned(Matrix3(base_pose(turn, start, quarter).linear()));
  EXPECT_NEAR(turned.angle(), 0.04, 1e-12);
  EXPECT_NEAR(turned.axis().y(), 1.0, 1e-9);
  ProcedurePhase circle = swing;
  circle.kind = PhaseKind::circle;
  EXPECT_NEAR(base_pose(circle, start, quarter).translation().norm(), 0.04, 1e-12);
}

}  // namespace
}  // namespace prehend
