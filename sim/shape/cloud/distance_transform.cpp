#include "sim/shape/cloud/distance_transform.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim/base/index.h"

namespace prehend {
namespace {

// The lower envelope of parabolas over one line of cells.
class Envelope {
 public:
  explicit Envelope(int longest)
      : at_(index(longest)), start_(index(longest) + 1), value_(index(longest)) {}

  // Replaces the squared distances of a line, `step` apart in memory.
  void apply(float* line, int count, std::ptrdiff_t step) {
    for (int i = 0; i < count; ++i) value_[index(i)] = line[i * step];
    int last = 0;
    at_[0] = 0;
    start_[0] = -kNowhere;
    start_[1] = kNowhere;
    for (int q = 1; q < count; ++q) {
      float s = crossing(q, at_[index(last)]);
      while (s <= start_[index(last)]) s = crossing(q, at_[index(--last)]);
      at_[index(++last)] = q;
      start_[index(last)] = s;
      start_[index(last) + 1] = kNowhere;
    }
    int k = 0;
    for (int q = 0; q < count; ++q) {
      while (start_[index(k) + 1] < static_cast<float>(q)) ++k;
      const auto d = static_cast<float>(q - at_[index(k)]);
      line[q * step] = d * d + value_[index(at_[index(k)])];
    }
  }

 private:
  static constexpr float kNowhere = 1e20F;

  float crossing(int q, int p) const {
    const auto high = static_cast<float>(q);
    const auto low = static_cast<float>(p);
    const float rise = value_[index(q)] - value_[index(p)];
    return (rise + (high - low) * (high + low)) / (2.0F * (high - low));
  }

  std::vector<int> at_;       // where the parabolas of the envelope have their lowest points
  std::vector<float> start_;  // where each of them begins
  std::vector<float> value_;
};

}  // namespace

std::vector<float> distance_transform(const std::vector<char>& from, const std::array<int, 3>& size,
                                      float far) {
  std::vector<float> squared(from.size());
  std::transform(from.begin(), from.end(), squared.begin(),
                 [far](char is) { return is != 0 ? 0.0F : far * far; });
  Envelope envelope(*std::max_element(size.begin(), size.end()));
  const std::ptrdiff_t row = size[0];
  const std::ptrdiff_t layer = row * size[1];
  for (int z = 0; z < size[2]; ++z) {
    for (int y = 0; y < size[1]; ++y) {
      envelope.apply(squared.data() + z * layer + y * row, size[0], 1);
    }
    for (int x = 0; x < size[0]; ++x) {
      envelope.apply(squared.data() + z * layer + x, size[1], row);
    }
  }
  if (size[2] > 1) {
    for (std::ptrdiff_t i = 0; i < layer; ++i) {
      envelope.apply(squared.data() + i, size[2], layer);
    }
  }
  for (float& d : squared) d = std::min(std::sqrt(d), far);
  return squared;
}

}  // namespace prehend
