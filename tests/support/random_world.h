// Worlds made up at random, to be judged while they move: piles, bodies thrown at walls, thin
// plates, bodies dropped into bowls, hands that close on bodies.
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/motion/require_world.h"
#include "sim/motion/world.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/object_generator.h"

namespace prehend::test {

enum class WorldKind { pile, thrown, plates, bowl, hand };
inline constexpr std::array<WorldKind, 5> kWorldKinds = {
    WorldKind::pile, WorldKind::thrown, WorldKind::plates, WorldKind::bowl, WorldKind::hand};

inline TriangleMesh random_shape(Random& random) {
  const auto size = [&] { return random.uniform(0.02, 0.12); };
  switch (random.index(8)) {
    case 0: {
      const Vector3 sides{size(), size(), size()};
      return make_box(sides, random.integer(1, 2));
    }
    case 1: {
      const double radius = 0.5 * size();
      const double height = size();
      return make_cylinder(radius, height, random.integer(3, 24));
    }
    case 2: {
      const double radius = 0.5 * size();
      return make_sphere(radius, random.integer(0, 2));
    }
    case 3:  // thin
      return make_box({size(), size(), random.uniform(0.001, 0.004)});
    case 4:  // long
      return make_box({size() + 0.1, random.uniform(0.004, 0.01), random.uniform(0.004, 0.01)});
    case 5: {  // a profile with a notch
      const double a = size();
      const double b = size();
      const double wall = 0.25 * std::min(a, b);
      return make_prism({{0.0, 0.0}, {a, 0.0}, {a, wall}, {wall, wall}, {wall, b}, {0.0, b}}, 0.0,
                        size());
    }
    default: {
      const std::vector<std::string> names = generated_object_names();
      return generate_object(names[random.index(names.size())], 150);
    }
  }
}

inline WorldBody random_body(Random& random, const std::string& name, const TriangleMesh& mesh) {
  WorldBody body{name, make_collision_body(name, mesh, true)};
  body.inertial = inertial_of_density(mesh, std::exp(random.uniform(std::log(200.0), 9.0)));
  return body;
}

inline WorldBody fixed_body(const std::string& name, const TriangleMesh& mesh, const Pose& X_WB) {
  WorldBody body{name, make_collision_body(name, mesh, true)};
  body.is_fixed = true;
  body.motion.X_WB = X_WB;
  return body;
}

class RandomWorld {
 public:
  RandomWorld(WorldKind kind, std::uint64_t seed) : random_(seed) {
    for (const Material a : kAll<Material>) {
      for (const Material b : kAll<Material>) friction(a, b);
    }
    switch (kind) {
      case WorldKind::pile:
        pile();
        break;
      case WorldKind::thrown:
        thrown();
        break;
      case WorldKind::plates:
        plates();
        break;
      case WorldKind::bowl:
        bowl();
        break;
      case WorldKind::hand:
        break;
    }
    const double bounce = random_.index(2) == 0 ? 0.0 : random_.uniform(0.0, 1.0);
    for (WorldBody& body : world_.bodies) body.restitution = bounce;
  }

  // A body before a hand that closes on it, thrown at its palm or floating. False where none fits.
  bool put_in_hand(const std::shared_ptr<const RobotModel>& model) {
    const Hand& hand = *model->robot.hand;
    const Preshape& preshape = hand.preshapes.front();
    WorldBody body = random_body(random_, "object", random_shape(random_));
    body.motion.X_WB = pose_from(random_.rotation(), hand.origin + preshape.depth * hand.approach) *
                       translation(-body.inertial.center_of_mass);
    const bool thrown = random_.index(2) == 1;
    const double speed = random_.uniform(0.0, 20.0);
    if (thrown) body.motion.linear = -speed * hand.approach;
    body.motion.angular = random_.in_box(20.0);
    world_.gravity.setZero();
    world_.bodies.push_back(std::move(body));
    close_hand(model, preshape.dofs);
    for (int i = 0; i < 50; ++i) {
      if (is_free()) return true;
      world_.bodies.back().motion.X_WB.translation() += 0.01 * hand.approach;
    }
    return false;
  }

  World& world() { return world_; }

 private:
  void friction(Material a, Material b) {
    world_.laws.friction.set(a, b, random_.index(6) == 0 ? 0.0 : random_.uniform(0.0, 1.2));
  }

  void ground() {
    world_.bodies.push_back(
        fixed_body("ground", make_box({2.0, 2.0, 0.05}), translation({0.0, 0.0, -0.025})));
  }

  // Turned at random about `place`, with a spin of at most `spin` about each axis [rad/s].
  void add(const TriangleMesh& mesh, const Vector3& place, const Vector3& linear, double spin) {
    const Pose X_WC = pose_from(random_.rotation(), place);
    const Vector3 angular = random_.in_box(spin);
    add(mesh, X_WC, linear, angular);
  }

  void add(const TriangleMesh& mesh, const Pose& X_WC, const Vector3& linear,
           const Vector3& angular) {
    WorldBody body = random_body(random_, "body" + std::to_string(world_.bodies.size()), mesh);
    body.motion.X_WB = X_WC * translation(-body.inertial.center_of_mass);
    body.motion.linear = linear;
    body.motion.angular = angular;
    world_.bodies.push_back(std::move(body));
  }

  void close_hand(const std::shared_ptr<const RobotModel>& model, const std::vector<double>& dofs) {
    WorldRobot robot = make_world_robot("hand", model, Pose::Identity(), dofs);
    for (std::size_t d = 0; d < model->robot.dofs.size(); ++d) {
      const double speed = model->robot.dofs[d].closing_velocity;
      robot.drives.push_back({.dof = static_cast<int>(d),
                              .target_rate = random_.uniform(1.0, 4.0) * speed,
                              .holds_rate = true,
                              .max_effort = model->effort[static_cast<Eigen::Index>(d)]});
    }
    world_.robots.push_back(std::move(robot));
  }

  bool is_free() const {
    try {
      require_world(world_);
    } catch (const InputError&) {
      return false;
    }
    return true;
  }

  // In columns that lean on each other as they fall.
  void pile() {
    ground();
    const int count = random_.integer(3, 7);
    for (int i = 0; i < count; ++i) {
      const double height = 0.15 + 0.22 * i;
      const Vector3 place = random_.in_box({-0.03, -0.03, height}, {0.03, 0.03, height});
      add(random_shape(random_), place, Vector3::Zero(), 5.0);
    }
  }

  // At each other, at the ground and at a wall, turning fast.
  void thrown() {
    ground();
    world_.bodies.push_back(
        fixed_body("wall", make_box({0.01, 1.0, 1.0}), translation({0.5, 0.0, 0.6})));
    const int count = random_.integer(1, 3);
    for (int i = 0; i < count; ++i) {
      const double speed = std::exp(random_.uniform(0.0, std::log(50.0)));
      const Vector3 place(-0.3 * i, random_.uniform(-0.02, 0.02), 0.4);
      const Vector3 ahead(1.0, 0.0, random_.uniform(-0.5, 0.2));
      const Vector3 direction = (ahead + random_.in_box(0.1)).normalized();
      add(random_shape(random_), place, speed * direction, 200.0);
    }
  }

  // Thin plates on and through each other's ways.
  void plates() {
    ground();
    world_.bodies.push_back(fixed_body("sheet", make_box({0.3, 0.3, 0.001}),
                                       pose_from(random_.rotation(), Vector3(0.0, 0.0, 0.3))));
    const int count = random_.integer(1, 3);
    for (int i = 0; i < count; ++i) {
      const double speed = std::exp(random_.uniform(0.0, std::log(50.0)));
      const Vector3 from = 0.35 * Vector3(std::cos(2.1 * i), std::sin(2.1 * i), 0.6);
      const Vector3 size = random_.in_box({0.03, 0.03, 0.0006}, {0.15, 0.15, 0.003});
      const Vector3 direction = (random_.in_box(0.05) - from).normalized();
      add(make_box(size), from + Vector3(0.0, 0.0, 0.3), speed * direction, 100.0);
    }
  }

  void bowl() {
    ground();
    const char* name = random_.index(2) == 0 ? "bowl" : "mug";
    add(generate_object(name, 300), translation({0.0, 0.0, 0.06}), Vector3::Zero(),
        Vector3::Zero());
    const int count = random_.integer(1, 4);
    for (int i = 0; i < count; ++i) {
      const double size = random_.uniform(0.01, 0.04);
      const TriangleMesh mesh = random_.index(2) == 0
                                    ? make_box({size, random_.uniform(0.005, 0.02), 0.015})
                                    : make_sphere(0.5 * size, random_.integer(0, 2));
      const double height = 0.25 + 0.1 * i;
      const Vector3 place = random_.in_box({-0.02, -0.02, height}, {0.02, 0.02, height});
      const Vector3 fall(0.0, 0.0, -random_.uniform(0.0, 10.0));
      add(mesh, place, fall, 20.0);
    }
  }

  Random random_;
  World world_;
};

}  // namespace prehend::test
