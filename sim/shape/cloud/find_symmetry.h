// Symmetries of a thing of which one side was seen.
#pragma once

#include <vector>

#include "sim/shape/cloud/object_view.h"
#include "sim/shape/cloud/reconstruct.h"

namespace prehend {

// A map of frame P to itself that keeps lengths; it may mirror.
using Congruence = Eigen::Isometry3f;

struct FoundSymmetry {
  Symmetry kind = Symmetry::none;
  std::vector<Congruence> images;  // that take the body to itself, without the identity
  double confirmed = 0.0;  // share of the seen surface that its images find seen, in the mean
  // Share of the seen surface whose images are where nothing is: a part that the symmetry does not
  // take in, such as the handle of a mug.
  double apart = 0.0;
};

struct SymmetryOptions {
  float tolerance = 0.003F;  // of a seen surface [m]
  bool upright = true;       // z of P is the normal of a support at z = 0, below which nothing is
};

// The symmetry that leaves least to guess: a revolution, two mirrors, one mirror, in this order, of
// those that the views allow. The surface is taken along; where its images would have been seen and
// were not, they speak against it (after Bohg et al. 2011, "Mind the gap").
FoundSymmetry find_symmetry(const std::vector<ObjectView>& views,
                            const std::vector<SeenPoint>& points, const SymmetryOptions& options);

// Of each point, how much its images speak against the symmetry: 0 (not at all) to 1.
std::vector<float> contradictions(const std::vector<ObjectView>& views,
                                  const std::vector<SeenPoint>& points,
                                  const std::vector<Congruence>& images,
                                  const SymmetryOptions& options);

}  // namespace prehend
