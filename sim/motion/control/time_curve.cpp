#include "sim/motion/control/time_curve.h"

#include <algorithm>
#include <cmath>

#include "sim/motion/control/cubic_peaks.h"
#include "sim/motion/control/path_speed.h"
#include "sim/motion/control/smooth_steps.h"

namespace prehend {
namespace {

using Points = std::vector<std::vector<double>>;

// The steps of timing a curve:
// 1. divide it into many stations and find the largest speed at each (path_speed.h);
// 2. integrate the speeds to the times of the stations;
// 3. read off the parameter s at equal steps of time, and smooth it (smooth_steps.h), so that its
//    second derivative is continuous and linear between samples;
// 4. lay a cubic spline in time through the points of the curve at these s.
// On a straight line that spline is the smoothed motion itself, and within the limits. Where the
// curve bends, smoothing mixes the speed of one place with the bend of another, which can leave an
// excess over the limits. Then all is repeated with lower limits around that place.

// Fewest intervals between stations. Acceleration limits hold at stations only; this many make the
// excess between them small.
constexpr std::size_t kIntervals = 2000;
// Rounds in which limits are lowered at places. An excess that is left after them, or is smaller
// than kSmallExcess, is removed by slowing down the motion as a whole.
constexpr int kRounds = 12;
constexpr double kSmallExcess = 1.001;
// Ratio of a value to its limit up to which the excess counts as rounding. Without it the motion
// might be slowed down by a last bit for ever.
constexpr double kInside = 1.0 + 1e-10;

// A sampled motion. `excess`: for each interval between two samples the factor by which it must be
// slowed down to be within the limits; below 1 where it is.
struct SampledRun {
  TimedPath path;
  std::vector<double> excess;
  double largest() const { return *std::max_element(excess.begin(), excess.end()); }
};

class CurveRun {
 public:
  CurveRun(const JointCurve& curve, const JointLimits& limits) : curve_(curve) {
    for (const std::size_t j : curve.moving) {
      limits_.velocity.push_back(limits.velocity[j]);
      limits_.acceleration.push_back(limits.acceleration[j]);
    }
    lay_stations();
    find_speeds();
  }

  // The motion with all its times multiplied by `slower` (>= 1).
  SampledRun sample(double slower, double sample_time) const;

  // Lowers the limits where a run, sampled with `slower` = 1, exceeds them.
  void ease(const SampledRun& run);

 private:
  void lay_stations();
  void find_speeds();
  // s at equal steps of time of the fastest motion, the first at rest at the start and the last at
  // rest at the end.
  std::vector<double> progress(int steps) const;

  const JointCurve& curve_;
  JointLimits limits_;  // of the moving joints
  std::vector<PathStation> stations_;
  // ds/dt and time [s] of each station; d2s/dt2 is constant between two of them.
  std::vector<double> speeds_, times_;
};

// Stations at all knots, and evenly between two of them, as many in each interval. The third
// derivative of the curve jumps at a knot, so no interval between stations reaches across one.
void CurveRun::lay_stations() {
  const PathSpline& curve = curve_.curve;
  const std::vector<double>& knots = curve.knots();
  const std::size_t parts = (kIntervals + knots.size() - 2) / (knots.size() - 1);
  stations_.reserve(parts * knots.size());
  const auto add = [&](double s) {
    CurvePoint point = curve.at(s);
    stations_.push_back({s, std::move(point.dq), std::move(point.ddq)});
  };
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    for (std::size_t k = 0; k < parts; ++k) {
      add(knots[i] +
          (knots[i + 1] - knots[i]) * (static_cast<double>(k) / static_cast<double>(parts)));
    }
  }
  add(knots.back());
}

void CurveRun::find_speeds() {
  const std::vector<double> squared = fastest_squared_speeds(stations_, limits_);
  speeds_.clear();
  times_.clear();
  double time = 0.0;
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    speeds_.push_back(std::sqrt(squared[i]));
    // At constant d2s/dt2 the mean speed of an interval is the mean of the speeds at its ends.
    if (i > 0) {
      time += 2.0 * (stations_[i].s - stations_[i - 1].s) / (speeds_[i - 1] + speeds_[i]);
    }
    times_.push_back(time);
  }
}

std::vector<double> CurveRun::progress(int steps) const {
  std::vector<double> progress;
  std::size_t i = 0;
  for (int k = 0; k <= steps; ++k) {
    const double time = times_.back() * (static_cast<double>(k) / steps);
    // The interval of stations (i, i + 1) it is in.
    while (i + 2 < times_.size() && times_[i + 1] <= time) ++i;
    const double passed = time - times_[i];
    const double acceleration = (speeds_[i + 1] - speeds_[i]) / (times_[i + 1] - times_[i]);
    const double speed = speeds_[i] + acceleration * passed;
    // Mean speed times time is s_i + v_i t + a t^2 / 2; the clamp below is against rounding.
    const double s = stations_[i].s + 0.5 * (speeds_[i] + speed) * passed;
    progress.push_back(std::clamp(s, stations_[i].s, stations_[i + 1].s));
  }
  progress.front() = stations_.front().s;
  progress.back() = stations_.back().s;
  return progress;
}

// A motion that is slower by a factor passes the same points at proportional times, so the samples
// are read from the fastest motion at the same fraction of its duration. Smoothing adds a step at
// either end, in which the motion comes out of rest.
SampledRun CurveRun::sample(double slower, double sample_time) const {
  const double duration = std::max(slower * times_.back(), kShortestMotion);
  const int steps = step_count(duration, sample_time);
  const double step = duration / steps;
  const std::vector<double> progress = this->progress(steps);
  const auto at = [&](int k) {
    return progress[static_cast<std::size_t>(std::clamp(k, 0, steps))];
  };
  SampledRun run;
  Points offsets;
  for (int k = 0; k <= steps + 2; ++k) {
    run.path.times.push_back(step * k);
    offsets.push_back(curve_.curve.at(smoothed(at, k - 1, step).value).q);
  }
  const PathSpline motion(run.path.times, std::move(offsets), SplineEnds::rest);
  run.path.positions.assign(run.path.times.size(), curve_.start);
  run.path.velocities.assign(run.path.times.size(), std::vector<double>(curve_.start.size(), 0.0));
  run.excess.assign(run.path.times.size() - 1, 0.0);
  for (std::size_t i = 0; i < run.path.times.size(); ++i) {
    for (std::size_t m = 0; m < curve_.moving.size(); ++m) {
      const double position = motion.points()[i][m];
      const double velocity = motion.slopes()[i][m];
      run.path.positions[i][curve_.moving[m]] += position;
      run.path.velocities[i][curve_.moving[m]] = velocity;
      if (i == 0) continue;
      const CubicPeaks peaks = cubic_peaks(position - motion.points()[i - 1][m],
                                           motion.slopes()[i - 1][m], velocity, step);
      run.excess[i - 1] = std::max({run.excess[i - 1], peaks.velocity / limits_.velocity[m],
                                    std::sqrt(peaks.acceleration / limits_.acceleration[m])});
    }
  }
  run.path.positions.back() = curve_.end;  // to the bit, so that segments can be joined
  return run;
}

// Between samples k and k + 1 the smoothed motion depends on the steps k - 2 to k + 1 of the
// fastest one.
void CurveRun::ease(const SampledRun& run) {
  const auto steps = static_cast<double>(run.excess.size() - 2);
  std::vector<double> factors(stations_.size(), 1.0);
  for (std::size_t k = 0; k < run.excess.size(); ++k) {
    if (run.excess[k] <= 1.0) continue;
    const double step = times_.back() / steps;
    const double from = step * (static_cast<double>(k) - 2.0);
    const double to = step * (static_cast<double>(k) + 1.0);
    auto i = static_cast<std::size_t>(std::lower_bound(times_.begin(), times_.end(), from) -
                                      times_.begin());
    for (; i < times_.size() && times_[i] <= to; ++i) {
      factors[i] = std::max(factors[i], run.excess[k]);
    }
  }
  for (std::size_t i = 0; i < stations_.size(); ++i) stations_[i].pace /= factors[i];
  find_speeds();
}

}  // namespace

TimedPath time_curve(const JointCurve& curve, const JointLimits& limits, double sample_time) {
  CurveRun run(curve, limits);
  SampledRun sampled = run.sample(1.0, sample_time);
  for (int round = 0; round < kRounds && sampled.largest() > kSmallExcess; ++round) {
    run.ease(sampled);
    sampled = run.sample(1.0, sample_time);
  }
  // A slower motion is sampled at other places, so it is checked again; two or three rounds are
  // usual.
  double slower = 1.0;
  while (sampled.largest() > kInside) {
    slower *= sampled.largest();
    sampled = run.sample(slower, sample_time);
  }
  return std::move(sampled.path);
}

}  // namespace prehend
