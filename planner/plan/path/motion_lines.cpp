#include "planner/plan/path/motion_lines.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace prehend {
namespace {

using Points = std::vector<std::vector<double>>;

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

// Parts into which the cubic between two samples is divided for the proof, which takes each of them
// as a straight line with something beside it. What is beside it shrinks with their square.
constexpr int kParts = 8;

// A part of a cubic of one joint: where it begins, its first Bezier point as seen from there, and
// the same from its end.
struct CubicPart {
  double from = 0.0;
  double to = 0.0;
  double leave = 0.0;
  double arrive = 0.0;
};

// Part k of kParts of the cubic of joint j between samples i - 1 and i.
CubicPart cubic_part(const TimedPath& path, std::size_t i, std::size_t j, int k) {
  const double h = path.times[i] - path.times[i - 1];
  const double q = path.positions[i - 1][j];
  const double change = path.positions[i][j] - q;
  const double v0 = h * path.velocities[i - 1][j];
  const double v1 = h * path.velocities[i][j];
  const double second = 3.0 * change - 2.0 * v0 - v1;
  const double third = v0 + v1 - 2.0 * change;
  const auto position = [&](double t) { return q + t * (v0 + t * (second + t * third)); };
  const auto slope = [&](double t) { return v0 + t * (2.0 * second + t * 3.0 * third); };
  const double s = static_cast<double>(k) / kParts;
  const double e = static_cast<double>(k + 1) / kParts;
  const double bezier = (e - s) / 3.0;
  return {position(s), position(e), bezier * slope(s), -bezier * slope(e)};
}

// Appends the cubic between samples i - 1 and i as straight lines, and says how far each joint gets
// beside them. A part of a cubic lies in the convex hull of its Bezier points, and the inner two
// are compared with the nearest points of the line: however fast a straight motion is, it sways by
// nothing.
void add_lines(const TimedPath& path, std::size_t i, Points& lines, std::vector<double>& sway) {
  const std::size_t joints = sway.size();
  for (int k = 0; k < kParts; ++k) {
    std::vector<double> way(joints);
    std::vector<double> leave(joints);
    std::vector<double> arrive(joints);  // both from the line's start to the Bezier point
    std::vector<double> end(joints);
    for (std::size_t j = 0; j < joints; ++j) {
      const CubicPart part = cubic_part(path, i, j, k);
      end[j] = part.to;
      way[j] = part.to - part.from;
      leave[j] = part.leave;
      arrive[j] = way[j] + part.arrive;
    }
    const double length = dot(way, way);
    for (const std::vector<double>& inner : {leave, arrive}) {
      const double nearest = length > 0.0 ? std::clamp(dot(inner, way) / length, 0.0, 1.0) : 0.0;
      for (std::size_t j = 0; j < joints; ++j) {
        sway[j] = std::max(sway[j], std::abs(inner[j] - nearest * way[j]));
      }
    }
    lines.push_back(std::move(end));
  }
}

}  // namespace

MotionLines motion_lines(const TimedPath& path, std::size_t first, std::size_t last) {
  MotionLines motion{{path.positions[first]},
                     std::vector<double>(path.positions[first].size(), 0.0)};
  for (std::size_t i = first + 1; i <= last; ++i) add_lines(path, i, motion.lines, motion.sway);
  return motion;
}

}  // namespace prehend
