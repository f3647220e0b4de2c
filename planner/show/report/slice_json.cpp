#include "planner/show/report/slice_json.h"

#include <algorithm>
#include <cmath>

#include "planner/show/report/robot_json.h"

namespace prehend {

nlohmann::ordered_json slice_json(const WrenchSlice& slice) {
  nlohmann::ordered_json json{{"vertices", nlohmann::ordered_json::array()},
                              {"triangles", nlohmann::ordered_json::array()}};
  if (slice.empty()) return json;
  const double largest = slice.vertices.cwiseAbs().maxCoeff();
  const double scale =
      std::pow(10.0, std::clamp(4.0 - std::floor(std::log10(largest)), 0.0, 300.0));
  for (Eigen::Index i = 0; i < slice.vertices.size(); ++i) {
    json["vertices"].push_back(rounded(slice.vertices.data()[i], scale));
  }
  for (Eigen::Index i = 0; i < slice.triangles.size(); ++i) {
    json["triangles"].push_back(slice.triangles.data()[i]);
  }
  return json;
}

}  // namespace prehend
