#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "planner/live/protocol/command.h"
#include "planner/live/protocol/session_json.h"
#include "planner/show/report/slice_json.h"
#include "sim/base/index.h"
#include "sim/base/joined.h"
#include "sim/base/json/json_pose.h"
#include "sim/base/range.h"

// The commands that ask and change nothing.
namespace prehend {
namespace {

ProtocolJson state_of(const CommandScope& scope, const JsonField& /*request*/) {
  return state_json(scope.session);
}

ProtocolJson contacts_of_hand(const CommandScope& scope, const JsonField& /*request*/) {
  return {{"contacts", contacts_json(scope.session, scope.session.contacts())}};
}

// With the names of its axes.
ProtocolJson chosen_json(const WrenchSlice& slice) {
  ProtocolJson json = slice_json(slice);
  json["axes"] = ProtocolJson::array();
  for (const int axis : slice.coordinates) json["axes"].push_back(kWrenchCoordinates[index(axis)]);
  return json;
}

ProtocolJson quality_of(const CommandScope& scope, const JsonField& request) {
  const bool sections = request.has("sections") && request["sections"].boolean();
  const GraspScore judged = scope.session.quality(sections);
  const WrenchFrame& frame = scope.session.state().world->compiled().wrench_frame;
  const bool limited = !judged.limiting_link.empty();
  ProtocolJson limit;
  if (limited) {
    limit = {{"link", judged.limiting_link}, {"epsilon_without", judged.epsilon_without}};
  }
  ProtocolJson json{{"outcome", name_of(judged.outcome)},
                    {"epsilon",
                     {{"lower", judged.epsilon.lower},
                      {"upper", judged.epsilon.upper},
                      {"status", name_of(judged.epsilon.status)}}},
                    {"volume", judged.volume},
                    {"weakest_wrench", scaled_wrench_json(judged.epsilon.weakest)},
                    {"torque_scale", frame.torque_scale},
                    {"torque_origin", vector_to_json(frame.torque_origin)},
                    {"limit", limit},
                    {"contacts", contacts_json(scope.session, judged.contacts)}};
  if (sections) {
    json["sections"] = {{"forces", slice_json(judged.sections.forces)},
                        {"torques", slice_json(judged.sections.torques)}};
    if (scope.session.state().judge.fixed) json["sections"]["chosen"] = chosen_json(judged.chosen);
  }
  return json;
}

int coordinate_named(const JsonField& field, const std::string& name) {
  const auto found = std::ranges::find(kWrenchCoordinates, name);
  if (found == kWrenchCoordinates.end())
    field.fail("must be three of " + joined(kWrenchCoordinates));
  return static_cast<int>(found - kWrenchCoordinates.begin());
}

FixedCoordinates fixed_coordinates(const JsonField& names, const JsonField& values) {
  FixedCoordinates fixed{.coordinates = {}, .values = values.vector3()};
  std::istringstream list(names.text());
  std::string name;
  int count = 0;
  while (std::getline(list, name, ',')) {
    if (count == 3) names.fail("must be three of " + joined(kWrenchCoordinates));
    fixed.coordinates[index(count++)] = coordinate_named(names, name);
  }
  if (count < 3) names.fail("must be three of " + joined(kWrenchCoordinates));
  return fixed;
}

ProtocolJson judge_set(const CommandScope& scope, const JsonField& request) {
  JudgeOptions judge = scope.session.state().judge;
  if (request.has("norm")) {
    const std::optional<WrenchNorm> norm = value_named<WrenchNorm>(request["norm"].text());
    if (!norm) request["norm"].fail("must be l1 or linf");
    judge.norm = *norm;
  }
  if (request.has("edges")) judge.edges = request["edges"].integer();
  if (request.has("fixed") != request.has("values"))
    request.fail("needs fixed and values, or none");
  if (request.has("fixed")) judge.fixed = fixed_coordinates(request["fixed"], request["values"]);
  if (request.has("section") && !request["section"].boolean()) judge.fixed.reset();
  scope.session.set_judge(judge);
  return state_json(scope.session);
}

ProtocolJson forces_of(const CommandScope& scope, const JsonField& request) {
  const auto vector_or_zero = [&](std::string_view name) {
    return request.has(name) ? request[name].vector3() : Vector3(Vector3::Zero());
  };
  const bool limits = request.has("drive_limits") && request["drive_limits"].boolean();
  const ContactForces found =
      scope.session.forces(vector_or_zero("force_object"), vector_or_zero("torque_object"), limits);
  ProtocolJson json{{"outcome", name_of(found.outcome)},
                    {"largest_normal", found.largest_normal},
                    {"sum_of_normals", found.sum_of_normals},
                    {"residual", found.residual},
                    {"forces", ProtocolJson::array()}};
  if (found.outcome == ForceOutcome::impossible) return json;
  for (Eigen::Index i = 0; i < found.forces.cols(); ++i) {
    json["forces"].push_back({{"force_object", vector_to_json(found.forces.col(i))},
                              {"normal", found.components(0, i)},
                              {"torsion", found.components(3, i)}});
  }
  return json;
}

ProtocolJson collisions_of(const CommandScope& scope, const JsonField& /*request*/) {
  ProtocolJson list = ProtocolJson::array();
  for (const Overlap& overlap : scope.session.collisions()) {
    list.push_back({{"link", overlap.link}, {"by", overlap.by}});
  }
  return {{"collisions", list}};
}

// What there is.
std::vector<Command> looking_commands() {
  return {
      {"state",
       CommandKind::query,
       "All that the session is now.",
       {},
       "`revision`, `scene`, `problem` (why the scene cannot be used for grasps, or null), "
       "`object`, `obstacles`, `platform`, `robots` (as of `view.robots`), `friction` (of the "
       "object "
       "with each `material` of the hand), `judge` (as of `judge.set`), `hand`, `arm` (its "
       "`joints` with values and limits, whether it has `reached` the hand without a collision, "
       "and the `problem` where not; null without a platform), `outcome` of the last auto-grasp "
       "while the hand stays there, `switches`, `planning`, `finding_path`, how many `results`, "
       "`pins`, and how "
       "often to `undo` "
       "and `redo`",
       state_of},
      {"contacts",
       CommandKind::query,
       "Where the hand touches the object.",
       {},
       "`contacts`, each with `link`, position [m] and unit normal (into the object) in the frames "
       "of object and world, `model`, `friction`, `torsion` [m] and `gap` [m]",
       contacts_of_hand}};
}

// How good it is.
std::vector<Command> scoring_commands() {
  return {
      {"quality",
       CommandKind::query,
       "How well the hand holds the object as it is.",
       {{"sections", FieldType::boolean, false,
         "whether to tell what the wrench space looks like; false"}},
       "`outcome`, the bracket of `epsilon`, `volume`, `weakest_wrench` with its torque times "
       "`torque_scale` [1/m] about `torque_origin` (frame of the object), `limit` (the link whose "
       "contacts the grasp needs most, and epsilon "
       "without them; null without force closure), `contacts`, and on demand `sections` of the "
       "grasp wrench space: `forces` (without torque) and `torques` (without force), each as "
       "`vertices` of a convex polyhedron and `triangles` of their numbers, both flat lists, empty "
       "where the space is flat, and `chosen` with the names of its `axes` where `judge.set` fixes "
       "coordinates",
       quality_of},
      {"judge.set",
       CommandKind::change,
       "Sets how `quality` judges from now on; plans keep to their accuracy.",
       {{"norm", FieldType::text, false, "l1 (the normal forces add up to 1) or linf (each is 1)"},
        {"edges", FieldType::integer, false, "of the pyramids in place of friction cones; 8",
         kJudgedEdges},
        {"fixed", FieldType::text, false,
         "the coordinates that one more section of the wrench space fixes, three of fx, fy, fz, "
         "tx, "
         "ty, tz with commas"},
        {"values", FieldType::vector3, false, "their values", kCoordinate},
        {"section", FieldType::boolean, false, "false: without that section"}},
       "the state, as of `state`",
       judge_set},
      {"forces",
       CommandKind::query,
       "The smallest contact forces that balance a load on the object.",
       {{"force_object", FieldType::vector3, false,
         "load at the centre of mass, frame of the object [N]; 0", kLoad},
        {"torque_object", FieldType::vector3, false,
         "load about the centre of mass, frame of the object [N m]; 0", kLoad},
        {"drive_limits", FieldType::boolean, false,
         "whether the hand's drives have to bear them; false"}},
       "`outcome` (balanced, impossible or limit), `largest_normal` and `sum_of_normals` [N], "
       "`residual`, and `forces`, one for each contact: the force on the object, its `normal` part "
       "[N] and the `torsion` about the normal [N m]",
       forces_of},
      {"collisions",
       CommandKind::query,
       "Which bodies overlap now.",
       {},
       "`collisions`, each a `link` of the hand, or of the arm where it holds the hand, and `by` "
       "what it overlaps",
       collisions_of}};
}

}  // namespace

std::vector<Command> judging_commands() {
  std::vector<Command> all = looking_commands();
  for (Command& command : scoring_commands()) all.push_back(std::move(command));
  return all;
}

}  // namespace prehend
