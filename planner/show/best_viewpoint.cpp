#include "planner/show/best_viewpoint.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

#include "planner/show/grasp_bodies.h"
#include "planner/show/picture/image.h"
#include "planner/show/picture/simplified_mesh.h"
#include "planner/show/picture/visible_pixels.h"
#include "sim/base/index.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {
namespace {

// Looks at simplified bodies from each of a fixed set of directions, counts how many pixels of each
// link and each friction cone are visible, and takes the direction with the best score
// (best_viewpoint.h). Rough pictures of all directions tell which few are worth finer ones.

// Pictures in which pixels are counted; they are not shown.
constexpr PictureSize kRough{64, 51};
constexpr PictureSize kFine{160, 128};

// Directions that are looked from again.
constexpr std::size_t kMostFine = 6;

// Weight of seeing the hand, against seeing the contacts.
constexpr double kHandPart = 0.5;

// More triangles of a body would not show in the small pictures.
constexpr std::size_t kMostTriangles = 500;

// Of the friction cones, for the same reason.
constexpr int kConeSides = 12;

// Scores closer than this count as equal, so that rounding does not choose between symmetric sides.
constexpr double kSameScore = 1e-9;

// What is seen from one direction.
struct View {
  std::vector<double> links;     // the part of the picture that shows each link
  std::vector<double> contacts;  // of each cone, the part that is not hidden, less along its axis
  double clear = 1.0;            // the part of the hand that no obstacle stands before
};

double sum(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

// What the pictures have to show of a grasp: the vertices of object, hand and cones in the world.
// The arm and the obstacles are not framed: they may be far larger than the grasp.
std::vector<Vector3> framed_points(const GraspBodies& bodies) {
  std::vector<Vector3> points;
  const auto add = [&](const DrawnBody& body) {
    for (const Vector3& p_B : body.mesh->vertices) points.push_back(body.X_WB * p_B);
  };
  std::for_each(bodies.hand.begin(), bodies.hand.end(), add);
  std::for_each(bodies.contacts.begin(), bodies.contacts.end(), add);
  add(bodies.object);
  return points;
}

// `axes` are those of the cones.
View view_from(const Vector3& direction, const GraspBodies& bodies,
               const std::vector<Vector3>& framed, const std::vector<Vector3>& axes,
               const PictureSize& size) {
  VisiblePixels picture(camera_around(framed, direction, size.width, size.height), size.width,
                        size.height);
  for (const DrawnBody& link : bodies.hand) picture.add(link);
  std::vector<double> alone;
  for (const DrawnBody& cone : bodies.contacts) alone.push_back(picture.add(cone));
  for (const DrawnBody& link : bodies.arm) picture.add(link);
  picture.add(bodies.object);
  const std::size_t links = bodies.hand.size();
  // Pixels are counted twice where there are obstacles: without them, for the part of the hand that
  // they hide, and with them, for everything else.
  std::vector<double> pixels = picture.counts();
  View view;
  if (!bodies.obstacles.empty()) {
    const double free = sum(std::span(pixels).first(links));
    for (const DrawnBody& obstacle : bodies.obstacles) picture.add(obstacle);
    pixels = picture.counts();
    view.clear = free == 0.0 ? 0.0 : sum(std::span(pixels).first(links)) / free;
  }
  for (std::size_t l = 0; l < links; ++l) {
    view.links.push_back(pixels[l] / (size.width * size.height));
  }
  for (std::size_t c = 0; c < alone.size(); ++c) {
    // The visible part of the cone: its pixels over those that it covers. Seen along its axis a
    // cone looks like a disc and does not show where it points, hence the sine of the angle between
    // axis and viewing direction.
    const double aside = axes[c].cross(direction).norm();
    view.contacts.push_back(alone[c] == 0.0 ? 0.0 : aside * pixels[links + c] / alone[c]);
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

// A direction, by its place among viewing_directions(), and its score.
struct Choice {
  std::size_t place = 0;
  double score = 0.0;
};

// Looks at one grasp.
class SideSearch {
 public:
  SideSearch(const GraspBodies& bodies, const PosedGrasp& grasp)
      : bodies_(bodies),
        grasp_(grasp),
        framed_(framed_points(bodies)),
        largest_(bodies.hand.size(), 0.0) {
    for (std::size_t c = 0; c < grasp.contacts.size(); ++c) {
      axes_.push_back(bodies.contacts[c].X_WB.linear() *
                      grasp.contacts[c].point.normal.normalized());
    }
  }

  Choice best(const RunContext& context) {
    std::vector<Choice> choices;
    for (std::size_t d = 0; d < directions_.size(); ++d) choices.push_back({d});
    look(kRough, context, choices);
    std::stable_sort(choices.begin(), choices.end(),
                     [](const Choice& a, const Choice& b) { return a.score > b.score; });
    choices.resize(std::min(choices.size(), kMostFine));
    std::sort(choices.begin(), choices.end(),
              [](const Choice& a, const Choice& b) { return a.place < b.place; });
    look(kFine, context, choices);
    Choice best = choices.front();
    for (const Choice& choice : choices) {
      if (choice.score > best.score + kSameScore) best = choice;
    }
    return best;
  }

 private:
  void look(const PictureSize& size, const RunContext& context, std::vector<Choice>& choices) {
    // All views come first, because hand_score compares each with the largest of them.
    std::vector<View> views;
    for (const Choice& choice : choices) {
      context.cancellation.check();
      views.push_back(view_from(directions_[choice.place], bodies_, framed_, axes_, size));
      for (std::size_t l = 0; l < largest_.size(); ++l) {
        largest_[l] = std::max(largest_[l], views.back().links[l]);
      }
    }
    for (std::size_t c = 0; c < choices.size(); ++c) {
      const double told = contact_score(views[c], grasp_, largest_.size()) +
                          kHandPart * hand_score(views[c], largest_);
      // What an obstacle covers counts as hidden in both parts already. The factor prefers, among
      // sides that tell as much, one on which nothing stands before the hand: an obstacle is drawn
      // translucent, but what is behind it is dim.
      choices[c].score = told * views[c].clear;
    }
  }

  const GraspBodies& bodies_;
  const PosedGrasp& grasp_;
  std::vector<Vector3> framed_;
  std::vector<Vector3> axes_;    // of the cones
  std::vector<double> largest_;  // of View::links, of all views so far
  std::vector<Vector3> directions_ = viewing_directions();
};

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

ViewpointSearch::ViewpointSearch(const CompiledScene& scene) : scene_(scene) {
  const auto prepare = [&](const TriangleMesh& mesh) {
    if (mesh.triangles.size() > kMostTriangles) coarse_[&mesh] = simplified(mesh, kMostTriangles);
  };
  prepare(scene.scene.object.mesh);
  for (const Link& link : scene.scene.hand.links) prepare(link.mesh);
  for (const StaticBody& body : scene.scene.obstacles) prepare(body.mesh);
  if (!scene.arm) return;
  const std::vector<Link>& platform = scene.arm->robot().links;
  for (std::size_t l = 0; l < platform.size(); ++l) {
    // Those of the hand are scene.hand's.
    if (!scene.arm->is_hand_link(link_id(l))) prepare(platform[l].mesh);
  }
}

Vector3 ViewpointSearch::best(const PosedGrasp& grasp, const RunContext& context) const {
  GraspBodies bodies = grasp_bodies(scene_, grasp, kConeSides);
  const auto coarsen = [&](DrawnBody& body) {
    const auto coarse = coarse_.find(&*body.mesh);
    if (coarse != coarse_.end()) body.mesh = coarse->second;
  };
  coarsen(bodies.object);
  for (std::vector<DrawnBody>* group : {&bodies.hand, &bodies.arm, &bodies.obstacles}) {
    std::for_each(group->begin(), group->end(), coarsen);
  }
  // Obstacles are translucent in pictures, but what is behind them is hard to see.
  for (DrawnBody& body : bodies.obstacles) body.color.opacity = 1.0;
  Choice side = SideSearch(bodies, grasp).best(context);
  // Where obstacles hide the grasp from every side, as a closed box does, they are left out.
  if (side.score == 0.0 && !bodies.obstacles.empty()) {
    bodies.obstacles.clear();
    side = SideSearch(bodies, grasp).best(context);
  }
  return viewing_directions()[side.place];
}

Vector3 best_viewpoint(const CompiledScene& scene, const PosedGrasp& grasp,
                       const RunContext& context) {
  return ViewpointSearch(scene).best(grasp, context);
}

}  // namespace prehend
