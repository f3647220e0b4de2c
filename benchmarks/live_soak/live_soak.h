// A live server with clients that try everything, and judges of what it answers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace prehend::live_soak {

struct LiveSoakOptions {
  int clients = 8;                                           // at once, at least 2
  long messages = std::numeric_limits<long>::max();          // of all clients together
  double seconds = std::numeric_limits<double>::infinity();  // after which it ends
  std::uint64_t seed = 1;
  std::size_t undo_memory = std::size_t{16} << 20U;  // SessionOptions::undo_memory
  // Whether the session is recorded, and has to come out the same when it is replayed.
  bool replays = false;
  std::function<bool()> interrupted = {};  // ends it; empty: nothing does
  // Is told now and then how far it is; may be empty.
  std::function<void(const struct LiveSoakResult&)> progress = {};
};

struct LiveSoakResult {
  long carried_out = 0;
  long refused = 0;
  int undone = 0;     // changes that were undone and made again
  int unchanged = 0;  // refused changes after which all was as before
  int evaluated = 0;  // grasps that evaluate() closed as well
  int stable = 0;     // of these
  int at_edges = 0;   // of these: JudgedGrasp::is_at_an_edge
  // How often each fault was found, and the first request that showed it.
  struct Fault {
    int count = 0;
    std::string first;
  };
  std::map<std::string, Fault> faults;
  // How often each command was refused for what problem.
  std::map<std::string, long> refusals;
  // Resident memory of this process, each time of the same session [MB]: ten times a quarter,
  // in a run of at least 100,000 messages.
  std::vector<double> resident;

  long messages() const { return carried_out + refused; }
  // Medians of the quarters that were measured in full.
  std::vector<double> quarters() const;
  // From the first quarter to the largest later one; 0.05 is 5 %.
  double growth() const;
};

// Serves a session on a free port of 127.0.0.1 and lets clients talk to it: each sends random
// requests, one after the other, and waits for the reply. Every few hundred requests all pause,
// while
// - a change by one client, undone and made again by another, has to lead to the same states;
// - a refused change has to leave the state as it was;
// - the hand is closed, which has to give the epsilon that evaluate() gives for the scene's file.
LiveSoakResult run_live_soak(const LiveSoakOptions& options);

}  // namespace prehend::live_soak
