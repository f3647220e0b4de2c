#include <algorithm>
#include <set>

#include "benchmarks/report/line_plot.h"
#include "benchmarks/report/names.h"
#include "benchmarks/report/page_parts.h"
#include "benchmarks/report/power_law.h"
#include "sim/base/formatted.h"

namespace prehend::bench {
namespace {

std::vector<std::string> series_of(const std::vector<Entry>& entries) {
  std::vector<std::string> names;
  for (const Entry& entry : entries) {
    if (std::find(names.begin(), names.end(), entry.series) == names.end()) {
      names.push_back(entry.series);
    }
  }
  return names;
}

Line line_of(const std::vector<Entry>& entries, const std::string& series) {
  Line line{series, {}, {}};
  std::vector<DataPoint> points;
  for (const Entry& entry : entries) {
    if (entry.series != series || !entry.x) continue;
    const Summary& value = entry.value;
    line.points.push_back({*entry.x, value.median, value.p10, value.p90});
    points.push_back({*entry.x, value.median});
  }
  line.fit = fit_power_law(points);
  return line;
}

// One plot for each unit: times and megabytes have no axis in common.
void add_plots(const std::string& size, const std::vector<Entry>& entries, PageWriter& page) {
  std::set<std::string> units;
  for (const Entry& entry : entries) units.insert(entry.unit);
  for (const std::string& unit : units) {
    LinePlot plot;
    plot.title = (is_time(unit) ? "Time over " : "Memory over ") + size;
    plot.x_label = size;
    plot.y_label = (is_time(unit) ? "time [" : "largest resident memory [") + unit + "]";
    plot.x_scale = Scale::logarithmic;
    plot.y_scale = Scale::logarithmic;
    std::vector<Entry> of_unit;
    std::copy_if(entries.begin(), entries.end(), std::back_inserter(of_unit),
                 [&](const Entry& entry) { return entry.unit == unit; });
    for (const std::string& series : series_of(of_unit)) {
      plot.lines.push_back(line_of(of_unit, series));
    }
    page.picture("scaling_" + size + (is_time(unit) ? "" : "_memory"), plot.title,
                 line_plot_svg(plot));
  }
}

void add_exponents(const std::vector<Entry>& entries, PageWriter& page) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& series : series_of(entries)) {
    const std::optional<PowerLaw> fit = line_of(entries, series).fit;
    rows.push_back({series, fit ? formatted("%.2f", fit->exponent) : "–",
                    fit ? formatted("%.3f", fit->r_squared) : "–"});
  }
  page.table({"what", "exponent", "R²"}, rows);
}

void add_values(const std::string& size, const std::vector<Entry>& entries, PageWriter& page) {
  std::set<double> sizes;
  for (const Entry& entry : entries) {
    if (entry.x) sizes.insert(*entry.x);
  }
  std::vector<std::string> headings = {size};
  for (const std::string& series : series_of(entries)) headings.push_back(series);
  std::vector<std::vector<std::string>> rows;
  for (const double x : sizes) {
    rows.push_back({formatted("%.0f", x)});
    for (std::size_t i = 1; i < headings.size(); ++i) {
      const auto found = std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) {
        return entry.series == headings[i] && entry.x == x;
      });
      rows.back().push_back(found == entries.end() ? "–"
                                                   : value_text(found->value.median, found->unit));
    }
  }
  page.table(headings, rows);
}

}  // namespace

void add_scaling(const Results& results, PageWriter& page) {
  bool begun = false;
  for (const char* size : kSizes) {
    const std::vector<Entry> entries = entries_of(results, kScaling, size);
    if (entries.empty()) continue;
    if (!begun) {
      page.heading(2, "Scaling");
      page.paragraph(
          "Medians, and the exponent of the power law with the least squared differences in "
          "logarithmic axes; size 0 has no place in it. An R² far below 1 says that the cost is no "
          "power of the size: it is constant at first, or bounded. A series ends early where its "
          "next point would have taken too long.");
      begun = true;
    }
    page.heading(3, std::string("Number of ") + size);
    add_plots(size, entries, page);
    add_exponents(entries, page);
    add_values(size, entries, page);
  }
}

}  // namespace prehend::bench
