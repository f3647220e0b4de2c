#include <algorithm>
#include <array>

#include "planner/bulk/batch_summary.h"
#include "planner/show/page/plain_page.h"
#include "sim/base/formatted.h"
#include "sim/base/xml/xml_text.h"

namespace prehend {
namespace {

constexpr std::string_view kBatchStyle = R"(
:root { --held: #0072b2; --other: #b9c2ca; }
@media (prefers-color-scheme: dark) { :root { --held: #4da3e0; --other: #4a545e; } }
.share { display: inline-block; width: 12rem; height: .8rem; background: var(--other); }
.share i { display: block; height: 100%; background: var(--held); }
.plots, .pictures { display: flex; flex-wrap: wrap; gap: 1.5rem; }
.plots figure, .pictures figure { margin: 0; } figcaption { color: var(--pale); max-width: 30rem; }
td:last-child, th:last-child { text-align: left; } .bar { fill: var(--held); } .axis { stroke: var(--pale); } .words { fill: var(--pale);
  font-size: 12px; }
.pictures img { max-width: 100%; height: auto; border: 1px solid var(--rule); }
)";

constexpr int kWidth = 440;
constexpr int kHeight = 180;
constexpr int kMargin = 28;  // below the bars, for the numbers

double share_of(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

std::string share_bar(const OutcomeCounts& counts) {
  return formatted(R"(<span class="share"><i style="width: %.1f%%"></i></span>)",
                   100.0 * share_of(counts.stable(), counts.all()));
}

std::string counts_table(const char* what, const std::map<std::string, OutcomeCounts>& rows) {
  // Tables of ten thousand objects help nobody: the ends of the list are shown.
  constexpr std::size_t kMostRows = 200;
  std::vector<std::pair<std::string, OutcomeCounts>> sorted(rows.begin(), rows.end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
    return share_of(a.second.stable(), a.second.all()) >
           share_of(b.second.stable(), b.second.all());
  });
  std::string text;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (sorted.size() > kMostRows && i == kMostRows / 2) {
      i = sorted.size() - kMostRows / 2;
      text += row_of({"…", "", "", "", ""});
    }
    const auto& [name, counts] = sorted[i];
    text += row_of(
        {markup_text(name), std::to_string(counts.all()), std::to_string(counts.stable()),
         formatted("%.1f %%", 100.0 * share_of(counts.stable(), counts.all())), share_bar(counts)});
  }
  return formatted("<h2>By %s</h2>\n", what) +
         table_of({what, "grasps", "stable", "share", ""}, text);
}

std::string outcome_table(const OutcomeCounts& counts) {
  std::string rows;
  for (const Outcome outcome : kAll<Outcome>) {
    const std::size_t count = counts.of[outcome];
    if (count == 0) continue;
    std::string name(name_of(outcome));
    std::replace(name.begin(), name.end(), '_', ' ');
    rows += row_of({markup_text(name), std::to_string(count),
                    formatted("%.1f %%", 100.0 * share_of(count, counts.all())),
                    markup_text(std::string(outcome_meaning(outcome)))});
  }
  return "<h2>Outcomes</h2>\n" + table_of({"outcome", "grasps", "share", "meaning"}, rows);
}

// Bars over the bins, with the first and the last value and the largest count.
std::string histogram_figure(const Histogram& histogram, const std::string& title) {
  const std::size_t most =
      std::max<std::size_t>(1, *std::max_element(histogram.bins.begin(), histogram.bins.end()));
  const double step = static_cast<double>(kWidth) / static_cast<double>(histogram.bins.size());
  std::string svg =
      formatted(R"(<figure><svg role="img" aria-label="%s" width="%d" height="%d" viewBox="0 0 %d )"
                R"(%d">)",
                markup_text(title).c_str(), kWidth, kHeight + kMargin, kWidth, kHeight + kMargin);
  for (std::size_t i = 0; i < histogram.bins.size(); ++i) {
    const double height = kHeight * share_of(histogram.bins[i], most);
    svg += formatted(R"(<rect class="bar" x="%.2f" y="%.2f" width="%.2f" height="%.2f"/>)",
                     step * static_cast<double>(i) + 0.5, kHeight - height, step - 1.0, height);
  }
  const double end = histogram.width * static_cast<double>(histogram.bins.size());
  svg += formatted(R"(<path class="axis" d="M0 %dH%d"/>)", kHeight, kWidth);
  svg += formatted(R"(<text class="words" x="0" y="%d">0</text>)", kHeight + 18);
  svg += formatted(R"(<text class="words" x="%d" y="%d" text-anchor="middle">%.4g</text>)",
                   kWidth / 2, kHeight + 18, 0.5 * end);
  svg += formatted(R"(<text class="words" x="%d" y="%d" text-anchor="end">%.4g</text></svg>)",
                   kWidth, kHeight + 18, end);
  return svg + formatted("<figcaption>%s; the highest bar is %zu</figcaption></figure>\n",
                         markup_text(title).c_str(), most);
}

std::string picture_section(const BatchSummary& summary) {
  if (summary.pictures.empty()) return {};
  std::string figures;
  for (std::size_t i = 0; i < summary.pictures.size(); ++i) {
    const std::string title = markup_text(summary.pictures[i]);
    figures +=
        formatted(R"(<figure><img src="pictures/%02zu.png" alt="%s" loading="lazy"><figcaption>%s)"
                  "</figcaption></figure>\n",
                  i + 1, title.c_str(), title.c_str());
  }
  return "<h2>Grasps chosen at random</h2>\n<div class=\"pictures\">\n" + figures + "</div>\n";
}

std::string failure_section(const BatchSummary& summary) {
  if (summary.failed.empty()) return {};
  std::string rows;
  for (const FailedPart& part : summary.failed) {
    rows += row_of({markup_text(part.name), markup_text(part.reason)});
  }
  const std::string more =
      summary.failed_parts > summary.failed.size()
          ? formatted("<p class=\"note\">The first %zu of %zu; failures.csv has all.</p>\n",
                      summary.failed.size(), summary.failed_parts)
          : "";
  return "<h2>Parts that failed</h2>\n" + table_of({"part", "reason"}, rows) + more;
}

}  // namespace

std::string batch_page(const BatchSummary& summary) {
  const BatchTally& tally = summary.tally;
  std::string body = formatted(
      "<p>%zu grasps of %zu objects in %zu sets, %zu of them stable (%.1f %%), by %s. %zu of %zu "
      "parts failed.</p>\n",
      tally.outcomes.all(), tally.objects.size(), tally.sets, tally.outcomes.stable(),
      100.0 * share_of(tally.outcomes.stable(), tally.outcomes.all()), summary.version.c_str(),
      summary.failed_parts, summary.parts);
  if (summary.open > 0) {
    body += formatted("<p class=\"warning\">Not complete: %zu parts were not planned yet.</p>\n",
                      summary.open);
  }
  std::string axes;
  for (const std::string& axis : summary.axes) axes += "<li>" + markup_text(axis) + "</li>\n";
  body += "<ul>\n" + axes + "</ul>\n" + outcome_table(tally.outcomes);
  body += "<h2>Distributions</h2>\n<div class=\"plots\">\n" +
          histogram_figure(tally.epsilon, "Stable grasps over epsilon") +
          histogram_figure(tally.contacts, "Grasps that touch, over the number of contacts") +
          histogram_figure(tally.objects_by_share, "Objects over the share of stable grasps") +
          "</div>\n";
  body += picture_section(summary) + counts_table("hand", tally.hands) +
          counts_table("object", tally.objects) + failure_section(summary);
  return plain_page(summary.name, kBatchStyle, body);
}

}  // namespace prehend
