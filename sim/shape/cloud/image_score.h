// How well the images of a seen surface agree with what was seen.
#pragma once

#include <vector>

#include "sim/shape/cloud/find_symmetry.h"

namespace prehend {

// Points spread evenly over a surface, for scores.
std::vector<SeenPoint> thinned_points(const std::vector<SeenPoint>& points, double apart,
                                      std::size_t most);

// What becomes of points under maps, in the mean of all of them.
struct ImageScore {
  double confirmed = 0.0;     // 0 to 1: on seen surface that faces the same way
  double contradicted = 0.0;  // 0 to 1: in free space

  double value() const { return confirmed - 2.5 * contradicted; }
};

class ImageScorer {
 public:
  ImageScorer(const std::vector<ObjectView>& views, const std::vector<SeenPoint>& points,
              const SymmetryOptions& options);

  ImageScore of(const Congruence& image) const;
  ImageScore of(const std::vector<Congruence>& images) const;  // the mean
  // 0 to 1: how far into free space a map takes a point.
  float contradiction(const Eigen::Vector3f& p_P) const;
  const std::vector<SeenPoint>& points() const { return *points_; }

 private:
  const std::vector<ObjectView>* views_;
  const std::vector<SeenPoint>* points_;
  SymmetryOptions options_;
};

// Maximises `score` of the parameters from `start`, by steps along one parameter at a time, which
// are halved where none of them is better (pattern search).
template <typename Parameters, typename Score>
Parameters climb(Parameters start, Parameters step, int halvings, const Score& score) {
  double best = score(start);
  for (int halving = 0; halving <= halvings;) {
    bool better = false;
    for (std::size_t k = 0; k < start.size(); ++k) {
      for (const double sign : {1.0, -1.0}) {
        Parameters moved = start;
        moved[k] += sign * step[k];
        const double value = score(moved);
        if (value <= best + 1e-9) continue;
        best = value;
        start = moved;
        better = true;
        break;
      }
    }
    if (better) continue;
    for (double& s : step) s *= 0.5;
    ++halving;
  }
  return start;
}

}  // namespace prehend
