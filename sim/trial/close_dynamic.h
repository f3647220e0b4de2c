// Closes the hand once in time, on an object that gives way, and judges the grasp that forms.
#pragma once

#include <limits>
#include <memory>
#include <optional>

#include "sim/trial/candidate.h"
#include "sim/trial/close_and_score.h"
#include "sim/trial/robustness.h"

namespace prehend {

struct RobotModel;

// As close_and_score, by simulation (form_dynamic_grasp): the object has its weight, its support
// and its friction, and the hand (a hand_model of the scene) presses with its efforts. Sets X_OC
// besides. A hand that overlaps something before it closes is hand_blocked; one whose links overlap
// each other is not_simulated. Where the object is not in the hand at the end, the outcome says
// what became of it, and there are no contacts. Contacts and quality of one that the hand drops
// while it rises are those of before. Throws Cancelled.
void close_dynamic(const CompiledScene& scene, const std::shared_ptr<const RobotModel>& hand,
                   const ClosingStart& start, const TrialOptions& options,
                   GraspWorkspace& workspace, Trial& trial, const RunContext& context = {});

// What becomes of a grasp where the object is free to move: `trial`, which `candidate` led to on an
// object that stands still, with the hand closed in time from where it began to close. An object
// pushed beyond `farthest` [m] counts as pushed away, and the rest is not simulated
// (DynamicGraspStart). Throws Cancelled.
Trial closed_freely(const CompiledScene& scene, const std::shared_ptr<const RobotModel>& hand,
                    const Candidate& candidate, const Trial& trial, const TrialOptions& options,
                    const RunContext& context = {},
                    double farthest = std::numeric_limits<double>::infinity());

// Whether the object is in the hand at the end of a trial whose hand closed in time, as far as that
// can be told: without something to rise from, only force closure tells.
bool keeps_object(const CompiledScene& scene, const Trial& free);

// How far the object's centre has moved in such a trial [m]; 0 where it did not begin.
double object_moved(const CompiledScene& scene, const Trial& free);

// How such a trial ended; nothing where the hand could not begin, or the simulation failed.
std::optional<FreeEnd> free_end(const CompiledScene& scene, const Trial& free);

}  // namespace prehend
