#include "sim/motion/control/time_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "tests/sim/motion/control/timed_path_checks.h"

namespace prehend {
namespace {

using test::expect_kept;
using test::interpolated;
using test::limited_part;
using test::Points;
using test::SineCurve;
using test::smoothed_time;
using test::trapezoid_position;
using test::trapezoid_time;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Points random_corners(Random& random, std::size_t joints) {
  Points points(2 + random.index(8), std::vector<double>(joints));
  for (std::vector<double>& q : points) {
    for (double& value : q) value = random.uniform(-3.0, 3.0);
  }
  return points;
}

TEST(TimeCorners, ShortLineIsATriangleOfSpeed) {
  for (const double distance : {1e-6, 1e-3, 0.1, 0.4}) {
    const JointLimits limits{{2.0}, {10.0}};
    const TimedPath path = time_path({{1.0}, {1.0 - distance}}, PathKind::corners, limits);
    EXPECT_NEAR(path.times.back() / smoothed_time(2.0 * std::sqrt(distance / 10.0)), 1.0, 1e-9)
        << distance;
    expect_kept(path, {{1.0}, {1.0 - distance}}, limits);
  }
}

TEST(TimeCorners, LongLineIsATrapezoidOfSpeed) {
  for (const double distance : {0.41, 1.0, 30.0}) {
    const JointLimits limits{{2.0}, {10.0}};
    const TimedPath path = time_path({{0.0}, {distance}}, PathKind::corners, limits);
    EXPECT_NEAR(path.times.back(), smoothed_time(distance / 2.0 + 2.0 / 10.0), 1e-9) << distance;
    expect_kept(path, {{0.0}, {distance}}, limits);
  }
}

// The second joint, of which a third of the way is asked, limits the speed; the first the ramps.
TEST(TimeCorners, EachLimitComesFromTheTightestJoint) {
  const JointLimits limits{{9.0, 0.5}, {4.0, 100.0}};
  const TimedPath path = time_path({{0.0, 0.0}, {3.0, 1.0}}, PathKind::corners, limits);
  EXPECT_NEAR(path.times.back(), smoothed_time(3.0 / 1.5 + 1.5 / 4.0), 1e-12);
}

// Basis functions of the uniform cubic B-spline, over the trapezoid at equal steps of time.
TEST(TimeCorners, CubicsBetweenSamplesAreTheSmoothedTrapezoid) {
  for (const double distance : {0.0003, 0.4, 0.4000001, 1.7}) {
    const TimedPath path = time_path({{0.0}, {distance}}, PathKind::corners, {{2.0}, {10.0}});
    const double step = path.times[1];
    const double end = trapezoid_time(distance, 2.0, 10.0);
    const auto control = [&](int k) {
      return k <= 0 ? 0.0 : trapezoid_position(std::min(step * k, end), distance, 2.0, 10.0);
    };
    for (std::size_t i = 1; i < path.times.size(); ++i) {
      const int k = static_cast<int>(i) - 3;
      for (const double t : {0.0, 0.2, 0.5, 0.9}) {
        const double r = 1.0 - t;
        const double expected =
            (r * r * r * control(k) + (4.0 - 6.0 * t * t + 3.0 * t * t * t) * control(k + 1) +
             (4.0 - 6.0 * r * r + 3.0 * r * r * r) * control(k + 2) + t * t * t * control(k + 3)) /
            6.0;
        ASSERT_NEAR(interpolated(path, i, t)[0], expected, 1e-9 * distance) << distance << ' ' << i;
      }
    }
  }
}

// A line that just reaches full speed has no cruise of a picosecond, over which rounding would
// show.
TEST(TimeCorners, NoStepIsTooShortForItsDifferences) {
  for (const double over : {1e-15, 1e-12, 1e-9}) {
    const double distance = 0.4 * (1.0 + over);
    const JointLimits limits{{2.0}, {10.0}};
    const TimedPath path = time_path({{0.0}, {distance}}, PathKind::corners, limits);
    expect_kept(path, {{0.0}, {distance}}, limits);
    for (std::size_t i = 1; i < path.times.size(); ++i) {
      ASSERT_GE(path.times[i] - path.times[i - 1], 1e-7) << over;
    }
  }
}

TEST(TimeCorners, RandomPathsStopAtEachCornerAndKeepTheLimits) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Random random(seed);
    const Points points = random_corners(random, 6);
    JointLimits limits;
    for (int j = 0; j < 6; ++j) {
      limits.velocity.push_back(random.uniform(0.1, 5.0));
      limits.acceleration.push_back(random.uniform(0.1, 50.0));
    }
    const TimedPath path = time_path(points, PathKind::corners, limits);
    expect_kept(path, points, limits);
    std::size_t next = 0;
    for (std::size_t i = 0; i < path.times.size(); ++i) {
      if (path.velocities[i] != std::vector<double>(6, 0.0)) continue;
      ASSERT_LT(next, points.size()) << seed;
      EXPECT_EQ(path.positions[i], points[next++]) << seed;
    }
    EXPECT_EQ(next, points.size()) << seed;
    EXPECT_GE(limited_part(path, limits), 0.85) << seed;
  }
}

TEST(TimeSmooth, StraightLineIsATrapezoid) {
  for (const int count : {2, 3, 60}) {
    for (const double distance : {0.2, 2.0}) {
      Points points;
      for (int i = 0; i < count; ++i) {
        const double q = distance * i / (count - 1);
        points.push_back({q, 1.0 - 0.5 * q});
      }
      const JointLimits limits{{2.0, 5.0}, {10.0, 50.0}};
      const TimedPath path = time_path(points, PathKind::smooth, limits);
      // The switch from speeding up to braking falls between two of 2000 stations.
      EXPECT_NEAR(path.times.back() / smoothed_time(trapezoid_time(distance, 2.0, 10.0)), 1.0, 1e-3)
          << count;
      expect_kept(path, points, limits);
    }
  }
}

// However its waypoints are spaced, one joint on its own takes the trapezoid.
TEST(TimeSmooth, SpacingOfWaypointsDoesNotMatter) {
  Points points;
  for (int i = 0; i <= 40; ++i) points.push_back({std::pow(i / 40.0, 3.0)});
  const TimedPath path = time_path(points, PathKind::smooth, {{2.0}, {10.0}});
  EXPECT_NEAR(path.times.back(), smoothed_time(trapezoid_time(1.0, 2.0, 10.0)), 2e-3);
}

// There and back: at the turn the joint stands, but keeps its acceleration. The curve turns in no
// time there, but smoothed speeds do not, which costs a part of the fastest time.
TEST(TimeSmooth, PassesAReversal) {
  Points points;
  for (int i = 0; i <= 200; ++i) points.push_back({std::sin(std::numbers::pi * i / 200.0)});
  const JointLimits limits{{100.0}, {10.0}};
  const TimedPath path = time_path(points, PathKind::smooth, limits);
  expect_kept(path, points, limits);
  EXPECT_NEAR(path.times.back(), smoothed_time(4.0 * std::sqrt(1.0 / 10.0)), 0.06);
}

TEST(TimeSmooth, RandomCurvesKeepTheLimitsAndUseThem) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const SineCurve curve(seed);
    const Points points = curve.points(40 + 5 * static_cast<int>(seed));
    const TimedPath path = time_path(points, PathKind::smooth, curve.limits());
    expect_kept(path, points, curve.limits());
    EXPECT_GE(limited_part(path, curve.limits()), 0.8) << seed;
  }
}

// Samples are off by what a spline through 200 points leaves, 0.5e-6 rad; the cubics between
// samples 20 ms apart by 8e-6 rad.
TEST(TimeSmooth, StaysOnTheCurveAtSamplesAndBetweenThem) {
  double at_samples = 0.0;
  double between = 0.0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const SineCurve curve(seed);
    const TimedPath path = time_path(curve.points(200), PathKind::smooth, curve.limits());
    for (std::size_t i = 1; i < path.times.size(); ++i) {
      at_samples = std::max(at_samples, curve.distance(path.positions[i]));
      for (const double t : {0.25, 0.5, 0.75}) {
        between = std::max(between, curve.distance(interpolated(path, i, t)));
      }
    }
  }
  EXPECT_LE(at_samples, 1e-6);
  EXPECT_LE(between, 2e-5);
}

// The corner is rounded off inside the triangle that it makes with the places where the lines end;
// what is left of the lines is followed.
TEST(TimeBlended, StaysInTheTrianglesOfItsCorners) {
  const JointLimits limits{{1.0, 1.0}, {5.0, 5.0}};
  const Points corner = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 2.0}};
  constexpr double kStray = 1e-4;  // of the cubics between samples
  for (const double blend : {0.01, 0.1, 0.5, 1.0}) {
    const TimedPath path = time_blended(corner, {blend}, limits);
    expect_kept(path, corner, limits);
    const double half = 0.5 * blend;
    double nearest = 10.0;
    for (std::size_t i = 1; i < path.times.size(); ++i) {
      for (const double t : {0.0, 0.3, 0.6}) {
        const std::vector<double> q = interpolated(path, i, t);
        EXPECT_LE(q[0], 1.0 + kStray);
        EXPECT_GE(q[1], -kStray);
        // Not beyond the chord of the triangle.
        if (q[0] > 1.0 - half && q[1] < half) {
          EXPECT_LE((1.0 - q[0]) + q[1], half + kStray);
        }
        if (q[0] < 1.0 - half) {
          EXPECT_NEAR(q[1], 0.0, kStray);
        }
        if (q[1] > half) {
          EXPECT_NEAR(q[0], 1.0, kStray);
        }
        nearest = std::min(nearest, std::hypot(1.0 - q[0], q[1]));
      }
    }
    // A third of the distance of the chord.
    EXPECT_NEAR(nearest, half * std::sqrt(0.5) / 3.0, 0.03 * half) << blend;
  }
}

TEST(TimeBlended, RandomPathsKeepTheLimitsAndAreFasterThanStops) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Random random(seed);
    const Points points = random_corners(random, 6);
    JointLimits limits;
    for (int j = 0; j < 6; ++j) {
      limits.velocity.push_back(random.uniform(0.5, 5.0));
      limits.acceleration.push_back(random.uniform(1.0, 50.0));
    }
    std::vector<double> blends(points.size() - 2);
    for (double& blend : blends) blend = random.index(3) == 0 ? 0.0 : random.uniform(0.05, 1.0);
    const TimedPath path = time_blended(points, blends, limits);
    expect_kept(path, points, limits);
    EXPECT_LE(path.times.back(), time_path(points, PathKind::corners, limits).times.back() + 1e-9);
    // It stops where it is to, and nowhere else.
    std::size_t stops = 0;
    for (std::size_t i = 1; i + 1 < path.times.size(); ++i) {
      if (path.velocities[i] == std::vector<double>(6, 0.0)) ++stops;
    }
    EXPECT_EQ(stops, static_cast<std::size_t>(std::count(blends.begin(), blends.end(), 0.0)));
  }
}

TEST(TimeBlended, WithoutBlendsItStopsAtEachCorner) {
  Random random(3);
  const Points points = random_corners(random, 3);
  const JointLimits limits{{1.0, 2.0, 3.0}, {5.0, 10.0, 2.0}};
  const TimedPath stops = time_path(points, PathKind::corners, limits);
  const TimedPath same = time_blended(points, std::vector<double>(points.size() - 2, 0.0), limits);
  EXPECT_EQ(same.positions, stops.positions);
  EXPECT_EQ(same.velocities, stops.velocities);
}

// Repeated waypoints add nothing, and a path that turns back on itself stands for a moment.
TEST(TimeBlended, PassesRepeatedPointsAndReversals) {
  const JointLimits limits{{1.0, 2.0}, {5.0, 10.0}};
  const Points once = {{0.0, 0.0}, {1.0, 0.3}, {1.2, 2.0}};
  const Points twice = {once[0], once[0], once[1], once[1], once[2], once[2]};
  EXPECT_EQ(time_blended(twice, {0.7, 0.5, 0.9, 0.2}, limits).positions,
            time_blended(once, {0.5}, limits).positions);
  const Points back = {{0.0, 0.0}, {1.0, 1.0}, {0.0, 0.0}};
  expect_kept(time_blended(back, {0.5}, limits), back, limits);
  const Points still = {{0.5, 0.5}, {0.5, 0.5}, {0.5, 0.5}};
  EXPECT_EQ(time_blended(still, {0.5}, limits).times, std::vector<double>{0.0});
  EXPECT_THROW((void)time_blended(once, {}, limits), InputError);
  EXPECT_THROW((void)time_blended(once, {1.5}, limits), InputError);
}

TEST(TimePath, TimeScalesWithTheLimits) {
  const SineCurve curve(3);
  JointLimits twice = curve.limits();
  for (double& v : twice.velocity) v *= 2.0;
  for (double& a : twice.acceleration) a *= 4.0;
  for (const PathKind kind : {PathKind::corners, PathKind::smooth}) {
    const Points points = curve.points(30);
    const double time = time_path(points, kind, curve.limits()).times.back();
    const TimedPath faster = time_path(points, kind, twice, {.sample_time = 0.01});
    EXPECT_NEAR(faster.times.back() / time, 0.5, 1e-6);
  }
}

TEST(TimePath, WithoutLimitsOfVelocityFourTimesTheAccelerationHalvesTheTime) {
  const SineCurve curve(4);
  JointLimits limits = curve.limits();
  for (double& v : limits.velocity) v = 1e3;
  JointLimits strong = limits;
  for (double& a : strong.acceleration) a *= 4.0;
  for (const PathKind kind : {PathKind::corners, PathKind::smooth}) {
    const Points points = curve.points(30);
    const double time = time_path(points, kind, limits).times.back();
    const TimedPath faster = time_path(points, kind, strong, {.sample_time = 0.01});
    EXPECT_NEAR(faster.times.back() / time, 0.5, 1e-5);
  }
}

TEST(TimePath, SamplesAreAsCloseAsAsked) {
  const SineCurve curve(5);
  for (const PathKind kind : {PathKind::corners, PathKind::smooth}) {
    const Points points = curve.points(20);
    const TimedPath coarse = time_path(points, kind, curve.limits(), {.sample_time = 0.5});
    const TimedPath fine = time_path(points, kind, curve.limits(), {.sample_time = 0.001});
    expect_kept(coarse, points, curve.limits(), 0.5);
    expect_kept(fine, points, curve.limits(), 0.001);
    EXPECT_GT(fine.times.size(), 9 * coarse.times.size());
    EXPECT_LT(fine.times.back(), coarse.times.back());
    EXPECT_GT(fine.times.back(), 0.8 * coarse.times.back());
  }
}

TEST(TimePath, NowhereToGoIsOneSample) {
  const std::vector<double> q = {0.5, -1.0};
  for (const PathKind kind : {PathKind::corners, PathKind::smooth}) {
    for (const Points& points : {Points{q}, Points{q, q}, Points{q, q, q}}) {
      const TimedPath path = time_path(points, kind, {{0.0, kNaN}, {0.0, kNaN}});
      EXPECT_EQ(path.times, std::vector<double>{0.0});
      EXPECT_EQ(path.positions, Points{q});
      EXPECT_EQ(path.velocities, (Points{{0.0, 0.0}}));
    }
  }
}

TEST(TimePath, RepeatedWaypointsChangeNothing) {
  const SineCurve curve(6);
  const Points points = curve.points(25);
  Points repeated;
  for (const std::vector<double>& q : points) repeated.insert(repeated.end(), 3, q);
  for (const PathKind kind : {PathKind::corners, PathKind::smooth}) {
    const TimedPath once = time_path(points, kind, curve.limits());
    const TimedPath thrice = time_path(repeated, kind, curve.limits());
    EXPECT_EQ(once.times, thrice.times);
    EXPECT_EQ(once.positions, thrice.positions);
  }
}

// Rounding may leave waypoints a hair apart, in no direction that means anything.
TEST(TimePath, NearlyRepeatedWaypointsKeepTheLimits) {
  const SineCurve curve(7);
  const Points points = curve.points(25);
  const double time = time_path(points, PathKind::smooth, curve.limits()).times.back();
  Random random(7);
  for (const double size : {1e-15, 1e-12, 1e-10}) {
    Points noisy;
    for (const std::vector<double>& q : points) {
      noisy.push_back(q);
      noisy.push_back(q);
      for (double& value : noisy.back()) value += random.uniform(-size, size);
    }
    const TimedPath smooth = time_path(noisy, PathKind::smooth, curve.limits());
    expect_kept(smooth, noisy, curve.limits());
    EXPECT_NEAR(smooth.times.back(), time, 1e-6) << size;
    expect_kept(time_path(noisy, PathKind::corners, curve.limits()), noisy, curve.limits());
  }
}

// A sharp corner and a needle are not smooth; the limits hold all the same.
TEST(TimePath, KinksKeepTheLimits) {
  Random random(8);
  for (int i = 0; i < 20; ++i) {
    const Points points = random_corners(random, 3);
    const JointLimits limits{{1.0, 2.0, 3.0}, {5.0, 10.0, 2.0}};
    expect_kept(time_path(points, PathKind::smooth, limits), points, limits);
  }
  const Points needle = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1e-5, 1e-6, 0.0}, {1.0, 1.0, 0.0}};
  const JointLimits limits{{1.0, 2.0, 0.0}, {5.0, 10.0, 0.0}};
  expect_kept(time_path(needle, PathKind::smooth, limits), needle, limits);
}

TEST(TimePath, TinyMotionsTakeAMicrosecond) {
  for (const PathKind kind : {PathKind::corners, PathKind::smooth}) {
    for (const double distance : {1e-16, 1e-200, 5e-324}) {
      const Points points = {{0.0}, {distance}};
      const TimedPath path = time_path(points, kind, {{2.0}, {10.0}});
      expect_kept(path, points, {{2.0}, {10.0}});
      EXPECT_GE(path.times.back(), 0.999e-6);
      EXPECT_LE(path.times.back(), 1.2e-6);
    }
  }
}

TEST(TimePath, JointsThatRestNeedNoLimits) {
  const Points points = {{0.0, 0.3}, {0.5, 0.3}, {1.0, 0.3}};
  for (const PathKind kind : {PathKind::corners, PathKind::smooth}) {
    const TimedPath path = time_path(points, kind, {{1.0, kNaN}, {1.0, 0.0}});
    for (std::size_t i = 0; i < path.times.size(); ++i) {
      ASSERT_EQ(path.positions[i][1], 0.3);
      ASSERT_EQ(path.velocities[i][1], 0.0);
    }
  }
}

void expect_refused(const Points& points, const JointLimits& limits, const std::string& words,
                    const TimePathOptions& options = {}) {
  for (const PathKind kind : {PathKind::corners, PathKind::smooth}) {
    try {
      time_path(points, kind, limits, options);
      ADD_FAILURE() << "accepted: " << words;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }
}

TEST(TimePath, RefusesWhatCannotBeTimed) {
  const JointLimits good{{1.0, 1.0}, {1.0, 1.0}};
  expect_refused({}, good, "waypoints: none");
  expect_refused({{0.0, 0.0}, {1.0}}, good, "waypoints[1]: has 1 numbers, the first 2");
  expect_refused({{0.0, 0.0}, {1.0, kNaN}}, good, "waypoints[1][1]: not finite");
  expect_refused({{0.0, 0.0}, {1.0, 1.0}}, {{1.0}, {1.0, 1.0}}, "limits: 1 velocities");
  const Points moving = {{0.0, 0.0}, {1.0, 1.0}};
  for (const double bad : {0.0, -1.0, kNaN, std::numeric_limits<double>::infinity()}) {
    expect_refused(moving, {{1.0, bad}, {1.0, 1.0}}, "limits.velocity[1]: not positive");
    expect_refused(moving, {{1.0, 1.0}, {bad, 1.0}}, "limits.acceleration[0]: not positive");
    expect_refused(moving, good, "sample_time", {.sample_time = bad});
  }
  expect_refused(moving, {{1e-9, 1.0}, {1.0, 1.0}}, "too many samples");
}

TEST(TimePath, RepeatsToTheBit) {
  const SineCurve curve(9);
  for (const PathKind kind : {PathKind::corners, PathKind::smooth}) {
    const TimedPath a = time_path(curve.points(50), kind, curve.limits());
    const TimedPath b = time_path(curve.points(50), kind, curve.limits());
    EXPECT_EQ(a.times, b.times);
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.velocities, b.velocities);
  }
}

TEST(Append, SharesTheSampleWhereSegmentsMeet) {
  const JointLimits limits{{1.0, 1.0}, {4.0, 4.0}};
  const TimedPath transfer =
      time_path({{0.0, 0.0}, {1.0, 0.5}, {1.0, 1.0}}, PathKind::corners, limits);
  const TimedPath approach = time_path({{1.0, 1.0}, {1.2, 1.1}}, PathKind::smooth, limits);
  Trajectory trajectory;
  trajectory.joints = {"a", "b"};
  append(trajectory, "transfer", transfer);
  append(trajectory, "approach", approach);
  append(trajectory, "close", time_path({{1.2, 1.1}}, PathKind::corners, limits));
  const std::size_t first = transfer.times.size();
  ASSERT_EQ(trajectory.times.size(), first + approach.times.size() - 1);
  ASSERT_EQ(trajectory.segments.size(), 3U);
  const int meet = static_cast<int>(first) - 1;
  const int last = static_cast<int>(trajectory.times.size()) - 1;
  EXPECT_EQ(trajectory.segments[0].first, 0);
  EXPECT_EQ(trajectory.segments[0].last, meet);
  EXPECT_EQ(trajectory.segments[1].first, meet);
  EXPECT_EQ(trajectory.segments[1].last, last);
  EXPECT_EQ(trajectory.segments[2].name, "close");
  EXPECT_EQ(trajectory.segments[2].first, last);
  EXPECT_EQ(trajectory.segments[2].last, last);
  for (std::size_t i = 1; i < approach.times.size(); ++i) {
    EXPECT_EQ(trajectory.times[first + i - 1], transfer.times.back() + approach.times[i]);
    EXPECT_EQ(trajectory.positions[first + i - 1], approach.positions[i]);
    EXPECT_EQ(trajectory.velocities[first + i - 1], approach.velocities[i]);
  }
}

TEST(Append, RefusesAJumpAndOtherJoints) {
  const JointLimits limits{{1.0}, {1.0}};
  Trajectory trajectory;
  trajectory.joints = {"a"};
  append(trajectory, "transfer", time_path({{0.0}, {1.0}}, PathKind::corners, limits));
  EXPECT_THROW(append(trajectory, "approach", time_path({{1.1}, {2.0}}, PathKind::smooth, limits)),
               InputError);
  EXPECT_THROW(append(trajectory, "approach", {}), InputError);
  const TimedPath two = time_path({{1.0, 0.0}}, PathKind::smooth, {{1.0, 1.0}, {1.0, 1.0}});
  EXPECT_THROW(append(trajectory, "approach", two), InputError);
  EXPECT_EQ(trajectory.segments.size(), 1U);
}

}  // namespace
}  // namespace prehend
