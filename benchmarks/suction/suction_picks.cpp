#include "benchmarks/suction/suction_picks.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace prehend::bench {

std::vector<std::size_t> spread_over(const std::vector<double>& values, std::size_t count) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  if (order.size() <= count) return order;
  std::vector<std::size_t> chosen;
  for (std::size_t k = 0; k < count; ++k) {
    chosen.push_back(order[count == 1 ? 0 : k * (order.size() - 1) / (count - 1)]);
  }
  return chosen;
}

std::vector<TakenItem> in_turn(const std::vector<std::size_t>& sizes, std::size_t count) {
  const std::size_t rounds = sizes.empty() ? 0 : *std::max_element(sizes.begin(), sizes.end());
  std::vector<TakenItem> taken;
  for (std::size_t round = 0; round < rounds; ++round) {
    for (std::size_t list = 0; list < sizes.size() && taken.size() < count; ++list) {
      if (round < sizes[list]) taken.push_back({list, round});
    }
  }
  return taken;
}

std::vector<double> spread_factors(double low, double high, std::size_t count) {
  std::vector<double> factors(count, low);
  if (count < 2) return factors;
  // Steps of about the golden section of the count, which reach each place once.
  auto step = static_cast<std::size_t>(std::lround(0.618 * static_cast<double>(count)));
  while (std::gcd(step, count) != 1) ++step;
  for (std::size_t k = 0; k < count; ++k) {
    const auto place = static_cast<double>(k * step % count);
    factors[k] = low * std::pow(high / low, place / static_cast<double>(count - 1));
  }
  return factors;
}

}  // namespace prehend::bench
