#include "sim/scene/reach/motion_filter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <span>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/wide_lanes.h"
#include "sim/scene/compiled_arm.h"
#include "sim/shape/cover_shapes.h"

// What takes or returns lanes is always inlined, so that there is no calling convention to differ
// between processors. (gcc warns of it at the end of the file: the warning stays off.)
#pragma GCC diagnostic ignored "-Wpsabi"
#define PREHEND_INLINE [[gnu::always_inline]] inline

namespace prehend {
// With a name, because members of MotionFilter::Lanes are of these types.
namespace motion_lanes {

constexpr std::size_t kPostures = 8;

// Where the shapes of a pair overlap, only the meshes can tell: stretches from whose middle it
// moves by less than this [m] are not halved any more.
constexpr double kFinestOverlap = 1e-2;
// How often a stretch is halved at most.
constexpr int kMostLevels = 14;

// Bound of the rounding errors of a distance, relative to the size of the space that the arm and
// the bodies take: some hundred operations in single precision.
constexpr double kLaneRounding = 1e-5;
// Angles beyond this [rad] are too coarse in single precision.
constexpr double kLargestAngle = 20.0;
// Added to the square of a sine that is found from the cosine, for the same reason.
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

ConstantFrame constant(const Pose& X) {
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

LaneFrame in_all_lanes(const ConstantFrame& frame) {
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

LaneShape lane_shape(const CoverShape& shape, const Pose& X_JM, double rounding) {
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

LaneBody lane_body(const CollisionBody& body, const Pose& X_JM, int joint, double rounding) {
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

// Sorts stretches and joins those that overlap or touch, with the pairs of both.
void join_neighbours(std::vector<OpenStretch>& open) {
  std::sort(open.begin(), open.end(),
            [](const OpenStretch& a, const OpenStretch& b) { return a.from < b.from; });
  std::vector<OpenStretch> joined;
  for (OpenStretch& stretch : open) {
    if (joined.empty() || joined.back().to < stretch.from) {
      joined.push_back(std::move(stretch));
      continue;
    }
    OpenStretch& last = joined.back();
    last.to = std::max(last.to, stretch.to);
    std::vector<std::size_t> pairs;
    std::set_union(last.pairs.begin(), last.pairs.end(), stretch.pairs.begin(), stretch.pairs.end(),
                   std::back_inserter(pairs));
    last.pairs = std::move(pairs);
  }
  open = std::move(joined);
}

// A pair of bodies, and how far they move against each other on the line [m].
struct LanePair {
  std::size_t a = 0;
  std::size_t b = 0;
  double motion = 0.0;
};

}  // namespace motion_lanes

using namespace motion_lanes;  // NOLINT(google-build-using-namespace)

class MotionFilter::Lanes {
 public:
  Lanes(const CompiledArm& arm, const std::vector<ArmPair>& pairs);

  FilterVerdict line(const std::vector<double>& from, const std::vector<double>& to,
                     double tightest, IfClose if_close, std::vector<OpenStretch>& open);

 private:
  // A stretch of the line by its middle, and what is not settled on it.
  struct Part {
    double middle = 0.0;
    std::vector<std::size_t> pairs;
  };

  void add_joints(const Robot& robot, std::vector<Pose>& X_ZJ);
  bool set_line(const std::vector<double>& from, const std::vector<double>& to);
  void find_block_pairs(std::span<const Part> parts);
  bool check(std::span<const Part> parts, double half, std::vector<Part>& next,
             std::vector<OpenStretch>& open);

  // In which lanes a pair is not free at the postures of the block, and in which of these its
  // shapes overlap, a bit each.
  PREHEND_INLINE unsigned lanes_left(const LanePair& pair, float free_beyond, unsigned& overlap);
  // In which lanes something in one body is in the other: in what of them is known to be solid.
  PREHEND_INLINE unsigned lanes_met(const LanePair& pair, unsigned among);
  PREHEND_INLINE unsigned lanes_inside(std::size_t a, std::size_t b);
  PREHEND_INLINE bool run_block_inline(float half);
  bool run_block(float half);
  PREHEND_FOR_AVX2 bool run_block_with_avx2(float half);
  PREHEND_INLINE void place_joints();
  PREHEND_INLINE void place_shapes(std::size_t body);
  PREHEND_INLINE LaneFrame frame_of(const LaneBody& body) const;

  const std::vector<ArmPair>& arm_pairs_;
  std::vector<LaneJoint> joints_;
  std::vector<LaneBody> bodies_;  // links, then bodies
  std::vector<LanePair> pairs_;
  float rounding_ = 0.0F;
  LaneFrame base_;

  // Of the line: the values of the joints at its start and their changes.
  std::vector<float> start_;
  std::vector<float> change_;

  bool close_is_blocked_ = false;
  double finest_ = 0.0;  // stretches are not halved where pairs move by less than this [m]

  // Of the block of postures that is looked at.
  Floats8 at_ = {};
  std::vector<LaneFrame> joint_frames_;
  std::vector<Lanes3> centers_;                   // of the balls around the bodies
  std::vector<std::vector<PlacedShape>> shapes_;  // by body
  std::vector<std::uint8_t> is_placed_;           // whether those of a body are up to date
  std::vector<std::size_t> block_pairs_;
  std::vector<unsigned> left_;  // by block pair, see lanes_left
  std::vector<unsigned> overlap_;
  std::vector<std::size_t> any_left_;  // of the block's pairs
  std::vector<std::uint8_t> is_in_block_;
};

MotionFilter::Lanes::Lanes(const CompiledArm& arm, const std::vector<ArmPair>& pairs)
    : arm_pairs_(pairs), base_(in_all_lanes(constant(Pose::Identity()))) {
  std::vector<Pose> X_ZJ;
  add_joints(arm.robot(), X_ZJ);
  double size = 1.0;
  for (const CompiledLink& link : arm.links) {
    for (const double reach : link.reach) size = std::max(size, reach);
  }
  for (const PlacedBody& body : arm.bodies)
    size = std::max(size, (body.X_RB * body.mesh.ball_center()).norm() + body.mesh.ball_radius());
  const double rounding = kLaneRounding * size;
  rounding_ = static_cast<float>(rounding);
  for (std::size_t l = 0; l < arm.links.size(); ++l) {
    const int joint = arm.robot().links[l].joint;
    bodies_.push_back(lane_body(arm.links[l], joint < 0 ? Pose::Identity() : X_ZJ[index(joint)],
                                joint, rounding));
  }
  for (const PlacedBody& body : arm.bodies) {
    bodies_.push_back(lane_body(body, body.X_RB, -1, rounding));
  }
  for (const ArmPair& pair : pairs) {
    const LinkId* link = std::get_if<LinkId>(&pair.other);
    pairs_.push_back(
        {index(pair.link),
         link != nullptr ? index(*link) : arm.links.size() + index(std::get<BodyId>(pair.other))});
  }
  is_in_block_.assign(pairs_.size(), 0);
  joint_frames_.resize(joints_.size());
  centers_.resize(bodies_.size());
  shapes_.resize(bodies_.size());
  is_placed_.assign(bodies_.size(), 0);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    for (const LaneShape& shape : bodies_[b].shapes)
      shapes_[b].push_back({in_all_lanes(shape.frame), &shape});
    centers_[b] = placed(base_, bodies_[b].around.center);
    if (bodies_[b].joint < 0) is_placed_[b] = 1;
  }
}

// X_ZJ: the pose of the frame after a joint in that after its motion about z.
void MotionFilter::Lanes::add_joints(const Robot& robot, std::vector<Pose>& X_ZJ) {
  for (const Joint& joint : robot.joints) {
    Matrix3 axes;
    const Vector3 across = any_orthogonal(joint.axis);
    axes << across, joint.axis.cross(across), joint.axis;
    const Pose X_JZ = pose_from(axes, Vector3::Zero());
    const Pose X_ZP = joint.parent < 0 ? Pose::Identity() : X_ZJ[index(joint.parent)];
    joints_.push_back({joint.parent, joint.type == JointType::prismatic, joint.zero,
                       constant(X_ZP * joint.X_PJ * X_JZ)});
    X_ZJ.push_back(X_JZ.inverse() * joint.X_JA);
  }
}

PREHEND_INLINE LaneFrame MotionFilter::Lanes::frame_of(const LaneBody& body) const {
  return body.joint < 0 ? base_ : joint_frames_[index(body.joint)];
}

PREHEND_INLINE void MotionFilter::Lanes::place_joints() {
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const LaneJoint& joint = joints_[j];
    LaneFrame X =
        placed(joint.parent < 0 ? base_ : joint_frames_[index(joint.parent)], joint.frame);
    const Floats8 value = start_[j] + at_ * change_[j];
    if (joint.slides) {
      X.origin.x += value * X.axis[2].x;
      X.origin.y += value * X.axis[2].y;
      X.origin.z += value * X.axis[2].z;
    } else {
      Floats8 sine;
      Floats8 cosine;
      sine_cosine(value, sine, cosine);
      const Lanes3 x = X.axis[0];
      const Lanes3 y = X.axis[1];
      X.axis[0] = {x.x * cosine + y.x * sine, x.y * cosine + y.y * sine, x.z * cosine + y.z * sine};
      X.axis[1] = {y.x * cosine - x.x * sine, y.y * cosine - x.y * sine, y.z * cosine - x.z * sine};
    }
    joint_frames_[j] = X;
  }
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (bodies_[b].joint < 0) continue;
    is_placed_[b] = 0;
    centers_[b] = placed(frame_of(bodies_[b]), bodies_[b].around.center);
  }
}

PREHEND_INLINE void MotionFilter::Lanes::place_shapes(std::size_t body) {
  if (is_placed_[body] != 0) return;
  is_placed_[body] = 1;
  const LaneFrame X = frame_of(bodies_[body]);
  for (PlacedShape& shape : shapes_[body]) shape.X = placed(X, shape.shape->frame);
}

PREHEND_INLINE unsigned MotionFilter::Lanes::lanes_left(const LanePair& pair, float free_beyond,
                                                        unsigned& overlap) {
  overlap = 0;
  const Lanes3 to = minus(centers_[pair.a], centers_[pair.b]);
  const float balls =
      bodies_[pair.a].around.radius + bodies_[pair.b].around.radius + free_beyond + rounding_;
  const unsigned near = at_most(dot(to, to), all_lanes(balls * balls));
  if (near == 0) return 0;
  place_shapes(pair.a);
  place_shapes(pair.b);
  unsigned left = 0;
  for (const PlacedShape& a : shapes_[pair.a]) {
    for (const PlacedShape& b : shapes_[pair.b]) {
      const float touching = rounding_ + a.shape->ball + b.shape->ball;
      const float beyond = free_beyond + touching;
      const Floats8 squared = all_lanes(beyond * beyond);
      const Floats8 one = squared_apart(b, a);
      if ((at_most(one, squared) & near) == 0) continue;
      Floats8 apart = larger(one, squared_apart(a, b));
      if ((at_most(apart, squared) & near) == 0) continue;
      apart = larger(apart, squared_across(a, b));
      left |= at_most(apart, squared) & near;
      overlap |= at_most(apart, all_lanes(touching * touching)) & near;
    }
  }
  return left;
}

PREHEND_INLINE unsigned MotionFilter::Lanes::lanes_inside(std::size_t a, std::size_t b) {
  unsigned met = 0;
  const LaneFrame X = frame_of(bodies_[a]);
  for (const PlacedShape& shape : shapes_[b]) {
    if (!shape.shape->is_filled) continue;
    for (const LaneBall& ball : bodies_[a].inside)
      met |= reaches(placed(X, ball.center), ball.radius, shape);
  }
  return met;
}

PREHEND_INLINE unsigned MotionFilter::Lanes::lanes_met(const LanePair& pair, unsigned among) {
  const unsigned met = lanes_inside(pair.a, pair.b) & among;
  return met != 0 ? met : lanes_inside(pair.b, pair.a) & among;
}

// Whether bodies of the block's pairs overlap in one of its postures; if not, which lanes of which
// pairs are not free. `half`: half of a stretch, as a part of the line.
PREHEND_INLINE bool MotionFilter::Lanes::run_block_inline(float half) {
  place_joints();
  any_left_.clear();
  left_.resize(block_pairs_.size());
  overlap_.resize(block_pairs_.size());
  for (std::size_t k = 0; k < block_pairs_.size(); ++k) {
    const LanePair& pair = pairs_[block_pairs_[k]];
    const float farthest = static_cast<float>(pair.motion) * half * (1.0F + 1e-6F);
    left_[k] = lanes_left(pair, farthest, overlap_[k]);
    if (left_[k] != 0) any_left_.push_back(k);
    if (overlap_[k] != 0 && (close_is_blocked_ || lanes_met(pair, overlap_[k]) != 0)) return true;
  }
  return false;
}

bool MotionFilter::Lanes::run_block(float half) { return run_block_inline(half); }

PREHEND_FOR_AVX2 bool MotionFilter::Lanes::run_block_with_avx2(float half) {
  return run_block_inline(half);
}

bool MotionFilter::Lanes::set_line(const std::vector<double>& from, const std::vector<double>& to) {
  start_.resize(from.size());
  change_.resize(from.size());
  for (std::size_t j = 0; j < from.size(); ++j) {
    start_[j] = static_cast<float>(from[j] + joints_[j].zero);
    change_[j] = static_cast<float>(to[j] - from[j]);
    if (std::abs(from[j]) > kLargestAngle || std::abs(to[j]) > kLargestAngle) return false;
  }
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    const ArmPair& pair = arm_pairs_[p];
    pairs_[p].motion = 0.0;
    for (std::size_t k = 0; k < pair.joints.size(); ++k) {
      const std::size_t j = index(pair.joints[k]);
      pairs_[p].motion += pair.reach[k] * std::abs(to[j] - from[j]);
    }
  }
  return true;
}

// All pairs that are open in one of the parts, in order.
void MotionFilter::Lanes::find_block_pairs(std::span<const Part> parts) {
  block_pairs_.clear();
  for (const Part& part : parts) {
    for (const std::size_t p : part.pairs) {
      if (is_in_block_[p] != 0) continue;
      is_in_block_[p] = 1;
      block_pairs_.push_back(p);
    }
  }
  for (const std::size_t p : block_pairs_) is_in_block_[p] = 0;
  std::sort(block_pairs_.begin(), block_pairs_.end());
}

// Looks at the middles of up to eight stretches, `half` of the line to both sides of them. What is
// not settled goes to `next` as their halves, or to `open`. False where bodies overlap.
bool MotionFilter::Lanes::check(std::span<const Part> parts, double half, std::vector<Part>& next,
                                std::vector<OpenStretch>& open) {
  for (std::size_t i = 0; i < kPostures; ++i)
    at_[i] = static_cast<float>(parts[std::min(i, parts.size() - 1)].middle);
  find_block_pairs(parts);
  const auto width = static_cast<float>(half);
  if (has_avx2() ? run_block_with_avx2(width) : run_block(width)) return false;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Part& part = parts[i];
    std::vector<std::size_t> coarse;
    std::vector<std::size_t> fine;
    for (const std::size_t k : any_left_) {
      if ((left_[k] >> i & 1U) == 0) continue;
      const std::size_t p = block_pairs_[k];
      const double finest =
          (overlap_[k] >> i & 1U) != 0 ? std::max(finest_, kFinestOverlap) : finest_;
      (pairs_[p].motion * half <= finest ? fine : coarse).push_back(p);
    }
    if (!fine.empty() && close_is_blocked_) return false;
    if (!fine.empty()) open.push_back({part.middle - half, part.middle + half, std::move(fine)});
    if (coarse.empty()) continue;
    next.push_back({part.middle - 0.5 * half, coarse});
    next.push_back({part.middle + 0.5 * half, std::move(coarse)});
  }
  return true;
}

FilterVerdict MotionFilter::Lanes::line(const std::vector<double>& from,
                                        const std::vector<double>& to, double tightest,
                                        IfClose if_close, std::vector<OpenStretch>& open) {
  open.clear();
  finest_ = 0.5 * tightest;
  close_is_blocked_ = if_close == IfClose::blocked;
  std::vector<std::size_t> all(pairs_.size());
  for (std::size_t p = 0; p < all.size(); ++p) all[p] = p;
  if (!set_line(from, to)) {
    open.push_back({0.0, 1.0, std::move(all)});
    return FilterVerdict::open;
  }
  std::vector<Part> parts;
  double half = 0.5 / kPostures;
  for (std::size_t i = 0; i < kPostures; ++i)
    parts.push_back({half * static_cast<double>(2 * i + 1), {}});
  parts.front().pairs = std::move(all);
  for (int level = 0; !parts.empty(); ++level, half *= 0.5) {
    std::vector<Part> next;
    for (std::size_t i = 0; i < parts.size(); i += kPostures) {
      const std::span block = std::span(parts).subspan(i, std::min(kPostures, parts.size() - i));
      if (!check(block, half, next, open)) return FilterVerdict::blocked;
    }
    parts = std::move(next);
    if (level < kMostLevels) continue;
    if (close_is_blocked_ && !parts.empty()) return FilterVerdict::blocked;
    for (Part& part : parts)
      open.push_back({part.middle - 0.5 * half, part.middle + 0.5 * half, std::move(part.pairs)});
    break;
  }
  join_neighbours(open);
  return open.empty() ? FilterVerdict::free : FilterVerdict::open;
}

MotionFilter::MotionFilter(const CompiledArm& arm, const std::vector<ArmPair>& pairs)
    : lanes_(std::make_unique<Lanes>(arm, pairs)) {}
MotionFilter::~MotionFilter() = default;

FilterVerdict MotionFilter::line(const std::vector<double>& from, const std::vector<double>& to,
                                 double tightest, IfClose if_close,
                                 std::vector<OpenStretch>& open) {
  return lanes_->line(from, to, tightest, if_close, open);
}

}  // namespace prehend

#undef PREHEND_INLINE
