// Common parameter of all long calls: number of threads, cancellation, progress report and
// deadline. None of it changes the result of a call that completes.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <string_view>

#include "sim/base/deadline.h"
#include "sim/base/named_enum.h"

namespace prehend {

// Thrown by a call that was cancelled before it had a result to return.
class Cancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "cancelled"; }
};

// A flag by which another thread or a signal handler stops a long call. It is set once and never
// cleared. Copies share the flag: keep one, pass another to the call, and call request() from any
// thread. Long calls check it at least every 50 ms of work.
class Cancellation {
 public:
  // Asks all calls that share this flag to stop. May be called in a signal handler, if the
  // Cancellation outlives the handler.
  void request() const noexcept { requested_->store(true, std::memory_order_relaxed); }

  // True once request() was called on this object or on a copy of it.
  bool requested() const noexcept { return requested_->load(std::memory_order_relaxed); }

  // Throws Cancelled if a stop was requested. Costs one relaxed atomic load, so inner loops can
  // afford it.
  void check() const {
    if (requested()) throw Cancelled();
  }

 private:
  // Only lock-free atomics may be accessed in a signal handler.
  static_assert(std::atomic<bool>::is_always_lock_free);
  std::shared_ptr<std::atomic<bool>> requested_ = std::make_shared<std::atomic<bool>>(false);
};

// The steps of a run, as they are reported in Progress.
enum class Stage {
  load,        // scene, robot and mesh files are read
  compile,     // the collision structures of the scene are built
  primitives,  // the object is decomposed into shape primitives
  candidates,  // candidate grasps are generated
  trials,      // every candidate grasp is tried
  rank,        // stable grasps are sorted
  close,       // the best grasps are closed again, on an object that gives way
  refine,      // the best grasps are improved by trials of grasps near them
  paths,       // arm paths to the best grasps are planned
  volumes,     // volumes and sections of the wrench hulls of the returned grasps
  disturb,     // grasps are tried again on disturbed poses
  shake,       // grasps are closed, lifted and shaken
  report,      // the report is written
  picture      // pictures are rendered
};

// Name of a stage in files and progress lines: "load", "compile" and so on.
constexpr auto enum_names(Stage /*of*/) {
  return std::to_array<std::string_view>({"load", "compile", "primitives", "candidates", "trials",
                                          "rank", "close", "refine", "paths", "volumes", "disturb",
                                          "shake", "report", "picture"});
}

// How far a stage is: `done` of `total` pieces of work (trials, paths).
struct Progress {
  Stage stage = Stage::trials;
  int done = 0;
  int total = 0;
  int stable = 0;  // number of finished trials with a stable grasp
};

// How long one stage took.
struct StageTime {
  Stage stage = Stage::trials;
  double seconds = 0.0;
};

// Passed to long calls by reference or value; copies share the cancellation flag.
struct RunContext {
  int threads = 0;  // number of worker threads; 0: one per processor
  Cancellation cancellation = {};
  // Called after each finished piece of a stage (a trial, a path), never by two threads at once;
  // may be empty. It may request cancellation. An exception thrown by it ends the call and reaches
  // the caller.
  std::function<void(const Progress&)> progress = {};
  // plan() and evaluate() begin no more trials, paths and volumes after it, and return what they
  // have; other calls do not look at it.
  Deadline deadline = {};
};

}  // namespace prehend
