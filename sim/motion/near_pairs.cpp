#include "sim/motion/near_pairs.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/base/index.h"
#include "sim/motion/contact_search.h"

namespace prehend {
namespace {

// Pairs that are this much farther apart than they need to be are known already: what speeds up
// within the step was then looked at [m].
constexpr double kMargin = 5e-3;

struct Ball {
  Vector3 center;
  double radius = 0.0;
  int solid = 0;
};

bool is_checked(const World& world, const Solid& a, const Solid& b) {
  if (!a.moves && !b.moves) return false;
  if (a.id.robot < 0 || a.id.robot != b.id.robot) return true;
  const RobotModel& model = *world.robots[index(a.id.robot)].model;
  const auto pair = std::minmax(a.id.index, b.id.index);
  return std::find(model.self_pairs.begin(), model.self_pairs.end(),
                   std::pair<int, int>(pair.first, pair.second)) != model.self_pairs.end();
}

// Whether neither has to be looked at: both rest.
bool both_rest(const World& world, const Solid& a, const Solid& b) {
  const auto rests = [&](const Solid& solid) {
    if (solid.id.robot >= 0) return false;
    const WorldBody& body = world.bodies[index(solid.id.index)];
    return body.is_fixed || body.asleep;
  };
  return rests(a) && rests(b);
}

double fastest_point(const Solid& solid) {
  return solid.velocity_at(solid.X_WS * solid.shape->mesh.ball_center()).norm() +
         solid.angular.norm() * solid.shape->mesh.ball_radius();
}

Ball ball_of(const Solid& solid, int place, double time) {
  return {solid.X_WS * solid.shape->mesh.ball_center(),
          solid.shape->mesh.ball_radius() + kMargin + time * fastest_point(solid), place};
}

// Pairs whose bounding balls come near each other within the step. What moves is little beside what
// may stand around it: each moving solid is compared with all others, in one pass over these.
std::vector<std::pair<int, int>> ball_pairs(const Solids& solids, const World& world, double time) {
  const std::vector<Solid>& all = solids.all();
  std::vector<Ball> moving;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].moves) moving.push_back(ball_of(all[i], static_cast<int>(i), time));
  }
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Ball other = ball_of(all[i], static_cast<int>(i), time);
    for (const Ball& ball : moving) {
      // A pair of two that move is met from both sides.
      if (ball.solid == other.solid || (all[i].moves && ball.solid > other.solid)) continue;
      const double reach = ball.radius + other.radius;
      if ((ball.center - other.center).squaredNorm() > reach * reach) continue;
      const auto pair = std::minmax(ball.solid, other.solid);
      if (is_checked(world, all[index(pair.first)], all[index(pair.second)])) {
        pairs.emplace_back(pair.first, pair.second);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// The range up to which contacts may be looked for: within about the size of a triangle only few
// of them are near. What is farther apart comes into the range first: bodies that meet within a
// step share the way between them by their forces, which is wrong by up to half of the range.
double widest_range(const Solid& a, const Solid& b) {
  constexpr double kPart = 0.3;
  constexpr double kWidest = 1e-3;  // [m]
  const auto grain = [](const Solid& solid) {
    const ProximityMesh& mesh = solid.shape->mesh;
    return 2.0 * mesh.ball_radius() / std::sqrt(static_cast<double>(mesh.mesh().triangles.size()));
  };
  return std::clamp(kPart * std::min(grain(a), grain(b)), 2.0 * kContactRange, kWidest);
}

// Looks at one pair: what the memory says of it is enough, or is brought up to date. Returns the
// longest step.
class PairSearch {
 public:
  PairSearch(const Solids& solids, double time, const StepOptions& options)
      : solids_(solids), options_(options), time_(time) {}

  double look(const Solid& a, const Solid& b, double speed, PairMemory& pair) {
    const double need = time_ * speed;
    const double moved = moved_since(pair, solids_);
    const bool is_fresh = pair.contacts.empty()
                              ? pair.at_least - moved > kContactRange + need
                              : moved <= kContactRefresh && pair.at_least - moved > need;
    if (is_fresh) return time_;
    const double range = std::clamp(kContactRange + need, kContactRange, widest_range(a, b));
    const Pose X_AB = a.X_WS.inverse() * b.X_WS;
    // Farther than needed now, so that the answer lasts for some steps.
    const double far = kContactRange + 3.0 * need + kMargin;
    const Gap gap = find_gap(a.shape->mesh, b.shape->mesh, X_AB,
                             {.cap = far, .relative_error = 0.1, .hint = pair.nearest});
    if (gap.pair.a >= 0) pair.nearest = gap.pair;
    if (gap.lower > range) {
      pair.contacts.clear();
      pair.crosses = false;
      pair.X_AB = X_AB;
      pair.at_least = std::min(gap.lower, far);
      if (pair.at_least > kContactRange + need) return time_;
      // To the middle of the range: the contact is there in the next step.
      return (pair.at_least - 0.5 * kContactRange) / speed;
    }
    touch(a.shape->mesh, b.shape->mesh, X_AB, gap, range, pair);
    // What comes from farther away within the step is found where surfaces cross (crossings.h).
    return time_;
  }

 private:
  void touch(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB, const Gap& gap,
             double range, PairMemory& pair) {
    // Nearer than this [m], the nearest points do not tell in which direction they have to part.
    constexpr double kNearest = 1e-7;
    pair.crosses = gap.upper == 0.0;
    pair.gap = gap.lower;
    if (gap.upper > kNearest) {
      search(a, b, X_AB, gap, range, pair);
      return;
    }
    if (pair.contacts.empty()) {
      if (const auto contact = crossing_contact(a, b, X_AB)) pair.contacts = {*contact};
    }
    if (!touch_apart(a, b, X_AB, range, pair) && !pair.crosses) {
      search(a, b, X_AB, gap, range, pair);
    }
    pair.X_AB = X_AB;
    pair.at_least = range;
  }

  // Contacts, of which one is as near as the gap: between edges that lie nearly along each other
  // none may be found there.
  void search(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB, const Gap& gap,
              double range, PairMemory& pair) {
    search_contacts(a, b, X_AB, range, workspace_, pair);
    const double near = std::max(2.0 * gap.upper, 0.1 * options_.rest_gap);
    const bool has_nearest =
        std::any_of(pair.contacts.begin(), pair.contacts.end(), [&](const HeldContact& contact) {
          return contact.normal_A.dot(contact.p_A - X_AB * contact.p_B) <= near;
        });
    if (!has_nearest) pair.contacts.push_back(nearest_contact(a, b, X_AB, gap.pair));
  }

  // Contacts of surfaces that cross: those that they have once they are moved apart along the
  // contacts held so far. Where that does not help these are kept: false.
  bool touch_apart(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB, double range,
                   PairMemory& pair) {
    Vector3 normal = Vector3::Zero();
    for (const HeldContact& contact : pair.contacts) normal += contact.normal_A;
    constexpr double kOpposed = 0.3;  // of their number: contacts on two sides have no way apart
    if (normal.norm() < kOpposed * static_cast<double>(pair.contacts.size()) + 1e-9) return false;
    for (const double part : {0.5, 2.0, 8.0, 32.0}) {
      const double apart = part * options_.rest_gap;
      Pose X_AB_apart = X_AB;
      X_AB_apart.translation() -= apart * normal.normalized();
      const Gap gap =
          find_gap(a, b, X_AB_apart, {.cap = 2.0 * apart, .relative_error = 0.1, .hint = {}});
      if (gap.upper == 0.0) continue;
      search(a, b, X_AB_apart, gap, range + apart, pair);
      return true;
    }
    return false;
  }

  const Solids& solids_;
  const StepOptions& options_;
  double time_;
  ContactWorkspace workspace_;
};

}  // namespace

// Either body may be the one that moves against the other. Of the smaller one the turn carries the
// points less far: seen from a cup that turns, the ends of its table move by more than the cup does
// seen from the table.
double moved_since(const PairMemory& pair, const Solids& solids) {
  const Solid& a = solids.at(pair.a);
  const Solid& b = solids.at(pair.b);
  Pose now = a.X_WS.inverse() * b.X_WS;
  Pose then = pair.X_AB;
  const bool a_is_small = a.shape->mesh.ball_radius() < b.shape->mesh.ball_radius();
  const ProximityMesh& small = (a_is_small ? a : b).shape->mesh;
  if (a_is_small) {
    now = now.inverse();
    then = then.inverse();
  }
  // Of a turn by t the norm of the difference is 2 sqrt(2) sin(t / 2), and the chord 2 sin(t / 2).
  const double chord = (now.linear() - then.linear()).norm() / std::numbers::sqrt2;
  return (now * small.ball_center() - then * small.ball_center()).norm() +
         chord * small.ball_radius();
}

double find_near(const Solids& solids, const Solids* speeds, const World& world, double time,
                 const StepOptions& options, ContactMemory& memory) {
  double longest = time;
  std::vector<PairMemory> next;
  std::size_t known = 0;
  PairSearch search(solids, time, options);
  for (const auto& [i, j] : ball_pairs(speeds != nullptr ? *speeds : solids, world, time)) {
    const Solid& a = solids.all()[index(i)];
    const Solid& b = solids.all()[index(j)];
    while (known < memory.pairs.size() &&
           (memory.pairs[known].a < a.id ||
            (memory.pairs[known].a == a.id && memory.pairs[known].b < b.id))) {
      ++known;
    }
    const bool is_known = known < memory.pairs.size() && memory.pairs[known].a == a.id &&
                          memory.pairs[known].b == b.id;
    next.push_back(is_known ? std::move(memory.pairs[known]) : PairMemory{a.id, b.id});
    if (both_rest(world, a, b)) continue;
    double speed = closing_speed(a, b);
    if (speeds != nullptr) {
      speed = std::max(speed, closing_speed(speeds->all()[index(i)], speeds->all()[index(j)]));
    }
    longest = std::min(longest, search.look(a, b, speed, next.back()));
  }
  memory.pairs = std::move(next);
  return std::max(longest, options.shortest * options.step);
}

bool may_have_met(const Solids& after, const ContactMemory& memory) {
  return std::any_of(memory.pairs.begin(), memory.pairs.end(), [&](const PairMemory& pair) {
    return pair.contacts.empty() && !pair.crosses && moved_since(pair, after) >= pair.at_least;
  });
}

}  // namespace prehend
