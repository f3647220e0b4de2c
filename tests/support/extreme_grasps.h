// Degenerate grasps and grasps with extreme numbers, by name: the rows of
// tests/sim/quality/oracle/extremes.md. The same on every platform, up to the rounding of its sine
// and cosine.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "sim/quality/wrench.h"
#include "tests/support/grasp_families.h"

namespace prehend::test {

struct ExtremeGrasp {
  std::string name;  // unique; letters, digits, spaces and punctuation
  Contacts contacts;
  WrenchFrame frame;
  int edges = 8;
};

// Four contacts on the unit sphere at the corners of a regular tetrahedron, rotated so that no
// coordinate is a round number. In force closure from a friction of about 0.4 on.
inline Contacts tetrahedron(double friction = 0.5) {
  Random random(1);
  const Contacts corners = cube_grasp(friction);
  return rotated({corners[0], corners[3], corners[5], corners[6]}, random.rotation());
}

// Two opposite soft fingers on the unit circle; `torsion` is the largest torque about the normal
// over the largest friction force.
inline Contacts soft_pair(double torsion, double friction = 0.5) {
  Contacts contacts = ring_grasp(2, friction);
  for (Contact& contact : contacts) {
    contact.model = ContactModel::soft_finger;
    contact.torsion = torsion;
  }
  return contacts;
}

inline Contacts soft(Contacts contacts, double torsion) {
  for (Contact& contact : contacts) {
    contact.model = ContactModel::soft_finger;
    contact.torsion = torsion;
  }
  return contacts;
}

inline Contacts scaled(Contacts contacts, double factor) {
  for (Contact& contact : contacts) contact.position *= factor;
  return contacts;
}

inline Contacts shifted(Contacts contacts, const Eigen::Vector3d& shift) {
  for (Contact& contact : contacts) contact.position += shift;
  return contacts;
}

// n contacts on the x axis, with normals around it in all directions: no torque about that line.
inline Contacts collinear_grasp(int n, double friction) {
  Contacts contacts = ring_grasp(n, friction);
  for (int i = 0; i < n; ++i) {
    Contact& contact = contacts[static_cast<std::size_t>(i)];
    contact.normal = Eigen::Vector3d(0.0, contact.normal.x(), contact.normal.y());
    contact.position = Eigen::Vector3d(2.0 * i / (n - 1) - 1.0, 0.0, 0.0);
  }
  return contacts;
}

// The grasp with its first contact `times` times in all.
inline Contacts repeated(Contacts contacts, int times) {
  contacts.insert(contacts.end(), static_cast<std::size_t>(times - 1), contacts.front());
  return contacts;
}

// Six contacts around a thin cylinder along z of length 2 and radius `radius`.
inline Contacts needle_grasp(double radius, double friction) {
  Contacts contacts;
  for (int i = 0; i < 6; ++i) {
    const double angle = 2.0 * i + 0.3;
    const Eigen::Vector3d out(std::cos(angle), std::sin(angle), 0.0);
    contacts.push_back({radius * out + (0.4 * i - 1.0) * Eigen::Vector3d::UnitZ(), -out, friction});
  }
  return contacts;
}

// Six contacts on the rim of a flat disc of radius 1 with axis z, in turn `half` above and below
// its middle plane.
inline Contacts disc_grasp(double half, double friction) {
  Contacts contacts = ring_grasp(6, friction);
  for (std::size_t i = 0; i < 6; ++i) contacts[i].position.z() = i % 2 == 0 ? half : -half;
  return contacts;
}

inline Contacts with_normals_of_length(Contacts contacts, double length) {
  for (Contact& contact : contacts) contact.normal *= length;
  return contacts;
}

// n contacts on the upper part of the unit sphere: all push down, so there is no force closure.
inline Contacts one_sided_grasp(int n, double friction) {
  Random random(2);
  Contacts contacts = random_grasp(random, n, friction);
  for (Contact& contact : contacts) {
    contact.position.z() = std::abs(contact.position.z()) + 1.0;
    contact.position.normalize();
    contact.normal = -contact.position;
  }
  return contacts;
}

inline Contacts gather(Contacts contacts, const Eigen::Vector3d& point) {
  for (Contact& contact : contacts) contact.position = point;
  return contacts;
}

inline std::vector<ExtremeGrasp> few_contacts() {
  return {
      {"no contact", {}, {}},
      {"one contact", ring_grasp(1, 0.5), {}},
      {"one contact, soft", soft(ring_grasp(1, 0.5), 0.1), {}},
      {"two contacts, side by side", {tetrahedron()[0], tetrahedron()[1]}, {}},
      {"two opposite points", ring_grasp(2, 0.5), {}},
      {"two opposite points, turned",
       {tetrahedron()[0], on_sphere(tetrahedron()[0].normal, 0.5)},
       {}},
      {"two opposite points, friction 100", ring_grasp(2, 100.0), {}},
  };
}

inline std::vector<ExtremeGrasp> special_positions() {
  const Contacts star = octahedron_grasp(0.5);
  return {
      {"three on a line", collinear_grasp(3, 0.5), {}},
      {"eight on a line", collinear_grasp(8, 0.5), {}},
      {"three on a circle", ring_grasp(3, 0.5), {}},
      {"four on a circle", ring_grasp(4, 0.5), {}},
      {"eight on a circle", ring_grasp(8, 0.5), {}},
      {"eight on a circle, no friction", ring_grasp(8, 0.0), {}},
      {"six on the axes", star, {}},
      {"six at the origin", gather(star, Eigen::Vector3d::Zero()), {}},
      {"six at a point", gather(star, Eigen::Vector3d(0.1, 0.2, 0.3)), {}},
      {"six at a point, soft", gather(soft(star, 0.1), Eigen::Vector3d(0.1, 0.2, 0.3)), {}},
  };
}

inline std::vector<ExtremeGrasp> duplicates() {
  Random random(3);
  Contacts pair = ring_grasp(2, 0.5);
  std::vector<ExtremeGrasp> grasps = {
      {"one contact of four 1,000 times", repeated(tetrahedron(), 1000), {}},
      {"one contact 1,000 times", repeated(ring_grasp(1, 0.5), 1000), {}},
      {"one of two opposite points 1,000 times", repeated(pair, 1000), {}},
      {"four contacts twice", doubled(random, tetrahedron(), 0.0), {}},
  };
  for (const int digits : {7, 8, 9, 10, 12, 15}) {
    const std::string at = " nearly twice, 1e-" + std::to_string(digits) + " apart";
    const double shift = std::pow(10.0, -digits);
    grasps.push_back({"four contacts" + at, doubled(random, tetrahedron(), shift), {}});
    grasps.push_back({"two opposite points" + at, doubled(random, pair, shift), {}});
  }
  return grasps;
}

inline std::vector<ExtremeGrasp> frictions() {
  Random random(4);
  const Contacts loose = loose_grasp(random, 14, 0.0);
  std::vector<ExtremeGrasp> grasps;
  for (const auto& [text, friction] : std::vector<std::pair<std::string, double>>{
           {"0", 0.0}, {"1e-9", 1e-9}, {"1e-6", 1e-6}, {"1", 1.0}, {"1e6", 1e6}}) {
    Contacts rough = loose;
    for (Contact& contact : rough) contact.friction = friction;
    grasps.push_back({"four contacts, friction " + text, tetrahedron(friction), {}});
    grasps.push_back({"fourteen contacts, friction " + text, rough, {}});
    grasps.push_back({"six on the axes, friction " + text, octahedron_grasp(friction), {}});
  }
  return grasps;
}

inline std::vector<ExtremeGrasp> sizes() {
  std::vector<ExtremeGrasp> grasps;
  for (const auto& [text, radius] : std::vector<std::pair<std::string, double>>{
           {"1 micrometre", 1e-6}, {"1 mm", 1e-3}, {"1 km", 1e3}, {"1,000 km", 1e6}}) {
    const Contacts contacts = scaled(tetrahedron(), radius);
    grasps.push_back({"radius " + text, contacts, {.torque_scale = 1.0 / radius}});
    grasps.push_back({"radius " + text + ", torques not scaled", contacts, {}});
  }
  for (const auto& [text, distance] :
       std::vector<std::pair<std::string, double>>{{"1e3", 1e3}, {"1e6", 1e6}}) {
    const Eigen::Vector3d away = distance * Eigen::Vector3d(0.6, 0.0, 0.8);
    const std::string name = "origin " + text + " radii away";
    grasps.push_back({name, tetrahedron(), {away, 1.0}});
    grasps.push_back(
        {name + ", torques scaled by the distance", tetrahedron(), {away, 1.0 / distance}});
    grasps.push_back(
        {"grasp and origin moved " + text + " radii", shifted(tetrahedron(), away), {away, 1.0}});
  }
  return grasps;
}

inline std::vector<ExtremeGrasp> shapes() {
  return {
      {"needle 1 : 1e3", needle_grasp(1e-3, 0.5), {}},
      {"needle 1 : 1e6", needle_grasp(1e-6, 0.5), {}},
      {"needle 1 : 1e9", needle_grasp(1e-9, 0.5), {}},
      {"needle 1 : 1e12", needle_grasp(1e-12, 0.5), {}},
      {"disc 1e6 : 1", disc_grasp(1e-6, 0.5), {}},
      {"disc 1e6 : 1, friction 1e-6", disc_grasp(1e-6, 1e-6), {}},
      {"normals of length 0.9991", with_normals_of_length(tetrahedron(), 0.9991), {}},
      {"normals of length 1.0009", with_normals_of_length(tetrahedron(), 1.0009), {}},
  };
}

inline std::vector<ExtremeGrasp> many() {
  Random random(5);
  return {
      {"1,000 contacts", random_grasp(random, 1000, 0.5), {}},
      {"1,000 contacts, no friction", loose_grasp(random, 1000, 0.0), {}},
      {"1,000 contacts, pyramids of 3 edges", random_grasp(random, 1000, 0.5), {}, 3},
      {"1,000 contacts, one-sided", one_sided_grasp(1000, 0.2), {}},
      {"1,000 contacts on a circle", ring_grasp(1000, 0.5), {}},
      {"1,000 contacts at a point", gather(random_grasp(random, 1000, 0.5), {0.1, 0.2, 0.3}), {}},
      {"pyramids of 3 edges", tetrahedron(), {}, 3},
      {"pyramids of 4 edges", tetrahedron(), {}, 4},
      {"pyramids of 100 edges", tetrahedron(), {}, 100},
      {"pyramids of 1,000 edges", tetrahedron(), {}, 1000},
      {"two opposite points, pyramids of 1,000 edges", ring_grasp(2, 0.5), {}, 1000},
  };
}

inline std::vector<ExtremeGrasp> soft_fingers() {
  std::vector<ExtremeGrasp> grasps;
  for (const auto& [text, torsion] : std::vector<std::pair<std::string, double>>{{"0", 0.0},
                                                                                 {"1e-12", 1e-12},
                                                                                 {"1e-10", 1e-10},
                                                                                 {"1e-8", 1e-8},
                                                                                 {"1e-6", 1e-6},
                                                                                 {"0.01", 0.01},
                                                                                 {"1e6", 1e6}}) {
    grasps.push_back({"two soft fingers, torsion " + text, soft_pair(torsion), {}});
    grasps.push_back({"four soft fingers, torsion " + text, soft(tetrahedron(), torsion), {}});
  }
  grasps.push_back({"two soft fingers, friction 1e-9", soft_pair(0.01, 1e-9), {}});
  grasps.push_back({"two soft fingers, friction 1e-6", soft_pair(0.01, 1e-6), {}});
  return grasps;
}

// All grasps of this file, in the order of the table.
inline std::vector<ExtremeGrasp> extreme_grasps() {
  std::vector<ExtremeGrasp> all;
  for (const auto& part : {few_contacts(), special_positions(), duplicates(), frictions(), sizes(),
                           shapes(), many(), soft_fingers()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}  // namespace prehend::test
