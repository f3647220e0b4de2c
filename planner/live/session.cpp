#include "planner/live/session.h"

#include <algorithm>
#include <utility>

#include "planner/live/start_posture.h"
#include "planner/live/state_memory.h"
#include "planner/results/grasps_file.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/json/json_field.h"
#include "sim/base/range.h"
#include "sim/scene/scene_file.h"

namespace prehend {
namespace {

// A file of grasps says what its scene is called; what is read back here is of the session's.
RunRecord record_of_session(const SessionState& state, const PlanOptions& options) {
  RunRecord record;
  record.scene = state.world->scene().name;
  record.options = options;
  return record;
}

// The arm's source and name: of another one, no posture is known.
std::string carrier_of(const Scene& scene) {
  return scene.carrier ? scene.carrier->source + " " + scene.carrier->platform.name : "";
}

// All that is about a world that is no more.
void forget_grasps(SessionState& state) {
  state.results.reset();
  state.outcome.reset();
  state.grasp.reset();
}

void require_fits(bool fits, const char* field, const char* problem, const std::string& value) {
  require(fits, {.field = field, .problem = problem, .value = value});
}

}  // namespace

Session::Session(SessionOptions options) : options_(std::move(options)) {
  state_.world = std::make_shared<const EditedScene>(scene_of_hand(kDefaultHand));
  state_.hand = start_posture(*state_.world, trial_options().reach);
}

Session::KeptState Session::kept(SessionState state) {
  KeptState kept{std::move(state), std::nullopt};
  if (const EditedScenePtr base = kept.state.world->base()) {
    kept.places = places_of(kept.state.world->scene());
    kept.state.world = base;
  }
  return kept;
}

SessionState Session::restored(KeptState kept) {
  if (kept.places) kept.state.world = with_bodies_at(kept.state.world, *kept.places);
  return std::move(kept.state);
}

// Forgets the oldest states where there are too many, or they take too much memory. `state_` is the
// present one.
void Session::limit_undo() {
  StateMemory memory;
  memory.add(state_.world.get());
  memory.add(state_.results.get());
  const std::size_t present = memory.bytes();
  std::size_t states = 0;
  while (states < undo_.size() && states < kMostUndo) {
    const SessionState& state = undo_[undo_.size() - 1 - states].state;
    memory.add(state.world.get());
    memory.add(state.results.get());
    if (memory.bytes() - present > options_.undo_memory) break;
    ++states;
  }
  undo_.erase(undo_.begin(), undo_.end() - static_cast<std::ptrdiff_t>(states));
}

void Session::push(SessionState next, const std::optional<Dragged>& dragged) {
  require_still(next);
  const bool goes_on = dragged && dragged_ == dragged;
  if (!goes_on) undo_.push_back(kept(std::move(state_)));
  redo_.clear();
  dragged_ = dragged;
  state_ = std::move(next);
  limit_undo();
  ++revision_;
}

void Session::require_no_plan() const {
  require_no_running_plan();
  require_still();
}

void Session::require_no_running_plan() const {
  require(!is_planning(), {.field = "command",
                           .problem = "a plan is running, which this would change the scene of: "
                                      "wait for its end, or plan.cancel"});
  require(!is_finding_path(), {.field = "command",
                               .problem = "a path is looked for, which this would change the scene "
                                          "of: wait for its end, or path.cancel"});
}

bool Session::undo() {
  require_no_plan();
  if (undo_.empty()) return false;
  redo_.push_back(kept(std::move(state_)));
  state_ = restored(std::move(undo_.back()));
  undo_.pop_back();
  dragged_.reset();
  ++revision_;
  return true;
}

bool Session::redo() {
  require_no_plan();
  if (redo_.empty()) return false;
  undo_.push_back(kept(std::move(state_)));
  state_ = restored(std::move(redo_.back()));
  redo_.pop_back();
  dragged_.reset();
  ++revision_;
  return true;
}

void Session::forget_history() {
  require_no_plan();
  undo_.clear();
  redo_.clear();
}

void Session::set_scene(Scene scene) {
  require_no_plan();
  SessionState next = state_;
  next.world = std::make_shared<const EditedScene>(std::move(scene));
  next.hand = start_posture(*next.world, trial_options().reach);
  next.arm.reset();
  forget_grasps(next);
  settle_arm(next);
  push(std::move(next));
}

void Session::edit(const std::function<void(Scene&)>& change) {
  require_no_plan();
  Scene scene = state_.world->scene();
  const std::string hand = scene.hand.name;
  const bool had_object = state_.world->has_object();
  change(scene);
  SessionState next = state_;
  if (scene.hand.name != hand || scene.hand.dofs.size() != state_.hand.dofs.size()) {
    next.hand.dofs = start_dofs(scene.hand);
    next.hand.joints = joint_values(scene.hand, next.hand.dofs);
  }
  if (carrier_of(scene) != carrier_of(state_.world->scene())) next.arm.reset();
  next.world = std::make_shared<const EditedScene>(std::move(scene));
  // The hand stays where it is in the world; the first object brings it a better place.
  const Pose& X_WO = state_.world->X_WO();
  const Pose& X_WO_next = next.world->X_WO();
  if (!had_object && next.world->has_object()) {
    next.hand.X_OH = start_posture(*next.world, trial_options().reach).X_OH;
  } else if (X_WO.matrix() != X_WO_next.matrix()) {
    next.hand.X_OH = X_WO_next.inverse() * X_WO * state_.hand.X_OH;
  }
  forget_grasps(next);
  settle_arm(next);
  push(std::move(next));
}

void Session::set_switches(const Switches& switches) {
  SessionState next = state_;
  next.switches = switches;
  push(std::move(next));
}

void Session::set_judge(const JudgeOptions& judge) {
  require_in(kJudgedEdges, judge.edges, "edges");
  if (judge.fixed) {
    const std::array<int, 3>& fixed = judge.fixed->coordinates;
    require(fixed[0] != fixed[1] && fixed[0] != fixed[2] && fixed[1] != fixed[2],
            {.field = "fixed", .problem = "must be three different coordinates"});
  }
  SessionState next = state_;
  next.judge = judge;
  push(std::move(next));
}

void Session::start_plan(const PlanOptions& options, const PlanListener& listener) {
  require_no_plan();
  (void)state_.world->compiled();
  job_ = std::make_unique<PlanJob>(state_.world->shared(), options, options_.threads, listener);
}

std::optional<Cancellation> Session::plan_cancellation() const {
  if (!job_) return std::nullopt;
  return job_->cancellation();
}

PlanResult Session::as_read(const std::string& text) const {
  return read_grasps(JsonFile("grasps", text), state_.world->compiled()).result;
}

std::string Session::finish_plan() {
  require(is_planning(), {.field = "command", .problem = "no plan is running"});
  const std::unique_ptr<PlanJob> job = std::move(job_);
  PlanResult result = job->take();
  std::string text;
  if (result.status == PlanStatus::cancelled) {
    text = grasps_json(job->scene(), result, record_of_session(state_, job->options()));
    result = as_read(text);
  }
  SessionState next = state_;
  next.results = std::make_shared<const PlanResult>(std::move(result));
  push(std::move(next));
  return text;
}

void Session::keep_results(const std::string& grasps_file) {
  PlanResult result = as_read(grasps_file);
  job_.reset();
  SessionState next = state_;
  next.results = std::make_shared<const PlanResult>(std::move(result));
  push(std::move(next));
}

std::string Session::grasps_text() const {
  require(state_.results != nullptr, {.field = "command", .problem = "nothing was planned here"});
  return grasps_json(state_.world->compiled(), *state_.results, record_of_session(state_, {}));
}

const ScoredGrasp& Session::result_at(std::size_t result) const {
  const bool is_there = state_.results && result < state_.results->grasps.size();
  require_fits(is_there, "grasp", "no result has this number", std::to_string(result));
  return state_.results->grasps[result];
}

void Session::go_to(std::size_t result) {
  const ScoredGrasp& scored = result_at(result);
  const Trial& trial = scored.trial;
  SessionState next = state_;
  next.hand = {hand_in_scene(trial), trial.dofs, trial.joints};
  next.outcome = trial.outcome;
  next.grasp = std::make_shared<const TriedGrasp>(TriedGrasp{scored.candidate, trial});
  hold_arm(next, trial.arm_dofs);
  push(std::move(next));
}

void Session::pin(const std::string& name) {
  const auto& pins = state_.pins;
  const bool used = std::any_of(pins.begin(), pins.end(),
                                [&](const PinnedGrasp& pinned) { return pinned.name == name; });
  require_fits(!used, "name", "another pin has this name", name);
  const double epsilon = quality().epsilon.lower;
  SessionState next = state_;
  next.pins.push_back({name, state_.world->scene().hand.name, state_.hand, epsilon});
  push(std::move(next));
}

void Session::unpin(const std::string& name) {
  SessionState next = state_;
  const auto gone =
      std::erase_if(next.pins, [&](const PinnedGrasp& pinned) { return pinned.name == name; });
  require_fits(gone > 0, "name", "no pin has this name", name);
  push(std::move(next));
}

void Session::go_to_pin(const std::string& name) {
  const auto pin = std::find_if(state_.pins.begin(), state_.pins.end(),
                                [&](const PinnedGrasp& pinned) { return pinned.name == name; });
  require_fits(pin != state_.pins.end(), "name", "no pin has this name", name);
  require_fits(pin->hand == state_.world->scene().hand.name, "name", "is a pin of another hand",
               pin->hand);
  SessionState next = state_;
  next.hand = pin->posture;
  next.outcome.reset();
  push(std::move(next));
}

}  // namespace prehend
