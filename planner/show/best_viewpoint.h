// Choice of the viewing direction that shows most of a grasp.
#pragma once

#include <unordered_map>
#include <vector>

#include "planner/show/picture/drawn_body.h"
#include "sim/base/pose.h"
#include "sim/base/run_context.h"

namespace prehend {

struct CompiledScene;
struct PosedGrasp;

// The directions that are chosen from: unit vectors from what is looked at to the eye, in the
// world's frame, around the upper half of the sphere. Always the same ones.
std::vector<Vector3> viewing_directions();

// Chooses for any number of grasps in one scene; simplified meshes of its bodies are kept between
// them.
class ViewpointSearch {
 public:
  // Keeps a reference to the scene.
  explicit ViewpointSearch(const CompiledScene& scene);

  // The one of viewing_directions() with the best score, of equal ones the first. The score is
  //   (mean over the links that touch + least of them + 1/2 mean over all links) * clear.
  // The first two terms are about contacts: how much of the friction cones of a link is seen, less
  // the more the viewer looks along a cone's axis, as the mean over the link's contacts, so that a
  // link with many contacts counts as much as one with a single one. The third is about the hand:
  // the root of a link's pixels over its pixels from where it is largest. `clear` is the part of
  // the hand's pixels before which no obstacle stands. The hand, the arm and obstacles hide what is
  // behind them, the object dims it. Where every score is 0 because of obstacles, they do not
  // count. Scores are those of small pictures: the few best of rough ones are compared again in
  // finer ones. Throws Cancelled.
  Vector3 best(const PosedGrasp& grasp, const RunContext& context = {}) const;

 private:
  const CompiledScene& scene_;
  std::unordered_map<const TriangleMesh*, SharedMesh> coarse_;  // of meshes with many triangles
};

// The same for one grasp.
Vector3 best_viewpoint(const CompiledScene& scene, const PosedGrasp& grasp,
                       const RunContext& context = {});

}  // namespace prehend
