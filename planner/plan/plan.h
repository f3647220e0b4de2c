// Planning: from a scene to ranked grasps. Evaluation: from given grasps to their scores.
#pragma once

#include <string>
#include <vector>

#include "planner/plan/plan_options.h"
#include "planner/plan/plan_result.h"
#include "sim/base/run_context.h"

namespace prehend {

struct CompiledScene;

// Plans grasps: decomposes the object into primitives (unless the scene gives them), proposes
// candidates, runs a trial of each, ranks the stable ones by epsilon, and with PlanOptions::paths
// plans paths of the arm to the best. The same options give the same result on any number of
// threads (but for times, and unless cancelled).
//
// Does not throw Cancelled. What a cancelled plan returns: the trials that were finished, ranked;
// of grasps whose path was asked for, those whose path was found (cancelled before the first path
// was searched for: the best grasps, without paths); volumes and sections as far as they were
// computed. With one thread the finished trials are the first ones, in the order of the candidates.
// Throws InputError when paths are wanted of a scene without an arm.
//
// `found` is told of the stable trials of the search while it runs, before they are ranked.
PlanResult plan(const CompiledScene& scene, const PlanOptions& options = {},
                const RunContext& context = {}, const FoundListener& found = {});

// Runs a trial of each of the given candidates and scores it. Grasps are returned in the order of
// the candidates, whatever their outcome; nothing is ranked or left out. Does not throw Cancelled:
// when cancelled it returns the grasps whose trials were finished (Tried::candidate says which
// candidates those were). Without candidates the status is PlanStatus::no_candidates.
PlanResult evaluate(const CompiledScene& scene, const std::vector<Candidate>& candidates,
                    const EvaluateOptions& options = {}, const RunContext& context = {});

// Why there was nothing to try, in one line: "mug: no grasp to try with hand NAME: the smallest
// size to close on is ... mm, the hand opens to ... mm; try --hand ...". For a result whose status
// is object_too_large or no_candidates.
std::string no_candidates_text(const CompiledScene& scene, const PlanResult& result);

}  // namespace prehend
