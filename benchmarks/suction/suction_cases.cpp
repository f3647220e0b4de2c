#include "benchmarks/suction/suction_cases.h"

#include <algorithm>
#include <filesystem>

#include "planner/plan/plan.h"
#include "sim/base/index.h"
#include "sim/scene/scene_file.h"
#include "sim/shape/convex_pieces.h"
#include "sim/trial/payload_margin.h"

namespace prehend::bench {
namespace {

// Of the lips.
Vector3 middle_of(const Trial& grasp) {
  Vector3 sum = Vector3::Zero();
  for (const GraspContact& contact : grasp.contacts) sum += contact.point.position;
  return sum / static_cast<double>(grasp.contacts.size());
}

Vector3 approach_of(const CompiledScene& scene, const Trial& grasp) {
  return grasp.X_OH.linear() * scene.scene.hand.hand->approach;
}

// From the approach through the middle of the lips to the centre of mass.
Vector3 off_center(const CompiledScene& scene, const Trial& grasp) {
  const Vector3 approach_O = approach_of(scene, grasp);
  const Vector3 way = scene.scene.object.center_of_mass - middle_of(grasp);
  return way - approach_O.dot(way) * approach_O;
}

Vector3 down_in(const CompiledScene& scene, const Trial& grasp, HungAttitude attitude) {
  constexpr double kCentered = 1e-4;  // m
  const Vector3 approach_O = approach_of(scene, grasp);
  switch (attitude) {
    case HungAttitude::as_it_lies:
      return -Vector3::UnitZ();
    case HungAttitude::worst:
      return payload_margin(scene, grasp).worst.down_O;
    case HungAttitude::off_cups:
      return approach_O;
    case HungAttitude::sideways:
      break;
  }
  const Vector3 across = off_center(scene, grasp);
  return across.norm() > kCentered ? across.normalized() : any_orthogonal(approach_O);
}

// LoadCase::strength with gravity along `down_O`.
double strength_in(const CompiledScene& scene, const Trial& grasp, const Vector3& down_O,
                   double mass) {
  BodyPlaces places = places_of(scene.scene);
  const Vector3 down_W = -Vector3::UnitZ();
  places.X_WO = Pose(Eigen::Quaterniond::FromTwoVectors(down_O, down_W));
  CompiledScene turned = with_bodies_at(scene, places);
  turned.scene.object.mass = mass;
  return weight_strength(turned, grasp);
}

// Without the bound of cup_contact on what bends the lip: the one by the relaxed side is below the
// radius.
Trial without_elastic_bound(Trial grasp) {
  for (GraspContact& contact : grasp.contacts) contact.point.moment = contact.point.torsion;
  return grasp;
}

HangingObject hanging_of(const SuctionCase& of, const Trial& grasp, const Vector3& down_O,
                         double mass) {
  const GraspableBody& body = of.scene.scene.object;
  HangingObject hanging;
  hanging.inertial = {mass, body.center_of_mass, body.inertia * (mass / body.mass)};
  hanging.pieces = of.pieces;
  hanging.down_O = down_O;
  for (const SuctionCup& cup : of.scene.scene.hand.hand->cups) {
    const auto sealed = std::find_if(
        grasp.contacts.begin(), grasp.contacts.end(),
        [&](const GraspContact& contact) { return index(contact.link) == index(cup.link); });
    if (sealed == grasp.contacts.end()) continue;
    hanging.cups.push_back({.center_O = grasp.X_OH * cup.position,
                            .axis_O = grasp.X_OH.linear() * cup.axis,
                            .radius = cup.radius,
                            .travel = cup.travel,
                            .stiffness = cup.lip_stiffness,
                            .friction = sealed->point.friction,
                            .pull = cup.pull});
  }
  return hanging;
}

}  // namespace

SuctionCase suction_case(const std::string& mesh, const std::string& hand, int trials,
                         std::size_t most, std::vector<TriangleMesh>& pieces) {
  SuctionCase made{std::filesystem::path(mesh).stem().string(), hand, {}, {}, {}};
  SceneSource source;
  source.hand = hand;
  made.scene = compile(load_scene(mesh, source));
  PlanOptions options;
  options.search.trials = trials;
  options.search.settled = 1.0;
  options.refine.trials = 0;
  options.rank.top = trials;
  options.free_closing = 0;
  options.volumes = false;
  std::vector<Trial> found;
  std::vector<double> ways;
  for (ScoredGrasp& grasp : plan(made.scene, options).grasps) {
    found.push_back(std::move(grasp.trial));
    ways.push_back(off_center(made.scene, found.back()).norm());
  }
  for (const std::size_t k : spread_over(ways, most)) made.grasps.push_back(found[k]);
  if (found.empty()) return made;
  if (pieces.empty()) pieces = convex_pieces(made.scene.scene.object.mesh).pieces;
  made.pieces = pieces;
  return made;
}

SuctionPick suction_pick(const SuctionCase& of, const Trial& grasp, HungAttitude attitude,
                         double wanted_margin) {
  const Vector3 down_O = down_in(of.scene, grasp, attitude);
  const double unit = strength_in(of.scene, grasp, down_O, 1.0);
  const double mass = unit / wanted_margin;
  SuctionPick pick;
  pick.object = of.object;
  pick.hand = of.hand;
  pick.attitude = attitude;
  pick.margin = strength_in(of.scene, grasp, down_O, mass);
  pick.elastic_margin = strength_in(of.scene, without_elastic_bound(grasp), down_O, mass);
  for (const SuctionCup& cup : of.scene.scene.hand.hand->cups) {
    pick.strain = std::max(pick.strain, cup.strain);
  }
  pick.hanging = hanging_of(of, grasp, down_O, mass);
  return pick;
}

}  // namespace prehend::bench
