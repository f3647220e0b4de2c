// A fast check of an arm's motions that comes before the proof: simple shapes for the meshes, and
// eight postures at once.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "sim/scene/ids.h"

namespace prehend {

struct CompiledArm;

// What the filter says of a motion.
enum class FilterVerdict {
  free,     // proven: the surfaces of all pairs stay apart
  blocked,  // in some posture bodies overlap
  open,     // neither: see OpenStretch
};

// A part of a line between two postures, by how much of the line is before it (0 .. 1), and the
// pairs (indices) that the filter did not settle there. On the rest of the line, and for all other
// pairs, the motion is proven free.
struct OpenStretch {
  double from = 0.0;
  double to = 0.0;
  std::vector<std::size_t> pairs;
};

// What a motion is on which shapes overlap or nearly touch.
enum class IfClose { open, blocked };

// The pairs of an arm prepared for many motions. Of the meshes it sees only their ShapeCover: the
// distance between the shapes around two bodies is at most that between the bodies, and balls
// inside them that overlap show that the bodies do. Distances are lower bounds from separating
// axes: those of both shapes and the line between their centres. They are computed in single
// precision, with a margin for its rounding.
//
// A motion is divided into eight stretches, which are halved until each pair is free by its
// distance in the middle (as in motion_check.h), or meets there, or would have to be divided finer
// than is worth while. The same results on all processors. One thread at a time.
class MotionFilter {
 public:
  // Both must live as long as the filter.
  MotionFilter(const CompiledArm& arm, const std::vector<ArmPair>& pairs);
  ~MotionFilter();
  MotionFilter(const MotionFilter&) = delete;
  MotionFilter& operator=(const MotionFilter&) = delete;

  // The straight line between two postures (one value for each joint [rad or m]). `tightest`: as in
  // MotionCheckOptions. Where shapes overlap or are too close, and bodies are not known to overlap,
  // the line stays open there; `if_close`: or it counts as blocked, which is faster. `open` is
  // replaced: the stretches that are not settled, in order, when the verdict is `open`.
  FilterVerdict line(const std::vector<double>& from, const std::vector<double>& to,
                     double tightest, IfClose if_close, std::vector<OpenStretch>& open);

  // The pair (index) for which the last line was `blocked`.
  std::size_t blocker() const;

 private:
  class Lanes;
  std::unique_ptr<Lanes> lanes_;
};

}  // namespace prehend
