// Carries out one candidate from the pre-grasp to the closed hand, and computes the quality of the
// grasp. A pure function of scene, candidate and options.
#pragma once

#include <memory>

#include "sim/base/run_context.h"
#include "sim/trial/candidate.h"
#include "sim/trial/trial.h"
#include "sim/trial/trial_options.h"

namespace prehend {

struct CompiledScene;

// Carries out `candidate`: the hand approaches until it touches the object, closes and is centred,
// an object that is not held may settle (settle.h), and the contacts are judged by epsilon in the
// L1 wrench space. A grasp that does not hold is tried again up to options.back_off_tries times
// with the hand backed off along the approach; only a stable grasp replaces the first. In a scene
// with an arm, the arm must also follow the approach without a collision (find_reach).
//
// `candidate` must fit the hand: a preshape in range, or one value per degree of freedom (and per
// joint, where given). Throws Cancelled.
Trial run_trial(const CompiledScene& scene, const Candidate& candidate,
                const TrialOptions& options = {}, const RunContext& context = {});

// The memory that trials need besides their results: one for each thread, for any number of trials
// of any scenes. It grows to what the largest trial needs; from then on the trials of a free hand
// do not allocate, except in the rare case in which rounding stalls epsilon and the full hull has
// to help (epsilon_l1). Inverse kinematics and the checks of an arm do allocate. Trials leave
// nothing in it that the next one could depend on.
class TrialWorkspace {
 public:
  TrialWorkspace();
  ~TrialWorkspace();
  TrialWorkspace(TrialWorkspace&& other) noexcept;
  TrialWorkspace& operator=(TrialWorkspace&& other) noexcept;

  // Internal, for run_trial.
  struct Buffers;
  Buffers& buffers() { return *buffers_; }

 private:
  std::unique_ptr<Buffers> buffers_;
};

// As run_trial above, in the memory of `workspace` and of `trial`, which is replaced. After
// Cancelled, `trial` means nothing. The context has no default, since making one allocates.
void run_trial(const CompiledScene& scene, const Candidate& candidate, const TrialOptions& options,
               TrialWorkspace& workspace, Trial& trial, const RunContext& context);

// The same without asking the arm, where there is one, whether it follows.
void run_hand_trial(const CompiledScene& scene, const Candidate& candidate,
                    const TrialOptions& options, TrialWorkspace& workspace, Trial& trial,
                    const RunContext& context);

}  // namespace prehend
