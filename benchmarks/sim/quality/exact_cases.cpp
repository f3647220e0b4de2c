#include "benchmarks/sim/quality/exact_cases.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "planner/results/contacts_file.h"
#include "sim/base/input_error.h"
#include "sim/base/json/json_field.h"
#include "sim/base/json/json_pose.h"
#include "sim/quality/measures.h"
#include "tests/support/degenerate_grasps.h"
#include "tests/support/judge_epsilon.h"

namespace prehend::test {
namespace {

constexpr std::size_t kMostFacets = 60000;

std::string contacts_text(const DegenerateGrasp& grasp) {
  nlohmann::json file;
  file["torque_origin"] = vector_to_json(grasp.frame.torque_origin);
  file["torque_scale"] = grasp.frame.torque_scale;
  file["contacts"] = nlohmann::json::array();
  for (const Contact& contact : grasp.contacts) {
    nlohmann::json entry{{"position", vector_to_json(contact.position)},
                         {"normal", vector_to_json(contact.normal)},
                         {"friction", contact.friction},
                         {"model", name_of(contact.model)}};
    if (contact.model == ContactModel::soft_finger) entry["torsion"] = contact.torsion;
    file["contacts"].push_back(entry);
  }
  return file.dump();
}

void judge(const DegenerateGrasp& grasp, ExactTally& tally) {
  const std::string text = contacts_text(grasp);
  ++tally.cases;
  try {
    const ContactsFile file = read_contacts(JsonFile("contacts.json", text));
    WrenchSpaceOptions space;
    space.edges = grasp.edges;
    const EpsilonBracket claimed =
        grasp_epsilon(file.contacts, file.frame, space, epsilon_options(space));
    const exact::Columns wrenches = judged_wrenches(
        grasp.contacts, {grasp.frame.torque_origin, grasp.frame.torque_scale}, grasp.edges);
    const EpsilonVerdict verdict = judge_epsilon(claimed, wrenches, kMostFacets);
    if (!verdict.fault.empty()) tally.faults.push_back(verdict.fault + " " + text);
    tally.closed += claimed.force_closure() ? 1 : 0;
    tally.limited += claimed.status == EpsilonStatus::limit ? 1 : 0;
    tally.worst = std::max(tally.worst, verdict.difference.value_or(0.0));
  } catch (const InputError& error) {
    tally.faults.push_back(std::string(error.what()) + " " + text);
  }
}

}  // namespace

std::vector<ExactTally> exact_cases(int of_each_kind, std::uint64_t seed) {
  std::vector<ExactTally> tallies;
  for (const DegenerateKind& kind : kDegenerateKinds) {
    ExactTally& tally = tallies.emplace_back();
    tally.kind = kind.name;
    Random random(seed);
    for (int i = 0; i < of_each_kind; ++i) judge(kind.make(random), tally);
  }
  return tallies;
}

}  // namespace prehend::test
