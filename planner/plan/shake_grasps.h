// Every grasp of a result is closed, lifted and shaken (sim/manipulation/shake.h), in parallel.
#pragma once

namespace prehend {

struct CompiledScene;
struct PlanResult;
struct RunContext;
struct TestProcedure;

// Fills in ScoredGrasp::shake of the grasps in which the hand has closed on the object. The same
// result on any number of threads. Does not throw Cancelled: what was not shaken when the context
// was cancelled or its time was over has none, and the result's status says so. Throws InputError
// for a hand or an object that cannot be moved (make_robot_model, make_grasp_world).
void shake_grasps(const CompiledScene& scene, const TestProcedure& procedure,
                  const RunContext& context, PlanResult& result);

// Puts grasps that survived more of their tests first; those that survived as many stay in their
// order, and so do those that were not shaken, behind all others.
void rank_by_shake(PlanResult& result);

}  // namespace prehend
