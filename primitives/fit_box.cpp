#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "primitives/fit_shapes.h"
#include "primitives/normal_equations.h"
#include "primitives/quantile.h"
#include "primitives/ranked_starts.h"
#include "sim/shape/sphere_directions.h"

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

// The points relative to the box. Of a point's six signed distances from the face planes (positive
// outside) the largest counts: inside the box that is the nearest face.
struct BoxView {
  Eigen::MatrixX3d q;        // in the frame of the box
  Eigen::ArrayXd residuals;  // signed distances from the planes of the faces
};

BoxView seen_from(const Slabs& box, const PointColumns& points) {
  BoxView seen{in_frame(box.R_OP, points.p), {}};
  const auto x = seen.q.col(0).array();
  const auto y = seen.q.col(1).array();
  const auto z = seen.q.col(2).array();
  seen.residuals = (x - box.high.x()).max(box.low.x() - x).max(y - box.high.y());
  seen.residuals = seen.residuals.max(box.low.y() - y).max(z - box.high.z()).max(box.low.z() - z);
  return seen;
}

// The face that a point of these coordinates is nearest to; 0 to 2: high side of that axis, 3 to 5:
// low side.
int nearest_face(const Slabs& box, const Vector3& q) {
  Eigen::Matrix<double, 6, 1> beyond;
  beyond << q - box.high, box.low - q;
  int face = 0;
  for (int other = 1; other < 6; ++other) {
    if (beyond[other] > beyond[face]) face = other;
  }
  return face;
}

Primitive primitive_of(const Slabs& box, double min_extent) {
  const Vector3 size = (box.high - box.low).cwiseMax(min_extent);
  return {Box{size}, pose_from(box.R_OP, box.R_OP * (0.5 * (box.low + box.high)))};
}

// Face positions that leave the fraction `tail` of the points outside of each.
Slabs slabs_in_frame(const Matrix3& R_OP, const PointColumns& points, double tail) {
  Slabs box{R_OP, Vector3::Zero(), Vector3::Zero()};
  Eigen::MatrixX3d q = in_frame(R_OP, points.p);
  for (int axis = 0; axis < 3; ++axis) {
    const std::span<double> along(q.col(axis).data(), static_cast<std::size_t>(q.rows()));
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

std::vector<Slabs> box_starts(std::span<const SurfacePoint> points, const PointColumns& columns,
                              const FitOptions& options) {
  return ranked_starts(
      starting_frames(points, options.thorough), columns, options, slabs_in_frame,
      [](const Slabs& box, const PointColumns& few) { return seen_from(box, few).residuals; });
}

// Unknowns: a small turn about each axis (0-2), high faces (3-5), low faces (6-8).
using BoxEquations = NormalEquations<9>;

// Sums over the points that are nearest to one face, of their weights times the products of their
// residuals r and their coordinates u, v along the two axes after that of the face.
struct FaceSums {
  double one = 0.0;
  double u = 0.0;
  double v = 0.0;
  double uu = 0.0;
  double uv = 0.0;
  double vv = 0.0;
  double r = 0.0;
  double ru = 0.0;
  double rv = 0.0;
};

void add_point(FaceSums& sums, const Vector3& q, int axis, double residual, double weight) {
  const double u = q[(axis + 1) % 3];
  const double v = q[(axis + 2) % 3];
  const double r = weight * residual;
  sums.one += weight;
  sums.u += weight * u;
  sums.v += weight * v;
  sums.uu += weight * u * u;
  sums.uv += weight * u * v;
  sums.vv += weight * v * v;
  sums.r += r;
  sums.ru += r * u;
  sums.rv += r * v;
}

// A turn w of the frame moves a point's coordinates by q x w. So only the turns about the two other
// axes and the position of its own face change a point's residual, by -sign (v, -u, 1), where sign
// is 1 for the high faces and -1 for the low ones.
void add_face(BoxEquations& equations, int face, const FaceSums& sums) {
  const int axis = face % 3;
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const double sign = face < 3 ? 1.0 : -1.0;
  equations.normal(u, u) += sums.vv;
  equations.normal(v, v) += sums.uu;
  equations.normal(std::max(u, v), std::min(u, v)) -= sums.uv;
  equations.normal(3 + face, u) += sums.v;
  equations.normal(3 + face, v) -= sums.u;
  equations.normal(3 + face, 3 + face) += sums.one;
  equations.right[u] += sign * sums.rv;
  equations.right[v] -= sign * sums.ru;
  equations.right[3 + face] += sign * sums.r;
}

// Faces that the points do not cover, such as the open top of a carton: those with far fewer points
// than their share of the box's area.
std::array<bool, 6> open_faces(const Slabs& box, const std::array<FaceSums, 6>& sums) {
  // A closed face has about its share of the points. An open one still gets some, from the rim of
  // the faces beside it, but far fewer than a quarter.
  constexpr double kCovered = 0.25;
  const Vector3 size = (box.high - box.low).cwiseMax(0.0);
  const Vector3 area(size.y() * size.z(), size.z() * size.x(), size.x() * size.y());
  double total = 0.0;
  for (const FaceSums& face : sums) total += face.one;
  std::array<bool, 6> open{};
  for (std::size_t face = 0; face < 6; ++face) {
    // Face f and the opposite face f + 3 have the same area, which is one of three.
    const double expected = total * area[static_cast<int>(face % 3)] / (2.0 * area.sum());
    open[face] = !(sums[face].one > kCovered * expected);
  }
  return open;
}

// Moves an uncovered face to where the surface of the faces beside it ends: to the extreme of the
// points near those faces, without the outermost 0.5 %.
void close_face(Slabs& box, int face, const Eigen::MatrixX3d& q, double cutoff) {
  constexpr double kTail = 0.005;
  const int axis = face % 3;
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  std::vector<double> along;
  for (Eigen::Index i = 0; i < q.rows(); ++i) {
    const double beyond = std::max(std::max(q(i, u) - box.high[u], box.low[u] - q(i, u)),
                                   std::max(q(i, v) - box.high[v], box.low[v] - q(i, v)));
    if (std::abs(beyond) < cutoff) along.push_back(q(i, axis));
  }
  if (along.empty()) return;
  if (face < 3) {
    box.high[axis] = quantile(along, 1.0 - kTail);
  } else {
    box.low[axis] = quantile(along, kTail);
  }
}

struct BoxSums {
  std::array<FaceSums, 6> faces;
  double loss = 0.0;  // as Step::loss_before
};

BoxSums sums_of(const Slabs& box, const PointColumns& points, const BoxView& seen, double cutoff,
                const FitOptions& options) {
  BoxSums sums;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const Vector3 q = seen.q.row(i);
    const int face = nearest_face(box, q);
    const double sign = face < 3 ? 1.0 : -1.0;
    const double facing = facing_weight(points.n.row(i), sign * box.R_OP.col(face % 3));
    const double residual = seen.residuals[i];
    sums.loss += facing * point_loss(residual, options.outlier);
    const double weight = biweight(residual, cutoff) * facing;
    if (!(weight > 0.0)) continue;
    add_point(sums.faces[static_cast<std::size_t>(face)], q, face % 3, residual, weight);
  }
  return sums;
}

// One Gauss-Newton step about the points' own centre: iteratively reweighted least squares on the
// distance of each point from the face it is nearest to. Which face that is, and the weights, are
// computed anew in every step.
Step improve(Slabs& box, const PointColumns& points, const FitOptions& options) {
  const BoxView seen = seen_from(box, points);
  const double cutoff = robust_cutoff(seen.residuals, options);
  const BoxSums sums = sums_of(box, points, seen, cutoff, options);
  BoxEquations equations;
  for (int face = 0; face < 6; ++face) {
    add_face(equations, face, sums.faces[static_cast<std::size_t>(face)]);
  }
  const std::array<bool, 6> open = open_faces(box, sums.faces);
  for (int face = 0; face < 6; ++face) {
    if (!open[static_cast<std::size_t>(face)]) continue;
    equations.fix(3 + face);
    close_face(box, face, seen.q, cutoff);
  }
  Step step{sums.loss, 0.0};
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
  const PointColumns centered = columns_about(mean, points);

  Slabs best;
  double best_loss = std::numeric_limits<double>::infinity();
  for (Slabs box : box_starts(points, centered, options)) {
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
