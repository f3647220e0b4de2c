// What becomes of an object that a hand grasps, pushes or loses.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/named_enum.h"
#include "sim/motion/dynamic_grasp/scene_world.h"

namespace prehend {

// What happened to the object, in the order of time.
enum class ObjectEventKind {
  touched,  // by a link of the hand, for the first time
  gripped,  // the hand presses on it from opposite sides
  lifted,   // it rose with the hand, clear of what it stood on
  tilted,   // it has tipped over: it lies otherwise than it stood, and lower
  left,     // no link of the hand touches it any more
  fell,     // it is lower than where it stood
};

// The name in files: the same word as the enumerator.
constexpr auto enum_names(ObjectEventKind /*of*/) {
  return std::to_array<std::string_view>(
      {"touched", "gripped", "lifted", "tilted", "left", "fell"});
}

struct ObjectEvent {
  ObjectEventKind kind = ObjectEventKind::touched;
  double time = 0.0;      // s
  std::string link = {};  // of touched: which one; of left: the last one that touched
};

// How it ended for the object.
enum class ObjectEnd {
  held,          // the hand presses on it from opposite sides
  touching,      // the hand touches it, from one side
  untouched,     // the hand never touched it
  pushed_away,   // the hand touched it from one side only, and it is out of its reach
  toppled,       // pushed over: it lies otherwise than it stood, and the hand does not touch it
  squeezed_out,  // the hand gripped it, and it slipped out
  dropped,       // the hand had lifted it
};

// The name in files: the same word as the enumerator.
constexpr auto enum_names(ObjectEnd /*of*/) {
  return std::to_array<std::string_view>(
      {"held", "touching", "untouched", "pushed_away", "toppled", "squeezed_out", "dropped"});
}

// What the end means, as a clause for people.
constexpr std::string_view object_end_meaning(ObjectEnd end) {
  constexpr std::array<std::string_view, kAll<ObjectEnd>.size()> kMeanings = {
      "the hand holds the object from opposite sides",
      "the hand touches the object from one side only",
      "the hand did not touch the object",
      "the hand pushed the object away",
      "the hand pushed the object over",
      "the object slipped out of the closing hand",
      "the object fell out of the hand that had lifted it"};
  return kMeanings[static_cast<std::size_t>(end)];
}

// Looks at a world after each of its steps.
class ObjectWatch {
 public:
  // `start`: before anything touches the object.
  ObjectWatch(const World& start, const WorldHand& hand);

  // `time`: after all steps so far [s].
  void look(const World& world, double time);

  const std::vector<ObjectEvent>& events() const { return events_; }
  bool has_left() const { return happened(ObjectEventKind::left); }
  // For how long no link of the hand has been near it, 0 before it was touched [s].
  double alone_for(double time) const;
  ObjectEnd end() const;

 private:
  bool happened(ObjectEventKind kind) const;
  void note(ObjectEventKind kind, double time, std::string link = {});

  WorldHand hand_;
  Vector3 up_O_;         // the vertical of the start, in the object
  double height_ = 0.0;  // of the centre of mass at the start
  bool touches_ = false;
  bool grips_ = false;
  std::optional<double> alone_since_;
  std::string last_link_;
  std::vector<ObjectEvent> events_;
};

// Links of the hand that press on the object in the last step of a world, without repetition,
// ascending.
std::vector<SolidId> links_on_object(const World& world, const WorldHand& hand);

}  // namespace prehend
