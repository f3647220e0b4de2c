// What planner and MuJoCo say of suction grasps, as tables in Markdown.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "benchmarks/suction/suction_picks.h"
#include "sim/base/named_enum.h"

namespace prehend::bench {

// When an object counts as held in MuJoCo.
enum class HeldReading {
  adhesion,  // the pull of a cup is shared by the points of the lip that touch
  seal,      // a cup loses its pull once a point of the lip comes off
  strain,    // and the object does not tilt by more than the lip may be strained
};

constexpr auto enum_names(HeldReading /*of*/) {
  return std::to_array<std::string_view>(
      {"adhesion alone", "... that ends where the lip lifts", "... and tilts within the strain"});
}

struct SuctionResult {
  std::string hand;
  HungAttitude attitude = HungAttitude::as_it_lies;
  double margin = 0.0;          // predicted: held from 1 on
  double elastic_margin = 0.0;  // as SuctionPick
  EnumArray<HeldReading, bool> held;
};

// How often both agree, for each reading, also where lips are elastic however far they are bent; by
// hand and attitude; and what is held by margin.
std::string suction_tables(const std::vector<SuctionResult>& results);

}  // namespace prehend::bench
