// What every long call takes besides its arguments: how many threads it may use, how it is told to
// stop, and whom it tells how far it is. Nothing in it changes a result that is complete.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <string_view>

namespace prehend {

// Thrown by calls that were told to stop and have nothing to return.
class Cancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "cancelled"; }
};

// A flag that is raised once and stays up. Copies share it: keep one, hand another to the call, and
// request() from any thread. Long calls look at it at least every 50 ms of work.
class Cancellation {
 public:
  // Also allowed in a signal handler (on a Cancellation that outlives the handler).
  void request() const noexcept { requested_->store(true, std::memory_order_relaxed); }

  bool requested() const noexcept { return requested_->load(std::memory_order_relaxed); }

  // Throws Cancelled once that was requested. One load of an atomic: cheap enough for inner loops.
  void check() const {
    if (requested()) throw Cancelled();
  }

 private:
  // Signal handlers may touch only atomics that need no lock.
  static_assert(std::atomic<bool>::is_always_lock_free);
  std::shared_ptr<std::atomic<bool>> requested_ = std::make_shared<std::atomic<bool>>(false);
};

// What a run is busy with.
enum class Stage {
  load,        // files are read
  compile,     // search structures of the scene are built
  primitives,  // the object is decomposed
  candidates,  // grasps are proposed
  trials,      // and tried
  rank,
  paths,    // of the arm, to the best grasps
  volumes,  // of the wrench hulls of what is returned, and sections of them
  report,
  picture
};

inline constexpr std::array<Stage, 10> kStages = {
    Stage::load, Stage::compile, Stage::primitives, Stage::candidates, Stage::trials,
    Stage::rank, Stage::paths,   Stage::volumes,    Stage::report,     Stage::picture};

// "load", ...: the word of the files and the progress lines.
constexpr std::string_view stage_name(Stage stage) {
  constexpr std::array<std::string_view, kStages.size()> kNames = {
      "load", "compile", "primitives", "candidates", "trials",
      "rank", "paths",   "volumes",    "report",     "picture"};
  return kNames[static_cast<std::size_t>(stage)];
}

// How far a stage is.
struct Progress {
  Stage stage = Stage::trials;
  int done = 0;
  int total = 0;
  int stable = 0;  // of the trials done, those whose grasp holds
};

// A value: copies share the cancellation.
struct RunContext {
  int threads = 0;  // to use, 0: as many as there are processors
  Cancellation cancellation = {};
  // Called after each piece of a stage (a trial, a path), never by two threads at once; may be
  // empty. It may request the cancellation. An exception from it ends the call and is thrown on.
  std::function<void(const Progress&)> progress = {};
};

}  // namespace prehend
