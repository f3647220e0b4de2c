// How much memory the states of a session take.
#pragma once

#include <cstddef>
#include <unordered_set>

#include "planner/live/edited_scene.h"
#include "planner/plan/plan.h"
#include "sim/shape/proximity_mesh.h"

namespace prehend {

// Adds up what states hold: the meshes and search trees of their scenes, and the results of plans.
// What several of them share counts once. A function of their contents alone, not of how memory was
// allocated, so that a recorded session forgets the same states when it is replayed. What is not
// counted is small beside it.
class StateMemory {
 public:
  // Each adds what was not added before. Null: nothing.
  void add(const EditedScene* world);
  void add(const PlanResult* results);

  std::size_t bytes() const { return bytes_; }

 private:
  bool is_new(const void* part) { return counted_.insert(part).second; }
  void add(const Robot& robot);
  void add(const TriangleMesh& mesh);
  void add(const CollisionBody& body);

  std::unordered_set<const void*> counted_;
  std::size_t bytes_ = 0;
};

}  // namespace prehend
