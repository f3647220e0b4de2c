// Why two simulators differ about a grasp: what has to be changed in one of them before they agree.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "benchmarks/shake/shake_cases.h"
#include "sim/manipulation/test_procedure.h"

namespace prehend::bench {

// A change to one of the two simulators, and whether the grasp survives in it then: nothing where
// it cannot be made.
struct Counterfactual {
  std::string cause;     // what the change takes away
  bool in_ours = false;  // else in MuJoCo
  std::function<std::optional<bool>()> survives;
};

// The cause of the first change after which the changed simulator says what the other does; none
// where no change does that. `ours`, `theirs`: what the two say unchanged, which differs.
std::optional<std::string> first_cause(const std::vector<Counterfactual>& changes, bool ours,
                                       bool theirs);

// The changes that are tried on a grasp, in this order.
//
// - clutches: ours with fingers whose joints move as one, as in MuJoCo's, where they break away.
// - start: ours closes from where MuJoCo's does, whose convex pieces overlap in the grasp.
// - pieces: ours grasps MuJoCo's convex pieces, from there.
// - their step: MuJoCo with a quarter of the step, and contacts that are stiffer accordingly.
// - our step: ours with a quarter of the step.
// - friction 10 %, friction 25 %: the grasp is at its limit: so much less friction loses it, or
//   more holds it.
// - clutches: MuJoCo's with the clutches and gears of ours.
//
// They refer to all arguments.
std::vector<Counterfactual> counterfactuals(const ShakeCase& shaken, const ShakenGrasp& grasp,
                                            const TestProcedure& procedure, const ShakeResult& ours,
                                            const ShakeResult& theirs);

// What became of a grasp in one simulator: "survived", or the tests that failed and how, as in
// "moved in +x, -y".
std::string verdict_text(const ShakeResult& result);

}  // namespace prehend::bench
