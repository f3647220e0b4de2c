// Random grasps of kinds that are degenerate in one way each, over all magnitudes that are
// accepted.
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "sim/base/random.h"
#include "sim/quality/wrench.h"
#include "tests/support/extreme_grasps.h"
#include "tests/support/grasp_families.h"

namespace prehend::test {

struct DegenerateGrasp {
  Contacts contacts;
  WrenchFrame frame;
  int edges = 8;
};

// 10 to a power that is uniform.
inline double any_size(Random& random, double smallest_power, double largest_power) {
  return std::pow(10.0, random.uniform(smallest_power, largest_power));
}

inline Contacts with_friction(Contacts contacts, double friction) {
  for (Contact& contact : contacts) contact.friction = friction;
  return contacts;
}

// Opposite contacts on a sphere, or one more of them beside the pair.
inline Contacts opposite_grasp(Random& random, double friction, bool is_pair) {
  Contacts contacts = rotated(ring_grasp(2, friction), random.rotation());
  if (!is_pair) contacts.push_back(doubled(random, {contacts[0]}, 0.1).back());
  return contacts;
}

struct DegenerateKind {
  std::string_view name;
  DegenerateGrasp (*make)(Random&);
};

inline int few(Random& random) { return random.integer(3, 6); }
inline double usual_friction(Random& random) { return random.uniform(0.2, 1.2); }

inline Contacts usual_grasp(Random& random) {
  const int count = few(random);
  return random_grasp(random, count, usual_friction(random));
}

inline constexpr std::array<DegenerateKind, 18> kDegenerateKinds{{
    {"not degenerate",
     [](Random& r) {
       return DegenerateGrasp{usual_grasp(r), {}};
     }},
    {"one contact",
     [](Random& r) {
       return DegenerateGrasp{random_grasp(r, 1, usual_friction(r)), {}};
     }},
    {"opposite pair",
     [](Random& r) {
       return DegenerateGrasp{opposite_grasp(r, usual_friction(r), true), {}};
     }},
    {"pair and a neighbour",
     [](Random& r) {
       return DegenerateGrasp{opposite_grasp(r, usual_friction(r), false), {}};
     }},
    {"on a line",
     [](Random& r) {
       const Contacts line = collinear_grasp(few(r), 0.5);
       return DegenerateGrasp{rotated(line, r.rotation()), {}};
     }},
    {"on a circle",
     [](Random& r) {
       const int count = few(r);
       const Contacts circle = ring_grasp(count, usual_friction(r));
       return DegenerateGrasp{rotated(circle, r.rotation()), {}};
     }},
    {"at one point",
     [](Random& r) {
       const Contacts contacts = usual_grasp(r);
       return DegenerateGrasp{gather(contacts, r.direction()), {}};
     }},
    {"contacts twice",
     [](Random& r) {
       const Contacts contacts = usual_grasp(r);
       return DegenerateGrasp{doubled(r, contacts, 0.0), {}};
     }},
    {"contacts nearly twice",
     [](Random& r) {
       const Contacts contacts = usual_grasp(r);
       const double shift = any_size(r, -16.0, -4.0);
       return DegenerateGrasp{doubled(r, contacts, shift), {}};
     }},
    {"small friction",
     [](Random& r) {
       const double friction = r.index(4) == 0 ? 0.0 : any_size(r, -12.0, -1.0);
       return DegenerateGrasp{loose_grasp(r, 10, friction), {}, 4};
     }},
    {"large friction",
     [](Random& r) {
       const Contacts contacts = usual_grasp(r);
       return DegenerateGrasp{with_friction(contacts, any_size(r, 0.5, 6.0)), {}};
     }},
    {"object of any size",
     [](Random& r) {
       const Contacts contacts = usual_grasp(r);
       const double radius = any_size(r, -6.0, 5.5);
       return DegenerateGrasp{scaled(contacts, radius), {.torque_scale = 1.0 / radius}};
     }},
    {"torques not scaled",
     [](Random& r) {
       const Contacts contacts = usual_grasp(r);
       return DegenerateGrasp{scaled(contacts, any_size(r, -6.0, 5.5)), {}};
     }},
    {"far origin",
     [](Random& r) {
       const Contacts contacts = usual_grasp(r);
       const Eigen::Vector3d away = r.direction();
       return DegenerateGrasp{contacts, {any_size(r, 1.0, 5.5) * away, 1.0}};
     }},
    {"needle",
     [](Random& r) {
       const Contacts needle = needle_grasp(any_size(r, -12.0, -1.0), 0.5);
       return DegenerateGrasp{rotated(needle, r.rotation()), {}};
     }},
    {"disc",
     [](Random& r) {
       const Contacts disc = disc_grasp(any_size(r, -9.0, -1.0), 0.5);
       return DegenerateGrasp{rotated(disc, r.rotation()), {}};
     }},
    {"soft fingers",
     [](Random& r) {
       const Contacts contacts = r.index(2) == 0 ? ring_grasp(2, 0.5) : usual_grasp(r);
       return DegenerateGrasp{soft(contacts, any_size(r, -12.0, 5.0)), {}, 4};
     }},
    {"few edges",
     [](Random& r) {
       const Contacts contacts = usual_grasp(r);
       return DegenerateGrasp{contacts, {}, r.integer(3, 5)};
     }},
}};

}  // namespace prehend::test
