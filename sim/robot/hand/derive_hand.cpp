#include "sim/robot/hand/derive_hand.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/robot/hand/grasp_choice.h"
#include "sim/robot/sound_robot.h"

namespace prehend {
namespace {

// Less opposition than this and nothing is held between the fingers.
constexpr double kLeastScore = -1.5;
// A preshape beside the best one may oppose less well, but not by more than this.
constexpr double kScoreGivenUp = 1.0;
constexpr double kDegree = std::numbers::pi / 180.0;

[[noreturn]] void refuse(const Robot& robot, const std::string& why) {
  throw InputError({robot.name, "hand", "nothing that could grasp: " + why});
}

std::string shown(const char* what, const Vector3& v, double unit = 1.0) {
  const Vector3 u = v / unit;
  // Nothing is shown as -0.000.
  const auto rounded = [](double x) { return std::round(1e3 * x) / 1e3 + 0.0; };
  return formatted("%s (%.3f, %.3f, %.3f)", what, rounded(u.x()), rounded(u.y()), rounded(u.z()));
}

using LinkPair = std::pair<int, int>;

bool contains(const std::vector<LinkPair>& pairs, const LinkPair& pair) {
  return std::find(pairs.begin(), pairs.end(), pair) != pairs.end();
}

void exempt(const LinkPair& pair, const char* when, SelfCollision& collision, Robot& robot) {
  collision.leave_out(pair);
  robot.exempt_pairs.push_back(pair);
  robot.notes.push_back("links " + robot.links[index(pair.first)].name + " and " +
                        robot.links[index(pair.second)].name + " overlap " + when +
                        ": their collision is not checked");
}

// Whether one of the links carries the other.
bool carries(const Robot& robot, const LinkPair& pair) {
  const std::vector<int> a = joints_to(robot, robot.links[index(pair.first)].joint);
  const std::vector<int> b = joints_to(robot, robot.links[index(pair.second)].joint);
  return std::equal(
      a.begin(), a.begin() + static_cast<std::ptrdiff_t>(std::min(a.size(), b.size())), b.begin());
}

// Pairs that overlap by construction: in nearly all of some random postures, or at the start where
// one link carries the other.
void exempt_overlapping(SelfCollision& collision, Robot& robot) {
  constexpr int kPostures = 60;
  constexpr double kNearlyAll = 0.9;
  Random random(1);
  std::map<LinkPair, int> counts;
  for (int i = 0; i < kPostures; ++i) {
    std::vector<double> dofs;
    for (const DegreeOfFreedom& dof : robot.dofs) {
      dofs.push_back(random.uniform(dof.lower, dof.upper));
    }
    for (const LinkPair& pair : collision.colliding(dofs)) ++counts[pair];
  }
  const std::vector<LinkPair> at_start = collision.colliding(initial_dofs(robot));
  for (const auto& [pair, count] : counts) {
    if (count < kNearlyAll * kPostures) continue;
    exempt(pair, "in every posture, or nearly", collision, robot);
  }
  for (const LinkPair& pair : at_start) {
    if (contains(robot.exempt_pairs, pair) || !carries(robot, pair)) continue;
    exempt(pair, "at the start, and one carries the other", collision, robot);
  }
}

// Pairs that collide at the start, open and half closed always do.
void exempt_always_colliding(const ClosingDofs& closing, const Opposition& best,
                             SelfCollision& collision, Robot& robot) {
  const double end = closing_time(robot, closing);
  std::vector<LinkPair> always = collision.colliding(best.dofs);
  for (const auto& dofs : {initial_dofs(robot), closed_for(robot, closing, 0.25 * end, best.dofs),
                           closed_for(robot, closing, 0.5 * end, best.dofs)}) {
    const auto now = collision.colliding(dofs);
    std::erase_if(always, [&](const LinkPair& pair) { return !contains(now, pair); });
  }
  for (const LinkPair& pair : always) exempt(pair, "in every posture", collision, robot);
}

// Names what is in the way of every opening, and how a sidecar can help.
[[noreturn]] void refuse_openings(const Robot& robot, const HandParts& parts,
                                  const ClosingDofs& closing, const Opposition& best,
                                  const SelfCollision& collision) {
  std::string pairs;
  for (const LinkPair& pair : collision.colliding(best.dofs)) {
    pairs += (pairs.empty() ? "[\"" : ", [\"") + robot.links[index(pair.first)].name + "\", \"" +
             robot.links[index(pair.second)].name + "\"]";
  }
  if (!pairs.empty()) {
    refuse(robot,
           "links collide in every opening; if they overlap by design, a sidecar file helps: "
           "\"exempt_collisions\": [" +
               pairs + "]");
  }
  std::string moved;
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    if (!closing.closes(d)) continue;
    moved += (moved.empty() ? "" : ", ") + robot.dofs[d].name +
             formatted(" from %.3g on", closing.open[d]) +
             (closing.velocity[d] > 0.0 ? " upwards" : " downwards");
  }
  refuse(robot, "link " + robot.links[index(parts.fingers[best.thumb].tip_link)].name + " and " +
                    (parts.fingers.size() > 1 ? "the other fingers" : "the base") +
                    " open no gap that closes (" + moved +
                    "); state preshapes, or the closing_velocity of degrees of freedom, in a "
                    "sidecar file");
}

void state_velocities(const ClosingDofs& closing, Robot& robot) {
  if (closing.stated) return;
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    robot.dofs[d].closing_velocity = closing.velocity[d];
    if (robot.dofs[d].lower == robot.dofs[d].upper) continue;
    robot.notes.push_back("inferred: degree of freedom " + robot.dofs[d].name +
                          (!closing.closes(d)          ? " does not close the hand"
                           : closing.velocity[d] > 0.0 ? " closes towards its upper limit"
                                                       : " closes towards its lower limit"));
  }
}

// A degree of freedom, and the limit to which it goes.
struct Turn {
  std::size_t dof = 0;
  double limit = 0.0;  // [rad]
};

// Degrees of freedom that take part in one way to spread a hand, and its name.
struct Spread {
  std::string name;
  std::vector<Turn> turns;
};

// The sum of the distances between the tips of all fingers but the thumb [m].
double spread_of(const std::vector<Vector3>& tips, std::size_t thumb) {
  double sum = 0.0;
  for (std::size_t a = 0; a < tips.size(); ++a) {
    for (std::size_t b = a + 1; b < tips.size(); ++b) {
      if (a != thumb && b != thumb) sum += (tips[a] - tips[b]).norm();
    }
  }
  return sum;
}

// The farther limit; nothing where both are about as far. Which of these is the upper one is a
// matter of how the joint is written.
std::optional<double> farther_limit(const DegreeOfFreedom& dof, double from) {
  constexpr double kEven = 0.1;  // of the range
  const double up = dof.upper - from;
  const double down = from - dof.lower;
  if (std::abs(up - down) <= kEven * (dof.upper - dof.lower)) return std::nullopt;
  return up > down ? dof.upper : dof.lower;
}

// The farther limit; of two that are about as far the one that takes the tips apart, and nothing
// for a finger between others that moves from one to the other.
std::optional<double> fanning_limit(const Robot& robot, const HandParts& parts,
                                    const Opposition& best, std::size_t d) {
  constexpr double kApart = 0.1;  // of how far the tip goes
  const DegreeOfFreedom& dof = robot.dofs[d];
  if (const auto limit = farther_limit(dof, best.dofs[d])) return limit;
  const auto tips = [&](double value) {
    std::vector<double> dofs = best.dofs;
    dofs[d] = value;
    return tips_at(robot, parts, dofs);
  };
  const std::vector<Vector3> upper = tips(dof.upper);
  const std::vector<Vector3> lower = tips(dof.lower);
  double way = 0.0;
  for (std::size_t f = 0; f < upper.size(); ++f) way = std::max(way, (upper[f] - lower[f]).norm());
  const double apart = spread_of(upper, best.thumb) - spread_of(lower, best.thumb);
  if (!(std::abs(apart) > kApart * way)) return std::nullopt;
  return apart > 0.0 ? dof.upper : dof.lower;
}

// The farther limit, or of two that are about as far the one where thumb and others oppose better.
double opposing_limit(const Robot& robot, const HandParts& parts, const ClosingDofs& closing,
                      const Opposition& best, std::size_t d) {
  const DegreeOfFreedom& dof = robot.dofs[d];
  if (const auto limit = farther_limit(dof, best.dofs[d])) return *limit;
  const auto score = [&](double value) {
    std::vector<double> dofs = best.dofs;
    dofs[d] = value;
    return opposition_of(robot, parts, closing, best.thumb, dofs).score;
  };
  return score(dof.upper) >= score(dof.lower) ? dof.upper : dof.lower;
}

// The posing degrees of freedom that leave the thumb alone spread the fingers together; each of the
// thumb's, and of the only finger beside it, is a way of its own.
std::vector<Spread> spreads_of(const Robot& robot, const HandParts& parts,
                               const ClosingDofs& closing, const Opposition& best) {
  const std::vector<int>& thumb = parts.fingers[best.thumb].joints;
  std::vector<Spread> spreads = {{"spread", {}}};
  for (const std::size_t d : posing_dofs(robot, parts, closing)) {
    const bool of_thumb = std::any_of(thumb.begin(), thumb.end(), [&](int joint) {
      return index(robot.joints[index(joint)].dof) == d;
    });
    if (of_thumb || parts.fingers.size() < 3) {
      spreads.push_back(
          {robot.dofs[d].name, {{d, opposing_limit(robot, parts, closing, best, d)}}});
    } else if (const auto limit = fanning_limit(robot, parts, best, d)) {
      spreads.front().turns.push_back({d, *limit});
    }
  }
  if (spreads.front().turns.empty()) spreads.erase(spreads.begin());
  return spreads;
}

struct Opening {
  std::string name;
  Opposition opposition;
  std::size_t place = 0;  // among those of the same spread, the best first
};

// The better ones first.
void sort_openings(std::vector<Opening>::iterator begin, std::vector<Opening>::iterator end) {
  std::stable_sort(begin, end, [](const Opening& a, const Opening& b) {
    return a.opposition.score > b.opposition.score;
  });
}

// The best opening, and those beside it at parts of the way towards each spread's limit: the best
// of each spread, then the second ones, since those of one spread are much alike.
std::vector<Opening> openings_of(const Robot& robot, const HandParts& parts,
                                 const ClosingDofs& closing, const Opposition& best) {
  std::vector<Opening> openings = {{"open", best}};
  if (parts.fingers.size() < 2) return openings;
  for (const Spread& spread : spreads_of(robot, parts, closing, best)) {
    const std::size_t first = openings.size();
    for (const double part : {0.25, 1.0 / 3.0, 0.5, 2.0 / 3.0, 1.0}) {
      std::vector<double> dofs = best.dofs;
      for (const Turn& turn : spread.turns) {
        dofs[turn.dof] += part * (turn.limit - best.dofs[turn.dof]);
      }
      Opposition other = opposition_of(robot, parts, closing, best.thumb, dofs);
      if (other.score < best.score - kScoreGivenUp) continue;
      const double angle = std::abs(dofs[spread.turns.front().dof]) / kDegree;
      openings.push_back({spread.name + formatted("_%.0f", angle), std::move(other)});
    }
    sort_openings(openings.begin() + static_cast<std::ptrdiff_t>(first), openings.end());
    for (std::size_t k = first; k < openings.size(); ++k) openings[k].place = k - first;
  }
  sort_openings(openings.begin() + 1, openings.end());
  std::stable_sort(openings.begin() + 1, openings.end(),
                   [](const Opening& a, const Opening& b) { return a.place < b.place; });
  return openings;
}

struct TestedPreshape {
  Preshape preshape;
  TestHolds holds;
};

// At most eight preshapes: the openings, and the first two half closed. Those that hold no test
// body are left out, but for the first one where none holds any.
std::vector<TestedPreshape> tested_preshapes(const Robot& robot, const HandParts& parts,
                                             const ClosingDofs& closing, const GraspChoice& choice,
                                             const SelfCollision& collision) {
  constexpr std::size_t kMostPreshapes = 8;
  const Hand hand = measured_hand(robot, parts, choice.opposition, choice.axes);
  const PreshapeMeasure measure(robot, parts, closing, hand, collision);
  const TestClosing test(robot, parts, closing, collision);
  std::vector<TestedPreshape> tested;
  std::vector<TestedPreshape> idle;
  const auto add = [&](const std::string& name, const Opposition& opening, double part) {
    if (tested.size() >= kMostPreshapes) return;
    const std::optional<Preshape> preshape = measure.at(name, opening, part);
    if (!preshape) return;
    TestHolds holds = try_bodies(test, choice.axes, choice.opposition.thumb, *preshape,
                                 test_sizes(preshape->max_width));
    (holds.held() > 0 ? tested : idle).push_back({*preshape, std::move(holds)});
  };
  const std::vector<Opening> openings = openings_of(robot, parts, closing, choice.opposition);
  const bool half = measure.turns(choice.opposition);
  for (std::size_t k = 0; k < openings.size(); ++k) {
    add(openings[k].name, openings[k].opposition, 0.0);
    if (half && k < 2) add(openings[k].name + "_half", openings[k].opposition, 0.5);
  }
  if (tested.empty() && !idle.empty()) tested.push_back(idle.front());
  return tested;
}

// "sphere 21 and 43, box 43"
std::string shown(const TestHolds& holds) {
  std::string text;
  std::string last;
  for (const char* body : kTestBodies) {
    for (const TestHolds::Held& held : holds.bodies) {
      if (held.body != body || !(held.epsilon > 0.0)) continue;
      text += last.empty() ? "" : last == held.body ? " and" : ",";
      if (last != held.body) text += (text.empty() ? "" : " ") + held.body;
      text += formatted(" %.0f", 1e3 * held.width);
      last = held.body;
    }
  }
  return text;
}

void note_preshapes(const std::vector<TestedPreshape>& tested, Robot& robot) {
  for (const TestedPreshape& one : tested) {
    const Preshape& preshape = one.preshape;
    const std::string held = shown(one.holds);
    robot.notes.push_back("inferred: preshape " + preshape.name +
                          formatted(" takes %.1f to %.1f mm, fingers meet at %.1f mm; ",
                                    1e3 * preshape.min_width, 1e3 * preshape.max_width,
                                    1e3 * preshape.depth) +
                          (held.empty() ? "it held no test body"
                                        : "held when closed on test bodies: " + held + " mm"));
  }
}

// How the hand closes, and with which thumb.
struct Grip {
  ClosingDofs closing;
  Opposition best;
};

// Names the joints whose limits leave them nowhere to go.
[[noreturn]] void refuse_still(const Robot& robot, const HandParts& parts) {
  std::string names;
  for (const Finger& finger : parts.fingers) {
    for (const int joint : finger.joints) {
      const Joint& j = robot.joints[index(joint)];
      const DegreeOfFreedom& dof = robot.dofs[index(j.dof)];
      if (dof.lower < dof.upper) continue;
      names += (names.empty() ? "" : ", ") + j.name;
    }
  }
  refuse(robot, names.empty() ? "no finger can move"
                              : "no finger can move: the limits of " + names +
                                    " leave one value each; give them a range");
}

Grip grip_of(const Robot& robot, const HandParts& parts) {
  Grip grip{.closing = find_closing_dofs(robot, parts), .best = {}};
  if (!(closing_time(robot, grip.closing) > 0.0)) refuse_still(robot, parts);
  if (parts.fingers.size() > 1) {
    grip.best = best_opposition(robot, parts, grip.closing);
  } else {
    grip.best.dofs = grip.closing.open;
    grip.best.score = 1.0;
  }
  return grip;
}

// Stated velocities count if the fingers close on each other with them. In files of other programs
// they may open the hand, or leave it to the user which way to go.
Grip find_grip(const HandParts& parts, Robot& robot) {
  Grip grip = grip_of(robot, parts);
  if (grip.best.score < kLeastScore && grip.closing.stated) {
    for (DegreeOfFreedom& dof : robot.dofs) dof.closing_velocity = 0.0;
    robot.notes.push_back(
        "its fingers do not close on each other with the velocities that it states");
    grip = grip_of(robot, parts);
  }
  if (grip.best.score < kLeastScore)
    refuse(robot,
           "its fingers do not close on each other; state the closing_velocity of its "
           "degrees of freedom in a sidecar file");
  return grip;
}

}  // namespace

Robot with_derived_hand(Robot robot, const StatedHand& stated) {
  require_sound(robot);
  const HandParts parts = find_hand_parts(robot);
  if (parts.fingers.empty()) {
    refuse(robot, robot.joints.empty() ? "it has no joints" : "its joints branch nowhere");
  }
  SelfCollision collision(robot);
  exempt_overlapping(collision, robot);
  const auto [closing, first] = find_grip(parts, robot);
  exempt_always_colliding(closing, first, collision, robot);
  const GraspChoice choice = choose_grasp(robot, parts, closing, first, stated, collision);
  const std::vector<TestedPreshape> tested =
      tested_preshapes(robot, parts, closing, choice, collision);
  if (tested.empty()) refuse_openings(robot, parts, closing, choice.opposition, collision);
  state_velocities(closing, robot);
  // A fifth of the effort moves what an ordinary finger is to move, and pushes an object that the
  // others do not hold yet a fifth as hard.
  constexpr double kGentle = 0.2;
  Hand hand{.approach = choice.axes.approach,
            .closing = choice.axes.closing,
            .origin = choice.axes.origin,
            .preshapes = {},
            .strategies = {{.name = "gentle", .effort = kGentle}}};
  for (const TestedPreshape& one : tested) hand.preshapes.push_back(one.preshape);
  robot.notes.push_back("inferred: " + shown("approach", hand.approach) + ", " +
                        shown("closing axis", hand.closing) + ", " +
                        shown("grasp origin", hand.origin, 1e-3) + " mm");
  robot.hand = std::move(hand);
  note_preshapes(tested, robot);
  return robot;
}

Robot with_hand(Robot robot) {
  if (!robot.hand) return with_derived_hand(std::move(robot));
  if (!robot.hand->preshapes.empty()) return robot;
  StatedHand stated;
  stated.approach = robot.hand->approach;
  stated.origin = robot.hand->origin;
  if (!robot.hand->closing.isZero()) stated.closing = robot.hand->closing;
  const std::vector<ClosingStrategy> strategies = robot.hand->strategies;
  Robot derived = with_derived_hand(std::move(robot), stated);
  if (!strategies.empty()) derived.hand->strategies = strategies;
  return derived;
}

}  // namespace prehend
