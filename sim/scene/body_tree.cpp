#include "sim/scene/body_tree.h"

#include <algorithm>
#include <utility>

#include "sim/base/index.h"
#include "sim/shape/wide_tree.h"

namespace prehend {

struct BodyExtent {
  Bounds box;
  Vector3 center = Vector3::Zero();  // of a ball around the body
  double radius = 0.0;
};

namespace {

Bounds placed_bounds(const PlacedBody& body) {
  Bounds box;
  for (const Vector3& p : body.mesh.mesh().vertices) {
    const Vector3 q = body.X_RB * p;
    box.lower = box.lower.cwiseMin(q);
    box.upper = box.upper.cwiseMax(q);
  }
  return box;
}

// The tree is built over triangles: one for each box, from one corner to the opposite one.
void add_diagonal(const Bounds& box, TriangleMesh& diagonals) {
  const int first = static_cast<int>(diagonals.vertices.size());
  diagonals.vertices.insert(diagonals.vertices.end(), {box.lower, box.upper, box.center()});
  diagonals.triangles.push_back({first, first + 1, first + 2});
}

double squared_from_segment(const Vector3& p, const Vector3& from, const Vector3& to) {
  const Vector3 along = to - from;
  const double length = along.squaredNorm();
  const double at = length > 0.0 ? std::clamp((p - from).dot(along) / length, 0.0, 1.0) : 0.0;
  return (p - from - at * along).squaredNorm();
}

// The ball around the region tells bodies apart from its box's corners; the ball around the body
// does where the region runs oblique to the axes.
bool may_meet(const BodyExtent& body, const SweptBall& region) {
  const double apart = body.radius + region.radius;
  if (squared_from_segment(body.center, region.from, region.to) > apart * apart) return false;
  const Vector3 middle = 0.5 * (region.from + region.to);
  const double around = region.radius + 0.5 * (region.to - region.from).norm();
  const Vector3 beyond =
      (body.box.lower - middle).cwiseMax(middle - body.box.upper).cwiseMax(Vector3::Zero());
  return beyond.squaredNorm() <= around * around;
}

}  // namespace

struct BodyTree::Data {
  std::vector<BodyExtent> obstacles;
  WideTree tree;  // a leaf for each obstacle
};

BodyTree::BodyTree(const std::vector<PlacedBody>& bodies) {
  if (bodies.size() < 2) return;
  auto data = std::make_shared<Data>();
  TriangleMesh diagonals;
  for (std::size_t b = 1; b < bodies.size(); ++b) {
    const PlacedBody& body = bodies[b];
    data->obstacles.push_back(
        {placed_bounds(body), body.X_RB * body.mesh.ball_center(), body.mesh.ball_radius()});
    add_diagonal(data->obstacles.back().box, diagonals);
  }
  data->tree = build_wide_tree(build_box_tree(diagonals));
  data_ = std::move(data);
}

void BodyTree::find(const SweptBall& region, NearBodies& near) const {
  near.found.clear();
  if (data_ == nullptr) return;
  const Vector3 reach = Vector3::Constant(region.radius);
  near.in_box.clear();
  collect_in_box(data_->tree,
                 {region.from.cwiseMin(region.to) - reach, region.from.cwiseMax(region.to) + reach},
                 near.in_box);
  for (const int obstacle : near.in_box) {
    if (may_meet(data_->obstacles[index(obstacle)], region)) {
      near.found.push_back(BodyId::obstacle(obstacle));
    }
  }
  std::sort(near.found.begin(), near.found.end());
}

}  // namespace prehend
