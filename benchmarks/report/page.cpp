#include "benchmarks/report/page.h"

#include <utility>

#include "benchmarks/report/page_parts.h"

namespace prehend::bench {
namespace {

void add_machine(const Results& results, PageWriter& page) {
  const Machine& machine = results.machine;
  page.table({"", "measured with"}, {{"prehend", machine.prehend},
                                     {"compiler", machine.compiler},
                                     {"build", machine.build},
                                     {"processor", machine.processor},
                                     {"cores", std::to_string(machine.cores)},
                                     {"date", machine.date},
                                     {"effort", results.effort}});
}

}  // namespace

std::vector<PageFile> page_of(const Results& results) {
  PageWriter page;
  page.heading(1, "Benchmarks");
  page.paragraph(
      "Made by `./run bench` from `results.json`; [how to run, read and compare]"
      "(../../docs/how-to/benchmarks.md). Times are processor times, which other programs disturb "
      "least; those of whole plans are of a wall clock.");
  add_machine(results, page);
  if (results.effort != "full" || results.machine.build != "Release") {
    page.paragraph(
        "**These are not measurements to quote**: fewer repetitions and smaller sizes than those "
        "of a full run, or not an optimised build.");
  }
  add_kernels(results, page);
  add_trials(results, page);
  add_plans(results, page);
  add_trade(results, page);
  add_scaling(results, page);
  add_peers(results, page);
  return std::move(page).files();
}

}  // namespace prehend::bench
