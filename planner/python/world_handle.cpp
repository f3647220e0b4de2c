#include "planner/python/world_handle.h"

#include <stdexcept>

#include "sim/motion/require_world.h"

namespace prehend::python {

World& WorldHandle::now() {
  if (is_stepping_) throw std::runtime_error("another thread is stepping the world");
  return world_;
}

World& WorldHandle::moved() {
  World& world = now();
  world.memory = {};
  world.contacts.clear();
  for (WorldBody& body : world.bodies) {
    body.asleep = false;
    body.rest_time = 0.0;
  }
  is_sound_ = false;
  return world;
}

World& WorldHandle::extended() {
  if (is_running_) throw std::runtime_error("a run of the world is going on");
  return moved();
}

void WorldHandle::require_sound(const StepOptions& options) {
  if (is_sound_) return;
  require_world(now(), options);
  is_sound_ = true;
}

Stepping::Stepping(WorldHandle& handle) : handle_(handle) {
  if (handle.is_running_) throw std::runtime_error("a run of the world is going on");
  handle.is_running_ = true;
  handle.is_stepping_ = true;
  no_gil_.emplace();
}

// Taking the GIL throws nothing.
// NOLINTNEXTLINE(bugprone-exception-escape)
Stepping::~Stepping() {
  no_gil_.reset();
  handle_.is_stepping_ = false;
  handle_.is_running_ = false;
}

Asking::Asking(WorldHandle& handle) : handle_(handle) { handle_.is_stepping_ = false; }

Asking::~Asking() { handle_.is_stepping_ = true; }

}  // namespace prehend::python
