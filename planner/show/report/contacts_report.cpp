#include "planner/show/report/contacts_report.h"

#include "planner/results/contacts_file.h"

namespace prehend {

Report contacts_report(const std::string& name, const ContactsFile& file,
                       const JudgedContacts& judged, std::uint64_t seed,
                       const RunContext& context) {
  const bool each = judged.space.norm == WrenchNorm::linf;
  const bool exact = judged.space.cone == FrictionCone::exact;
  Report report;
  report.title = name;
  report.facts = {
      {"contacts", std::to_string(file.contacts.size())},
      {"unit", each ? "each normal force (L-infinity)" : "the sum of normal forces (L1)"},
      {"friction cones", exact ? "exact" : std::to_string(judged.space.edges) + " edges"},
      {"seed", std::to_string(seed)}};
  if (each) report.unit_force = "normal forces of each contact up to";
  report.frame = file.frame;
  ReportGrasp grasp;
  grasp.force_closure = judged.epsilon.force_closure();
  grasp.epsilon = judged.epsilon;
  grasp.volume = judged.volume;
  grasp.origin = "given contacts";
  // Without a hand there are no links, gaps or motion: a report of contacts has one grasp with its
  // wrench space only.
  for (const Contact& contact : file.contacts) grasp.contacts.push_back({contact});
  constexpr int kSamples = 100;
  grasp.detail = grasp_detail(file.contacts, {}, file.frame, judged.space, seed, kSamples, context);
  grasp.detail->sections = space_sections(file.contacts, file.frame, judged.space);
  report.grasps.push_back(std::move(grasp));
  report.grasps_in_all = 1;
  return report;
}

}  // namespace prehend
