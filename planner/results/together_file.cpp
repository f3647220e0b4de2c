#include "planner/results/together_file.h"

#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "planner/results/json_grasp.h"
#include "planner/results/json_trajectory.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 2> kSides = {"first", "second"};

Json path_json(const Trajectory& trajectory) {
  FieldWriter fields;
  trajectory_fields(fields, trajectory);
  return std::move(fields).json();
}

// Infinity, which JSON has no number for, is null.
Json times_json(double strength) { return std::isfinite(strength) ? Json(strength) : Json(); }

Json lift_json(const SharedLift& lift) {
  return {{"end", std::string(name_of(lift.end))}, {"risen", lift.risen}, {"tilt", lift.tilt}};
}

Json pair_json(const std::array<HandPlan, 2>& plans, const SharedGrasp& pair) {
  Json json{{"epsilon", pair.epsilon.lower},
            {"weight", {{"strength", times_json(pair.strength)}}},
            {"lift", lift_json(pair.lift)}};
  for (std::size_t side = 0; side < 2; ++side) {
    const HandPlan& plan = plans[side];
    Json& own = json[kSides[side]];
    own["grasp"] =
        grasp_to_json(plan.result.grasps[pair.grasps[side]], plan.scene, plan.result.primitives);
    own["strength_alone"] = times_json(pair.alone[side]);
    if (!pair.paths) continue;
    own["path"] = path_json(pair.paths->reach[side]);
    own["lift"] = path_json(pair.paths->lift[side]);
  }
  return json;
}

}  // namespace

std::string together_json(const std::array<HandPlan, 2>& plans,
                          const std::array<RunRecord, 2>& records, const TogetherResult& result) {
  Json file{{"format", "prehend together 1"}, {"object", plans[0].scene.scene.object.name}};
  for (std::size_t side = 0; side < 2; ++side) {
    file[kSides[side]] = {{"scene", records[side].scene},
                          {"hand", plans[side].scene.scene.hand.name}};
  }
  file["pairs"] = {{"looked_at", result.pairs},
                   {"apart", result.apart},
                   {"bear_the_weight", result.bear},
                   {"tried", result.tried},
                   {"lifted", result.lifted}};
  file["grasps"] = Json::array();
  for (const SharedGrasp& pair : result.grasps) file["grasps"].push_back(pair_json(plans, pair));
  return file.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace prehend
