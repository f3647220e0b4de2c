#include "planner/show/report/plan_report.h"

#include <algorithm>

#include "planner/plan/grasp_text.h"
#include "planner/plan/plan.h"
#include "planner/results/grasps_file.h"
#include "planner/show/best_viewpoint.h"
#include "planner/show/posed_grasp.h"
#include "sim/base/index.h"
#include "sim/base/parallel/parallel.h"
#include "sim/quality/wrench_space.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {
namespace {

// They keep a report small and quick to make.
constexpr std::size_t kMostGrasps = 1000;      // that are listed
constexpr std::size_t kMostCandidates = 4000;  // that are drawn

std::string contacts_text(ContactKind contacts) {
  switch (contacts) {
    case ContactKind::hard:
      return "hard points";
    case ContactKind::soft:
      return "rubber as soft fingers";
    case ContactKind::fem:
      return "pads of finite elements";
  }
  return {};
}

std::vector<std::pair<std::string, std::string>> facts_of(const CompiledScene& scene,
                                                          const PlanResult& result,
                                                          const RunRecord& record) {
  std::vector<std::pair<std::string, std::string>> facts;
  facts.emplace_back("scene", record.scene);
  facts.emplace_back("object", scene.scene.object.name);
  facts.emplace_back("hand", scene.scene.hand.name);
  if (scene.arm) facts.emplace_back("robot", scene.arm->robot().name);
  facts.emplace_back("contacts", contacts_text(record.options.trial.contacts));
  facts.emplace_back("seed", std::to_string(record.options.seed));
  for (const StageCount& stage : result.stages) {
    facts.emplace_back(name_of(stage.what), std::to_string(stage.count));
  }
  return facts;
}

ReportGrasp grasp_of(const CompiledScene& scene, const PlanResult& result,
                     const ScoredGrasp& scored) {
  const Trial& trial = scored.trial;
  ReportGrasp grasp;
  grasp.outcome = name_of(trial.outcome);
  grasp.force_closure = trial.outcome == Outcome::stable;
  grasp.epsilon = trial.epsilon;
  if (scored.volume) grasp.volume = Interval{*scored.volume, *scored.volume};
  grasp.holding = scored.holding;
  grasp.robustness = scored.robustness;
  grasp.origin = origin_text(scored, result);
  grasp.preshape = preshape_name(scene, scored.candidate);
  grasp.collision_of = collision_text(scene, trial);
  grasp.moved = moved_text(trial);
  if (scored.free) {
    grasp.free_epsilon = scored.free->outcome == Outcome::stable ? scored.free->epsilon.lower : 0.0;
    if (!grasp.moved.empty()) grasp.moved += "; ";
    grasp.moved += "on an object that is free to move: " + free_text(*scored.free);
  }
  grasp.primitive = scored.primitive.value_or(-1);
  grasp.shake = scored.shake;
  for (const GraspContact& contact : trial.contacts) {
    grasp.contacts.push_back({contact.point, scene.links[index(contact.link)].name, contact.gap});
  }
  grasp.motion =
      grasp_motion(scene, scored.candidate, trial, scored.path ? &*scored.path : nullptr);
  return grasp;
}

GraspDetail detail_of(const CompiledScene& scene, const ReportGrasp& grasp,
                      const ScoredGrasp& scored, const RunRecord& record,
                      const RunContext& context) {
  std::vector<Contact> contacts;
  std::vector<std::string> links;
  for (const ReportContact& contact : grasp.contacts) {
    contacts.push_back(contact.point);
    links.push_back(contact.link);
  }
  WrenchSpaceOptions space;
  // The space in which the trial judged the grasp: L1 norm and pyramids.
  space.edges = record.options.trial.cone_edges;
  // A report shows two digits of what the samples are for. A plan in which not even the volumes are
  // wanted gets a rougher figure.
  const int samples = record.options.volumes ? 50 : 20;
  GraspDetail detail = grasp_detail(contacts, links, scene.wrench_frame, space, record.options.seed,
                                    samples, context);
  // Sections were computed with the volume, from the same hull, for as many grasps as were asked
  // for.
  if (scored.sections) detail.sections = *scored.sections;
  return detail;
}

void add_why_not(const CompiledScene& scene, const PlanResult& result, Report& report) {
  for (Outcome outcome : kAll<Outcome>) {
    report.outcomes.push_back({std::string(name_of(outcome)), std::string(outcome_meaning(outcome)),
                               result.outcomes[outcome]});
  }
  for (const CollisionCount& blocker : result.blockers) {
    report.blockers.push_back(
        {std::string(name_of(blocker.outcome)), blocker.link, blocker.by, blocker.count});
  }
  for (const RuleCount& rule : result.rules) {
    ReportRule& row = report.rules.emplace_back(ReportRule{rule.rule, {}});
    for (const Outcome outcome : kAll<Outcome>) {
      const int count = rule.outcomes[outcome];
      if (count > 0) row.outcomes.emplace_back(name_of(outcome), count);
    }
  }
  if (result.status == PlanStatus::object_too_large || result.status == PlanStatus::no_candidates) {
    report.problem = no_candidates_text(scene, result);
  }
  for (const Advice& advice : result.advice) report.advice.push_back(advice.words);
  report.candidates_in_all = result.tried.size();
  const std::size_t count = std::min(result.tried.size(), kMostCandidates);
  // Candidates are in the order of primitives and rules; every n-th one represents all of them.
  for (std::size_t i = 0; i < count; ++i) {
    const Tried& tried = result.tried[i * result.tried.size() / count];
    report.candidates.push_back({tried.X_OH * scene.scene.hand.hand->origin, tried.approach_O,
                                 static_cast<std::size_t>(tried.outcome),
                                 collision_text(tried.collision_of)});
  }
}

}  // namespace

Report plan_report(const CompiledScene& scene, const PlanResult& result, const RunRecord& record,
                   std::size_t most_detailed, const RunContext& context) {
  context.cancellation.check();
  Report report;
  const std::string& object = scene.scene.object.name;
  report.title = (object.empty() ? "object" : object) + ", " + scene.scene.hand.name;
  if (scene.arm) report.title += " on " + scene.arm->robot().name;
  report.facts = facts_of(scene, result, record);
  report.scene = &scene;
  report.frame = scene.wrench_frame;
  report.primitives = result.primitives;
  report.solids = result.solids;
  report.grasps_in_all = result.grasps.size();
  report.grasps.resize(std::min(result.grasps.size(), kMostGrasps));
  const ViewpointSearch search(scene);
  // Each grasp has its own place in the list, so the report is the same on any number of threads.
  // Only the first ones are analysed in detail.
  for_each_in_parallel(report.grasps.size(), context.threads, [&](std::size_t i) {
    context.cancellation.check();
    report.grasps[i] = grasp_of(scene, result, result.grasps[i]);
    if (i < most_detailed) {
      report.grasps[i].detail =
          detail_of(scene, report.grasps[i], result.grasps[i], record, context);
      report.grasps[i].side = search.best(posed_grasp(scene, result.grasps[i]), context);
    }
  });
  add_why_not(scene, result, report);
  return report;
}

}  // namespace prehend
