#include "planner/propose/candidates.h"

#include "planner/propose/proposal_sequence.h"

namespace prehend {

Proposals propose_grasps(const CompiledScene& scene, const std::vector<Primitive>& primitives,
                         std::size_t count, const CandidateOptions& options,
                         const RunContext& context) {
  ProposalSequence sequence(scene, primitives, options);
  Proposals proposals{{}, sequence.smallest_width(), sequence.largest_opening()};
  while (proposals.grasps.size() < count) {
    context.cancellation.check();
    std::optional<ProposedGrasp> grasp = sequence.next();
    if (!grasp) break;
    proposals.grasps.push_back(std::move(*grasp));
  }
  return proposals;
}

}  // namespace prehend
