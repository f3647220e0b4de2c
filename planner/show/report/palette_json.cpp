#include "planner/show/report/palette_json.h"

#include <cmath>

#include "planner/show/palette.h"
#include "sim/base/formatted.h"

namespace prehend {
namespace {

using Json = nlohmann::ordered_json;

std::string hex(const Color& color) {
  const auto byte = [](double part) { return static_cast<int>(std::lround(255.0 * part)); };
  return formatted("#%02x%02x%02x", byte(color.red), byte(color.green), byte(color.blue));
}

Json look_json(const Color& color) { return {{"color", hex(color)}, {"opacity", color.opacity}}; }

}  // namespace

Json palette_json() {
  Json axes = Json::array();
  for (const Color& axis : palette::kAxes) axes.push_back(hex(axis));
  Json solids = Json::array();
  for (std::size_t k = 0; k < palette::kTips.size(); ++k) {
    solids.push_back(look_json(palette::of_solid(k)));
  }
  Json outcomes = Json::object();
  for (const Outcome outcome : kAll<Outcome>) {
    outcomes[std::string(name_of(outcome))] = hex(palette::of(outcome));
  }
  return {{"object", look_json(palette::kObject)},
          {"hard", look_json(palette::kHard)},
          {"rubber", look_json(palette::kRubber)},
          {"arm", look_json(palette::kArm)},
          {"obstacle", look_json(palette::kObstacle)},
          {"primitive", look_json(palette::kPrimitive)},
          {"solids", solids},
          {"contact", look_json(palette::kContact)},
          {"weakest", look_json(palette::kWeakest)},
          {"pointed_at", look_json(palette::kPointedAt)},
          {"center", look_json(palette::kCenterOfMass)},
          {"wrench_space", look_json(palette::kWrenchSpace)},
          {"epsilon_ball", look_json(palette::kEpsilonBall)},
          {"force", look_json(palette::kForce)},
          {"contribution", look_json(palette::kContribution)},
          {"axes", axes},
          {"outcomes", outcomes}};
}

}  // namespace prehend
