// Where the object is relative to the open hand, judged by their surfaces alone.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "sim/base/named_enum.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/candidate.h"

namespace prehend {

enum class ObjectPlace {
  between,  // the fingers stand on both sides of it: closing, they will meet it
  beside,   // the closing fingers miss it
  inside,   // a finger's place is inside the object
  palm      // between the fingers, but the palm is in it as well, by more than poses may be off
};

// The same word as the enumerator.
constexpr auto enum_names(ObjectPlace /*of*/) {
  return std::to_array<std::string_view>({"between", "beside", "inside", "palm"});
}

// A hand in the posture in which it begins to close.
class OpenHand {
 public:
  // `grasp` must fit the hand. The scene must outlive this.
  OpenHand(const CompiledScene& scene, const Candidate& grasp);

  // With the hand's base at X_OH. The fingers stand at the ends of lines along Hand::closing, as
  // long as the hand is open: one through the place where they meet when they close
  // (Preshape::depth), and eight around it that go through the same fingertips.
  ObjectPlace place(const Pose& X_OH) const;

  // Whether a link of the hand crosses the surface of an obstacle of the scene.
  bool meets_obstacle(const Pose& X_OH) const;

 private:
  ObjectPlace along(const Vector3& from_O, const Vector3& closing_O) const;
  bool palm_meets_object(const Pose& X_OH) const;

  const CompiledScene* scene_;
  std::vector<Pose> X_HL_;            // of the links
  std::vector<std::size_t> palm_;     // links that no finger moves
  std::vector<Vector3> line_starts_;  // hand's base frame
  double opening_ = 0.0;              // length of the lines [m]
};

// How far the place where the fingers meet is in front of the hand's base, along the approach [m].
double tool_reach(const Hand& hand, const Preshape& preshape);

// The preshape that takes the widest objects.
const Preshape& widest_preshape(const Hand& hand);

}  // namespace prehend
