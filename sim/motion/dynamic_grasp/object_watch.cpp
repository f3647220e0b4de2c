#include "sim/motion/dynamic_grasp/object_watch.h"

#include <algorithm>
#include <cmath>

#include "sim/base/index.h"

namespace prehend {
namespace {

// Pressures of links oppose each other where the cosine of the angle between them is below this:
// three fingers around a cylinder press at 120 degrees to each other.
constexpr double kOpposed = -0.3;
constexpr double kLifted = 5e-3;  // the object counts as lifted from this rise on [m]
// As tilted from this angle on between the vertical and what was vertical, if it also sank by so
// much: a ball that rolls does not tip over [rad, m].
constexpr double kTilted = 0.79;
constexpr double kSank = 2e-3;
constexpr double kFell = 0.02;  // and as fallen from this way down on [m]
// No link of the hand is near it (as contacts are found) for so long: it has left the hand [s].
constexpr double kLeft = 0.05;

// What one contact does to the object.
struct Press {
  SolidId by;
  Vector3 direction = Vector3::Zero();  // of the normal force on the object, unit
};

std::vector<Press> presses_on_object(const World& world) {
  std::vector<Press> presses;
  for (const WorldContact& contact : world.contacts) {
    if (contact.impulse_W.isZero(0.0)) continue;
    if (contact.a == kObjectSolid) presses.push_back({contact.b, contact.normal_W});
    if (contact.b == kObjectSolid) presses.push_back({contact.a, -contact.normal_W});
  }
  return presses;
}

// Also of contacts that bear nothing: an object without weight that is pushed along at a constant
// speed presses on nothing.
bool is_near_hand(const World& world, const WorldHand& hand) {
  return std::any_of(world.contacts.begin(), world.contacts.end(), [&](const WorldContact& c) {
    return (c.a == kObjectSolid && hand.has(c.b)) || (c.b == kObjectSolid && hand.has(c.a));
  });
}

bool grips(const std::vector<Press>& presses, const WorldHand& hand, double opposed) {
  for (std::size_t i = 0; i < presses.size(); ++i) {
    if (!hand.has(presses[i].by)) continue;
    for (std::size_t k = 0; k < i; ++k) {
      if (!hand.has(presses[k].by)) continue;
      if (presses[i].direction.dot(presses[k].direction) < opposed) return true;
    }
  }
  return false;
}

std::string name_of(const World& world, const SolidId& link) {
  return world.robots[index(link.robot)].model->robot.links[index(link.index)].name;
}

}  // namespace

std::vector<SolidId> links_on_object(const World& world, const WorldHand& hand) {
  std::vector<SolidId> links;
  for (const Press& press : presses_on_object(world)) {
    if (hand.has(press.by)) links.push_back(press.by);
  }
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  return links;
}

ObjectWatch::ObjectWatch(const World& start, const WorldHand& hand) : hand_(hand) {
  const WorldBody& object = start.bodies[index(kObjectBody)];
  up_O_ = object.motion.X_WB.linear().transpose() * Vector3::UnitZ();
  height_ = center_in_world(object.inertial, object.motion.X_WB).z();
}

bool ObjectWatch::happened(ObjectEventKind kind) const {
  return std::any_of(events_.begin(), events_.end(),
                     [&](const ObjectEvent& event) { return event.kind == kind; });
}

// Only the first of each kind tells something: an object that slides along a finger leaves it and
// touches it again many times.
void ObjectWatch::note(ObjectEventKind kind, double time, std::string link) {
  if (!happened(kind)) events_.push_back({kind, time, std::move(link)});
}

void ObjectWatch::look(const World& world, double time) {
  const std::vector<Press> presses = presses_on_object(world);
  const auto first = std::find_if(presses.begin(), presses.end(),
                                  [&](const Press& press) { return hand_.has(press.by); });
  touches_ = first != presses.end();
  grips_ = grips(presses, hand_, kOpposed);
  if (touches_) {
    last_link_ = name_of(world, first->by);
    note(ObjectEventKind::touched, time, last_link_);
  }
  if (is_near_hand(world, hand_)) {
    alone_since_.reset();
    // Back in the hand.
    std::erase_if(events_,
                  [](const ObjectEvent& event) { return event.kind == ObjectEventKind::left; });
  } else if (!alone_since_) {
    alone_since_ = time;
  }
  if (grips_) note(ObjectEventKind::gripped, time);
  const WorldBody& object = world.bodies[index(kObjectBody)];
  const double rise = center_in_world(object.inertial, object.motion.X_WB).z() - height_;
  const bool by_hand_alone = std::all_of(presses.begin(), presses.end(),
                                         [&](const Press& press) { return hand_.has(press.by); });
  if (touches_ && by_hand_alone && rise > kLifted) note(ObjectEventKind::lifted, time);
  const double upright = (object.motion.X_WB.linear() * up_O_).z();
  if (upright < std::cos(kTilted) && rise < -kSank) {
    note(ObjectEventKind::tilted, time);
  }
  const bool is_alone = alone_since_ && time - *alone_since_ > kLeft;
  if (is_alone && happened(ObjectEventKind::touched)) {
    note(ObjectEventKind::left, *alone_since_, last_link_);
  }
  if (rise < -kFell) note(ObjectEventKind::fell, time);
}

double ObjectWatch::alone_for(double time) const {
  const bool counts = alone_since_ && happened(ObjectEventKind::touched);
  return counts ? time - *alone_since_ : 0.0;
}

ObjectEnd ObjectWatch::end() const {
  if (grips_) return ObjectEnd::held;
  if (touches_) return ObjectEnd::touching;
  if (!happened(ObjectEventKind::touched)) return ObjectEnd::untouched;
  if (happened(ObjectEventKind::lifted)) return ObjectEnd::dropped;
  if (happened(ObjectEventKind::gripped)) return ObjectEnd::squeezed_out;
  if (happened(ObjectEventKind::tilted)) return ObjectEnd::toppled;
  return ObjectEnd::pushed_away;
}

}  // namespace prehend
