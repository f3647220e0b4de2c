#include "sim/motion/dynamic_grasp/object_watch.h"

#include <algorithm>
#include <cmath>

#include "sim/base/index.h"

namespace prehend {
namespace {

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

ObjectWatch::ObjectWatch(const World& start, const WorldHand& hand,
                         const ObjectWatchOptions& options)
    : hand_(hand), options_(options) {
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
  grips_ = grips(presses, hand_, options_.opposed);
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
  if (touches_ && by_hand_alone && rise > options_.lifted) note(ObjectEventKind::lifted, time);
  const double upright = (object.motion.X_WB.linear() * up_O_).z();
  if (upright < std::cos(options_.tilted) && rise < -options_.sank) {
    note(ObjectEventKind::tilted, time);
  }
  const bool is_alone = alone_since_ && time - *alone_since_ > options_.left;
  if (is_alone && happened(ObjectEventKind::touched)) {
    note(ObjectEventKind::left, *alone_since_, last_link_);
  }
  if (rise < -options_.fell) note(ObjectEventKind::fell, time);
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
