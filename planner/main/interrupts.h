// Ctrl-C (SIGINT), SIGTERM and the end of the budget: the program stops early and leaves no
// half-written files.
#pragma once

#include <atomic>
#include <csignal>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>

#include "sim/base/deadline.h"
#include "sim/base/run_context.h"

namespace prehend {

// Waits for the signals on a thread of its own, where locks and output are allowed, unlike in a
// signal handler. Signals that the program was started to ignore (as a background job of a script)
// stay ignored.
//
// At first a signal ends the program at once, with a line on stderr. After cancel_first() it
// requests the cancellation instead, and a second signal ends the program.
class Interrupts {
 public:
  // Make it before any other thread, since threads inherit which signals are left to it.
  Interrupts();
  ~Interrupts();
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;

  const Cancellation& cancellation() const { return cancellation_; }

  // In `seconds` (> 0) of wall-clock time the budget is used up, which acts like a signal.
  void limit_time(double seconds);
  // When that is; the commands that return what they have begin no more work then. Without a limit
  // it never comes.
  const Deadline& deadline() const { return deadline_; }
  // From now on time has no limit. Returns whether the budget was used up before.
  bool unlimit_time();
  // The budget ended the work before its time was quite over: exit_status() and reason() say so.
  void use_up_budget();

  // From now on the first signal requests cancellation().
  void cancel_first();
  // From now on a signal ends the program at once. `words`: the end of its line on stderr, such as
  // "nothing is written".
  void end_at_once(const std::string& words);

  // Exit status of a program that a signal ended: 130 for Ctrl-C, 143 for SIGTERM; 124 for the
  // budget, as that of timeout(1).
  int exit_status() const;
  // What ended the program: "interrupted" or "the budget is used up".
  const char* reason() const;

  // As write_file, but not while the program is being ended: no part of a file stays behind.
  void write(const std::filesystem::path& file, const std::string& content);
  void write(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);

 private:
  void wait();
  void react();

  sigset_t watched_{};
  sigset_t before_{};
  Cancellation cancellation_;
  Deadline deadline_;
  std::atomic<int> signal_ = SIGINT;  // the last that came
  std::atomic<bool> is_over_ = false;
  std::timed_mutex lock_;  // of what follows, and held while a file is written
  bool cancels_ = false;
  static constexpr const char* kNothing = "nothing is written";
  std::string words_ = kNothing;
  std::thread waiter_;
};

}  // namespace prehend
