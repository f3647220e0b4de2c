#include "planner/show/best_viewpoint.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>

#include "planner/show/grasp_bodies.h"
#include "planner/show/picture/draw.h"
#include "planner/show/picture/simplified_mesh.h"
#include "planner/show/picture/visible_pixels.h"
#include "sim/base/index.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {
namespace {

// Renders a small picture from each of a fixed set of directions, counts how many pixels of each
// link and each friction cone are visible, and takes the direction with the best score
// (best_viewpoint.h).

// Weight of seeing the hand, against seeing the contacts.
constexpr double kHandPart = 0.5;

// More triangles of a body would not show in the small pictures.
constexpr std::size_t kMostTriangles = 2000;

// Scores closer than this count as equal, so that rounding does not choose between symmetric sides.
constexpr double kSameScore = 1e-9;

// The bodies of the small pictures, by their role.
struct SmallScene {
  std::vector<DrawnBody> framed;     // fills the picture: object, hand and cones
  std::vector<DrawnBody> seen;       // the hand's links, then the cones
  std::size_t links = 0;             // of the hand
  std::vector<DrawnBody> around;     // object and arm
  std::vector<DrawnBody> obstacles;  // drawn solid here; empty when they are not to count
};

// The body with a simplified mesh where it has many triangles.
DrawnBody coarse(DrawnBody body) {
  if (body.mesh->triangles.size() > kMostTriangles) {
    body.mesh = simplified(*body.mesh, kMostTriangles);
  }
  return body;
}

std::vector<DrawnBody> coarse(std::vector<DrawnBody> bodies) {
  for (DrawnBody& body : bodies) body = coarse(std::move(body));
  return bodies;
}

SmallScene small_scene(const CompiledScene& scene, const PosedGrasp& grasp, bool with_obstacles) {
  const GraspBodies bodies = grasp_bodies(scene, grasp);
  const DrawnBody object = coarse(bodies.object);
  SmallScene small;
  small.links = bodies.hand.size();
  small.seen = coarse(bodies.hand);
  small.seen.insert(small.seen.end(), bodies.contacts.begin(), bodies.contacts.end());
  // The arm and the obstacles are not framed: they may be far larger than the grasp.
  small.framed = small.seen;
  small.framed.push_back(object);
  small.around = coarse(bodies.arm);
  small.around.push_back(object);
  if (with_obstacles) small.obstacles = coarse(bodies.obstacles);
  // Obstacles are translucent in pictures, but what is behind them is hard to see.
  for (DrawnBody& body : small.obstacles) body.color.opacity = 1.0;
  return small;
}

// What is seen from one direction.
struct View {
  std::vector<double> links;     // pixels of each link
  std::vector<double> contacts;  // of each cone, the part that is not hidden, less along its axis
  double clear = 1.0;            // the part of the hand that no obstacle stands before
};

double sum(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

View view_from(const Vector3& direction, const SmallScene& small, const CompiledScene& scene,
               const PosedGrasp& grasp, const PictureSize& size) {
  const Camera camera =
      camera_around(small.framed, direction, {.width = size.width, .height = size.height});
  const auto pixels_of = [&](const std::vector<DrawnBody>& seen,
                             const std::vector<DrawnBody>& around) {
    return visible_pixels(seen, around, camera, size.width, size.height);
  };
  // Pixels are counted twice where there are obstacles: without them, for the part of the hand that
  // they hide, and with them, for everything else.
  std::vector<double> pixels = pixels_of(small.seen, small.around);
  View view;
  if (!small.obstacles.empty()) {
    const double free = sum(std::span(pixels).first(small.links));
    std::vector<DrawnBody> around = small.around;
    around.insert(around.end(), small.obstacles.begin(), small.obstacles.end());
    pixels = pixels_of(small.seen, around);
    view.clear = free == 0.0 ? 0.0 : sum(std::span(pixels).first(small.links)) / free;
  }
  const auto cones = pixels.begin() + static_cast<std::ptrdiff_t>(small.links);
  view.links.assign(pixels.begin(), cones);
  for (std::size_t c = 0; c < grasp.contacts.size(); ++c) {
    // The visible part of the cone: its pixels over those it has with nothing around it. Seen along
    // its axis a cone looks like a disc and does not show where it points, hence the sine of the
    // angle between axis and viewing direction.
    const double alone = pixels_of({small.seen[small.links + c]}, {})[0];
    const Vector3 axis =
        scene.scene.object.X_WO.linear() * grasp.contacts[c].point.normal.normalized();
    const double aside = axis.cross(direction).norm();
    view.contacts.push_back(alone == 0.0 ? 0.0
                                         : aside * cones[static_cast<std::ptrdiff_t>(c)] / alone);
  }
  return view;
}

// The mean over the links that touch plus the least of them, where each link counts with the mean
// of what is seen of its contacts. The least keeps a view from hiding one finger behind the others.
double contact_score(const View& view, const PosedGrasp& grasp, std::size_t links) {
  std::vector<double> sums(links, 0.0);
  std::vector<int> counts(links, 0);
  for (std::size_t c = 0; c < view.contacts.size(); ++c) {
    const auto link = index(grasp.contacts[c].link);
    sums[link] += view.contacts[c];
    ++counts[link];
  }
  double sum = 0.0;
  // No link counts with more than 1, which is a cone that is wholly visible from the side.
  double least = 1.0;
  int touching = 0;
  for (std::size_t l = 0; l < links; ++l) {
    if (counts[l] == 0) continue;
    const double mean = sums[l] / counts[l];
    sum += mean;
    least = std::min(least, mean);
    ++touching;
  }
  return touching == 0 ? 0.0 : sum / touching + least;
}

// Mean over the links of how large each is, against the view in which it is largest.
double hand_score(const View& view, const std::vector<double>& largest) {
  double sum = 0.0;
  for (std::size_t l = 0; l < largest.size(); ++l) {
    // The root makes the first visible pixels of a link count most: a view that shows some of every
    // link is better than one that shows one link whole.
    if (largest[l] > 0.0) sum += std::sqrt(view.links[l] / largest[l]);
  }
  return largest.empty() ? 0.0 : sum / static_cast<double>(largest.size());
}

// A direction and its score.
struct Choice {
  Vector3 direction = Vector3::UnitZ();
  double score = 0.0;
};

Choice best_side(const CompiledScene& scene, const PosedGrasp& grasp, bool with_obstacles,
                 const PictureSize& size, const RunContext& context) {
  const SmallScene small = small_scene(scene, grasp, with_obstacles);
  const std::vector<Vector3> directions = viewing_directions();
  // All views come first, because hand_score compares each with the largest of them.
  std::vector<View> views;
  std::vector<double> largest(small.links, 0.0);
  for (const Vector3& direction : directions) {
    context.cancellation.check();
    views.push_back(view_from(direction, small, scene, grasp, size));
    for (std::size_t l = 0; l < small.links; ++l) {
      largest[l] = std::max(largest[l], views.back().links[l]);
    }
  }
  Choice best{directions.front()};
  for (std::size_t d = 0; d < directions.size(); ++d) {
    const double told =
        contact_score(views[d], grasp, small.links) + kHandPart * hand_score(views[d], largest);
    // What an obstacle covers counts as hidden in both parts already. The factor prefers, among
    // sides that tell as much, one on which nothing stands before the hand: an obstacle is drawn
    // translucent, but what is behind it is dim.
    const double score = told * views[d].clear;
    if (score > best.score + kSameScore) best = {directions[d], score};
  }
  return best;
}

}  // namespace

std::vector<Vector3> viewing_directions() {
  struct Ring {
    double elevation;  // rad
    int count;
  };
  std::vector<Vector3> directions;
  // Rings of constant elevation; those at the usual height of the eye come first and have most
  // directions, since the first of equal scores wins. Half a step of azimuth keeps directions off
  // the axes of the world, along which boxes show only one face.
  for (const Ring& ring : {Ring{0.5, 12}, Ring{0.17, 10}, Ring{0.95, 6}}) {
    for (int i = 0; i < ring.count; ++i) {
      const double angle = 2.0 * std::numbers::pi * (i + 0.5) / ring.count;
      directions.emplace_back(std::cos(ring.elevation) * std::cos(angle),
                              std::cos(ring.elevation) * std::sin(angle), std::sin(ring.elevation));
    }
  }
  directions.push_back(Vector3::UnitZ());
  return directions;
}

Vector3 best_viewpoint(const CompiledScene& scene, const PosedGrasp& grasp, const PictureSize& size,
                       const RunContext& context) {
  const Choice side = best_side(scene, grasp, true, size, context);
  // Where obstacles hide the grasp from every side, as a closed box does, they are left out.
  if (side.score > 0.0 || !scene.has_obstacles()) return side.direction;
  return best_side(scene, grasp, false, size, context).direction;
}

}  // namespace prehend
