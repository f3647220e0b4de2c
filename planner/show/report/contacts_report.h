// The report on contacts that were given directly, without a scene or a hand.
#pragma once

#include <string>

#include "planner/show/report/report.h"
#include "sim/base/run_context.h"
#include "sim/quality/epsilon.h"
#include "sim/quality/interval.h"
#include "sim/quality/wrench_space.h"

namespace prehend {

struct ContactsFile;

// The quality of the contacts of a file, and the wrench space that it refers to.
struct JudgedContacts {
  WrenchSpaceOptions space;  // norm, friction cones and force limits
  EpsilonBracket epsilon;    // bounds of epsilon, and the weakest wrench
  Interval volume;           // bounds of the volume of the wrench space
};

// The report with the title `name`. `seed` is that of the noise in the robustness estimate
// (grasp_detail). Throws as grasp_detail.
Report contacts_report(const std::string& name, const ContactsFile& file,
                       const JudgedContacts& judged, std::uint64_t seed,
                       const RunContext& context = {});

}  // namespace prehend
