#include "benchmarks/report/results_file.h"

#include <set>

#include "sim/base/json/json_fields.h"

namespace prehend::bench {
namespace {

constexpr int kFormat = 1;  // raised when older programs could not read what is written

template <typename Fields, typename Value>
void visit_needed(Fields& fields, const char* name, Value& value) {
  fields.needs(name);
  fields(name, value);
}

// `summary` stands beside the other fields of its entry.
template <typename Fields, typename SummaryType>
void visit_summary(Fields& fields, SummaryType& summary) {
  visit_needed(fields, "samples", summary.samples);
  visit_needed(fields, "median", summary.median);
  visit_needed(fields, "p90", summary.p90);
  visit_needed(fields, "p99", summary.p99);
  visit_needed(fields, "p10", summary.p10);
  visit_needed(fields, "least", summary.least);
  visit_needed(fields, "most", summary.most);
  visit_needed(fields, "mean", summary.mean);
  fields.require("samples", summary.samples > 0, "must be above 0");
}

template <typename Fields, typename EntryType>
void visit_entry(Fields& fields, EntryType& entry) {
  fields.derived("name", [&] { return name_of(entry); });
  visit_needed(fields, "part", entry.part);
  visit_needed(fields, "group", entry.group);
  visit_needed(fields, "series", entry.series);
  fields("x", entry.x);
  visit_needed(fields, "unit", entry.unit);
  visit_summary(fields, entry.value);
}

template <typename Fields, typename MachineType>
void visit_machine(Fields& fields, MachineType& machine) {
  visit_needed(fields, "prehend", machine.prehend);
  visit_needed(fields, "compiler", machine.compiler);
  visit_needed(fields, "build", machine.build);
  visit_needed(fields, "processor", machine.processor);
  visit_needed(fields, "cores", machine.cores);
  visit_needed(fields, "date", machine.date);
}

template <typename Fields, typename ResultsType>
void visit_results(Fields& fields, ResultsType& results, int& format) {
  visit_needed(fields, "format", format);
  fields.require("format", format == kFormat, "is not one that this program knows");
  visit_needed(fields, "effort", results.effort);
  fields.needs("machine");
  fields.object("machine", [&](auto& inner) { visit_machine(inner, results.machine); });
  fields.needs("entries");
  fields.objects("entries", results.entries,
                 [](auto& inner, auto& entry) { visit_entry(inner, entry); });
}

}  // namespace

std::string results_json(const Results& results) {
  FieldWriter fields;
  int format = kFormat;
  visit_results(fields, results, format);
  return std::move(fields).json().dump(1) + "\n";
}

Results read_results(const std::filesystem::path& file) {
  const JsonFile json(file);
  FieldReader fields(json.root());
  Results results;
  int format = 0;
  visit_results(fields, results, format);
  fields.finish();
  std::set<std::string> names;
  for (const Entry& entry : results.entries) {
    const std::string name = name_of(entry);
    if (!names.insert(name).second) json.root()["entries"].fail("twice the entry " + name);
  }
  return results;
}

}  // namespace prehend::bench
