#include "planner/main/interrupts.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <pthread.h>
#include <sys/time.h>
#include <unistd.h>

#include "sim/base/output_file.h"

namespace prehend {
namespace {

bool is_ignored(int signal) {
  struct sigaction action {};
  return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

// The destructor sends this signal to the waiting thread alone, to end its wait.
constexpr int kWake = SIGUSR1;

// Sent by the kernel when the budget is used up.
constexpr int kTimeIsUp = SIGALRM;

}  // namespace

Interrupts::Interrupts() {
  ::sigemptyset(&watched_);
  ::sigaddset(&watched_, kWake);
  ::sigaddset(&watched_, kTimeIsUp);
  for (const int signal : {SIGINT, SIGTERM}) {
    if (!is_ignored(signal)) ::sigaddset(&watched_, signal);
  }
  // sigwait gets a signal only if it is blocked in all threads; otherwise it may be delivered to
  // another one. Threads inherit the mask of the one that starts them, so it is set before the
  // first is started.
  ::pthread_sigmask(SIG_BLOCK, &watched_, &before_);
  waiter_ = std::thread([this] { wait(); });
}

Interrupts::~Interrupts() {
  // In this order: the waiter looks at is_over_ when the signal wakes it. The mask is restored once
  // no thread waits any more.
  is_over_ = true;
  ::pthread_kill(waiter_.native_handle(), kWake);
  waiter_.join();
  // A program that was told to end is about to: a second signal that came meanwhile would kill it
  // here, before it says so with its exit status.
  if (cancellation_.requested()) return;
  // Nor does one that came too late to be waited for.
  const timespec at_once{};
  while (::sigtimedwait(&watched_, nullptr, &at_once) > 0) {
  }
  ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void Interrupts::limit_time(double seconds) {
  deadline_ = Deadline::in(seconds);
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  // At least one microsecond: a timer of 0 is one that is off.
  const double rest = 1e6 * (seconds - std::floor(seconds));
  timer.it_value.tv_usec = std::max<suseconds_t>(1, static_cast<suseconds_t>(rest));
  ::setitimer(ITIMER_REAL, &timer, nullptr);
}

bool Interrupts::unlimit_time() {
  const itimerval off{};
  ::setitimer(ITIMER_REAL, &off, nullptr);
  return cancellation_.requested() && signal_.load() == kTimeIsUp;
}

void Interrupts::use_up_budget() { signal_ = kTimeIsUp; }

int Interrupts::exit_status() const {
  constexpr int kTimeout = 124;
  const int signal = signal_.load();
  return signal == kTimeIsUp ? kTimeout : 128 + signal;
}

const char* Interrupts::reason() const {
  return signal_.load() == kTimeIsUp ? "the budget is used up" : "interrupted";
}

void Interrupts::cancel_first() {
  const std::lock_guard lock(lock_);
  cancels_ = true;
}

void Interrupts::end_at_once(const std::string& words) {
  const std::lock_guard lock(lock_);
  cancels_ = false;
  words_ = words;
}

void Interrupts::write(const std::filesystem::path& file, const std::string& content) {
  write(file, [&](std::ostream& stream) { stream << content; });
}

void Interrupts::write(const std::filesystem::path& file,
                       const std::function<void(std::ostream&)>& write) {
  const std::lock_guard lock(lock_);
  write_file(file, write);
  if (words_ == kNothing) words_ = "not all files may be written";
}

void Interrupts::wait() {
  int signal = 0;
  while (::sigwait(&watched_, &signal) == 0) {
    if (is_over_) return;
    // Sent by someone else.
    if (signal == kWake) continue;
    signal_ = signal;
    react();
  }
}

void Interrupts::react() {
  // A second signal ends the program, too, where a file that is being written takes longer than
  // this.
  if (cancellation_.requested()) {
    const std::unique_lock patient(lock_, std::chrono::seconds(1));
    std::_Exit(exit_status());
  }
  const std::lock_guard lock(lock_);
  cancellation_.request();
  if (cancels_) return;
  // A progress bar may be on the current line of the terminal.
  const char* start = ::isatty(STDERR_FILENO) != 0 ? "\n" : "";
  std::fprintf(stderr, "%sprehend: %s, %s\n", start, reason(), words_.c_str());
  // _Exit runs no destructors: other threads are still working with what these would destroy.
  std::_Exit(exit_status());
}

}  // namespace prehend
