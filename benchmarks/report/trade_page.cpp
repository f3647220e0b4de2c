#include <algorithm>
#include <cmath>

#include "benchmarks/report/knee.h"
#include "benchmarks/report/line_plot.h"
#include "benchmarks/report/names.h"
#include "benchmarks/report/page_parts.h"
#include "benchmarks/support/percentile.h"
#include "sim/base/formatted.h"

namespace prehend::bench {
namespace {

// The curve of one object and setting: a point for each number of trials.
struct Curve {
  std::string object;
  std::string setting;
  std::vector<double> trials;
  std::vector<LinePoint> points;  // best epsilon over seconds
};

// "mug, draft" as object and setting.
Curve curve_named(const std::string& series) {
  const std::size_t comma = series.rfind(", ");
  if (comma == std::string::npos) return {series, "", {}, {}};
  return {series.substr(0, comma), series.substr(comma + 2), {}, {}};
}

std::vector<Curve> curves_of(const Results& results) {
  std::vector<Curve> curves;
  for (const Entry& best : entries_of(results, kTrade, kBestEpsilon)) {
    Entry time = best;
    time.group = kPlanTime;
    const Entry* took = find_entry(results, name_of(time));
    if (took == nullptr || !best.x) continue;
    const Curve named = curve_named(best.series);
    auto curve = std::find_if(curves.begin(), curves.end(), [&](const Curve& known) {
      return known.object == named.object && known.setting == named.setting;
    });
    if (curve == curves.end()) curve = curves.insert(curve, named);
    curve->trials.push_back(*best.x);
    curve->points.push_back(
        {took->value.median, best.value.median, best.value.p10, best.value.p90});
  }
  return curves;
}

std::optional<std::size_t> knee_of(const Curve& curve) {
  std::vector<DataPoint> points;
  for (const LinePoint& point : curve.points) points.push_back({point.x, point.y});
  return knee_of(points);
}

void add_settings(const Results& results, PageWriter& page) {
  std::vector<std::vector<std::string>> rows;
  for (const Entry& time : entries_of(results, kTrade, kTimePerTrial)) {
    const auto value = [&](const char* group) {
      const Entry* entry =
          find_entry(results, std::string(kTrade) + "/" + group + "/" + time.series);
      return entry == nullptr ? Summary{} : entry->value;
    };
    rows.push_back(
        {time.series, value_text(time.value.median, time.unit),
         value_text(time.value.p90, time.unit), value_text(value(kEpsilonError).median, "%"),
         value_text(value(kEpsilonError).p90, "%"), value_text(value(kOtherVerdict).median, "%"),
         value_text(value(kBestKept).median, "1") + " of 10"});
  }
  page.table({"object, setting", "trial, median", "90 %", "error of ε, median", "90 %",
              "other verdict", "best kept"},
             rows);
}

void add_curves(const std::vector<Curve>& curves, PageWriter& page) {
  std::vector<std::string> objects;
  for (const Curve& curve : curves) {
    if (std::find(objects.begin(), objects.end(), curve.object) == objects.end()) {
      objects.push_back(curve.object);
    }
  }
  for (const std::string& object : objects) {
    LinePlot plot;
    plot.title = "Best grasp found by seconds of planning: " + object;
    plot.x_label = "planning [s]";
    plot.y_label = "best ε";
    plot.x_scale = Scale::logarithmic;
    for (const Curve& curve : curves) {
      if (curve.object == object) plot.lines.push_back({curve.setting, curve.points, {}});
    }
    page.picture("trade_" + object, plot.title, line_plot_svg(plot));
  }
}

void add_knees(const std::vector<Curve>& curves, PageWriter& page) {
  std::vector<std::vector<std::string>> rows;
  for (const Curve& curve : curves) {
    const std::optional<std::size_t> knee = knee_of(curve);
    if (curve.points.empty()) continue;
    rows.push_back({curve.object + ", " + curve.setting});
    if (knee) {
      const LinePoint& point = curve.points[*knee];
      rows.back().insert(rows.back().end(), {formatted("%.0f", curve.trials[*knee]),
                                             value_text(point.x, "s"), value_text(point.y, "1")});
    } else {
      rows.back().insert(rows.back().end(), {"–", "–", "–"});
    }
    const LinePoint& last = curve.points.back();
    rows.back().insert(rows.back().end(), {value_text(last.x, "s"), value_text(last.y, "1")});
  }
  page.table({"object, setting", "knee: trials", "time", "best ε", "longest: time", "best ε"},
             rows);
}

// Where the default lies, in words.
void add_verdict(const Results& results, const std::vector<Curve>& curves, PageWriter& page) {
  const std::vector<Entry> defaults = entries_of(results, kTrade, kDefault);
  if (defaults.empty()) return;
  const Entry& standing = defaults.front();
  std::vector<double> knees;
  for (const Curve& curve : curves) {
    const std::optional<std::size_t> knee = knee_of(curve);
    if (curve.setting == standing.series && knee) knees.push_back(curve.trials[*knee]);
  }
  std::string words = formatted("The default is `%s` with %.0f trials, chosen to be the knee. ",
                                standing.series.c_str(), standing.value.median);
  if (knees.empty()) {
    words += "These curves are too short to have one.";
  } else {
    // The numbers of trials that were tried are a factor of two apart.
    const double knee = benchmark::percentile(knees, 0.5);
    const double ratio = standing.value.median / knee;
    words += formatted(
        "Here, the knee of `%s` is at %.0f trials (median of the %zu objects that have one): ",
        standing.series.c_str(), knee, knees.size());
    if (ratio > 2.01) {
      words += formatted("**the default spends %.1f times that.**", ratio);
    } else if (ratio < 0.49) {
      words += formatted("**the default spends only %.2f of that.**", ratio);
    } else {
      words += "the default is at it, within a factor of two.";
    }
  }
  page.paragraph(words);
}

}  // namespace

void add_trade(const Results& results, PageWriter& page) {
  const std::vector<Curve> curves = curves_of(results);
  const bool any = !entries_of(results, kTrade, kTimePerTrial).empty() || !curves.empty();
  if (!any) return;
  page.heading(2, "Time against accuracy");
  page.paragraph(
      "The same candidates at each setting, one thread. The error of ε is relative to that at the "
      "finest setting, of grasps that hold at both; \"other verdict\" is the part of all trials "
      "that hold at one of the two only; \"best kept\" says how many of the 10 best grasps at the "
      "finest setting are among this setting's best 20.");
  add_settings(results, page);
  if (curves.empty()) return;
  page.paragraph(
      "Whole plans with more and more trials, on all processors: the ε of the best grasp, as the "
      "finest setting sees it (0 where it does not hold there), over the time of the plan. Lines "
      "are medians over the seeds, bands reach from 10 % to 90 % of them.");
  add_curves(curves, page);
  add_verdict(results, curves, page);
  page.paragraph(
      "A knee is the point highest above the straight line from the first point of its curve to "
      "the last, time and ε in parts of their range.");
  add_knees(curves, page);
}

}  // namespace prehend::bench
