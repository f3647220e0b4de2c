#include "sim/robot/hand/grasp_choice.h"

#include <algorithm>

#include "sim/base/index.h"
#include "sim/robot/one_finger.h"

namespace prehend {
namespace {

constexpr std::size_t kMostOppositions = 4;
constexpr std::size_t kMostPromising = 6;  // ways that are tried on bodies of all sizes
// As much has to be held, or neither posture nor axes are changed.
constexpr double kOtherPosture = 1.5;
constexpr double kOtherAxes = 1.1;
constexpr double kInMiddle = 2e-3;  // an origin so near the middle of the opening is there [m]
// Epsilon that an opening counts for that takes the largest of the test bodies: of hands that hold
// none, the one that opens wider.
constexpr double kOpening = 1e-3;

bool only_slides(const Robot& robot, const ClosingDofs& closing) {
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    if (closing.closes(d) && !slides(robot, d)) return false;
  }
  return true;
}

// One of the ways, with what the hand takes that opens for it.
struct Way {
  GraspChoice choice;
  Preshape open;
  double gain = 1.0;  // how much more it has to hold than what was found before
};

class Chooser {
 public:
  Chooser(const Robot& robot, const HandParts& parts, const ClosingDofs& closing,
          const StatedHand& stated, const SelfCollision& collision)
      : robot_(robot),
        parts_(parts),
        closing_(closing),
        stated_(stated),
        collision_(collision),
        test_(robot, parts, closing, collision) {}

  // Adds an opposition with all directions in which it may face a body.
  void add(const Opposition& opposition, double gain) {
    const HandAxes met = find_hand_axes(robot_, parts_, closing_, opposition, stated_);
    std::vector<HandAxes> all = {met};
    if (!stated_.approach) {
      for (const Vector3& approach :
           other_approaches(robot_, parts_, closing_, opposition, met.approach)) {
        StatedHand facing = stated_;
        facing.approach = approach;
        all.push_back(find_hand_axes(robot_, parts_, closing_, opposition, facing));
      }
    }
    for (const HandAxes& axes : all) {
      add({opposition, axes}, gain);
      if (stated_.closing) continue;
      if (const auto turned = across_bending(robot_, parts_, opposition, axes)) {
        add({opposition, *turned}, gain);
      }
    }
  }

  // Adds what a hand with one finger holds as it is, and turned about the axis on which its finger
  // bends: where it closes onto a jaw that stands still, bodies should lie flat on that. They come
  // in the middle of the opening and are pushed to the jaw.
  void add_turned(const GraspChoice& met) {
    constexpr double kTurn = 0.2618;  // 15 degrees
    constexpr int kMostTurns = 3;
    add(met, 1.0);
    const Vector3 axis = met.axes.approach.cross(met.axes.closing);
    for (int turn = -kMostTurns; turn <= kMostTurns; ++turn) {
      StatedHand facing = stated_;
      facing.approach = Eigen::AngleAxisd(turn * kTurn, axis) * met.axes.approach;
      GraspChoice choice = met;
      choice.axes = find_hand_axes(robot_, parts_, closing_, met.opposition, facing);
      const Hand hand = measured_hand(robot_, parts_, choice.opposition, choice.axes);
      const PreshapeMeasure measure(robot_, parts_, closing_, hand, collision_);
      const auto open = measure.at("open", choice.opposition, 0.0);
      if (!open) continue;
      const auto push = pushing_direction(robot_, joint_values(robot_, open->dofs),
                                          closing_.velocity, choice.axes.approach);
      if (push && !stated_.origin) choice.axes.origin -= 0.5 * open->max_width * *push;
      add(choice, kOtherAxes);
    }
  }

  // The first one, or the last of those that hold so much more than the ones before. Nothing where
  // none opens a gap.
  std::optional<GraspChoice> best() const {
    if (ways_.empty()) return std::nullopt;
    const std::vector<double> sizes = test_sizes(middle_width());
    const Way* found = nullptr;
    double most = 0.0;
    for (const Way* way : promising(sizes[1])) {
      const double its = worth(*way, sizes);
      if (found != nullptr && !(its > way->gain * most)) continue;
      found = way;
      most = its;
    }
    return found->choice;
  }

 private:
  double worth(const Way& way, const std::vector<double>& sizes) const {
    return try_bodies(test_, way.choice.axes, way.choice.opposition.thumb, way.open, sizes)
               .mean_epsilon() +
           kOpening * std::min(1.0, way.open.max_width / sizes.back());
  }

  // The first way, and those that hold bodies of this size best.
  std::vector<const Way*> promising(double size) const {
    std::vector<std::pair<double, const Way*>> all;
    for (const Way& way : ways_) all.emplace_back(worth(way, {size}), &way);
    std::stable_sort(all.begin() + 1, all.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    all.resize(std::min(all.size(), kMostPromising));
    std::sort(all.begin(), all.end(),
              [](const auto& a, const auto& b) { return a.second < b.second; });
    std::vector<const Way*> ways;
    for (const auto& [its, way] : all) ways.push_back(way);
    return ways;
  }

  // As it is, and with the origin moved to the middle of the opening.
  void add(const GraspChoice& choice, double gain) {
    const Hand hand = measured_hand(robot_, parts_, choice.opposition, choice.axes);
    const PreshapeMeasure measure(robot_, parts_, closing_, hand, collision_);
    if (const auto open = measure.at("open", choice.opposition, 0.0)) {
      ways_.push_back({choice, *open, gain});
    }
    const double off = measure.off_middle(choice.opposition);
    if (stated_.origin || std::abs(off) < kInMiddle) return;
    GraspChoice centred = choice;
    centred.axes.origin += off * hand.closing;
    const Hand other = measured_hand(robot_, parts_, centred.opposition, centred.axes);
    const PreshapeMeasure from_middle(robot_, parts_, closing_, other, collision_);
    if (const auto open = from_middle.at("open", choice.opposition, 0.0)) {
      ways_.push_back({centred, *open, gain});
    }
  }

  double middle_width() const {
    std::vector<double> widths;
    for (const Way& way : ways_) widths.push_back(way.open.max_width);
    const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
    std::nth_element(widths.begin(), middle, widths.end());
    return *middle;
  }

  const Robot& robot_;
  const HandParts& parts_;
  const ClosingDofs& closing_;
  const StatedHand& stated_;
  const SelfCollision& collision_;
  TestClosing test_;
  std::vector<Way> ways_;
};

}  // namespace

Hand measured_hand(const Robot& robot, const HandParts& parts, const Opposition& opposition,
                   const HandAxes& axes) {
  Hand hand{.approach = axes.approach,
            .closing = axes.closing,
            .origin = axes.origin,
            .preshapes = {},
            .strategies = {}};
  if (parts.fingers.size() < 2) return hand;
  const std::vector<Vector3> tips = tips_at(robot, parts, opposition.dofs);
  const Vector3 apart = mean_of_others(tips, opposition.thumb) - tips[opposition.thumb];
  if (apart.dot(hand.closing) < 0.0) hand.closing = -hand.closing;
  return hand;
}

GraspChoice choose_grasp(const Robot& robot, const HandParts& parts, const ClosingDofs& closing,
                         const Opposition& best, const StatedHand& stated,
                         const SelfCollision& collision) {
  const GraspChoice met{best, find_hand_axes(robot, parts, closing, best, stated)};
  if (only_slides(robot, closing)) return met;
  Chooser chooser(robot, parts, closing, stated, collision);
  if (parts.fingers.size() < 2) {
    if (stated.approach) return met;
    chooser.add_turned(met);
    return chooser.best().value_or(met);
  }
  chooser.add(best, kOtherAxes);
  const auto good = good_oppositions(robot, parts, closing, kMostOppositions);
  for (std::size_t k = 1; k < good.size(); ++k) chooser.add(good[k], kOtherPosture);
  return chooser.best().value_or(met);
}

}  // namespace prehend
