// Sets of wrenches whose largest ball and volume are known in closed form.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/QR>

#include "sim/quality/wrench.h"
#include "tests/support/grasp_families.h"

namespace prehend::test {

struct KnownSet {
  std::string name;
  Wrenches wrenches;
  double epsilon = 0.0;  // smallest facet offset: signed
  double volume = 0.0;
};

// +-a_i along axis i. The facet through all positive corners has normal (1 / a_i).
inline KnownSet cross_polytope(const Wrench& a) {
  KnownSet set{"cross polytope", Wrenches::Zero(6, 12)};
  for (int i = 0; i < 6; ++i) {
    set.wrenches(i, 2 * i) = a[i];
    set.wrenches(i, 2 * i + 1) = -a[i];
  }
  set.epsilon = 1.0 / a.cwiseInverse().norm();
  set.volume = 64.0 / 720.0 * a.prod();
  return set;
}

// The corners of the box [-a, a]: twelve facets of 32 corners each.
inline KnownSet box(const Wrench& a) {
  KnownSet set{"box", Wrenches(6, 64)};
  for (int corner = 0; corner < 64; ++corner) {
    for (int i = 0; i < 6; ++i) set.wrenches(i, corner) = ((corner >> i) & 1) != 0 ? a[i] : -a[i];
  }
  set.epsilon = a.minCoeff();
  set.volume = 64.0 * a.prod();
  return set;
}

// The six unit vectors and -(1, ..., 1): the facet without e_k has the normal with -6 at k, else 1.
inline KnownSet simplex() {
  KnownSet set{"simplex", Wrenches(6, 7)};
  set.wrenches << Eigen::Matrix<double, 6, 6>::Identity(), -Wrench::Ones();
  set.epsilon = 1.0 / std::sqrt(41.0);
  set.volume = 7.0 / 720.0;
  return set;
}

// `set` moved by `shift` along the first axis, for sets whose nearest facet faces that axis.
inline KnownSet moved(KnownSet set, double shift) {
  set.name += " moved by " + std::to_string(shift);
  set.wrenches.row(0).array() += shift;
  set.epsilon -= std::abs(shift);
  return set;
}

inline Eigen::Matrix<double, 6, 6> random_orthogonal(Random& random) {
  Eigen::Matrix<double, 6, 6> entries;
  for (double& entry : entries.reshaped()) entry = random.uniform(-1.0, 1.0);
  return Eigen::HouseholderQR<Eigen::Matrix<double, 6, 6>>(entries).householderQ();
}

inline KnownSet turned(KnownSet set, Random& random) {
  set.name += " turned";
  set.wrenches = random_orthogonal(random) * set.wrenches;
  return set;
}

inline KnownSet scaled(KnownSet set, double factor) {
  set.name += " scaled by " + std::to_string(factor);
  set.wrenches *= factor;
  set.epsilon *= factor;
  set.volume *= std::pow(factor, 6);
  return set;
}

inline std::vector<KnownSet> known_sets() {
  Random random(6);
  Wrench lengths;
  lengths << 1.0, 0.5, 2.0, 3.0, 0.25, 1.5;
  Wrench needle;
  needle << 1.0, 1e-3, 1.0, 1e-2, 1.0, 1.0;
  const std::vector<KnownSet> plain = {
      cross_polytope(Wrench::Ones()),
      cross_polytope(lengths),
      cross_polytope(needle),
      box(Wrench::Ones()),
      box(lengths),
      box(needle),
      simplex(),
      moved(box(Wrench::Ones()), 0.25),
      moved(box(Wrench::Ones()), 0.999999),
      moved(box(Wrench::Ones()), 1.5),
  };
  std::vector<KnownSet> sets;
  for (const KnownSet& set : plain) {
    sets.push_back(set);
    sets.push_back(turned(set, random));
    sets.push_back(scaled(turned(set, random), 1e-6));
    sets.push_back(scaled(set, 1e6));
  }
  return sets;
}

}  // namespace prehend::test
