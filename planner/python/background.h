// Long calls from Python: the work runs in a thread of its own, the thread that called waits for it
// and listens to Python meanwhile.
#pragma once

#include <functional>
#include <pybind11/pybind11.h>

#include "sim/base/run_context.h"

namespace prehend::python {

namespace py = pybind11;

// What a Python caller says about how a long call is to run.
struct CallOptions {
  int threads = 0;
  py::object progress = py::none();  // a callable that takes a Progress, or None
  Cancellation cancellation;
  Deadline deadline = {};
};

// Calls `work` with a context, in another thread and without the GIL, and returns once it is done.
// Until then the calling thread
// - calls `progress` with the latest progress: earlier ones that it had no time for are left out;
// - lets Python handle signals (if it is the main thread), at least every 20 ms.
// Where either raises an exception, Ctrl-C's KeyboardInterrupt for instance, the work is cancelled
// and the exception thrown on. What `work` throws is thrown on as well, Cancelled included.
//
// The callback runs in the thread that called, as Python code expects: a signal handler, a
// debugger and most user interfaces only work in the main one.
void run_in_background(const CallOptions& options,
                       const std::function<void(const RunContext&)>& work);

}  // namespace prehend::python
