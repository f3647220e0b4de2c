// What a report shows, as plain values.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "planner/path/grasp_motion.h"
#include "planner/report/grasp_detail.h"
#include "sim/quality/interval.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {

struct ReportContact {
  Contact point;                   // frame O
  std::string link = {};           // empty: there is no hand
  std::optional<double> gap = {};  // between link and object [m]
};

struct ReportGrasp {
  std::string outcome;  // as outcome_name says; empty: there was no trial
  bool force_closure = false;
  EpsilonBracket epsilon;
  Interval volume;
  std::string origin = {};  // the rule and primitive that it came from
  std::string preshape = {};
  std::string blame = {};  // which link met what
  int primitive = -1;      // index into the report's, -1: none
  std::vector<ReportContact> contacts;
  std::optional<GraspMotion> motion = {};  // empty without a hand
  std::optional<GraspDetail> detail = {};
  std::optional<Vector3> side = {};  // from where to look at it: unit, to the eye, in the world
};

struct ReportOutcome {
  std::string name;
  std::string meaning;
  int count = 0;
};

// A candidate as an arrow: where its hand was aimed, and which way it came.
struct ReportCandidate {
  Vector3 p_O = Vector3::Zero();
  Vector3 approach_O = Vector3::UnitZ();  // unit
  std::size_t outcome = 0;                // index into the report's
  std::string blame = {};
};

struct ReportBlocker {
  std::string outcome;
  std::string link;
  std::string by;
  int count = 0;
};

struct Report {
  std::string title;
  std::vector<std::pair<std::string, std::string>> facts;  // of the run: name, value
  const CompiledScene* scene = nullptr;  // none: contacts alone. Outlives the report
  WrenchFrame frame;                     // of all grasps
  // What is unit: words for the sum of all normal forces, or for each.
  std::string unit_force = "normal forces that add up to";
  std::vector<Primitive> primitives = {};
  std::vector<ReportGrasp> grasps = {};
  std::size_t grasps_in_all = 0;  // those that the report leaves out included
  std::vector<ReportOutcome> outcomes = {};
  std::vector<ReportBlocker> blockers = {};
  std::vector<ReportCandidate> candidates = {};
  std::size_t candidates_in_all = 0;
};

}  // namespace prehend
