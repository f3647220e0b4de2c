#include "planner/show/validation/validation_page.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "planner/show/page/plain_page.h"
#include "planner/show/validation/unit_plot.h"
#include "planner/show/validation/validation_text.h"
#include "sim/base/formatted.h"
#include "sim/base/xml/xml_text.h"

namespace prehend {
namespace {

// The colours of lines can be told apart by colour-blind people (Okabe and Ito 2008).
constexpr const char* kStyle = R"(
:root { --c0: #0072b2; --c1: #d55e00; --c2: #009e73; --c3: #cc79a7; --c4: #b8860b;
  --c5: #56b4e9; --c6: #777; --c7: #a0522d; --c8: #6a51a3; }
@media (prefers-color-scheme: dark) { :root { --c0: #4da3e0; --c1: #f08a3c; --c2: #2fc79a;
  --c3: #e29fc6; --c4: #e0b84c; --c6: #a8a8a8; --c7: #e0708a; --c8: #a893dd; } }
svg { vertical-align: middle; } .plot { max-width: 100%; height: auto; }
.beside { display: flex; flex-wrap: wrap; gap: 1.5rem; align-items: center; }
.words { fill: var(--pale); font-size: 12px; } .axis { stroke: var(--pale); }
.grid { stroke: var(--rule); } .axis, .grid, .line { fill: none; }
.diagonal { stroke: var(--pale); stroke-dasharray: 5 4; }
.line { stroke-width: 2; stroke-linejoin: round; }
.c5, .c6, .c7, .c8 { stroke-dasharray: 7 3; } .bar { fill: var(--bar); }
)";

// The classes of colours, for lines and dots.
constexpr std::size_t kColors = 9;

std::string color_rules() {
  std::string rules;
  for (std::size_t i = 0; i < kColors; ++i) {
    rules += formatted(".line.c%zu { stroke: var(--c%zu); } .dot.c%zu { fill: var(--c%zu); }\n", i,
                       i, i, i);
  }
  return rules;
}

std::string shown(const std::optional<double>& value, const char* pattern) {
  return value ? formatted(pattern, *value) : "–";
}

std::string shown(const std::optional<Interval>& interval, const char* pattern) {
  if (!interval) return "–";
  return formatted(pattern, interval->lower) + " to " + formatted(pattern, interval->upper);
}

std::string score_section(const ValidationReport& report) {
  std::string rows;
  for (const ScoreFigures& figures : report.scores) {
    const bool drawn = figures.auc.value && figures.auc.interval;
    const bool is_epsilon = &figures == &report.scores[kReferenceScore];
    rows += row_of({markup_text(figures.score.title), shown(figures.auc.value, "%.3f"),
                    shown(figures.auc.interval, "%.3f"),
                    drawn ? interval_svg(*figures.auc.value, *figures.auc.interval) : "",
                    is_epsilon ? "" : shown(figures.over_epsilon.value, "%+.3f"),
                    is_epsilon ? "" : shown(figures.over_epsilon.interval, "%+.3f")});
  }
  return "<h2>How well each score tells lifted grasps from failed ones</h2>\n<p>AUC: the "
         "probability that of a grasp that lifted and one that failed the lifted one has the "
         "larger "
         "score; 0.5 is chance, 1 perfect. The last columns say by how much that is more than for "
         "epsilon, in the same resamples.</p>\n" +
         table_of({"score", "AUC", "interval", "0 to 1", "more than epsilon", "interval"}, rows) +
         "<p class=\"note\">" + markup_text(interval_text(report)) + ".</p>\n";
}

std::string roc_section(const ValidationReport& report) {
  UnitPlot plot("Lifted grasps over failed grasps above each score",
                "share of the failed grasps above a score", "share of the lifted grasps above it");
  plot.diagonal();
  std::string names;
  for (std::size_t s = 0; s < report.scores.size(); ++s) {
    const ScoreFigures& figures = report.scores[s];
    std::vector<PlotPoint> points;
    for (const RocPoint& point : figures.roc) points.push_back({point.failed, point.lifted});
    plot.line(points, s % kColors);
    names += row_of({formatted("<svg width=\"26\" height=\"10\"><path class=\"line c%zu\" d=\"M0 "
                               "5H26\"/></svg> ",
                               s % kColors) +
                         markup_text(figures.score.title),
                     shown(figures.auc.value, "%.3f")});
  }
  return "<h2>Curves</h2>\n<div class=\"beside\">" + plot.svg() + "<div>" +
         table_of({"score", "AUC"}, names) + "</div></div>\n";
}

std::string reliability_plot(const Calibration& calibration) {
  UnitPlot plot("Observed shares over predicted probabilities", "predicted probability",
                "share that lifted");
  int most = 1;
  for (const ReliabilityBin& bin : calibration.bins) most = std::max(most, bin.count);
  for (const ReliabilityBin& bin : calibration.bins) {
    if (bin.count > 0) plot.bar({bin.from, bin.to}, 0.25 * bin.count / most);
  }
  plot.diagonal();
  for (const ReliabilityBin& bin : calibration.bins) {
    if (bin.count > 0) plot.dot({bin.predicted, bin.share()}, bin.observed, 4.0, 0);
  }
  return plot.svg();
}

std::string calibration_section(const ScoreFigures& figures) {
  const Calibration& calibration = *figures.calibration;
  std::string rows;
  for (const ReliabilityBin& bin : calibration.bins) {
    const bool empty = bin.count == 0;
    rows += row_of({formatted("%g to %g", bin.from, bin.to), std::to_string(bin.count),
                    empty ? "–" : formatted("%.3f", bin.predicted),
                    empty ? "–" : formatted("%.3f", bin.share()),
                    empty ? "–" : shown(std::optional(bin.observed), "%.2f")});
  }
  return "<h2>Whether the " + markup_text(figures.score.title) + " is right</h2>\n<p>" +
         formatted(
             "Expected calibration error %.3f; Brier score %.3f, where %.3f is what the share "
             "of all that lifted would get as the prediction of each.",
             calibration.expected_error, calibration.brier, calibration.brier_of_base_rate) +
         " On the dashed line as many lift as were predicted; bars show how many grasps there are "
         "of each prediction.</p>\n<div class=\"beside\">" +
         reliability_plot(calibration) + "<div>" +
         table_of({"predicted", "grasps", "mean", "lifted", "95 % (Wilson)"}, rows) +
         "</div></div>\n";
}

std::string part_section(const char* what, const std::vector<ValidationPart>& parts,
                         const std::vector<ScoreFigures>& scores) {
  std::vector<std::string> heads = {what, "lifted", "failed"};
  for (const ScoreFigures& figures : scores) {
    std::string name(figures.score.name);
    std::replace(name.begin(), name.end(), '_', ' ');
    heads.push_back(markup_text(name));
  }
  std::string rows;
  for (const ValidationPart& part : parts) {
    std::vector<std::string> cells = {markup_text(part.name), std::to_string(part.lifted),
                                      std::to_string(part.failed)};
    for (const auto& auc : part.auc) cells.push_back(shown(auc, "%.2f"));
    rows += row_of(cells);
  }
  return formatted("<h2>AUC by %s</h2>\n", what) + table_of(heads, rows);
}

std::string frame_section(const FrameCheck& frames) {
  std::string words = frame_text(frames);
  words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
  const bool ends = words.back() == '?';
  std::string rows;
  for (const ObjectPlace place : kAll<ObjectPlace>) {
    constexpr std::array<const char*, kAll<ObjectPlace>.size()> kWords = {
        "the object is between the open fingers", "the closing fingers miss the object",
        "a finger is in the object", "between the fingers, and in the palm as well"};
    const auto at = static_cast<std::size_t>(place);
    rows += row_of({kWords.at(at), std::to_string(frames.places.at(at))});
  }
  rows += row_of({"the open hand is in an obstacle", std::to_string(frames.in_obstacles)});
  return std::string("<h2>Frames</h2>\n<p") + (frames.suspicion ? " class=\"warning\"" : "") + ">" +
         markup_text(words) + (ends ? "" : ".") +
         "</p>\n<p class=\"note\">Judged by surfaces alone, without a look at what lifted.</p>\n" +
         table_of({"as given", "grasps"}, rows);
}

std::string outcome_section(const ValidationReport& report) {
  std::string rows;
  for (const Outcome outcome : kAll<Outcome>) {
    const int count = report.outcomes[outcome];
    if (count == 0) continue;
    std::string name(name_of(outcome));
    std::replace(name.begin(), name.end(), '_', ' ');
    rows += row_of({markup_text(name), std::to_string(count)});
  }
  return "<h2>How the trials ended</h2>\n" + table_of({"outcome", "grasps"}, rows);
}

}  // namespace

std::string validation_page(const ValidationReport& report) {
  std::string page = "<p>" + execution_text(report) + ".</p>\n";
  if (report.frames.suspicion) page += frame_section(report.frames);
  page += score_section(report) + roc_section(report);
  for (const ScoreFigures& figures : report.scores) {
    if (figures.calibration) page += calibration_section(figures);
  }
  page += part_section("object", report.objects, report.scores);
  if (report.sessions.size() > 1) {
    page += part_section("session", report.sessions, report.scores);
  }
  if (!report.frames.suspicion) page += frame_section(report.frames);
  page += outcome_section(report);
  return plain_page(report.name + ": scores and executed grasps", kStyle + color_rules(), page);
}

}  // namespace prehend
