#include "planner/show/report/report_json.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "planner/plan/grasp_text.h"
#include "planner/results/json_shake.h"
#include "planner/show/report/packed_mesh.h"
#include "planner/show/report/palette_json.h"
#include "planner/show/report/robot_json.h"
#include "planner/show/report/slice_json.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/success.h"

namespace prehend {
namespace {

using Json = nlohmann::ordered_json;

// Frames limit the size of a report: at most kMostFrames for each motion and about kAllFrames for
// all motions together, but at least kLeastFrames for each, however many there are. The page
// interpolates between frames.
constexpr std::size_t kMostFrames = 160;
constexpr std::size_t kAllFrames = 32000;
constexpr std::size_t kLeastFrames = 24;

Json body_json(const std::string& name, const TriangleMesh& mesh, const Pose& X_WB) {
  return {{"name", name}, {"X", rounded(X_WB)}, {"mesh", drawn_mesh(mesh, kMostDrawnTriangles)}};
}

Json points_json(const std::vector<Vector3>& points) {
  Json json = Json::array();
  for (const Vector3& p : points) json.push_back(rounded(p));
  return json;
}

Json sizes_json(const Box& box) { return {{"size", rounded(box.size)}}; }
Json sizes_json(const Sphere& sphere) { return {{"radius", rounded(sphere.radius)}}; }
Json sizes_json(const Cylinder& cylinder) {
  return {{"radius", rounded(cylinder.radius)}, {"height", rounded(cylinder.height)}};
}
Json sizes_json(const Cone& cone) {
  return {{"radius_low", rounded(cone.radius_low)},
          {"radius_high", rounded(cone.radius_high)},
          {"height", rounded(cone.height)}};
}
Json sizes_json(const Rim& rim) {
  return {{"points", points_json(points_of(rim))},
          {"width", rounded(rim.width)},
          {"closed", rim.closed}};
}
Json sizes_json(const Bar& bar) {
  return {
      {"points", points_json(bar.points)}, {"width", rounded(bar.width)}, {"closed", bar.closed}};
}

Json shape_json(const Primitive& primitive) {
  Json json = std::visit([](const auto& shape) { return sizes_json(shape); }, primitive.shape);
  json["shape"] = shape_name(primitive.shape);
  json["X"] = rounded(primitive.X_OP);
  return json;
}

Json distances_json(const SurfaceDistances& distances) {
  return {{"median", significant(distances.median)},
          {"percentile_95", significant(distances.percentile_95)}};
}

// `distances`: of the surface that is nearest to it; null where nobody has measured them.
Json primitives_json(const Report& report) {
  Json list = Json::array();
  for (std::size_t k = 0; k < report.primitives.size(); ++k) {
    Json json = shape_json(report.primitives[k]);
    const bool measured = report.solids && k < report.solids->distances_of.size();
    json["distances"] = measured ? distances_json(report.solids->distances_of[k]) : Json();
    list.push_back(std::move(json));
  }
  return list;
}

Json scene_json(const CompiledScene& scene) {
  const GraspableBody& object = scene.scene.object;
  Json json;
  json["object"] = body_json(object.name, object.mesh, object.X_WO);
  json["object"]["mass"] = rounded(object.mass);
  json["object"]["material"] = name_of(object.material);
  json["hand"] = robot_json(scene.scene.hand);
  json["hand"]["approach"] = rounded(scene.scene.hand.hand->approach);
  json["hand"]["closing"] = rounded(scene.scene.hand.hand->closing);
  json["obstacles"] = Json::array();
  for (const StaticBody& body : scene.scene.obstacles) {
    json["obstacles"].push_back(body_json(body.name, body.mesh, body.X_WB));
  }
  json["arm"] = scene.arm ? arm_json(*scene.arm) : Json();
  return json;
}

Json detail_json(const GraspDetail& detail) {
  Json links = Json::array();
  for (const LinkShare& share : detail.links) {
    links.push_back({{"link", share.link}, {"without", significant(share.epsilon_without)}});
  }
  Json without = Json::array();
  for (const double epsilon : detail.epsilon_without) without.push_back(significant(epsilon));
  return {{"robust",
           {{"mean", significant(detail.robust.mean)},
            {"percentile_5", significant(detail.robust.percentile_5)},
            {"force_closure", significant(detail.robust.force_closure)}}},
          {"without", without},
          {"links", links},
          {"forces", slice_json(detail.sections.forces)},
          {"torques", slice_json(detail.sections.torques)}};
}

Json contact_json(const ReportContact& contact) {
  const Contact& point = contact.point;
  Json json{{"p", rounded(point.position)},
            {"n", rounded(point.normal)},
            {"mu", significant(point.friction)},
            {"model", name_of(point.model)}};
  const bool twists =
      point.model == ContactModel::soft_finger || point.model == ContactModel::suction;
  if (twists) json["torsion"] = rounded(point.torsion);
  if (!contact.link.empty()) json["link"] = contact.link;
  // Gaps are at most a tenth of a millimetre, so they need more decimals.
  if (contact.gap) json["gap"] = rounded(*contact.gap, 1e8);
  return json;
}

Json forces_json(const std::vector<MotionForce>& forces) {
  Json json = Json::array();
  for (const MotionForce& force : forces) {
    for (const double x : force.p_O) json.push_back(rounded(x));
    for (const double x : force.force_O) json.push_back(rounded(x, 1e3));
  }
  return json;
}

void add_free_poses(const GraspMotion& motion, Json& json) {
  for (const char* name : {"objects", "hands", "forces"}) json[name] = Json::array();
  for (const MotionFrame& frame : motion.frames) {
    json["objects"].push_back(rounded(frame.X_OC));
    json["hands"].push_back(rounded(frame.X_OH));
    json["forces"].push_back(forces_json(frame.forces));
  }
}

// On an arm a row has the joints of the whole platform, from which the page computes the hand's
// pose. Without an arm it has the hand's position and joints; the hand's rotation is the same in
// all frames and given once, by X_OH.
//
// Where the object moves freely, "objects" and "hands" have the pose of each in O at each row, and
// "forces" those on the object: position and force, six numbers each.
Json motion_json(const GraspMotion& whole, std::size_t most_frames) {
  const GraspMotion motion = thinned(whole, static_cast<int>(most_frames));
  Json rows = Json::array();
  Json times = Json::array();
  const bool on_arm = !motion.frames.front().arm_joints.empty();
  for (const MotionFrame& frame : motion.frames) {
    Json row = on_arm ? Json::array() : rounded(Vector3(frame.X_OH.translation()));
    for (const double joint : on_arm ? frame.arm_joints : frame.joints) {
      // To 1e-5 rad or m, times to 1e-4 s.
      row.push_back(rounded(joint, 1e5));
    }
    rows.push_back(std::move(row));
    times.push_back(rounded(frame.time, 1e4));
  }
  Json segments = Json::array();
  for (const TrajectorySegment& s : motion.segments) {
    segments.push_back({{"name", s.name}, {"first", s.first}, {"last", s.last}});
  }
  Json json{{"on_arm", on_arm},
            {"X_OH", rounded(motion.frames[motion.grasp()].X_OH)},
            {"grasp", motion.grasp()},
            {"times", times},
            {"rows", rows},
            {"segments", segments}};
  if (motion.is_simulated) add_free_poses(motion, json);
  return json;
}

Json interval_json(const Interval& interval) {
  return {significant(interval.lower), significant(interval.upper)};
}

Json burden_json(const LoadCase& load_case) {
  const double squeeze = load_case.sum_of_normals;
  return {{"squeeze", std::isfinite(squeeze) ? Json(significant(squeeze)) : Json()},
          {"strength", load_factor_text(load_case)}};
}

Json grasp_json(const ReportGrasp& grasp, std::size_t most_frames) {
  Json json{{"outcome", grasp.outcome},
            {"force_closure", grasp.force_closure},
            {"epsilon", {significant(grasp.epsilon.lower), significant(grasp.epsilon.upper)}},
            {"free_epsilon", grasp.free_epsilon ? Json(significant(*grasp.free_epsilon)) : Json()},
            {"volume", grasp.volume ? interval_json(*grasp.volume) : Json()},
            {"origin", grasp.origin},
            {"preshape", grasp.preshape},
            {"blame", grasp.collision_of},
            {"moved", grasp.moved},
            {"primitive", grasp.primitive},
            {"weakest_force", rounded(Vector3(grasp.epsilon.weakest.head<3>()))},
            {"weakest_torque", rounded(Vector3(grasp.epsilon.weakest.tail<3>()))}};
  if (grasp.holding) {
    json["weight"] = {{"holds", grasp.holding->holds()},
                      {"given", burden_json(grasp.holding->given)},
                      {"worst", burden_json(grasp.holding->worst)}};
  }
  if (grasp.robustness) {
    const Robustness& robustness = *grasp.robustness;
    const Interval interval = held_interval(robustness.held, robustness.samples);
    json["robustness"] = {{"samples", robustness.samples},
                          {"held", robustness.held},
                          {"success", success_probability(robustness)},
                          {"interval", interval_json(interval)},
                          {"epsilon_mean", significant(robustness.epsilon_mean)},
                          {"spare", robustness.position_margin},
                          {"weakest", rounded(robustness.weakest_O)},
                          {"weakness", weakness_text(robustness)}};
  }
  json["contacts"] = Json::array();
  for (const ReportContact& contact : grasp.contacts) {
    json["contacts"].push_back(contact_json(contact));
  }
  json["motion"] = grasp.motion ? motion_json(*grasp.motion, most_frames) : Json();
  json["side"] = grasp.side ? rounded(*grasp.side) : Json();
  if (grasp.shake) json["shake"] = shake_to_json(*grasp.shake);
  if (!grasp.events.empty()) json["events"] = grasp.events;
  json["detail"] = grasp.detail ? detail_json(*grasp.detail) : Json();
  return json;
}

// There may be thousands of candidates, so each is a row of eight numbers: the aimed point (3), the
// approach (3), the index of the outcome and that of the text in `blames`, of which many candidates
// share one.
Json candidates_json(const Report& report) {
  Json rows = Json::array();
  std::vector<std::string> blames;
  for (const ReportCandidate& candidate : report.candidates) {
    const auto known = std::find(blames.begin(), blames.end(), candidate.collision_of);
    const auto collision_of = known - blames.begin();
    if (known == blames.end()) blames.push_back(candidate.collision_of);
    Json row = rounded(candidate.p_O, 1e5);
    for (const double x : candidate.approach_O) row.push_back(rounded(x, 1e3));
    row.push_back(candidate.outcome);
    row.push_back(collision_of);
    rows.push_back(std::move(row));
  }
  return {{"rows", rows}, {"blames", blames}, {"in_all", report.candidates_in_all}};
}

}  // namespace

std::string report_json(const Report& report) {
  Json json;
  json["title"] = report.title;
  json["facts"] = Json::array();
  for (const auto& [name, value] : report.facts) json["facts"].push_back({name, value});
  json["palette"] = palette_json();
  json["frame"] = {{"origin", rounded(report.frame.torque_origin)},
                   {"radius", significant(1.0 / report.frame.torque_scale)}};
  json["unit_force"] = report.unit_force;
  json["scene"] = report.scene != nullptr ? scene_json(*report.scene) : Json();
  json["primitives"] = primitives_json(report);
  json["distances"] = report.solids ? distances_json(report.solids->distances) : Json();
  json["grasps"] = Json::array();
  const std::size_t most_frames = std::clamp(
      kAllFrames / std::max<std::size_t>(1, report.grasps.size()), kLeastFrames, kMostFrames);
  for (const ReportGrasp& grasp : report.grasps) {
    json["grasps"].push_back(grasp_json(grasp, most_frames));
  }
  json["grasps_in_all"] = report.grasps_in_all;
  json["outcomes"] = Json::array();
  for (const ReportOutcome& outcome : report.outcomes) {
    json["outcomes"].push_back(
        {{"name", outcome.name}, {"meaning", outcome.meaning}, {"count", outcome.count}});
  }
  json["blockers"] = Json::array();
  for (const ReportBlocker& blocker : report.blockers) {
    json["blockers"].push_back({{"outcome", blocker.outcome},
                                {"link", blocker.link},
                                {"by", blocker.by},
                                {"count", blocker.count}});
  }
  json["rules"] = Json::array();
  for (const ReportRule& rule : report.rules) {
    Json counts = Json::array();
    for (const auto& [name, count] : rule.outcomes) counts.push_back({name, count});
    json["rules"].push_back({{"rule", rule.rule}, {"outcomes", counts}});
  }
  json["problem"] = report.problem;
  json["advice"] = report.advice;
  json["candidates"] = candidates_json(report);
  // File names may have bytes that are not UTF-8, for which dump() would throw otherwise.
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace prehend
