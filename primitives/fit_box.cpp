#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "primitives/fit_shapes.h"
#include "primitives/normal_equations.h"
#include "primitives/quantile.h"
#include "primitives/ranked_starts.h"

namespace prehend {
namespace {

// A box is fitted by robust Gauss-Newton from several starts. The starts are the best of many
// frames (principal axes of points and normals, each axis turned in steps, directions of the
// half-sphere), since Gauss-Newton only finds the nearest local minimum. Each step assigns every
// point to the face plane that it is nearest to and solves for a small turn of the frame and all
// six face positions.

// A box as three pairs of parallel planes.
struct Slabs {
  Matrix3 R_OP = Matrix3::Identity();  // axes as columns
  Vector3 low = Vector3::Zero();       // face positions along the axes
  Vector3 high = Vector3::Zero();
};

// A point relative to the box. Of the six signed distances from the face planes (positive outside)
// the largest counts: inside the box that is the nearest face.
struct BoxPoint {
  Vector3 q = Vector3::Zero();  // in the frame of the box
  int face = 0;                 // 0 to 2: high side of that axis, 3 to 5: low side
  double residual = 0.0;        // signed distance from the plane of the face
};

BoxPoint seen_from(const Slabs& box, const Vector3& p_O) {
  BoxPoint seen;
  seen.q = box.R_OP.transpose() * p_O;
  Eigen::Matrix<double, 6, 1> beyond;
  beyond << seen.q - box.high, box.low - seen.q;
  seen.residual = beyond.maxCoeff(&seen.face);
  return seen;
}

Primitive primitive_of(const Slabs& box, double min_extent) {
  const Vector3 size = (box.high - box.low).cwiseMax(min_extent);
  return {Box{size}, pose_from(box.R_OP, box.R_OP * (0.5 * (box.low + box.high)))};
}

// Face positions that leave the fraction `tail` of the points outside of each.
Slabs slabs_in_frame(const Matrix3& R_OP, std::span<const SurfacePoint> points, double tail) {
  Slabs box{R_OP, Vector3::Zero(), Vector3::Zero()};
  std::vector<double> along(points.size());
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      along[i] = R_OP.col(axis).dot(points[i].p_O);
    }
    box.low[axis] = quantile(along, tail);
    box.high[axis] = quantile(along, 1.0 - tail);
  }
  return box;
}

// Frames with their third axis along `axis`, turned about it in six equal steps of a quarter turn
// (15 degrees); the box is the same after a quarter.
void add_turned_frames(const Vector3& axis, std::vector<Matrix3>& frames) {
  constexpr int kTurns = 6;
  const Vector3 u = any_orthogonal(axis);
  const Vector3 v = axis.cross(u);
  for (int i = 0; i < kTurns; ++i) {
    const double angle = 0.5 * std::numbers::pi * i / kTurns;
    Matrix3 frame;
    frame.col(0) = std::cos(angle) * u + std::sin(angle) * v;
    frame.col(2) = axis;
    frame.col(1) = axis.cross(frame.col(0));
    frames.push_back(frame);
  }
}

std::vector<Matrix3> starting_frames(std::span<const SurfacePoint> points, bool thorough) {
  constexpr int kDirections = 12;
  std::vector<Matrix3> frames = {point_axes(points), normal_axes(points)};
  const std::vector<Matrix3> principal = frames;
  for (const Matrix3& axes : principal) {
    for (int i = 0; i < 3; ++i) add_turned_frames(axes.col(i), frames);
  }
  if (thorough) {
    for (const Vector3& d : half_sphere_directions(kDirections)) add_turned_frames(d, frames);
  }
  return frames;
}

std::vector<Slabs> box_starts(std::span<const SurfacePoint> points, const FitOptions& options) {
  return ranked_starts(
      starting_frames(points, options.thorough), points, options, slabs_in_frame,
      [](const Slabs& box, const Vector3& p_O) { return seen_from(box, p_O).residual; });
}

// Faces that the points do not cover, such as the open top of a carton: those with far fewer points
// than their share of the box's area. `support`: weight of the points per face.
std::array<bool, 6> open_faces(const Slabs& box, const std::array<double, 6>& support) {
  // A closed face has about its share of the points. An open one still gets some, from the rim of
  // the faces beside it, but far fewer than a quarter.
  constexpr double kCovered = 0.25;
  const Vector3 size = (box.high - box.low).cwiseMax(0.0);
  const Vector3 area(size.y() * size.z(), size.z() * size.x(), size.x() * size.y());
  double total = 0.0;
  for (const double weight : support) total += weight;
  std::array<bool, 6> open{};
  for (std::size_t face = 0; face < 6; ++face) {
    // Face f and the opposite face f + 3 have the same area, which is one of three.
    const double expected = total * area[static_cast<int>(face % 3)] / (2.0 * area.sum());
    open[face] = !(support[face] > kCovered * expected);
  }
  return open;
}

// Unknowns: a small turn about each axis (0-2), high faces (3-5), low faces (6-8).
using BoxEquations = NormalEquations<9>;

void add_point(BoxEquations& equations, const BoxPoint& seen, double weight) {
  const int axis = seen.face % 3;
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const double sign = seen.face < 3 ? 1.0 : -1.0;
  // A turn w of the frame moves the point's coordinates by q x w. So only the turns about the two
  // other axes and the position of its own face change a point's residual.
  const std::array<int, 3> unknown = {u, v, 3 + seen.face};
  const std::array<double, 3> slope = {-sign * seen.q[v], sign * seen.q[u], -sign};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      equations.normal(unknown[i], unknown[j]) += weight * slope[i] * slope[j];
    }
    equations.right[unknown[i]] -= weight * slope[i] * seen.residual;
  }
}

// Moves an uncovered face to where the surface of the faces beside it ends: to the extreme of the
// points near those faces, without the outermost 0.5 %.
void close_face(Slabs& box, int face, std::span<const BoxPoint> seen, double cutoff) {
  constexpr double kTail = 0.005;
  const int axis = face % 3;
  std::vector<double> along;
  for (const BoxPoint& s : seen) {
    Vector3 beyond = (s.q - box.high).cwiseMax(box.low - s.q);
    beyond[axis] = -std::numeric_limits<double>::infinity();
    if (std::abs(beyond.maxCoeff()) < cutoff) along.push_back(s.q[axis]);
  }
  if (along.empty()) return;
  if (face < 3) {
    box.high[axis] = quantile(along, 1.0 - kTail);
  } else {
    box.low[axis] = quantile(along, kTail);
  }
}

// One Gauss-Newton step about the points' own centre: iteratively reweighted least squares on the
// distance of each point from the face it is nearest to. Which face that is, and the weights, are
// computed anew in every step.
Step improve(Slabs& box, std::span<const SurfacePoint> points, const FitOptions& options) {
  std::vector<BoxPoint> seen;
  std::vector<double> residuals;
  for (const SurfacePoint& s : points) {
    seen.push_back(seen_from(box, s.p_O));
    residuals.push_back(seen.back().residual);
  }
  const double cutoff = robust_cutoff(residuals, options);
  BoxEquations equations;
  Step step;
  std::array<double, 6> support{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double sign = seen[i].face < 3 ? 1.0 : -1.0;
    const double facing = facing_weight(points[i].n_O, sign * box.R_OP.col(seen[i].face % 3));
    const double weight = biweight(residuals[i], cutoff) * facing;
    step.loss_before += facing * point_loss(residuals[i], options.outlier);
    support[static_cast<std::size_t>(seen[i].face)] += weight;
    add_point(equations, seen[i], weight);
  }
  const std::array<bool, 6> open = open_faces(box, support);
  for (int face = 0; face < 6; ++face) {
    if (!open[static_cast<std::size_t>(face)]) continue;
    equations.fix(3 + face);
    close_face(box, face, seen, cutoff);
  }
  const BoxEquations::Vector change = equations.damped_change();
  if (!change.allFinite()) return step;
  turn_frame(box.R_OP, change.head<3>());
  box.high += change.segment<3>(3);
  box.low += change.segment<3>(6);
  step.change = change.norm();
  return step;
}

}  // namespace

Primitive fit_box(std::span<const SurfacePoint> points, const FitOptions& options) {
  constexpr double kConverged = 1e-10;
  // About the points' mean, so that turning the frame does not also move the box.
  Vector3 mean = Vector3::Zero();
  for (const SurfacePoint& s : points) mean += s.p_O / static_cast<double>(points.size());
  std::vector<SurfacePoint> centered(points.begin(), points.end());
  for (SurfacePoint& s : centered) s.p_O -= mean;

  Slabs best;
  double best_loss = std::numeric_limits<double>::infinity();
  for (Slabs box : box_starts(centered, options)) {
    for (int i = 0; i <= options.steps; ++i) {
      // The loss belongs to the box before the step: that is the one to keep.
      const Slabs before = box;
      const Step step = improve(box, centered, options);
      if (step.loss_before < best_loss) {
        best = before;
        best_loss = step.loss_before;
      }
      if (step.change < kConverged || (box.high - box.low).minCoeff() < 0.0) break;
    }
  }
  Primitive found = primitive_of(best, options.min_extent);
  found.X_OP.pretranslate(mean);
  return found;
}

}  // namespace prehend
