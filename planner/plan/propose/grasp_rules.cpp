#include "planner/plan/propose/grasp_rules.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

namespace prehend {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

// A point at this part of a line of this length about the origin, along a unit direction.
Vector3 along(const Vector3& direction, double length, double part) {
  return (part - 0.5) * length * direction;
}

// Collects rules, which are stated in the primitive's frame P, and expresses their grasps in the
// object's frame O.
class Rules {
 public:
  explicit Rules(const Pose& X_OP) : X_OP_(X_OP) {}

  // `aim_P` gives target, approach and closing direction in P.
  template <typename AimInP>
  void add(const char* name, double width, std::vector<Freedom> freedoms, const AimInP& aim_P) {
    rules_.push_back({name, width, std::move(freedoms),
                      [X_OP = X_OP_, aim_P](const std::vector<double>& choices) {
                        const AimedGrasp aimed = aim_P(choices);
                        return AimedGrasp{X_OP * aimed.target_O, X_OP.linear() * aimed.approach_O,
                                          X_OP.linear() * aimed.closing_O};
                      }});
  }

  // A rule whose closing direction has two signs: a hand has its thumb on one side, so turning it
  // by half a turn about the approach is another grasp.
  template <typename AimInP>
  void add_both_sides(const char* name, double width, const std::vector<Freedom>& freedoms,
                      const AimInP& aim_P) {
    for (const double side : {1.0, -1.0}) {
      add(name, width, freedoms, [aim_P, side](const std::vector<double>& choices) {
        AimedGrasp aimed = aim_P(choices);
        aimed.closing_O *= side;
        return aimed;
      });
    }
  }

  std::vector<GraspRule> take() { return std::move(rules_); }

 private:
  const Pose X_OP_;
  std::vector<GraspRule> rules_;
};

void add_rules(const Box& box, Rules& rules) {
  for (int closing = 0; closing < 3; ++closing) {
    for (int approach = 0; approach < 3; ++approach) {
      if (approach == closing) continue;
      const int third = 3 - closing - approach;  // of the axes 0, 1, 2
      const double length = box.size[third];
      for (const double from : {1.0, -1.0}) {
        rules.add_both_sides("box faces", box.size[closing], {Freedom::place},
                             [=](const std::vector<double>& choices) {
                               return AimedGrasp{along(Vector3::Unit(third), length, choices[0]),
                                                 from * Vector3::Unit(approach),
                                                 Vector3::Unit(closing)};
                             });
      }
    }
  }
}

// The axis of the cylinder is z.
void add_rules(const Cylinder& cylinder, Rules& rules) {
  const Vector3 z = Vector3::UnitZ();
  const double height = cylinder.height;
  const auto sideways = [](double turn) {
    return Vector3(std::cos(kTurn * turn), std::sin(kTurn * turn), 0.0);
  };
  rules.add_both_sides(
      "cylinder side, thumb across", 2.0 * cylinder.radius, {Freedom::turn, Freedom::place},
      [=](const std::vector<double>& choices) {
        const Vector3 approach = sideways(choices[0]);
        return AimedGrasp{along(z, height, choices[1]), approach, z.cross(approach)};
      });
  rules.add_both_sides("cylinder side, thumb along", height, {Freedom::turn},
                       [=](const std::vector<double>& choices) {
                         return AimedGrasp{Vector3::Zero(), sideways(choices[0]), z};
                       });
  for (const double end : {1.0, -1.0}) {
    rules.add("cylinder end", 2.0 * cylinder.radius, {Freedom::turn},
              [=](const std::vector<double>& choices) {
                return AimedGrasp{end * 0.5 * height * z, -end * z, sideways(choices[0])};
              });
  }
}

// Steps in height above the equator give rings of equal area (Archimedes).
void add_rules(const Sphere& sphere, Rules& rules) {
  rules.add("sphere", 2.0 * sphere.radius, {Freedom::span, Freedom::turn, Freedom::turn},
            [](const std::vector<double>& choices) {
              const double height = 1.0 - 2.0 * choices[0];
              const double ring = std::sqrt(std::max(0.0, 1.0 - height * height));
              const double angle = kTurn * choices[1];
              const Vector3 approach(-ring * std::cos(angle), -ring * std::sin(angle), -height);
              const Vector3 x = any_orthogonal(approach);
              const Vector3 y = approach.cross(x);
              const double turn = kTurn * choices[2];
              return AimedGrasp{Vector3::Zero(), approach, std::cos(turn) * x + std::sin(turn) * y};
            });
}

// The axis of the cone is z.
void add_rules(const Cone& cone, Rules& rules) {
  const Vector3 z = Vector3::UnitZ();
  const double height = cone.height;
  const double middle = 0.5 * (cone.radius_low + cone.radius_high);
  const auto sideways = [](double turn) {
    return Vector3(std::cos(kTurn * turn), std::sin(kTurn * turn), 0.0);
  };
  for (const double end : {1.0, -1.0}) {
    const double radius = end > 0.0 ? cone.radius_high : cone.radius_low;
    rules.add_both_sides(
        "cone side, thumb across", 2.0 * std::max(radius, middle), {Freedom::turn, Freedom::place},
        [=](const std::vector<double>& choices) {
          const Vector3 approach = sideways(choices[0]);
          return AimedGrasp{0.5 * end * height * choices[1] * z, approach, z.cross(approach)};
        });
    rules.add("cone end", 2.0 * radius, {Freedom::turn}, [=](const std::vector<double>& choices) {
      return AimedGrasp{end * 0.5 * height * z, -end * z, sideways(choices[0])};
    });
  }
  rules.add_both_sides("cone side, thumb along", height, {Freedom::turn},
                       [=](const std::vector<double>& choices) {
                         return AimedGrasp{Vector3::Zero(), sideways(choices[0]), z};
                       });
}

// Between two points of a curve: the one before, the one behind, and the part of the way.
struct Between {
  std::size_t before = 0;
  std::size_t behind = 0;
  double part = 0.0;
};

// At this part of a curve of `count` points, in equal steps from point to point.
Between between(double choice, std::size_t count, bool closed) {
  const std::size_t steps = closed ? count : count - 1;
  const double at = std::clamp(choice, 0.0, 1.0) * static_cast<double>(steps);
  const std::size_t before = std::min(static_cast<std::size_t>(at), steps - 1);
  return {before, (before + 1) % count, at - static_cast<double>(before)};
}

Freedom along_curve(bool closed) { return closed ? Freedom::turn : Freedom::place; }

// `a` at part 0, `b` at part 1.
Vector3 mixed(const Vector3& a, const Vector3& b, double part) { return a + part * (b - a); }

// The unit vector between two others; the first where they are opposite, as in a fold of a curve.
Vector3 unit_between(const Vector3& a, const Vector3& b, double part) {
  constexpr double kOpposite = 1e-6;
  const Vector3 v = mixed(a, b, part);
  return v.norm() > kOpposite ? Vector3(v.normalized()) : a;
}

// The part of `v` across the unit vector `axis`, of length 1; any direction across where `v` is
// along the axis but for rounding. What is left then is not across it either: at a part 1e-6 of `v`
// the error of the right angle is 1e-10.
Vector3 unit_across(const Vector3& v, const Vector3& axis) {
  constexpr double kAlong = 1e-6;
  const Vector3 flat = v - axis * axis.dot(v);
  return flat.norm() > kAlong * v.norm() ? Vector3(flat.normalized()) : any_orthogonal(axis);
}

// The target is inside the wall, so that the fingertips reach beyond its edge: how far, is left
// open, because a wall that is bent can only be held near its edge.
void add_rules(const Rim& rim, Rules& rules) {
  constexpr double kDeepest = 0.8;  // of the depth of the wall
  if (rim.points.size() < 2) return;
  rules.add_both_sides("rim", rim.width, {along_curve(rim.closed), Freedom::place},
                       [rim](const std::vector<double>& choices) {
                         const Between at = between(choices[0], rim.points.size(), rim.closed);
                         const RimPoint& a = rim.points[at.before];
                         const RimPoint& b = rim.points[at.behind];
                         const Vector3 into = unit_between(a.into, b.into, at.part);
                         const Vector3 across = mixed(a.across, b.across, at.part);
                         const Vector3 target =
                             mixed(a.p, b.p, at.part) + kDeepest * choices[1] * rim.depth * into;
                         return AimedGrasp{target, into, unit_across(across, into)};
                       });
}

// A point of a curve with its tangent and a direction across it, both of length 1.
struct CurveFrame {
  Vector3 p = Vector3::Zero();
  Vector3 tangent = Vector3::UnitZ();
  Vector3 across = Vector3::UnitX();
};

// The points of a curve without those that repeat the one before, as where many points were made
// from few spots of a surface: what rounding leaves between them is no tangent.
std::vector<Vector3> points_apart(const Bar& bar) {
  constexpr double kLeastStep = 1e-3;  // of how far the curve reaches from its first point
  double reach = 0.0;
  for (const Vector3& p : bar.points) reach = std::max(reach, (p - bar.points.front()).norm());
  std::vector<Vector3> apart = {bar.points.front()};
  for (const Vector3& p : bar.points) {
    if ((p - apart.back()).norm() > kLeastStep * reach) apart.push_back(p);
  }
  if (bar.closed && (apart.back() - apart.front()).norm() <= kLeastStep * reach) apart.pop_back();
  return apart;
}

// The directions across turn with the curve and not about it, from the one towards the middle of
// the curve on.
std::vector<CurveFrame> curve_frames(const std::vector<Vector3>& points, bool closed) {
  const std::size_t count = points.size();
  Vector3 middle = Vector3::Zero();
  for (const Vector3& p : points) middle += p / static_cast<double>(count);
  Vector3 across = middle - points.front();
  std::vector<CurveFrame> frames;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = i > 0 ? i - 1 : (closed ? count - 1 : 0);
    const std::size_t behind = i + 1 < count ? i + 1 : (closed ? 0 : i);
    Vector3 along = points[behind] - points[before];
    // Where the curve comes back to the point before.
    if (along.isZero(0.0)) along = points[behind] - points[i];
    const Vector3 tangent = along.normalized();
    across = unit_across(across, tangent);
    frames.push_back({points[i], tangent, across});
  }
  return frames;
}

// The tangent of the curve, not the step from one point to the next: fingers that are wide along a
// bent bar touch it on both sides of its middle only if they are aligned with it.
void add_rules(const Bar& bar, Rules& rules) {
  if (bar.points.empty()) return;
  const std::vector<Vector3> points = points_apart(bar);
  if (points.size() < 2) return;
  rules.add_both_sides(
      "bar", bar.width, {Freedom::turn, along_curve(bar.closed)},
      [frames = curve_frames(points, bar.closed),
       closed = bar.closed](const std::vector<double>& choices) {
        const Between at = between(choices[1], frames.size(), closed);
        const CurveFrame& a = frames[at.before];
        const CurveFrame& b = frames[at.behind];
        const Vector3 tangent = unit_between(a.tangent, b.tangent, at.part);
        const Vector3 x = unit_across(mixed(a.across, b.across, at.part), tangent);
        const double turn = kTurn * choices[0];
        const Vector3 approach = std::cos(turn) * x + std::sin(turn) * tangent.cross(x);
        return AimedGrasp{mixed(a.p, b.p, at.part), approach, tangent.cross(approach)};
      });
}

}  // namespace

int choice_count(Freedom freedom, int level) {
  switch (freedom) {
    case Freedom::place:
      return (2 << level) - 1;
    case Freedom::span:
      return (2 << level) + 1;
    case Freedom::turn:
      return 4 << level;
  }
  return 0;
}

double choice_at(Freedom freedom, int level, int i) {
  const double steps = freedom == Freedom::turn ? 4 << level : 2 << level;
  return (freedom == Freedom::place ? i + 1 : i) / steps;
}

bool is_new_choice(Freedom freedom, int level, int i) {
  if (level == 0) return true;
  return (freedom == Freedom::place ? i + 1 : i) % 2 != 0;
}

std::vector<GraspRule> grasp_rules(const Primitive& primitive) {
  Rules rules(primitive.X_OP);
  std::visit([&](const auto& shape) { add_rules(shape, rules); }, primitive.shape);
  return rules.take();
}

}  // namespace prehend
