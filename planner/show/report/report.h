// The content of a report as plain values, independent of how it is written (report_json.h,
// report_html.h). Lengths in metres; O is the object's frame.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "planner/plan/path/grasp_motion.h"
#include "planner/show/report/grasp_detail.h"
#include "primitives/decompose.h"
#include "sim/manipulation/shake_report.h"
#include "sim/quality/epsilon.h"
#include "sim/quality/interval.h"
#include "sim/shape/primitive.h"
#include "sim/trial/payload_margin.h"
#include "sim/trial/robustness.h"

namespace prehend {

struct CompiledScene;

// A contact of a grasp.
struct ReportContact {
  Contact point;                   // position, normal into the object and friction, frame O
  std::string link = {};           // link that touches; empty: there is no hand
  std::optional<double> gap = {};  // between link and object [m]
};

// A grasp with all that its part of the page shows.
struct ReportGrasp {
  std::string outcome;  // name_of(); empty: there was no trial
  bool force_closure = false;
  EpsilonBracket epsilon;
  // Bounds of the volume of the wrench space; nothing where it was not computed.
  std::optional<Interval> volume;
  std::optional<PayloadMargin> holding = {};  // empty where it was not computed
  std::optional<Robustness> robustness = {};  // empty where it was not asked for
  std::string origin = {};        // origin_text(): the primitive and rule that it came from
  std::string preshape = {};      // preshape_name()
  std::string collision_of = {};  // which link collided with what; empty without a collision
  std::optional<double> free_epsilon = {};  // where a free object ends (ScoredGrasp::free)
  std::string moved = {};                   // moved_text(): what gave way until the grasp held
  int primitive = -1;                       // index into Report::primitives, -1: none
  std::vector<ReportContact> contacts;
  std::optional<GraspMotion> motion = {};  // empty without a hand
  std::optional<GraspDetail> detail = {};  // empty for grasps that are not analysed further
  std::optional<ShakeReport> shake = {};   // empty for grasps that were not shaken
  std::vector<std::string> events = {};    // what a simulation saw, in the order of time
  std::optional<Vector3> side = {};        // viewing direction, unit, towards the eye, world frame
};

// How many candidates ended with one outcome.
struct ReportOutcome {
  std::string name;     // name_of()
  std::string meaning;  // one sentence for the legend
  int count = 0;
};

// A candidate, drawn as an arrow that ends where the hand was aimed and points along the approach.
struct ReportCandidate {
  Vector3 p_O = Vector3::Zero();          // tip of the arrow [m]
  Vector3 approach_O = Vector3::UnitZ();  // unit
  std::size_t outcome = 0;                // index into Report::outcomes
  std::string collision_of = {};          // which link collided with what
};

// How many candidates ended with `outcome` because `link` collided with `by` (Blocker).
struct ReportBlocker {
  std::string outcome;
  std::string link;
  std::string by;
  int count = 0;
};

// How the candidates of one rule ended (RuleCount).
struct ReportRule {
  std::string rule;
  std::vector<std::pair<std::string, int>> outcomes;  // name_of() and count, without zeros
};

// A whole report: of a plan, of an evaluation, or (without scene) of contacts alone.
struct Report {
  std::string title;
  std::vector<std::pair<std::string, std::string>> facts;  // about the run: name and value
  const CompiledScene* scene = nullptr;  // must outlive the report; null: contacts alone
  WrenchFrame frame;                     // torque origin and scale of all wrenches
  // Words for what the wrench space limits to one: the sum of all normal forces, or each of them.
  std::string unit_force = "normal forces that add up to";
  std::vector<Primitive> primitives = {};
  std::optional<Decomposition> solids = {};  // the first of them (PlanResult::solids)
  std::vector<ReportGrasp> grasps = {};
  std::size_t grasps_in_all = 0;  // including those that the report leaves out
  std::vector<ReportOutcome> outcomes = {};
  std::vector<ReportBlocker> blockers = {};
  std::string problem = {};  // why there was nothing to try; empty where there was
  // Of a plan without a grasp.
  std::vector<ReportRule> rules = {};
  std::vector<std::string> advice = {};
  std::vector<ReportCandidate> candidates = {};
  std::size_t candidates_in_all = 0;  // including those that the report leaves out
};

}  // namespace prehend
