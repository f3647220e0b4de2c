// What all parts of a batch share, read once: hands, scenes and settings with the names of their
// contents.
#pragma once

#include <string>
#include <vector>

#include "planner/bulk/batch.h"
#include "planner/bulk/batch_part.h"

namespace prehend {

// A scene with the hand that a part uses, and an object that is to be replaced.
struct SceneTemplate {
  Scene scene;
  std::string key;  // of all that it says but for its object
};

// Immutable, shared by threads.
class BatchInputs {
 public:
  // Reads hands, scenes and settings. Throws InputError for those that cannot be read: a batch with
  // such a hand is a mistake, not one with a broken mesh.
  explicit BatchInputs(const Batch& batch);

  const SceneTemplate& scene_of(const BatchPart& part) const {
    return scenes_[part.scene * hand_count_ + part.hand];
  }
  // The options with the part's seed, as a search takes them (search_settings).
  const PlanOptions& options_of(const BatchPart& part) const {
    return options_[part.setting * seed_count_ + part.seed];
  }
  // As JSON text, also the seed.
  const std::string& settings_of(const BatchPart& part) const {
    return settings_[part.setting * seed_count_ + part.seed];
  }

 private:
  std::size_t hand_count_;
  std::size_t seed_count_;
  std::vector<SceneTemplate> scenes_;
  std::vector<PlanOptions> options_;
  std::vector<std::string> settings_;
};

// The name of what is known before the object is read: program, batch fields, hand, scene and
// settings. `object_key`: of the object's mesh.
std::string part_key(const Batch& batch, const BatchInputs& inputs, const BatchPart& part,
                     const std::string& object_key);

}  // namespace prehend
