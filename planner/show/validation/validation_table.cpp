#include <algorithm>

#include "planner/show/validation/validation_text.h"
#include "sim/base/formatted.h"
#include "sim/base/input_error.h"

namespace prehend {
namespace {

// Bootstraps of fewer groups know too little of how groups differ.
constexpr int kFewGroups = 10;

std::string number_words(const std::optional<double>& value, const char* pattern) {
  return value ? formatted(pattern, *value) : "-";
}

std::string interval_text(const std::optional<Interval>& interval, const char* pattern) {
  if (!interval) return "-";
  return formatted(pattern, interval->lower) + " to " + formatted(pattern, interval->upper);
}

std::size_t widest_name(const std::vector<ValidationPart>& parts, std::size_t least) {
  for (const ValidationPart& part : parts) least = std::max(least, part.name.size());
  return least;
}

// AUC of each score for each part, under the names that scores have in files.
std::string part_table(const char* title, const std::vector<ValidationPart>& parts,
                       const std::vector<ScoreFigures>& scores) {
  const auto width = static_cast<int>(widest_name(parts, 10));
  std::string text = formatted("%-*s  lifted  failed", width, title);
  for (const ScoreFigures& figures : scores) {
    text += "  " + std::string(figures.score.name);
  }
  text += "\n";
  for (const ValidationPart& part : parts) {
    text += formatted("%-*s  %6d  %6d", width, on_one_line(part.name).c_str(), part.lifted,
                      part.failed);
    for (std::size_t s = 0; s < scores.size(); ++s) {
      text += formatted("  %*s", static_cast<int>(scores[s].score.name.size()),
                        number_words(part.auc[s], "%.3f").c_str());
    }
    text += "\n";
  }
  return text;
}

std::string calibration_text(const ScoreFigures& figures) {
  const Calibration& calibration = *figures.calibration;
  return formatted("%s: expected calibration error %.3f, Brier score %.3f (%.3f without a look)\n",
                   std::string(figures.score.title).c_str(), calibration.expected_error,
                   calibration.brier, calibration.brier_of_base_rate);
}

// "1 object", "2 objects"
std::string counted(std::size_t count, const char* what) {
  return formatted("%zu %s%s", count, what, count == 1 ? "" : "s");
}

}  // namespace

std::string execution_text(const ValidationReport& report) {
  const auto all = static_cast<std::size_t>(report.lifted + report.failed);
  return counted(all, "execution") + " of " + counted(report.objects.size(), "object") + " in " +
         counted(report.sessions.size(), "session") +
         formatted(": %d lifted, %d failed", report.lifted, report.failed);
}

std::string interval_text(const ValidationReport& report) {
  const BootstrapOptions& options = report.bootstrap;
  constexpr std::array<const char*, kAll<Grouping>.size()> kGroups = {
      "objects", "sessions", "objects and sessions", "single executions"};
  std::string words = formatted("%g %% intervals from %d resamples of %d %s", 100.0 * options.level,
                                options.resamples, report.groups,
                                kGroups.at(static_cast<std::size_t>(options.grouping)));
  if (report.undefined > 0) {
    words += formatted(", of which %d had one outcome only", report.undefined);
  }
  if (report.groups < kFewGroups) words += "; so few make them too narrow";
  return words;
}

std::string validation_table(const ValidationReport& report) {
  std::string text = execution_text(report) + "\n";
  text += formatted("%-28s  %6s  %-16s  %-9s  %s\n", "score", "AUC", "95 %", "- epsilon", "95 %");
  for (std::size_t s = 0; s < report.scores.size(); ++s) {
    const ScoreFigures& figures = report.scores[s];
    const Estimate more = s == kReferenceScore ? Estimate{} : figures.over_epsilon;
    text += formatted("%-28s  %6s  %-16s  %9s  %s\n", std::string(figures.score.title).c_str(),
                      number_words(figures.auc.value, "%.3f").c_str(),
                      interval_text(figures.auc.interval, "%.3f").c_str(),
                      number_words(more.value, "%+.3f").c_str(),
                      interval_text(more.interval, "%+.3f").c_str());
  }
  text += interval_text(report) + "\n";
  for (const ScoreFigures& figures : report.scores) {
    if (figures.calibration) text += calibration_text(figures);
  }
  text += "\n" + part_table("object", report.objects, report.scores);
  if (report.sessions.size() > 1) {
    text += "\n" + part_table("session", report.sessions, report.scores);
  }
  text += "\nframes: " + frame_text(report.frames) + "\n";
  if (report.frames.in_obstacles > 0) {
    text += formatted("frames: %d open hands are in an obstacle of the scene\n",
                      report.frames.in_obstacles);
  }
  return text;
}

}  // namespace prehend
