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
#include "sim/scene/reach/motion_lanes.h"

namespace prehend {
// With a name, because members of MotionFilter::Lanes are of these types.
namespace motion_lanes {

constexpr std::size_t kPostures = 8;

// Where the shapes of a pair overlap, only the meshes can tell: stretches from whose middle it
// moves by less than this [m] are not halved any more.
constexpr double kFinestOverlap = 1e-2;
// What blocked one motion of a search often blocks the next: this many pairs are looked at first.
constexpr std::size_t kRecent = 4;
// How often a stretch is halved at most.
constexpr int kMostLevels = 14;

// Bound of the rounding errors of a distance, relative to the size of the space that the arm and
// the bodies take: some hundred operations in single precision.
constexpr double kLaneRounding = 1e-5;
// Angles beyond this [rad] are too coarse in single precision.
constexpr double kLargestAngle = 20.0;
// Sums of lengths are multiplied by this, so that rounding does not make them smaller.
constexpr float kBeyondRounding = 1.0F + 1e-5F;

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

// A joint behind which a body moves, and the farthest that a point of the body moves per unit of
// the joint's motion, in any posture (CompiledLink::reach).
struct LaneLever {
  std::size_t joint = 0;
  float reach = 0.0F;
};

// A pair of bodies, and what moves each of them against the other: joints from base to tip.
struct LanePair {
  std::size_t a = 0;
  std::size_t b = 0;
  std::vector<LaneLever> levers_a;
  std::vector<LaneLever> levers_b;
  bool moves_from_base = false;  // `levers_a` are all of the link, and there are no others
};

// A number in each lane, aligned also in lists.
struct LaneNumbers {
  Floats8 of = {};
};

// Those of a link from its joint number `shared` on.
std::vector<LaneLever> levers_of(const CompiledLink& link, std::size_t shared) {
  std::vector<LaneLever> levers;
  for (std::size_t k = shared; k < link.joints.size(); ++k)
    levers.push_back({index(link.joints[k]), static_cast<float>(link.reach[k])});
  return levers;
}

}  // namespace motion_lanes

using namespace motion_lanes;  // NOLINT(google-build-using-namespace)

class MotionFilter::Lanes {
 public:
  Lanes(const CompiledArm& arm, const std::vector<ArmPair>& pairs);

  FilterVerdict line(const std::vector<double>& from, const std::vector<double>& to,
                     double tightest, IfClose if_close, std::vector<OpenStretch>& open);
  std::size_t blocker() const { return blocker_; }

 private:
  // A stretch of the line by its middle, and what is not settled on it.
  struct Part {
    double middle = 0.0;
    std::vector<std::size_t> pairs;
  };

  // Which pairs a block looks at: on the whole line all, later those that its parts say.
  enum class BlockPairs { all, of_parts };

  void add_joints(const Robot& robot, std::vector<Pose>& X_ZJ);
  bool set_line(const std::vector<double>& from, const std::vector<double>& to);
  void find_block_pairs(std::span<const Part> parts);
  bool check(std::span<const Part> parts, BlockPairs pairs, double half, std::vector<Part>& next,
             std::vector<OpenStretch>& open);

  // In which lanes a pair is not free at the postures of the block, and in which of these its
  // shapes overlap, a bit each.
  PREHEND_INLINE unsigned lanes_left(const LanePair& pair, const Floats8& free_beyond,
                                     unsigned& overlap);
  // The farthest that points of a pair move against each other, `half` of the line to both sides
  // of the postures (as in motion_bound.h).
  PREHEND_INLINE Floats8 motion_of(const LanePair& pair, float half);
  PREHEND_INLINE Floats8 motion_by(const std::vector<LaneLever>& levers, std::size_t body,
                                   float half) const;
  // In which lanes something in one body is in the other: in what of them is known to be solid.
  PREHEND_INLINE unsigned lanes_met(const LanePair& pair, unsigned among);
  PREHEND_INLINE unsigned lanes_inside(std::size_t a, std::size_t b);
  PREHEND_INLINE bool blocks(const LanePair& pair, unsigned overlap);
  PREHEND_INLINE bool recent_meets(float half);
  void remember(std::size_t pair);
  PREHEND_INLINE bool run_block_inline(float half);
  bool run_block(float half);
  PREHEND_FOR_AVX2 bool run_block_with_avx2(float half);
  PREHEND_INLINE void place_joints();
  PREHEND_INLINE void place_shapes(std::size_t body);
  PREHEND_INLINE LaneFrame frame_of(const LaneBody& body) const;

  std::vector<LaneJoint> joints_;
  std::vector<LaneBody> bodies_;  // links, then bodies
  std::vector<LanePair> pairs_;
  std::vector<std::size_t> all_;  // their indices
  float rounding_ = 0.0F;
  LaneFrame base_;

  // Of the line: the values of the joints at its start and their changes.
  std::vector<float> start_;
  std::vector<float> change_;
  std::vector<float> turn_;  // sizes of the changes

  bool close_is_blocked_ = false;
  double finest_ = 0.0;  // stretches are not halved where pairs move by less than this [m]

  // Of the block of postures that is looked at.
  Floats8 at_ = {};
  std::vector<LaneFrame> joint_frames_;
  std::vector<Lanes3> centers_;                   // of the balls around the bodies
  std::vector<std::vector<PlacedShape>> shapes_;  // by body
  std::vector<std::uint8_t> is_placed_;           // whether those of a body are up to date
  std::vector<LaneNumbers> from_base_;            // how far bodies move against the base
  std::vector<std::uint8_t> is_bounded_;          // whether that is up to date
  std::vector<std::size_t> block_pairs_;
  std::vector<unsigned> left_;  // by block pair, see lanes_left
  std::vector<unsigned> overlap_;
  std::vector<LaneNumbers> motion_;
  std::vector<std::size_t> any_left_;  // of the block's pairs
  std::size_t blocker_ = 0;            // of the last motion that was blocked
  std::vector<std::size_t> recent_;    // pairs that blocked the last motions, the last one first
  std::vector<std::uint8_t> is_in_block_;
};

MotionFilter::Lanes::Lanes(const CompiledArm& arm, const std::vector<ArmPair>& pairs)
    : base_(in_all_lanes(constant(Pose::Identity()))) {
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
    const CompiledLink& link = arm.links[index(pair.link)];
    LanePair lanes;
    lanes.a = index(pair.link);
    if (const auto* other = std::get_if<LinkId>(&pair.other)) {
      const CompiledLink& second = arm.links[index(*other)];
      const std::size_t shared = shared_joints(link, second);
      lanes.b = index(*other);
      lanes.levers_a = levers_of(link, shared);
      lanes.levers_b = levers_of(second, shared);
    } else {
      lanes.b = arm.links.size() + index(std::get<BodyId>(pair.other));
      lanes.levers_a = levers_of(link, 0);
      lanes.moves_from_base = true;
    }
    pairs_.push_back(std::move(lanes));
  }
  for (std::size_t p = 0; p < pairs_.size(); ++p) all_.push_back(p);
  is_in_block_.assign(pairs_.size(), 0);
  joint_frames_.resize(joints_.size());
  centers_.resize(bodies_.size());
  shapes_.resize(bodies_.size());
  is_placed_.assign(bodies_.size(), 0);
  from_base_.resize(bodies_.size());
  is_bounded_.assign(bodies_.size(), 0);
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
    is_bounded_[b] = 0;
    centers_[b] = placed(frame_of(bodies_[b]), bodies_[b].around.center);
  }
}

PREHEND_INLINE void MotionFilter::Lanes::place_shapes(std::size_t body) {
  if (is_placed_[body] != 0) return;
  is_placed_[body] = 1;
  const LaneFrame X = frame_of(bodies_[body]);
  for (PlacedShape& shape : shapes_[body]) shape.X = placed(X, shape.shape->frame);
}

PREHEND_INLINE Floats8 MotionFilter::Lanes::motion_by(const std::vector<LaneLever>& levers,
                                                      std::size_t body, float half) const {
  Floats8 moved = {};
  const float slack = bodies_[body].around.radius + rounding_;
  for (std::size_t k = levers.size(); k-- > 0;) {
    const std::size_t j = levers[k].joint;
    const float turn = turn_[j] * half;
    if (turn == 0.0F) continue;
    Floats8 most = all_lanes(levers[k].reach);
    if (!joints_[j].slides) {
      const Lanes3 to = minus(centers_[body], joint_frames_[j].origin);
      const Floats8 along = dot(to, joint_frames_[j].axis[2]);
      const Floats8 squared = dot(to, to);
      const Floats8 out = root(above_0(squared - along * along) + kSineRounding * squared);
      most = smaller(most, out + slack);
    }
    moved = moved + most * turn;
  }
  return moved * kBeyondRounding;
}

PREHEND_INLINE Floats8 MotionFilter::Lanes::motion_of(const LanePair& pair, float half) {
  if (!pair.moves_from_base)
    return motion_by(pair.levers_a, pair.a, half) + motion_by(pair.levers_b, pair.b, half);
  if (is_bounded_[pair.a] == 0) {
    from_base_[pair.a].of = motion_by(pair.levers_a, pair.a, half);
    is_bounded_[pair.a] = 1;
  }
  return from_base_[pair.a].of;
}

PREHEND_INLINE unsigned MotionFilter::Lanes::lanes_left(const LanePair& pair,
                                                        const Floats8& free_beyond,
                                                        unsigned& overlap) {
  overlap = 0;
  const Lanes3 to = minus(centers_[pair.a], centers_[pair.b]);
  const Floats8 balls =
      free_beyond + (bodies_[pair.a].around.radius + bodies_[pair.b].around.radius + rounding_);
  const unsigned near = at_most(dot(to, to), balls * balls);
  if (near == 0) return 0;
  place_shapes(pair.a);
  place_shapes(pair.b);
  unsigned left = 0;
  for (const PlacedShape& a : shapes_[pair.a]) {
    for (const PlacedShape& b : shapes_[pair.b]) {
      const float touching = rounding_ + a.shape->ball + b.shape->ball;
      const Floats8 beyond = free_beyond + touching;
      const Floats8 squared = beyond * beyond;
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

// Whether a pair whose shapes overlap in these lanes blocks the motion.
PREHEND_INLINE bool MotionFilter::Lanes::blocks(const LanePair& pair, unsigned overlap) {
  return overlap != 0 && (close_is_blocked_ || lanes_met(pair, overlap) != 0);
}

// Whether a pair that blocked one of the last motions blocks this one.
PREHEND_INLINE bool MotionFilter::Lanes::recent_meets(float half) {
  for (const std::size_t p : recent_) {
    const LanePair& pair = pairs_[p];
    unsigned overlap = 0;
    lanes_left(pair, motion_of(pair, half), overlap);
    if (!blocks(pair, overlap)) continue;
    remember(p);
    return true;
  }
  return false;
}

// Puts a pair first of those that blocked the last motions.
void MotionFilter::Lanes::remember(std::size_t pair) {
  blocker_ = pair;
  auto at = std::find(recent_.begin(), recent_.end(), pair);
  if (at == recent_.end()) {
    if (recent_.size() < kRecent) recent_.push_back(pair);
    at = recent_.end() - 1;
    *at = pair;
  }
  std::rotate(recent_.begin(), at, at + 1);
}

// Whether bodies of the block's pairs overlap in one of its postures; if not, which lanes of which
// pairs are not free. `half`: half of a stretch, as a part of the line.
PREHEND_INLINE bool MotionFilter::Lanes::run_block_inline(float half) {
  place_joints();
  any_left_.clear();
  left_.resize(block_pairs_.size());
  overlap_.resize(block_pairs_.size());
  motion_.resize(block_pairs_.size());
  if (block_pairs_.size() == all_.size() && recent_meets(half)) return true;
  for (std::size_t k = 0; k < block_pairs_.size(); ++k) {
    const LanePair& pair = pairs_[block_pairs_[k]];
    motion_[k].of = motion_of(pair, half);
    left_[k] = lanes_left(pair, motion_[k].of, overlap_[k]);
    if (left_[k] != 0) any_left_.push_back(k);
    if (!blocks(pair, overlap_[k])) continue;
    remember(block_pairs_[k]);
    return true;
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
  turn_.resize(from.size());
  for (std::size_t j = 0; j < from.size(); ++j) {
    start_[j] = static_cast<float>(from[j] + joints_[j].zero);
    change_[j] = static_cast<float>(to[j] - from[j]);
    turn_[j] = std::abs(change_[j]);
    if (std::abs(from[j]) > kLargestAngle || std::abs(to[j]) > kLargestAngle) return false;
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
bool MotionFilter::Lanes::check(std::span<const Part> parts, BlockPairs pairs, double half,
                                std::vector<Part>& next, std::vector<OpenStretch>& open) {
  for (std::size_t i = 0; i < kPostures; ++i)
    at_[i] = static_cast<float>(parts[std::min(i, parts.size() - 1)].middle);
  if (pairs == BlockPairs::all) {
    block_pairs_ = all_;
  } else {
    find_block_pairs(parts);
  }
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
      (motion_[k].of[i] <= finest ? fine : coarse).push_back(p);
    }
    if (!fine.empty() && close_is_blocked_) {
      blocker_ = fine.front();
      return false;
    }
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
  if (!set_line(from, to)) {
    open.push_back({0.0, 1.0, all_});
    return FilterVerdict::open;
  }
  std::vector<Part> parts;
  parts.reserve(kPostures);
  double half = 0.5 / kPostures;
  for (std::size_t i = 0; i < kPostures; ++i)
    parts.push_back({half * static_cast<double>(2 * i + 1), {}});
  for (int level = 0; !parts.empty(); ++level, half *= 0.5) {
    std::vector<Part> next;
    for (std::size_t i = 0; i < parts.size(); i += kPostures) {
      const std::span block = std::span(parts).subspan(i, std::min(kPostures, parts.size() - i));
      const BlockPairs pairs = level == 0 ? BlockPairs::all : BlockPairs::of_parts;
      if (!check(block, pairs, half, next, open)) return FilterVerdict::blocked;
    }
    parts = std::move(next);
    if (level < kMostLevels) continue;
    if (close_is_blocked_ && !parts.empty()) {
      blocker_ = parts.front().pairs.front();
      return FilterVerdict::blocked;
    }
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

std::size_t MotionFilter::blocker() const { return lanes_->blocker(); }

FilterVerdict MotionFilter::line(const std::vector<double>& from, const std::vector<double>& to,
                                 double tightest, IfClose if_close,
                                 std::vector<OpenStretch>& open) {
  return lanes_->line(from, to, tightest, if_close, open);
}

}  // namespace prehend
