// Worlds as Python holds them, and who may touch one while it moves.
#pragma once

#include <optional>
#include <pybind11/pybind11.h>

#include "sim/motion/step_options.h"
#include "sim/motion/world.h"

namespace prehend::python {

namespace py = pybind11;

// A world and what is going on with it. Its members are only touched with the GIL held.
class WorldHandle {
 public:
  WorldHandle() = default;
  explicit WorldHandle(World world) : world_(std::move(world)) {}

  // To be looked at, or to be changed in what moves it. Throws std::runtime_error while another
  // thread steps it without the GIL.
  World& now();
  // To be changed in where things are: what steps know of contacts is forgotten, bodies that sleep
  // wake up, and the next step first checks that nothing overlaps.
  World& moved();
  // To get more bodies or robots. Also throws while a run holds on to those that are there.
  World& extended();

  // Throws InputError for a world that cannot be stepped, unless that is known of it.
  void require_sound(const StepOptions& options);

 private:
  friend class Stepping;
  friend class Asking;

  World world_;
  bool is_sound_ = false;     // require_world has seen it since things were moved
  bool is_running_ = false;   // a run or step is going on
  bool is_stepping_ = false;  // and it does not hold the GIL
};

// While it lives the world may be stepped, and the GIL is released. Throws std::runtime_error where
// that is going on already.
class Stepping {
 public:
  explicit Stepping(WorldHandle& handle);
  ~Stepping();  // NOLINT(bugprone-exception-escape)
  Stepping(const Stepping&) = delete;
  Stepping& operator=(const Stepping&) = delete;

  World& world() { return handle_.world_; }

 private:
  WorldHandle& handle_;
  std::optional<py::gil_scoped_release> no_gil_;
};

// While it lives, between two steps, the GIL is held and Python may look at the world.
class Asking {
 public:
  explicit Asking(WorldHandle& handle);
  ~Asking();
  Asking(const Asking&) = delete;
  Asking& operator=(const Asking&) = delete;

 private:
  const py::gil_scoped_acquire gil_;
  WorldHandle& handle_;
};

}  // namespace prehend::python
