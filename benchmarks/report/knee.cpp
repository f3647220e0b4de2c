#include "benchmarks/report/knee.h"

namespace prehend::bench {

std::optional<std::size_t> knee_of(const std::vector<DataPoint>& curve) {
  if (curve.size() < 3) return std::nullopt;
  const double width = curve.back().x - curve.front().x;
  const double height = curve.back().y - curve.front().y;
  if (!(width > 0.0) || !(height > 0.0)) return std::nullopt;
  constexpr double kRounding = 1e-12;  // a straight line has no knee
  std::optional<std::size_t> knee;
  double highest = kRounding;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double above =
        (curve[i].y - curve.front().y) / height - (curve[i].x - curve.front().x) / width;
    if (above <= highest) continue;
    highest = above;
    knee = i;
  }
  return knee;
}

}  // namespace prehend::bench
