#include "sim/shape/files/mesh_color.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

#include "sim/base/formatted.h"
#include "sim/base/index.h"

namespace prehend {
namespace {

constexpr double kFullByte = 255.0;

// Colours that are about the same, with the area that has them [m^2].
struct ColorBin {
  Vector3 weighted = Vector3::Zero();  // their sum, by area
  double area = 0.0;

  Vector3 mean() const { return weighted / area; }
};

// All colours by their parts in steps of 1/31, so that not more than 32768 are compared.
std::vector<ColorBin> bins_of(const ColoredMesh& mesh) {
  constexpr float kSteps = 31.0F;
  std::map<int, ColorBin> bins;
  for (std::size_t t = 0; t < mesh.colors.size(); ++t) {
    if (!mesh.colors[t]) continue;
    int key = 0;
    for (const float part : *mesh.colors[t]) {
      key = 32 * key + static_cast<int>(std::lround(kSteps * part));
    }
    const double area = 0.5 * doubled_area_vector(mesh.surface, t).norm();
    if (!(area > 0.0)) continue;
    ColorBin& bin = bins[key];
    bin.weighted += area * mesh.colors[t]->cast<double>();
    bin.area += area;
  }
  std::vector<ColorBin> result;
  for (const auto& [key, bin] : bins) result.push_back(bin);
  return result;
}

std::optional<int> hexadecimal_digit(char c) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  const char lower = c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c;
  const std::size_t at = kDigits.find(lower);
  return at == kDigits.npos ? std::nullopt : std::optional(static_cast<int>(at));
}

}  // namespace

std::optional<float> color_part(double value, double full) {
  if (!(value >= 0.0 && value <= full)) return std::nullopt;
  return static_cast<float>(value / full);
}

float shown_part(float light) {
  return light <= 0.0031308F ? 12.92F * light : 1.055F * std::pow(light, 1.0F / 2.4F) - 0.055F;
}

SurfaceColor mean_color(const std::vector<SurfaceColor>& of_vertices, const Triangle& triangle,
                        std::size_t first) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (const int v : triangle) {
    const SurfaceColor& color = of_vertices[index(v) - first];
    if (!color) return std::nullopt;
    sum += *color;
  }
  return Eigen::Vector3f(sum / 3.0F);
}

std::string color_text(const Vector3& color) {
  const auto byte = [&](int k) { return static_cast<int>(std::lround(kFullByte * color[k])); };
  return formatted("#%02x%02x%02x", byte(0), byte(1), byte(2));
}

std::optional<Vector3> color_in_text(std::string_view word) {
  constexpr std::size_t kLength = 7;
  if (word.size() != kLength || word.front() != '#') return std::nullopt;
  Vector3 color = Vector3::Zero();
  for (int k = 0; k < 3; ++k) {
    const std::optional<int> high = hexadecimal_digit(word[index(2 * k + 1)]);
    const std::optional<int> low = hexadecimal_digit(word[index(2 * k + 2)]);
    if (!high || !low) return std::nullopt;
    color[k] = (16 * *high + *low) / kFullByte;
  }
  return color;
}

std::vector<ColorShare> frequent_colors(const ColoredMesh& mesh) {
  constexpr std::size_t kMost = 5;
  constexpr double kSame = 0.1;
  std::vector<ColorBin> bins = bins_of(mesh);
  double whole = 0.0;
  for (std::size_t t = 0; t < mesh.surface.triangles.size(); ++t) {
    whole += 0.5 * doubled_area_vector(mesh.surface, t).norm();
  }
  std::vector<ColorShare> shares;
  while (!bins.empty() && shares.size() < kMost) {
    const auto less = [](const ColorBin& a, const ColorBin& b) { return a.area < b.area; };
    const Vector3 color = std::max_element(bins.begin(), bins.end(), less)->mean();
    double area = 0.0;
    std::erase_if(bins, [&](const ColorBin& bin) {
      const bool same = (bin.mean() - color).norm() <= kSame;
      if (same) area += bin.area;
      return same;
    });
    shares.push_back({color, area / whole});
  }
  std::stable_sort(shares.begin(), shares.end(),
                   [](const ColorShare& a, const ColorShare& b) { return a.share > b.share; });
  return shares;
}

}  // namespace prehend
