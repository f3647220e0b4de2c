// Families of random grasps with a given number of contacts.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/support/grasp_families.h"

namespace prehend::benchmark {

using namespace test;  // NOLINT(google-build-using-namespace): the grasps that tests share

struct Family {
  std::string name;
  int multiple;  // of contacts that it has
  int fewest;
  std::function<Contacts(Random&, int contacts, double friction)> make;
};

inline Contacts turned(Random& random, const Contacts& contacts) {
  return rotated(contacts, random.rotation());
}

inline std::vector<Family> families_by_size() {
  return {
      {"random", 1, 3, random_grasp},
      {"loose", 1, 3, loose_grasp},
      {"ring", 1, 3,
       [](Random& random, int n, double f) { return turned(random, ring_grasp(n, f)); }},
      {"ring aligned", 1, 3, [](Random&, int n, double f) { return ring_grasp(n, f); }},
      {"cylinder", 1, 3,
       [](Random& random, int n, double f) {
         return turned(random, cylinder_grasp(random, n, f));
       }},
      {"cylinder aligned", 1, 3, cylinder_grasp},
      {"patches", 4, 8,
       [](Random& random, int n, double f) { return patches_grasp(random, n / 4, f); }},
      {"jaw", 8, 8,
       [](Random& random, int, double f) {
         return turned(random, jaw_grasp(random.uniform(0.01, 0.2), f));
       }},
      {"two, nearly, twice", 4, 4,
       [](Random& random, int n, double f) {
         Contacts pair = turned(random, ring_grasp(2, f));
         for (; n > 2; n /= 2) pair = doubled(random, pair, 0.05);
         return pair;
       }},
      {"some frictionless", 1, 3,
       [](Random& random, int n, double f) {
         Contacts contacts = random_grasp(random, n, f);
         contacts[0].friction = 0.0;
         return contacts;
       }},
      {"soft fingers", 1, 3,
       [](Random& random, int n, double f) {
         Contacts contacts = random_grasp(random, n, f);
         for (Contact& contact : contacts) {
           contact.model = ContactModel::soft_finger;
           contact.torsion = 0.1;
         }
         return contacts;
       }},
  };
}

}  // namespace prehend::benchmark
