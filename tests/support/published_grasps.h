// Grasps that others published, as candidates: the files of shared data/grasps/dexycb_franka_*.json
// (100 poses of the Franka hand an object, from DexYCB, CVPR 2021).
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/scene/compiled_scene.h"
#include "sim/trial/candidate.h"
#include "sim/trial/trial.h"

namespace prehend::test {

// Each file says how its frames go: X_OH is the 4 x 4 matrix, with `frame_offset_m` added to its
// translation; the hand is open. Its hand frame is that of robots/franka_hand.
inline std::vector<Candidate> published_grasps(const std::filesystem::path& file,
                                               const CompiledScene& scene) {
  const nlohmann::json json = nlohmann::json::parse(std::ifstream(file));
  const auto& offset = json.at("frame_offset_m");
  const Hand& hand = *scene.scene.hand.hand;
  const auto open = std::find_if(hand.preshapes.begin(), hand.preshapes.end(),
                                 [](const Preshape& p) { return p.name == "open"; });
  std::vector<Candidate> grasps;
  for (const auto& matrix : json.at("grasps")) {
    Candidate grasp;
    for (std::size_t row = 0; row < 3; ++row) {
      const auto at = static_cast<Eigen::Index>(row);
      for (std::size_t column = 0; column < 4; ++column) {
        grasp.X_OH.matrix()(at, static_cast<Eigen::Index>(column)) =
            matrix.at(row).at(column).get<double>();
      }
      grasp.X_OH.translation()[at] += offset.at(row).get<double>();
    }
    // Printed with seven digits: the nearest rotation is what was meant.
    const Eigen::Quaterniond turn(Matrix3(grasp.X_OH.linear()));
    grasp.X_OH.linear() = turn.normalized().toRotationMatrix();
    grasp.approach_O = grasp.X_OH.linear() * hand.approach;
    grasp.preshape = static_cast<int>(open - hand.preshapes.begin());
    grasps.push_back(std::move(grasp));
  }
  return grasps;
}

}  // namespace prehend::test
