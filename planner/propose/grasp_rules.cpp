#include "planner/propose/grasp_rules.h"

#include <cmath>
#include <numbers>

namespace prehend {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

Vector3 axis(int k) { return Vector3::Unit(k); }

// `count` places along [-length / 2, length / 2], in the middles of equal parts.
std::vector<double> places_along(double length, int count) {
  std::vector<double> places;
  places.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) places.push_back(length * ((i + 0.5) / count - 0.5));
  return places;
}

// Collects grasps, which the rules state in the primitive's frame P, expressed in the object's
// frame O. Each is added with both signs of the closing direction: a hand has its thumb on one
// side, so turning it by half a turn about the approach is another grasp.
class Aims {
 public:
  explicit Aims(const Pose& X_OP) : X_OP_(X_OP) {}

  void add(const Vector3& target, const Vector3& approach, const Vector3& closing, double width,
           const char* rule) {
    for (const double side : {1.0, -1.0}) {
      grasps_.push_back({X_OP_ * target, X_OP_.linear() * approach,
                         side * (X_OP_.linear() * closing), width, rule});
    }
  }

  std::vector<AimedGrasp> take() { return std::move(grasps_); }

 private:
  const Pose X_OP_;
  std::vector<AimedGrasp> grasps_;
};

// Box: thumb and fingers on the two faces orthogonal to `closing`; the hand approaches along either
// of the other two axes, from both ends, at places spread along the remaining axis. Short boxes get
// the same places, which then lie close together and are sorted out as duplicates.
void aim(const Box& box, const GraspRuleOptions& options, Aims& aims) {
  for (int closing = 0; closing < 3; ++closing) {
    for (int approach = 0; approach < 3; ++approach) {
      if (approach == closing) continue;
      const int along = 3 - closing - approach;  // the third of the axes 0, 1, 2
      for (const double place : places_along(box.size[along], options.places)) {
        for (const double from : {1.0, -1.0}) {
          aims.add(place * axis(along), from * axis(approach), axis(closing), box.size[closing],
                   "box faces");
        }
      }
    }
  }
}

// Cylinder (axis z): from the side with the fingers across the axis, closing on the diameter, or
// along it, closing on both ends; and onto an end with the fingers around the rim.
void aim(const Cylinder& cylinder, const GraspRuleOptions& options, Aims& aims) {
  const Vector3 z = Vector3::UnitZ();
  for (int i = 0; i < options.cylinder_directions; ++i) {
    const double angle = kTurn * i / options.cylinder_directions;
    const Vector3 approach(std::cos(angle), std::sin(angle), 0.0);
    const Vector3 across = z.cross(approach);
    for (const double place : places_along(cylinder.height, options.places)) {
      aims.add(place * z, approach, across, 2.0 * cylinder.radius, "cylinder side, thumb across");
    }
    aims.add(Vector3::Zero(), approach, z, cylinder.height, "cylinder side, thumb along");
    // For approaches onto the ends the direction only turns the hand about the axis. Half of the
    // turns are enough, since each grasp is added with the thumb on either side.
    if (2 * i < options.cylinder_directions) {
      for (const double end : {1.0, -1.0}) {
        const Vector3 on_end = end * 0.5 * cylinder.height * z;
        aims.add(on_end, -end * z, across, 2.0 * cylinder.radius, "cylinder end");
      }
    }
  }
}

// Sphere: towards the centre from directions spread evenly over the sphere, and for each with the
// hand turned about the approach.
void aim(const Sphere& sphere, const GraspRuleOptions& options, Aims& aims) {
  const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < options.sphere_directions; ++i) {
    // Fibonacci lattice: z in equal steps gives rings of equal area (Archimedes), and turning by
    // the golden angle from one point to the next spreads the points evenly without clusters at the
    // poles.
    const double z = 1.0 - 2.0 * (i + 0.5) / options.sphere_directions;
    const double ring = std::sqrt(1.0 - z * z);
    const Vector3 approach(ring * std::cos(golden * i), ring * std::sin(golden * i), z);
    const Vector3 x = any_orthogonal(approach);
    const Vector3 y = approach.cross(x);
    for (int turn = 0; turn < options.sphere_turns; ++turn) {
      // Half a turn is enough, since each grasp is added with the thumb on either side.
      const double angle = 0.5 * kTurn * turn / options.sphere_turns;
      aims.add(Vector3::Zero(), approach, std::cos(angle) * x + std::sin(angle) * y,
               2.0 * sphere.radius, "sphere");
    }
  }
}

}  // namespace

std::vector<AimedGrasp> aim_at(const Primitive& primitive, const GraspRuleOptions& options) {
  Aims aims(primitive.X_OP);
  std::visit([&](const auto& shape) { aim(shape, options, aims); }, primitive.shape);
  return aims.take();
}

}  // namespace prehend
