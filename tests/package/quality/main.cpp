// Three fingertips around a ball: how well they hold it, and how hard they must press.
#include <cmath>
#include <iostream>
#include <numbers>
#include <prehend/quality.h>
#include <vector>

int main() {
  const double radius = 0.05;  // m
  std::vector<prehend::Contact> contacts;
  for (const double degrees : {0.0, 120.0, 240.0}) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const Eigen::Vector3d outward(std::cos(angle), std::sin(angle), 0.0);
    contacts.push_back({.position = radius * outward, .normal = -outward, .friction = 0.5});
  }
  const prehend::WrenchFrame frame{.torque_scale = 1.0 / radius};

  const prehend::WrenchSpaceOptions space{.cone = prehend::FrictionCone::exact};
  const auto epsilon = grasp_epsilon(contacts, frame, space, epsilon_options(space));
  std::cout << "epsilon from " << epsilon.lower << " to " << epsilon.upper << "\n";

  const prehend::Wrench weight{0.0, 0.0, -3.0, 0.0, 0.0, 0.0};  // N
  const auto forces = balancing_forces(contacts, frame, weight);
  if (forces.outcome != prehend::ForceOutcome::balanced) return 1;
  std::cout << "largest normal force " << forces.largest_normal << " N\n"
            << "forces, one a column:\n"
            << forces.forces << "\n";
}
