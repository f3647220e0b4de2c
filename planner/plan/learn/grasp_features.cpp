#include "planner/plan/learn/grasp_features.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "planner/plan/learn/primitive_extent.h"
#include "sim/base/index.h"
#include "sim/shape/proximity.h"
#include "sim/shape/separation.h"

namespace prehend {
namespace {

// Two lines beside the target, one before and one behind it are this far from it, in openings.
constexpr double kBeside = 0.15;

// A primitive explains the surface that is within this part of the object's radius.
constexpr double kExplained = 0.1;

// So many triangles of the object, evenly spread over their list, stand for its surface.
constexpr std::size_t kSurfaceSamples = 2000;

// The directions of a candidate in the object's frame, and its target.
struct GraspLine {
  Vector3 target = Vector3::Zero();
  Vector3 approach = Vector3::UnitZ();
  Vector3 closing = Vector3::UnitX();
  Vector3 lateral = Vector3::UnitY();
};

GraspLine line_of(const Hand& hand, const ProposedGrasp& grasp) {
  const Pose& X_OH = grasp.candidate.X_OH;
  GraspLine line;
  line.approach = X_OH.linear() * hand.approach;
  line.closing = X_OH.linear() * hand.closing;
  line.lateral = line.approach.cross(line.closing);
  line.target = X_OH * hand.origin + grasp.stand_off * line.approach;
  return line;
}

// How far the object reaches from `point` along a unit direction [m], up to its convex sets.
double reach_from(const ProximityMesh& object, const Vector3& point, const Vector3& direction) {
  double most = -std::numeric_limits<double>::infinity();
  for (const ConvexPoints& part : object.parts()) {
    most = std::max(most, direction.dot(part.farthest(direction)) + part.margin());
  }
  return most - direction.dot(point);
}

// The cosine between a direction and the inward normal of a triangle; 0 without a triangle.
double facing(const TriangleMesh& mesh, int triangle, const Vector3& direction) {
  if (triangle < 0) return 0.0;
  const Vector3 outward = doubled_area_vector(mesh, index(triangle));
  const double size = outward.norm();
  return size > 0.0 ? -outward.dot(direction) / size : 0.0;
}

// What two fingers meet that come from both ends of a line.
struct Pinch {
  double thickness = 0.0;   // m
  double off_middle = 0.0;  // m
  double facing_least = 0.0;
  double facing_most = 0.0;
};

Pinch pinch(const ProximityMesh& object, const Vector3& middle, const Vector3& closing,
            double opening) {
  const double half = 0.5 * opening;
  const RayHit there = first_hit(object, middle - half * closing, closing, opening);
  const RayHit back = first_hit(object, middle + half * closing, -closing, opening);
  Pinch found;
  const double a = facing(object.mesh(), there.triangle, closing);
  const double b = facing(object.mesh(), back.triangle, -closing);
  found.facing_least = std::min(a, b);
  found.facing_most = std::max(a, b);
  if (there.triangle < 0 || back.triangle < 0) return found;
  found.thickness = opening - there.distance - back.distance;
  found.off_middle = 0.5 * std::abs(there.distance - back.distance);
  return found;
}

double share_of_surface(const TriangleMesh& mesh, const Primitive& primitive, double tolerance) {
  const std::size_t step = std::max<std::size_t>(1, mesh.triangles.size() / kSurfaceSamples);
  double all = 0.0;
  double near = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += step) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Vector3 middle =
        (mesh.vertices[index(a)] + mesh.vertices[index(b)] + mesh.vertices[index(c)]) / 3.0;
    const double area = doubled_area_vector(mesh, t).norm();
    all += area;
    if (std::abs(signed_distance(primitive, middle)) <= tolerance) near += area;
  }
  return all > 0.0 ? near / all : 0.0;
}

double deviation(const Matrix3& second_moments, const Vector3& direction) {
  return std::sqrt(std::max(0.0, direction.dot(second_moments * direction)));
}

// Writes features one after the other.
class FeatureList {
 public:
  explicit FeatureList(GraspFeatures& features) : features_(features) {}
  void add(double value) {
    constexpr double kMost = 1e6;  // a hand without an opening gives no finite lengths
    features_.at(next_++) =
        static_cast<float>(std::isfinite(value) ? std::clamp(value, -kMost, kMost) : 0.0);
  }

 private:
  GraspFeatures& features_;
  std::size_t next_ = 0;
};

void add_primitive(FeatureList& list, const Primitive& primitive, const GraspLine& line,
                   double width, double opening) {
  for (std::size_t kind = 0; kind < std::variant_size_v<Shape>; ++kind) {
    list.add(primitive.shape.index() == kind ? 1.0 : 0.0);
  }
  const bool has_axis = std::holds_alternative<Cylinder>(primitive.shape) ||
                        std::holds_alternative<Cone>(primitive.shape);
  const Vector3 axis = primitive.X_OP.linear().col(2);
  list.add(has_axis ? std::abs(axis.dot(line.approach)) : 0.0);
  list.add(has_axis ? std::abs(axis.dot(line.closing)) : 0.0);
  list.add(width / opening);
  list.add(primitive_extent(primitive, line.approach) / opening);
  list.add(primitive_extent(primitive, line.lateral) / opening);
}

void add_target(FeatureList& list, const Vector3& from_center, const GraspLine& line,
                double radius) {
  const double approach = from_center.dot(line.approach);
  const double lateral = from_center.dot(line.lateral);
  list.add(approach / radius);
  list.add(std::abs(from_center.dot(line.closing)) / radius);
  list.add(std::abs(lateral) / radius);
  list.add(std::hypot(approach, lateral) / radius);
}

void add_object(FeatureList& list, const ProximityMesh& object, const GraspLine& line,
                double opening) {
  const auto reach = [&](const Vector3& direction) {
    return reach_from(object, line.target, direction) / opening;
  };
  list.add(reach(-line.approach));
  list.add(reach(line.approach));
  for (const Vector3& direction : {line.closing, line.lateral}) {
    const double along = reach(direction);
    const double against = reach(-direction);
    list.add(std::max(along, against));
    list.add(std::min(along, against));
  }
}

void add_rays(FeatureList& list, const ProximityMesh& object, const GraspLine& line,
              double opening) {
  const auto pinch_at = [&](const Vector3& offset) {
    return pinch(object, line.target + kBeside * opening * offset, line.closing, opening);
  };
  const Pinch middle = pinch_at(Vector3::Zero());
  const Pinch left = pinch_at(-line.lateral);
  const Pinch right = pinch_at(line.lateral);
  list.add(middle.thickness / opening);
  list.add(middle.off_middle / opening);
  list.add(middle.facing_least);
  list.add(middle.facing_most);
  list.add(std::min(left.thickness, right.thickness) / opening);
  list.add(std::max(left.thickness, right.thickness) / opening);
  list.add(std::min(left.facing_least, right.facing_least));
  list.add(pinch_at(-line.approach).facing_least);
  list.add(pinch_at(line.approach).facing_least);
  const double before = 1.01 * std::max(0.0, reach_from(object, line.target, -line.approach));
  const RayHit palm =
      first_hit(object, line.target - before * line.approach, line.approach, before);
  list.add(palm.triangle < 0 ? 0.0 : (before - palm.distance) / opening);
}

}  // namespace

std::vector<std::string> grasp_feature_names() {
  return {kGraspFeatures.begin(), kGraspFeatures.end()};
}

FeatureMaker::FeatureMaker(const CompiledScene& scene, std::vector<Primitive> primitives)
    : scene_(&scene), primitives_(std::move(primitives)) {
  const GraspableBody& object = scene.scene.object;
  radius_ = 1.0 / scene.wrench_frame.torque_scale;
  for (const Primitive& primitive : primitives_) {
    surface_share_.push_back(
        share_of_surface(scene.object().mesh.mesh(), primitive, kExplained * radius_));
  }
  // The inertia is the trace of the second moments, times the identity, minus the second moments.
  const Matrix3 inertia =
      object.mass > 0.0 ? Matrix3(object.inertia / object.mass) : Matrix3::Zero();
  second_moments_ = 0.5 * inertia.trace() * Matrix3::Identity() - inertia;
  const Robot& robot = scene.scene.hand;
  const Vector3 lateral = robot.hand->approach.cross(robot.hand->closing);
  for (const Preshape& preshape : robot.hand->preshapes) {
    largest_opening_ = std::max(largest_opening_, preshape.max_width);
    std::vector<Pose> X_HL;
    link_poses(robot, joint_values(robot, preshape.dofs), X_HL);
    OpenHand open;
    double square = 0.0;
    for (std::size_t l = 0; l < scene.links.size(); ++l) {
      const Vector3 middle = X_HL[l] * scene.links[l].mesh.ball_center() - robot.hand->origin;
      square += std::pow(lateral.dot(middle), 2) / static_cast<double>(scene.links.size());
      open.reach = std::max(open.reach, robot.hand->approach.dot(middle));
    }
    open.spread = std::sqrt(square);
    open_hands_.push_back(open);
  }
}

GraspFeatures FeatureMaker::features(const ProposedGrasp& grasp) const {
  const Hand& hand = *scene_->scene.hand.hand;
  const std::size_t number = index(grasp.candidate.preshape.value());
  const Preshape& preshape = hand.preshapes[number];
  const OpenHand& open = open_hands_[number];
  const Primitive& primitive = primitives_[index(grasp.primitive)];
  const GraspLine line = line_of(hand, grasp);
  const double opening = preshape.max_width;
  GraspFeatures features{};
  FeatureList list(features);
  add_primitive(list, primitive, line, grasp.width, opening);
  list.add(surface_share_[index(grasp.primitive)]);
  list.add(opening / largest_opening_);
  list.add(preshape.min_width / opening);
  list.add(preshape.depth / opening);
  list.add(grasp.stand_off / opening);
  list.add(open.spread / opening);
  list.add(open.reach / opening);
  add_target(list, line.target - scene_->wrench_frame.torque_origin, line, radius_);
  list.add((line.target - primitive.X_OP.translation()).norm() / opening);
  list.add(deviation(second_moments_, line.approach) / opening);
  list.add(deviation(second_moments_, line.closing) / opening);
  list.add(deviation(second_moments_, line.lateral) / opening);
  const ProximityMesh& object = scene_->object().mesh;
  add_object(list, object, line, opening);
  list.add(radius_ / largest_opening_);
  add_rays(list, object, line, opening);
  return features;
}

}  // namespace prehend
