#include "planner/plan/propose/proposal_sequence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "planner/plan/propose/hand_pose.h"
#include "planner/plan/propose/suction_rules.h"
#include "sim/base/index.h"

namespace prehend {
namespace {

// Levels of detail beyond this have steps below a ten-thousandth of a turn.
constexpr int kFinestLevel = 12;

std::size_t point_count(const GraspRule& rule, int level) {
  std::size_t count = 1;
  for (const Freedom freedom : rule.freedoms) count *= index(choice_count(freedom, level));
  return count;
}

// A step that visits all of 0 .. count - 1, far from the places before at any time: near the golden
// section of the count, without a common divisor.
std::size_t golden_stride(std::size_t count) {
  auto stride = static_cast<std::size_t>(0.6180339887498949 * static_cast<double>(count));
  stride = std::max<std::size_t>(stride, 1);
  while (std::gcd(stride, count) != 1) ++stride;
  return stride;
}

// Where some points are left out, a track ends after so many points in a row that propose nothing.
constexpr std::size_t kMostLeftOut = 1U << 17U;

// How far from a direction of approach that a rule gives at this level of detail one of its other
// directions may be [rad]: half a step of two turns.
constexpr int kLevelOfDirections = 3;
constexpr double kHalfStep = 0.14;

// The places where a rule expects the two sides of the hand on the surface.
std::array<Vector3, 2> expected_contacts(const AimedGrasp& aimed, double width) {
  const Vector3 half = 0.5 * width * aimed.closing_O;
  return {aimed.target_O + half, aimed.target_O - half};
}

// How far a primitive's surface may be from that of the part that it stands for [m].
constexpr double kAimMargin = 2e-3;

bool aims_into(const SurfaceRegions& regions, const AimedGrasp& aimed, double width) {
  const auto [one, other] = expected_contacts(aimed, width);
  return regions.contain(one, kAimMargin) || regions.contain(other, kAimMargin);
}

bool aims_only_into(const SurfaceRegions& regions, const AimedGrasp& aimed, double width) {
  const auto [one, other] = expected_contacts(aimed, width);
  return !regions.empty() && regions.contain(one, kAimMargin) && regions.contain(other, kAimMargin);
}

// Calls visit(choices) for each point of the grid of the rule at this level, until it returns true.
template <typename Visit>
bool any_choices(const GraspRule& rule, int level, const Visit& visit) {
  for (std::size_t point = 0; point < point_count(rule, level); ++point) {
    std::vector<double> choices;
    std::size_t rest = point;
    for (const Freedom freedom : rule.freedoms) {
      const std::size_t count = index(choice_count(freedom, level));
      choices.push_back(choice_at(freedom, level, static_cast<int>(rest % count)));
      rest /= count;
    }
    if (visit(choices)) return true;
  }
  return false;
}

// Whether the rule may have a grasp that the limit allows.
bool may_allow(const std::optional<ApproachLimit>& limit, const CompiledScene& scene,
               const GraspRule& rule) {
  if (!limit) return true;
  ApproachLimit wider = *limit;
  wider.angle = std::min(wider.angle + kHalfStep, kApproachAngle.upper);
  return any_choices(rule, kLevelOfDirections, [&](const std::vector<double>& choices) {
    return allows(wider, scene, rule.aim(choices).approach_O);
  });
}

}  // namespace

ProposalSequence::ProposalSequence(const CompiledScene& scene,
                                   const std::vector<Primitive>& primitives,
                                   const CandidateOptions& options)
    : scene_(&scene),
      options_(options),
      smallest_width_(std::numeric_limits<double>::infinity()),
      progress_{Progress{{}, {kDuplicateDistance, kDuplicateAngle}},
                Progress{{}, {kDuplicateDistance, kDuplicateAngle}}} {
  for (const Preshape& preshape : scene.scene.hand.hand->preshapes) {
    reach_.push_back(hand_reach(scene, preshape.dofs));
    largest_opening_ = std::max(largest_opening_, preshape.max_width);
  }
  const std::vector<SuctionCup>& cups = scene.scene.hand.hand->cups;
  std::vector<std::vector<GraspRule>> of_cups;
  if (!cups.empty()) of_cups = suction_rules(scene, primitives);
  for (std::size_t p = 0; p < primitives.size(); ++p) {
    is_curve_.push_back(is_curve(primitives[p].shape));
    add_ways(cups.empty() ? grasp_rules(primitives[p]) : std::move(of_cups[p]),
             static_cast<int>(p));
  }
  for (std::size_t w = 0; w < ways_.size(); ++w) progress_of(ways_[w]).families.push_back(w);
  for (Progress& track : progress_) begin_level(track, 0);
}

ProposalSequence::Progress& ProposalSequence::progress_of(const Way& way) {
  return progress(is_curve_[index(way.primitive)] ? Track::curves : Track::solids);
}

Track ProposalSequence::track_of(const ProposedGrasp& grasp) const {
  return is_curve_[index(grasp.primitive)] ? Track::curves : Track::solids;
}

bool ProposalSequence::mark_proposed(const ProposedGrasp& grasp) {
  const Way& way = ways_[index(grasp.way)];
  Progress& track = progress_of(way);
  if (grasp.level > track.level) begin_level(track, grasp.level);
  return track.known.add(grasp.candidate.X_OH, way.preshape);
}

void ProposalSequence::add_ways(std::vector<GraspRule> rules, int number) {
  const Hand& hand = *scene_->scene.hand.hand;
  const std::vector<Preshape>& preshapes = hand.preshapes;
  // Cups move on until they touch, up to as far into the object as they give way.
  double beyond = 0.0;
  for (const SuctionCup& cup : hand.cups) beyond = std::max(beyond, cup.travel);
  for (GraspRule& rule : rules) {
    smallest_width_ = std::min(smallest_width_, rule.width);
    if (!may_allow(options_.approach, *scene_, rule)) continue;
    const int at = static_cast<int>(rules_.size());
    for (std::size_t s = 0; s < preshapes.size(); ++s) {
      if (rule.width < preshapes[s].min_width || rule.width > preshapes[s].max_width) continue;
      ways_.push_back({number, at, static_cast<int>(s), 0.0 - beyond});
      if (preshapes[s].depth > 0.0) {
        ways_.push_back({number, at, static_cast<int>(s), preshapes[s].depth});
      }
    }
    rules_.push_back(std::move(rule));
  }
}

void ProposalSequence::begin_level(Progress& track, int level) {
  track.level = level;
  track.place = 0;
  track.passed = 0;
  track.first_point.assign(1, 0);
  for (const std::size_t way : track.families) {
    track.first_point.push_back(track.first_point.back() +
                                point_count(rules_[index(ways_[way].rule)], level));
  }
  track.stride = golden_stride(track.first_point.back());
  const double part = std::pow(0.5, level);
  track.known.refine(part * kDuplicateDistance, part * kDuplicateAngle);
}

std::optional<ProposedGrasp> ProposalSequence::next(Track track) {
  Progress& walk = progress(track);
  std::size_t left_out = 0;
  while (true) {
    const bool leaves_out =
        options_.approach || !scene_->keep_out.empty() || !scene_->scene.hand.hand->cups.empty();
    if (leaves_out && left_out++ == kMostLeftOut) walk.families.clear();
    if (walk.families.empty()) return std::nullopt;
    if (walk.passed == walk.first_point.back()) {
      if (walk.level == kFinestLevel) return std::nullopt;
      begin_level(walk, walk.level + 1);
    }
    const std::size_t point = walk.place;
    walk.place = (walk.place + walk.stride) % walk.first_point.back();
    ++walk.passed;
    const auto above = std::upper_bound(walk.first_point.begin(), walk.first_point.end(), point);
    const auto way = static_cast<std::size_t>(above - walk.first_point.begin()) - 1;
    if (std::optional<ProposedGrasp> grasp =
            at(walk.families[way], point - walk.first_point[way], walk.level)) {
      return grasp;
    }
  }
}

// Point `point` of the grid of a way at this level: its choices are the digits of the number.
std::optional<ProposedGrasp> ProposalSequence::at(std::size_t way, std::size_t point, int level) {
  std::vector<double> choices;
  bool is_new = false;
  for (const Freedom freedom : rules_[index(ways_[way].rule)].freedoms) {
    const std::size_t count = index(choice_count(freedom, level));
    const int digit = static_cast<int>(point % count);
    point /= count;
    choices.push_back(choice_at(freedom, level, digit));
    is_new = is_new || is_new_choice(freedom, level, digit);
  }
  if (!is_new) return std::nullopt;
  return proposed(way, std::move(choices), level);
}

std::optional<ProposedGrasp> ProposalSequence::proposed(std::size_t number,
                                                        std::vector<double> choices, int level) {
  const Way& way = ways_[number];
  const GraspRule& rule = rules_[index(way.rule)];
  const AimedGrasp aimed = rule.aim(choices);
  if (options_.approach && !allows(*options_.approach, *scene_, aimed.approach_O)) {
    return std::nullopt;
  }
  if (!scene_->keep_out.empty() && aims_into(scene_->keep_out, aimed, rule.width)) {
    return std::nullopt;
  }
  ProposedGrasp grasp;
  grasp.candidate.X_OH = hand_pose(*scene_->scene.hand.hand, aimed, way.stand_off);
  if (!progress_of(way).known.add(grasp.candidate.X_OH, way.preshape)) return std::nullopt;
  grasp.candidate.approach_O = aimed.approach_O;
  grasp.candidate.approach_distance =
      approach_distance(*scene_, grasp.candidate.X_OH, aimed.approach_O,
                        reach_[index(way.preshape)], options_.start_clearance);
  grasp.candidate.preshape = way.preshape;
  grasp.primitive = way.primitive;
  grasp.rule = rule.name;
  grasp.width = rule.width;
  grasp.stand_off = way.stand_off;
  grasp.way = static_cast<int>(number);
  grasp.choices = std::move(choices);
  grasp.level = level;
  grasp.preferred = aims_only_into(scene_->preferred, aimed, rule.width);
  return grasp;
}

std::vector<ProposedGrasp> ProposalSequence::beside(const ProposedGrasp& grasp) {
  std::vector<ProposedGrasp> found;
  const auto add = [&](std::size_t way, const std::vector<double>& choices, int level) {
    if (auto one = proposed(way, choices, level)) found.push_back(std::move(*one));
  };
  const Way& way = ways_[index(grasp.way)];
  const GraspRule& rule = rules_[index(way.rule)];
  const int finer = std::min(grasp.level + 1, kFinestLevel);
  for (std::size_t k = 0; k < rule.freedoms.size(); ++k) {
    const bool turns = rule.freedoms[k] == Freedom::turn;
    const double step = 1.0 / (turns ? 4 << finer : 2 << finer);
    for (const double side : {1.0, -1.0}) {
      std::vector<double> choices = grasp.choices;
      choices[k] += side * step;
      if (turns) choices[k] -= std::floor(choices[k]);
      if (choices[k] < 0.0 || choices[k] > 1.0) continue;
      add(index(grasp.way), choices, finer);
    }
  }
  for (std::size_t other = 0; other < ways_.size(); ++other) {
    const Way& with = ways_[other];
    const bool one_differs =
        (with.preshape != way.preshape) != ((with.stand_off > 0.0) != (way.stand_off > 0.0));
    if (with.rule == way.rule && one_differs) add(other, grasp.choices, grasp.level);
  }
  return found;
}

}  // namespace prehend
