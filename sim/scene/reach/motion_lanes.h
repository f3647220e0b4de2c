// Frames, boxes, cylinders and balls in eight postures at once, for MotionFilter only.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "sim/base/index.h"
#include "sim/base/pose.h"
#include "sim/base/wide_lanes.h"
#include "sim/scene/collision_body.h"
#include "sim/shape/cover_shapes.h"

// Compilers warn, gcc at the end of the file, of calling conventions of functions that are inlined.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace prehend::motion_lanes {

// Added to the square of a sine that is found from the cosine, against rounding.
constexpr float kSineRounding = 4e-7F;
// Sine of the angle between two axes from which on the direction orthogonal to both is reliable.
constexpr float kLeastSine = 2e-2F;
// Distance of two axes [m] from which on the direction between them is reliable.
constexpr float kLeastOffset = 2e-2F;

struct Lanes3 {
  Floats8 x, y, z;
};

PREHEND_INLINE Floats8 all_lanes(float value) { return Floats8{} + value; }
PREHEND_INLINE Floats8 larger(const Floats8& a, const Floats8& b) { return a > b ? a : b; }
PREHEND_INLINE Floats8 smaller(const Floats8& a, const Floats8& b) { return a < b ? a : b; }
PREHEND_INLINE Floats8 above_0(const Floats8& a) { return larger(a, Floats8{}); }
PREHEND_INLINE Floats8 size_of(const Floats8& a) { return larger(a, -a); }
PREHEND_INLINE Floats8 dot(const Lanes3& a, const Lanes3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
PREHEND_INLINE Lanes3 minus(const Lanes3& a, const Lanes3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
PREHEND_INLINE Lanes3 times(const Lanes3& a, const Floats8& s) {
  return {a.x * s, a.y * s, a.z * s};
}
PREHEND_INLINE Floats8 root(const Floats8& a) {
  Floats8 result = a;
  take_roots(result);
  return result;
}
// The lanes in which a <= b, a bit each.
PREHEND_INLINE unsigned at_most(const Floats8& a, const Floats8& b) {
  const Ints8 is = a <= b;
  return bits_of(is);
}

// Sine and cosine from their Taylor series around the next multiple of a right angle, which is
// taken off in two parts so that it does not round.
PREHEND_INLINE void sine_cosine(const Floats8& angle, Floats8& sine, Floats8& cosine) {
  const Floats8 turns = angle * 0.63661977F;
  const Floats8 half = turns > 0.0F ? all_lanes(0.5F) : all_lanes(-0.5F);
  const Ints8 whole = __builtin_convertvector(turns + half, Ints8);
  const Floats8 k = __builtin_convertvector(whole, Floats8);
  const Floats8 x = (angle - k * 1.5703125F) - k * 4.8382679e-4F;
  const Floats8 xx = x * x;
  const Floats8 s =
      x +
      x * xx *
          (-1.0F / 6.0F + xx * (1.0F / 120.0F + xx * (-1.0F / 5040.0F + xx * (1.0F / 362880.0F))));
  const Floats8 c =
      1.0F + xx * (-0.5F + xx * (1.0F / 24.0F + xx * (-1.0F / 720.0F + xx * (1.0F / 40320.0F))));
  const Ints8 is_odd = (whole & 1) != 0;
  const Floats8 s_turned = is_odd ? c : s;
  const Floats8 c_turned = is_odd ? s : c;
  const Ints8 sine_flips = (whole & 2) != 0;
  const Ints8 cosine_flips = ((whole + 1) & 2) != 0;
  sine = sine_flips ? -s_turned : s_turned;
  cosine = cosine_flips ? -c_turned : c_turned;
}

// A constant frame: the columns of its rotation, and its origin.
struct ConstantFrame {
  std::array<std::array<float, 3>, 3> axis{};
  std::array<float, 3> origin{};
};

inline ConstantFrame constant(const Pose& X) {
  ConstantFrame frame;
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i)
      frame.axis[index(k)][index(i)] = static_cast<float>(X.linear()(i, k));
    frame.origin[index(k)] = static_cast<float>(X.translation()[k]);
  }
  return frame;
}

// Frames in the platform's base frame, one in each lane.
struct LaneFrame {
  std::array<Lanes3, 3> axis;
  Lanes3 origin;
};

inline LaneFrame in_all_lanes(const ConstantFrame& frame) {
  const auto spread = [](const std::array<float, 3>& v) {
    return Lanes3{all_lanes(v[0]), all_lanes(v[1]), all_lanes(v[2])};
  };
  return {{spread(frame.axis[0]), spread(frame.axis[1]), spread(frame.axis[2])},
          spread(frame.origin)};
}

PREHEND_INLINE Lanes3 turned(const LaneFrame& X, const std::array<float, 3>& v) {
  return {X.axis[0].x * v[0] + X.axis[1].x * v[1] + X.axis[2].x * v[2],
          X.axis[0].y * v[0] + X.axis[1].y * v[1] + X.axis[2].y * v[2],
          X.axis[0].z * v[0] + X.axis[1].z * v[1] + X.axis[2].z * v[2]};
}
PREHEND_INLINE Lanes3 placed(const LaneFrame& X, const std::array<float, 3>& p) {
  const Lanes3 v = turned(X, p);
  return {X.origin.x + v.x, X.origin.y + v.y, X.origin.z + v.z};
}
PREHEND_INLINE LaneFrame placed(const LaneFrame& X, const ConstantFrame& Y) {
  return {{turned(X, Y.axis[0]), turned(X, Y.axis[1]), turned(X, Y.axis[2])}, placed(X, Y.origin)};
}

// A joint in a frame whose z axis is the joint's: first the constant frame, in that after the
// parent's motion, then the motion along or about z.
struct LaneJoint {
  int parent = -1;
  bool slides = false;
  double zero = 0.0;  // added to its value [rad or m]
  ConstantFrame frame;
};

struct LaneShape {
  ConstantFrame frame;
  std::array<float, 3> half{};
  float disc = 0.0F;
  float ball = 0.0F;
  bool is_round = false;  // about z
  // The same of a smaller shape within the body, less the margin for rounding.
  bool is_filled = false;
  std::array<float, 3> inner_half{};
  float inner_disc = 0.0F;
  float inner_ball = 0.0F;
};

struct LaneBall {
  std::array<float, 3> center{};
  float radius = 0.0F;
};

// A link or body: its shapes in the frame after the motion of its joint, or in the base frame.
struct LaneBody {
  int joint = -1;
  LaneBall around;
  std::vector<LaneShape> shapes;
  std::vector<LaneBall> inside;  // less the margin for rounding
};

inline LaneShape lane_shape(const CoverShape& shape, const Pose& X_JM, double rounding) {
  LaneShape lanes;
  lanes.frame = constant(X_JM * shape.X_MS);
  lanes.disc = static_cast<float>(shape.disc);
  lanes.ball = static_cast<float>(shape.ball);
  lanes.is_round = shape.half.x() == 0.0 && shape.half.y() == 0.0;
  const auto inner = [&](double size) { return size * shape.inside - rounding; };
  lanes.is_filled = shape.inside > 0.0;
  for (int k = 0; k < 3; ++k) {
    lanes.half[index(k)] = static_cast<float>(shape.half[k]);
    lanes.inner_half[index(k)] = static_cast<float>(std::max(0.0, inner(shape.half[k])));
    if (shape.ball == 0.0 && shape.half[k] > 0.0 && inner(shape.half[k]) <= 0.0)
      lanes.is_filled = false;
  }
  lanes.inner_disc = static_cast<float>(std::max(0.0, inner(shape.disc)));
  lanes.inner_ball = static_cast<float>(std::max(0.0, inner(shape.ball)));
  return lanes;
}

inline LaneBody lane_body(const CollisionBody& body, const Pose& X_JM, int joint, double rounding) {
  const ShapeCover& cover = cover_of(body.mesh);
  const auto ball_of = [&](const Vector3& center, double radius) {
    const Eigen::Vector3f p = (X_JM * center).cast<float>();
    return LaneBall{{p.x(), p.y(), p.z()}, static_cast<float>(radius)};
  };
  LaneBody result{.joint = joint,
                  .around = ball_of(body.mesh.ball_center(), body.mesh.ball_radius()),
                  .shapes = {},
                  .inside = {}};
  for (const CoverShape& shape : cover.shapes) {
    result.shapes.push_back(lane_shape(shape, X_JM, rounding));
    result.shapes.back().is_filled = result.shapes.back().is_filled && body.is_solid;
  }
  for (const InnerBall& ball : cover.inside) {
    if (ball.radius == 0.0 || body.is_solid)
      result.inside.push_back(ball_of(ball.center, std::max(0.0, ball.radius - rounding)));
  }
  return result;
}

// A shape in every posture.
struct PlacedShape {
  LaneFrame X;
  const LaneShape* shape = nullptr;
};

// How far a shape reaches along the unit vectors n, without its ball.
PREHEND_INLINE Floats8 extent(const PlacedShape& of, const Lanes3& n) {
  const LaneShape& shape = *of.shape;
  const Floats8 along = size_of(dot(of.X.axis[2], n));
  if (!shape.is_round) {
    return along * shape.half[2] + size_of(dot(of.X.axis[0], n)) * shape.half[0] +
           size_of(dot(of.X.axis[1], n)) * shape.half[1];
  }
  if (shape.disc == 0.0F) return along * shape.half[2];
  return along * shape.half[2] + shape.disc * root(above_0(1.0F - along * along) + kSineRounding);
}

// Lower bounds of the squared distance between the shapes without their balls, from directions
// that belong to `a`: its axes where it is a box; else its axis and the direction from it to the
// centre of b. They are orthogonal, so that the squares of what separates along each add up.
PREHEND_INLINE Floats8 squared_apart(const PlacedShape& a, const PlacedShape& b) {
  const LaneShape& shape = *a.shape;
  const Lanes3 to = minus(b.X.origin, a.X.origin);
  const Floats8 along = dot(to, a.X.axis[2]);
  const Floats8 over = above_0(size_of(along) - shape.half[2] - extent(b, a.X.axis[2]));
  Floats8 sum = over * over;
  if (shape.is_round) {
    const Lanes3 out = minus(to, times(a.X.axis[2], along));
    const Floats8 distance = root(dot(out, out));
    const Floats8 safe = larger(distance, all_lanes(kLeastOffset));
    const Floats8 beside = above_0(distance - shape.disc - extent(b, times(out, 1.0F / safe)));
    return distance > kLeastOffset ? sum + beside * beside : sum;
  }
  for (std::size_t k = 0; k < 2; ++k) {
    const Floats8 beside =
        above_0(size_of(dot(to, a.X.axis[k])) - shape.half[k] - extent(b, a.X.axis[k]));
    sum += beside * beside;
  }
  return sum;
}

// Lower bounds as those above, from the directions orthogonal to an axis of each: what separates
// edges, and the sides of round shapes.
PREHEND_INLINE Floats8 squared_across(const PlacedShape& a, const PlacedShape& b) {
  const Lanes3 to = minus(b.X.origin, a.X.origin);
  Floats8 most = {};
  for (std::size_t i = a.shape->is_round ? 2 : 0; i < 3; ++i) {
    for (std::size_t k = b.shape->is_round ? 2 : 0; k < 3; ++k) {
      const Lanes3& u = a.X.axis[i];
      const Lanes3& v = b.X.axis[k];
      const Lanes3 n = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
      const Floats8 length = root(dot(n, n));
      const Lanes3 unit = times(n, 1.0F / larger(length, all_lanes(kLeastSine)));
      const Floats8 apart = size_of(dot(to, unit)) - extent(a, unit) - extent(b, unit);
      most = length > kLeastSine ? larger(most, apart) : most;
    }
  }
  return most * most;
}

// In which lanes a ball reaches into the smaller shape within a body.
PREHEND_INLINE unsigned reaches(const Lanes3& center, float radius, const PlacedShape& of) {
  const LaneShape& shape = *of.shape;
  const Lanes3 from = minus(center, of.X.origin);
  const Floats8 along = dot(from, of.X.axis[2]);
  const Floats8 over = above_0(size_of(along) - shape.inner_half[2]);
  Floats8 sum = over * over;
  if (shape.is_round) {
    const Floats8 beside =
        above_0(root(above_0(dot(from, from) - along * along)) - shape.inner_disc);
    sum += beside * beside;
  } else {
    for (std::size_t k = 0; k < 2; ++k) {
      const Floats8 out = above_0(size_of(dot(from, of.X.axis[k])) - shape.inner_half[k]);
      sum += out * out;
    }
  }
  const float within = radius + shape.inner_ball;
  return at_most(sum, all_lanes(within * within));
}

}  // namespace prehend::motion_lanes
