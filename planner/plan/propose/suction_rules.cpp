#include "planner/plan/propose/suction_rules.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include "planner/plan/propose/hand_pose.h"
#include "sim/base/index.h"
#include "sim/scene/compiled_scene.h"
#include "sim/shape/proximity.h"
#include "sim/shape/triangle_mesh.h"
#include "sim/trial/cup_contacts.h"

namespace prehend {
namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;
constexpr int kSamples = 1500;     // places that are looked at
constexpr int kWaysOfPlaces = 24;  // lists into which the places of all primitives are divided

double largest_radius(const Hand& hand) {
  double largest = 0.0;
  for (const SuctionCup& cup : hand.cups) largest = std::max(largest, cup.radius);
  return largest;
}

// How far from the hand's origin lips reach, across its approach.
double lip_reach(const Hand& hand) {
  double reach = 0.0;
  for (const SuctionCup& cup : hand.cups) {
    const Vector3 from = cup.position - hand.origin;
    reach = std::max(reach, (from - hand.approach * hand.approach.dot(from)).norm() + cup.radius);
  }
  return reach;
}

// Points spread over the surface: one in each of equal parts of the area, taken triangle after
// triangle, at places within the triangle that follow the R2 sequence.
template <typename Visit>
void for_each_sample(const TriangleMesh& mesh, int samples, const Visit& visit) {
  const double step = surface_area(mesh) / samples;
  double passed = 0.0;
  int made = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vector3 doubled = doubled_area_vector(mesh, t);
    passed += 0.5 * doubled.norm();
    const Corners corner = corners_of(mesh, static_cast<int>(t));
    for (; made < samples && (made + 0.5) * step < passed; ++made) {
      double a = std::fmod(0.5 + 0.7548776662466927 * made, 1.0);
      double b = std::fmod(0.5 + 0.5698402909980532 * made, 1.0);
      if (a + b > 1.0) {
        a = 1.0 - a;
        b = 1.0 - b;
      }
      visit(Vector3(corner[0] + a * (corner[1] - corner[0]) + b * (corner[2] - corner[0])),
            Vector3(doubled.stableNormalized()));
    }
  }
}

// The mean of the outer normals around a point, as far as lips reach; none where the surface turns
// away from `normal` altogether.
Vector3 mean_normal(const ProximityMesh& mesh, const Vector3& point, const Vector3& normal,
                    double reach) {
  constexpr int kAround = 8;
  const Vector3 x = any_orthogonal(normal);
  const Vector3 y = normal.cross(x);
  Vector3 sum = normal;
  for (int i = 0; i < kAround; ++i) {
    const double angle = kFullTurn * i / kAround;
    const Vector3 from = point + reach * (std::cos(angle) * x + std::sin(angle) * y + normal);
    const RayHit hit = first_hit(mesh, from, -normal, 2.0 * reach);
    if (hit.triangle < 0) continue;
    const Vector3 other = doubled_area_vector(mesh.mesh(), index(hit.triangle)).stableNormalized();
    if (other.dot(normal) > 0.0) sum += other;
  }
  return sum.normalized();
}

// How many cups seal with the hand's origin at the point, in the best of some turns.
int sealed_cups(const CompiledScene& scene, const Vector3& point, const Vector3& approach) {
  const Hand& hand = *scene.scene.hand.hand;
  const int turns = hand.cups.size() > 1 ? 4 : 1;
  const Vector3 x = any_orthogonal(approach);
  int most = 0;
  for (int turn = 0; turn < turns; ++turn) {
    const double angle = 0.5 * std::numbers::pi * turn / turns;
    const Vector3 closing = std::cos(angle) * x + std::sin(angle) * approach.cross(x);
    const Pose X_OH = hand_pose(hand, {point, approach, closing}, 0.0);
    int sealed = 0;
    for (const CupSeal& seal : cup_seals(scene, X_OH)) sealed += seal.end == SealEnd::sealed;
    most = std::max(most, sealed);
  }
  return most;
}

class SuctionRules {
 public:
  explicit SuctionRules(bool turns) : turns_(turns) {}

  // `aim` gives point and approach in P for the choices before the turn.
  template <typename Aim>
  void add(const char* name, const Pose& X_OP, std::vector<Freedom> freedoms, const Aim& aim) {
    const std::size_t turn = freedoms.size();
    if (turns_) freedoms.push_back(Freedom::turn);
    rules_.push_back({name, 0.0, std::move(freedoms),
                      [X_OP, aim, turn, turns = turns_](const std::vector<double>& choices) {
                        const auto [point_P, approach_P] = aim(choices);
                        const Vector3 approach = X_OP.linear() * approach_P;
                        const Vector3 x = any_orthogonal(approach);
                        const double angle = turns ? kFullTurn * choices[turn] : 0.0;
                        return AimedGrasp{
                            X_OP * point_P, approach,
                            std::cos(angle) * x + std::sin(angle) * approach.cross(x)};
                      }});
  }

  std::vector<GraspRule> take() { return std::exchange(rules_, {}); }

 private:
  bool turns_;
  std::vector<GraspRule> rules_;
};

using Aimed = std::pair<Vector3, Vector3>;  // point and approach

void add_faces(const Box& box, const Pose& X_OP, SuctionRules& rules) {
  for (int axis = 0; axis < 3; ++axis) {
    const int one = (axis + 1) % 3;
    const int other = (axis + 2) % 3;
    for (const double side : {1.0, -1.0}) {
      rules.add("face", X_OP, {Freedom::place, Freedom::place},
                [=, size = box.size](const std::vector<double>& choices) {
                  Vector3 point;
                  point[axis] = 0.5 * side * size[axis];
                  point[one] = (choices[0] - 0.5) * size[one];
                  point[other] = (choices[1] - 0.5) * size[other];
                  return Aimed{point, -side * Vector3::Unit(axis)};
                });
    }
  }
}

// The side and the ends of a cone; a cylinder is one with equal radii.
void add_round(double low, double high, double height, const Pose& X_OP, SuctionRules& rules) {
  rules.add("side", X_OP, {Freedom::turn, Freedom::place}, [=](const std::vector<double>& choices) {
    const double angle = kFullTurn * choices[0];
    const Vector3 out(std::cos(angle), std::sin(angle), 0.0);
    const double radius = low + choices[1] * (high - low);
    const Vector3 point = radius * out + (choices[1] - 0.5) * height * Vector3::UnitZ();
    const Vector3 normal = height * out - (high - low) * Vector3::UnitZ();
    return Aimed{point, -normal.normalized()};
  });
  for (const double end : {1.0, -1.0}) {
    if ((end > 0.0 ? high : low) <= 0.0) continue;
    rules.add("face", X_OP, {}, [=](const std::vector<double>& /*choices*/) {
      return Aimed{0.5 * end * height * Vector3::UnitZ(), -end * Vector3::UnitZ()};
    });
  }
}

void add_ball(const Sphere& sphere, const Pose& X_OP, SuctionRules& rules) {
  rules.add("side", X_OP, {Freedom::span, Freedom::turn},
            [radius = sphere.radius](const std::vector<double>& choices) {
              const double z = 1.0 - 2.0 * choices[0];
              const double ring = std::sqrt(std::max(0.0, 1.0 - z * z));
              const double angle = kFullTurn * choices[1];
              const Vector3 out(ring * std::cos(angle), ring * std::sin(angle), z);
              return Aimed{radius * out, -out};
            });
}

void add_faces(const Primitive& primitive, SuctionRules& rules) {
  const Pose& X_OP = primitive.X_OP;
  if (const auto* box = std::get_if<Box>(&primitive.shape)) add_faces(*box, X_OP, rules);
  if (const auto* cylinder = std::get_if<Cylinder>(&primitive.shape)) {
    add_round(cylinder->radius, cylinder->radius, cylinder->height, X_OP, rules);
  }
  if (const auto* cone = std::get_if<Cone>(&primitive.shape)) {
    add_round(cone->radius_low, cone->radius_high, cone->height, X_OP, rules);
  }
  if (const auto* sphere = std::get_if<Sphere>(&primitive.shape)) add_ball(*sphere, X_OP, rules);
}

// The number in an ordered list that a choice stands for: those of level 0, 1, 2, ... of
// Freedom::place have 1, 2, 4, ... new choices, which are odd multiples of 1/2, 1/4, 1/8, ...
std::size_t rank_of(double choice) {
  constexpr int kFinest = 24;
  for (int level = 0; level < kFinest; ++level) {
    const double scaled = std::ldexp(choice, level + 1);
    if (scaled != std::floor(scaled)) continue;
    const auto odd = static_cast<std::size_t>(std::max(0.0, scaled));
    return (std::size_t{1} << level) - 1 + odd / 2;
  }
  return 0;
}

void add_places(std::vector<SuctionPlace> places, SuctionRules& rules) {
  if (places.empty()) return;
  const auto shared = std::make_shared<const std::vector<SuctionPlace>>(std::move(places));
  rules.add("smooth place", Pose::Identity(), {Freedom::place},
            [shared](const std::vector<double>& choices) {
              const SuctionPlace& place = (*shared)[rank_of(choices[0]) % shared->size()];
              return Aimed{place.point_O, place.approach_O};
            });
}

// The solid whose surface is nearest, or where there are only curves the nearest of these.
std::size_t nearest_primitive(const std::vector<Primitive>& primitives, const Vector3& point) {
  std::tuple<bool, double, std::size_t> best{true, std::numeric_limits<double>::infinity(), 0};
  for (std::size_t p = 0; p < primitives.size(); ++p) {
    best = std::min(
        best, {is_curve(primitives[p].shape), std::abs(signed_distance(primitives[p], point)), p});
  }
  return std::get<2>(best);
}

}  // namespace

std::vector<SuctionPlace> suction_places(const CompiledScene& scene) {
  const Hand& hand = *scene.scene.hand.hand;
  const ProximityMesh& mesh = scene.object().mesh;
  const double radius = largest_radius(hand);
  const double reach = lip_reach(hand);
  const Vector3& center = scene.wrench_frame.torque_origin;
  std::vector<SuctionPlace> found;
  for_each_sample(mesh.mesh(), kSamples, [&](const Vector3& point, const Vector3& normal) {
    if (normal.isZero(0.0)) return;
    SuctionPlace place{point, -mean_normal(mesh, point, normal, 0.7 * reach)};
    place.off_center = (center - point).cross(place.approach_O).norm();
    place.sealed = sealed_cups(scene, point, place.approach_O);
    if (place.sealed > 0) found.push_back(place);
  });
  std::stable_sort(found.begin(), found.end(), [](const SuctionPlace& a, const SuctionPlace& b) {
    return a.sealed != b.sealed ? a.sealed > b.sealed : a.off_center < b.off_center;
  });
  std::vector<SuctionPlace> apart;
  for (const SuctionPlace& place : found) {
    const bool near = std::any_of(apart.begin(), apart.end(), [&](const SuctionPlace& other) {
      return (other.point_O - place.point_O).norm() < 0.5 * radius &&
             other.approach_O.dot(place.approach_O) > 0.9;
    });
    if (!near) apart.push_back(place);
  }
  return apart;
}

std::vector<std::vector<GraspRule>> suction_rules(const CompiledScene& scene,
                                                  const std::vector<Primitive>& primitives) {
  if (primitives.empty()) return {};
  const bool turns = scene.scene.hand.hand->cups.size() > 1 || scene.arm;
  std::vector<std::vector<SuctionPlace>> places(primitives.size());
  const std::vector<SuctionPlace> all = suction_places(scene);
  for (const SuctionPlace& place : all) {
    places[nearest_primitive(primitives, place.point_O)].push_back(place);
  }
  std::vector<std::vector<GraspRule>> of_primitives;
  for (std::size_t p = 0; p < primitives.size(); ++p) {
    SuctionRules rules(turns);
    add_faces(primitives[p], rules);
    // Several lists, so that the coarsest level of detail has several places.
    const std::size_t count = places[p].size();
    const std::size_t lists =
        count == 0 ? 0 : (kWaysOfPlaces * count + all.size() - 1) / all.size();
    for (std::size_t list = 0; list < lists; ++list) {
      std::vector<SuctionPlace> part;
      for (std::size_t i = list; i < count; i += lists) part.push_back(places[p][i]);
      add_places(std::move(part), rules);
    }
    of_primitives.push_back(rules.take());
  }
  return of_primitives;
}

}  // namespace prehend
