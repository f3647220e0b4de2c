// The report of contacts that were judged without a scene or a hand.
#pragma once

#include <string>

#include "planner/files/contacts_file.h"
#include "planner/report/report.h"

namespace prehend {

struct JudgedContacts {
  WrenchSpaceOptions space;
  EpsilonBracket epsilon;
  Interval volume;
};

// The report's title is `name`.
Report contacts_report(const std::string& name, const ContactsFile& file,
                       const JudgedContacts& judged, std::uint64_t seed);

}  // namespace prehend
