#include "planner/python/background.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

namespace prehend::python {
namespace {

// The work runs in a second thread without the GIL. The calling thread waits for it and takes the
// GIL now and then, to let Python handle signals and to call the callback. The two threads exchange
// the latest progress, not a queue of all: a slow callback must not hold up the work.

// How long a signal may wait while the work reports nothing.
constexpr std::chrono::milliseconds kPatience(20);

// Messages from the working thread to the waiting one.
class Mailbox {
 public:
  struct News {
    std::optional<Progress> progress;
    bool done = false;
  };

  void put(const Progress& progress) {
    {
      const std::lock_guard lock(mutex_);
      news_.progress = progress;
    }
    // After the lock is released, so that the woken thread need not wait for it.
    arrived_.notify_one();
  }

  void put_done() {
    {
      const std::lock_guard lock(mutex_);
      news_.done = true;
    }
    arrived_.notify_one();
  }

  // What came since the last call. Waits for something to come, for kPatience at most.
  News take() {
    std::unique_lock lock(mutex_);
    arrived_.wait_for(lock, kPatience, [&] { return news_.progress || news_.done; });
    News news = news_;
    news_.progress.reset();
    return news;
  }

 private:
  std::mutex mutex_;
  std::condition_variable arrived_;
  News news_;
};

// Lets Python handle signals and calls the callback, with the GIL. Throws py::error_already_set
// where either raises an exception.
void listen(const std::optional<Progress>& progress, const py::object& callback) {
  const py::gil_scoped_acquire gil;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (progress && !callback.is_none()) callback(*progress);
}

}  // namespace

void run_in_background(const CallOptions& options,
                       const std::function<void(const RunContext&)>& work) {
  Mailbox mailbox;
  RunContext context;
  context.threads = options.threads;
  context.cancellation = options.cancellation;
  context.deadline = options.deadline;
  if (!options.progress.is_none()) {
    context.progress = [&mailbox](const Progress& progress) { mailbox.put(progress); };
  }
  std::exception_ptr of_work;
  std::exception_ptr of_python;
  {
    const py::gil_scoped_release no_gil;
    std::thread worker([&] {
      try {
        work(context);
      } catch (...) {
        of_work = std::current_exception();
      }
      mailbox.put_done();
    });
    for (bool done = false; !done;) {
      const Mailbox::News news = mailbox.take();
      done = news.done;
      if (of_python) continue;  // only the end of the work is waited for
      try {
        listen(news.progress, options.progress);
      } catch (...) {
        of_python = std::current_exception();
        options.cancellation.request();
      }
    }
    worker.join();
  }
  // Where both are there, Python's exception is the cause: it cancelled the work, which may have
  // thrown Cancelled for that reason. Both are thrown here, with the GIL held again.
  if (of_python) std::rethrow_exception(of_python);
  if (of_work) std::rethrow_exception(of_work);
}

}  // namespace prehend::python
