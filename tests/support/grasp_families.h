// Families of random grasps for tests of the quality measures, from a seed and the same on every
// platform: generic ones, and those in which wrenches coincide, lie in one hyperplane or have many
// directions of equal epsilon, where algorithms on convex hulls tend to fail. Lengths are relative
// to an object of radius 1.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/base/random.h"
#include "sim/quality/contact.h"
#include "sim/quality/wrench.h"

namespace prehend::test {

using Contacts = std::vector<Contact>;

// A contact on the unit sphere at `direction` (unit), with the normal into the sphere.
inline Contact on_sphere(const Eigen::Vector3d& direction, double friction) {
  return {direction, -direction, friction};
}

// n contacts anywhere on the unit sphere.
inline Contacts random_grasp(Random& random, int n, double friction) {
  Contacts contacts;
  for (int i = 0; i < n; ++i) contacts.push_back(on_sphere(random.direction(), friction));
  return contacts;
}

// n contacts with positions in the cube [-1, 1]^3 and normals that are independent of the
// positions.
inline Contacts loose_grasp(Random& random, int n, double friction) {
  Contacts contacts;
  for (int i = 0; i < n; ++i) {
    // From z to x: exact results of some of these grasps are on file (oracle/extremes.json).
    Eigen::Vector3d p;
    for (const int axis : {2, 1, 0}) p[axis] = random.uniform(-1, 1);
    contacts.push_back({p, random.direction(), friction});
  }
  return contacts;
}

// n contacts evenly around the equator of the unit sphere.
inline Contacts ring_grasp(int n, double friction) {
  Contacts contacts;
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / n;
    contacts.push_back(on_sphere({std::cos(angle), std::sin(angle), 0.0}, friction));
  }
  return contacts;
}

// Six contacts where the coordinate axes meet the unit sphere.
inline Contacts octahedron_grasp(double friction) {
  Contacts contacts;
  for (int axis = 0; axis < 3; ++axis) {
    contacts.push_back(on_sphere(Eigen::Vector3d::Unit(axis), friction));
    contacts.push_back(on_sphere(-Eigen::Vector3d::Unit(axis), friction));
  }
  return contacts;
}

// Eight contacts on the unit sphere in the directions of a cube's corners.
inline Contacts cube_grasp(double friction) {
  Contacts contacts;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d corner((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1,
                                 (i & 4) != 0 ? 1 : -1);
    contacts.push_back(on_sphere(corner.normalized(), friction));
  }
  return contacts;
}

// n contacts on the lateral surface of a cylinder of radius 0.4 and height 1.8, axis z.
inline Contacts cylinder_grasp(Random& random, int n, double friction) {
  Contacts contacts;
  for (int i = 0; i < n; ++i) {
    const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
    const Eigen::Vector3d out(std::cos(angle), std::sin(angle), 0.0);
    contacts.push_back(
        {0.4 * out + random.uniform(-0.9, 0.9) * Eigen::Vector3d::UnitZ(), -out, friction});
  }
  return contacts;
}

// A square of four contacts around `centre` with sides 2 * `half` and one common unit `normal`.
inline Contacts patch(const Eigen::Vector3d& centre, const Eigen::Vector3d& normal, double half,
                      double friction) {
  const Tangents tangents = contact_tangents(normal);
  Contacts contacts;
  for (const double a : {-half, half}) {
    for (const double b : {-half, half}) {
      contacts.push_back({centre + a * tangents.first + b * tangents.second, normal, friction});
    }
  }
  return contacts;
}

// Appends the contacts of `more` to `to`.
inline void append(Contacts& to, const Contacts& more) {
  to.insert(to.end(), more.begin(), more.end());
}

// n square patches of four contacts on tangent planes of the unit sphere.
inline Contacts patches_grasp(Random& random, int n, double friction) {
  Contacts contacts;
  for (int i = 0; i < n; ++i) {
    const Eigen::Vector3d out = random.direction();
    append(contacts, patch(out, -out, random.uniform(0.02, 0.2), friction));
  }
  return contacts;
}

// Contacts of a parallel jaw: two opposite square patches with sides 2 * `half`, 0.6 apart along y.
inline Contacts jaw_grasp(double half, double friction) {
  Contacts contacts =
      patch(Eigen::Vector3d::UnitY() * 0.3, -Eigen::Vector3d::UnitY(), half, friction);
  append(contacts,
         patch(Eigen::Vector3d::UnitY() * -0.3, Eigen::Vector3d::UnitY(), half, friction));
  return contacts;
}

// Every contact twice, the copy moved by `shift` in a random direction.
inline Contacts doubled(Random& random, Contacts contacts, double shift) {
  const std::size_t n = contacts.size();
  for (std::size_t i = 0; i < n; ++i) {
    Contact copy = contacts[i];
    copy.position += shift * random.direction();
    contacts.push_back(copy);
  }
  return contacts;
}

// The contacts with positions and normals rotated about the origin.
inline Contacts rotated(const Contacts& contacts, const Eigen::Matrix3d& rotation) {
  Contacts turned = contacts;
  for (Contact& contact : turned) {
    contact.position = rotation * contact.position;
    contact.normal = rotation * contact.normal;
  }
  return turned;
}

// A grasp of a family, and the number of edges of its friction pyramids.
struct NamedGrasp {
  std::string name;
  Contacts contacts;
  int edges = 8;
};

// About 20 * `rounds` grasps: in each round one of every family (some at several settings), with
// random sizes and frictions. "aligned" means not rotated, so that many coordinates are exactly 0;
// "near flat", "nearly" and "doubled" have wrenches close to a hyperplane or to each other.
inline std::vector<NamedGrasp> grasp_families(std::uint64_t seed, int rounds) {
  Random random(seed);
  std::vector<NamedGrasp> grasps;
  for (int round = 0; round < rounds; ++round) {
    const auto add = [&](const std::string& name, const Contacts& contacts, int edges = 8) {
      grasps.push_back({name + " " + std::to_string(round), contacts, edges});
    };
    const double friction = random.uniform(0.1, 1.0);
    const auto turn = [&](const Contacts& contacts) {
      return rotated(contacts, random.rotation());
    };
    add("random", random_grasp(random, random.integer(3, 10), friction));
    const Contacts few = random_grasp(random, random.integer(3, 6), friction);
    add("random edges", few, random.integer(3, 13));
    add("loose", loose_grasp(random, random.integer(6, 14), friction));
    add("ring", turn(ring_grasp(random.integer(3, 8), friction)));
    add("ring aligned", ring_grasp(random.integer(3, 8), friction));
    add("octahedron", turn(octahedron_grasp(friction)));
    add("octahedron aligned", octahedron_grasp(friction));
    add("cube", turn(cube_grasp(friction)));
    add("cylinder", turn(cylinder_grasp(random, random.integer(3, 10), friction)));
    add("cylinder aligned", cylinder_grasp(random, random.integer(3, 10), friction));
    add("patches", patches_grasp(random, random.integer(2, 4), friction));
    add("jaw", turn(jaw_grasp(random.uniform(0.01, 0.2), friction)));
    add("jaw aligned", jaw_grasp(random.uniform(0.01, 0.2), friction));
    add("near flat jaw", turn(jaw_grasp(std::pow(10.0, random.uniform(-6.0, -2.0)), friction)));
    Contacts flat = turn(random_grasp(random, 2, friction));
    append(flat, doubled(random, flat, std::pow(10.0, random.uniform(-5.0, -2.0))));
    add("two, nearly", flat);
    for (const int digits : {7, 9, 12}) {
      add("doubled at 1e-" + std::to_string(digits),
          doubled(random, random_grasp(random, random.integer(3, 5), friction),
                  std::pow(10.0, -digits)));
    }
    add("doubled", doubled(random, random_grasp(random, random.integer(3, 5), friction), 0.0));
    Contacts mixed = random_grasp(random, random.integer(4, 9), friction);
    for (std::size_t i = 0; i < mixed.size(); i += 2) mixed[i].friction = 0.0;
    add("some frictionless", mixed);
    Contacts slippery = loose_grasp(random, random.integer(10, 24), 0.0);
    add("all frictionless", slippery);
    Contacts one_sided = random_grasp(random, random.integer(3, 8), friction);
    for (Contact& contact : one_sided) {
      contact.position.z() = std::abs(contact.position.z());
      contact.normal = -contact.position;
    }
    add("one sided", one_sided);
    Contacts at_a_point = random_grasp(random, random.integer(3, 6), friction);
    for (Contact& contact : at_a_point) contact.position = Eigen::Vector3d(0.1, 0.2, 0.3);
    add("at a point", at_a_point);
  }
  return grasps;
}

}  // namespace prehend::test
