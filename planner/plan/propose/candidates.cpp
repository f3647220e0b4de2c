#include "planner/plan/propose/candidates.h"

#include "planner/plan/propose/proposal_sequence.h"
#include "sim/base/require_settings.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {

Proposals propose_grasps(const CompiledScene& scene, const std::vector<Primitive>& primitives,
                         std::size_t count, const CandidateOptions& options,
                         const RunContext& context) {
  require_settings(options);
  constexpr std::size_t kSolids = 4;
  ProposalSequence sequence(scene, primitives, options);
  Proposals proposals{{}, sequence.smallest_width(), sequence.largest_opening()};
  while (proposals.grasps.size() < count) {
    context.cancellation.check();
    const bool turn_of_curves = proposals.grasps.size() % kSolids == kSolids - 1;
    const Track first = turn_of_curves ? Track::curves : Track::solids;
    std::optional<ProposedGrasp> grasp = sequence.next(first);
    if (!grasp) grasp = sequence.next(turn_of_curves ? Track::solids : Track::curves);
    if (!grasp) break;
    proposals.grasps.push_back(std::move(*grasp));
  }
  return proposals;
}

}  // namespace prehend
