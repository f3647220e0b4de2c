#include "sim/quality/wrench_size.h"

#include <cmath>
#include <cstdlib>

namespace prehend {
namespace {

// The largest exponent of a coordinate that needs no scaling. A volume in six dimensions has six
// times the exponent, and 2^900 and 2^-900 are in the range of normal doubles (2^-1022 to 2^1023).
constexpr int kLargest = 150;

}  // namespace

int excess_exponent(const Eigen::Ref<const Wrenches>& wrenches) {
  if (wrenches.cols() == 0) return 0;
  const double size = wrenches.cwiseAbs().maxCoeff();
  if (!std::isfinite(size)) return 0;
  int exponent = 0;
  std::frexp(size, &exponent);
  return std::abs(exponent) > kLargest ? exponent : 0;
}

Wrenches times_power_of_two(const Eigen::Ref<const Wrenches>& wrenches, int exponent) {
  return wrenches.unaryExpr([exponent](double value) { return std::ldexp(value, exponent); });
}

}  // namespace prehend
