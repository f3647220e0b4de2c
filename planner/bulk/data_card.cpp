#include <cctype>
#include <string_view>

#include "planner/bulk/batch_summary.h"
#include "sim/base/formatted.h"
#include "sim/base/input_error.h"

namespace prehend {
namespace {

double percent_of(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

// As Markdown that shows the text as it is, on one line: names of files and hands may hold markup.
// An underscore inside a word is none.
std::string markdown_text(const std::string& given) {
  constexpr std::string_view kMarkup = "\\`*_~[]<>&|#$";
  const std::string text = on_one_line(given);
  std::string escaped;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_inside =
        i > 0 && i + 1 < text.size() && is_of_word(text[i - 1]) && is_of_word(text[i + 1]);
    const bool is_markup = kMarkup.find(text[i]) != std::string_view::npos;
    if (is_markup && !(text[i] == '_' && is_inside)) escaped += '\\';
    escaped += text[i];
  }
  return escaped;
}

std::string outcome_rows(const BatchSummary& summary) {
  std::string rows = "| outcome | grasps | share | meaning |\n|---|---:|---:|---|\n";
  const OutcomeCounts& counts = summary.tally.outcomes;
  for (const Outcome outcome : kAll<Outcome>) {
    const std::size_t count = counts.of[outcome];
    if (count == 0) continue;
    rows +=
        formatted("| %s | %zu | %.1f %% | %s |\n", std::string(name_of(outcome)).c_str(), count,
                  percent_of(count, counts.all()), std::string(outcome_meaning(outcome)).c_str());
  }
  return rows;
}

std::string hand_rows(const BatchSummary& summary) {
  std::string rows = "| hand | grasps | stable | share |\n|---|---:|---:|---:|\n";
  for (const auto& [name, counts] : summary.tally.hands) {
    rows += formatted("| %s | %zu | %zu | %.1f %% |\n", markdown_text(name).c_str(), counts.all(),
                      counts.stable(), percent_of(counts.stable(), counts.all()));
  }
  return rows;
}

std::string file_lines(const BatchSummary& summary) {
  std::string lines;
  for (const std::string& format : summary.formats) {
    if (format == "acronym") {
      lines +=
          "- `acronym/OBJECT/HAND.h5`: grasps of one object by one hand, in ACRONYM's layout and "
          "more\n";
    } else if (format == "graspgen") {
      lines +=
          "- `graspgen/OBJECT/HAND.json`: poses and whether they hold, as GraspGen reads them\n";
    } else if (format == "csv") {
      lines += "- `grasps.csv`: all grasps, a row each\n";
    }
  }
  return lines +
         "- `failures.csv`: parts without a result, and why\n- `index.html`: distributions "
         "and pictures\n";
}

}  // namespace

std::string data_card(const BatchSummary& summary) {
  const OutcomeCounts& counts = summary.tally.outcomes;
  std::string card = "# " + markdown_text(summary.name) + "\n\n";
  card += formatted(
      "%zu simulated grasps of %zu objects, %zu of them stable (%.1f %%), in %zu sets; the others "
      "are there as well, with the reason why they do not hold. Made by %s.\n\n",
      counts.all(), summary.tally.objects.size(), counts.stable(),
      percent_of(counts.stable(), counts.all()), summary.tally.sets, summary.version.c_str());
  if (summary.open > 0) {
    card += formatted("**Not complete:** %zu of %zu parts were not planned yet.\n\n", summary.open,
                      summary.parts);
  }
  card += "## What was planned\n\n";
  for (const std::string& axis : summary.axes) card += "- " + markdown_text(axis) + "\n";
  card += formatted("- parts: %zu, of which %zu failed\n\n", summary.parts, summary.failed_parts);
  card += "## Outcomes\n\n" + outcome_rows(summary) + "\n" + hand_rows(summary) + "\n";
  card +=
      "A stable grasp is one in force closure: its contacts, with friction, can balance a force "
      "and torque in any direction. `epsilon_lower` and `epsilon_upper` bound the largest "
      "disturbance that it resists in every direction, for contact forces whose normals add up to "
      "1 N (Ferrari and Canny 1992). Nothing was executed on a real robot.\n\n";
  card += "## Files\n\n" + file_lines(summary) + "\n## Licence\n\n";
  card +=
      summary.licence.empty()
          ? "The licence of the meshes was not stated. Poses refer to meshes that are not "
            "part of the data set.\n"
          : "Of the meshes, which are not part of the data set: " + markdown_text(summary.licence) +
                "\n";
  card += "\n## Settings\n\n";
  for (const std::string& settings : summary.settings) {
    card += "```json\n" + settings + "\n```\n";
  }
  return card;
}

}  // namespace prehend
