#include "planner/main/result_table.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "planner/plan/grasp_text.h"
#include "sim/base/formatted.h"
#include "sim/base/joined.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/success.h"

namespace prehend {
namespace {

// "-" where it was not computed.
std::string volume_text(const ScoredGrasp& grasp) {
  return grasp.volume ? formatted("%.3g", *grasp.volume) : "-";
}

// "3.2/1.1": how many times the weight the hand holds, as the object lies and at worst; "-" where
// it was not computed.
std::string weight_text(const ScoredGrasp& grasp) {
  if (!grasp.holding) return "-";
  return load_factor_text(grasp.holding->given) + "/" + load_factor_text(grasp.holding->worst);
}

// "84 %": how probably the grasp lifts the object.
std::string success_text(const ScoredGrasp& grasp) {
  if (!grasp.robustness) return "-";
  return formatted("%.0f %%", 100.0 * success_probability(*grasp.robustness));
}

bool is_disturbed(const ScoredGrasp& grasp) { return grasp.robustness.has_value(); }

// "14 of 16" disturbed trials held, and how far the object may be off; a column only where there
// are any.
std::string held_text(const ScoredGrasp& grasp) {
  if (!grasp.robustness) return "-";
  return formatted("%d of %d, %.3g mm", grasp.robustness->held, grasp.robustness->samples,
                   1e3 * grasp.robustness->position_margin);
}

std::string free_words(const ScoredGrasp& grasp) {
  return grasp.free ? free_text(*grasp.free) : "-";
}

// "5 of 6" tests survived, "-" of a grasp that was not shaken; a column only where there are any.
// Of a protocol with growing pulls also the largest that was survived.
std::string shake_text(const ScoredGrasp& grasp) {
  if (!grasp.shake) return "-";
  const std::string words = formatted("%d of %d", grasp.shake->survived(), grasp.shake->count());
  const std::optional<double> pull = grasp.shake->largest_pull();
  if (!pull) return words;
  const char* least = grasp.shake->holds() ? "over " : "";
  return words + formatted(", %s%.3g m/s2", least, *pull);
}

std::string preferred_text(const ScoredGrasp& grasp) {
  return grasp.trial.preferred ? "yes" : "no";
}

// A column that is there only where a grasp has something in it.
struct OptionalColumn {
  std::string_view title;
  std::string (*words)(const ScoredGrasp&);
  bool (*has)(const ScoredGrasp&);
};

constexpr std::array<OptionalColumn, 5> kOptionalColumns = {
    {{"preferred", preferred_text, [](const ScoredGrasp& grasp) { return grasp.trial.preferred; }},
     {"free object", free_words, [](const ScoredGrasp& grasp) { return grasp.free.has_value(); }},
     {"lifts", success_text, is_disturbed},
     {"held, spare", held_text, is_disturbed},
     {"shaken", shake_text, [](const ScoredGrasp& grasp) { return grasp.shake.has_value(); }}}};

std::string padded(std::string words, std::size_t width) {
  words.resize(width + 2, ' ');
  return words;
}

// The titles and, for each grasp, the words of the optional columns, each as wide as its longest.
struct OptionalCells {
  std::string titles;
  std::vector<std::string> rows;
};

OptionalCells optional_cells(const std::vector<ScoredGrasp>& grasps) {
  OptionalCells cells{"", std::vector<std::string>(grasps.size())};
  for (const OptionalColumn& column : kOptionalColumns) {
    if (std::none_of(grasps.begin(), grasps.end(), column.has)) continue;
    std::size_t width = column.title.size();
    for (const ScoredGrasp& grasp : grasps) width = std::max(width, column.words(grasp).size());
    cells.titles += padded(std::string(column.title), width);
    for (std::size_t i = 0; i < grasps.size(); ++i) {
      cells.rows[i] += padded(column.words(grasps[i]), width);
    }
  }
  return cells;
}

}  // namespace

std::string grasp_table(const CompiledScene& scene, const PlanResult& result, std::size_t rows) {
  const OptionalCells optional = optional_cells(result.grasps);
  std::string text = formatted("%4s  %8s  %9s  %9s  %8s  %-17s  %-16s  %s%s\n", "rank", "epsilon",
                               "volume", "x weight", "contacts", "outcome", "preshape",
                               optional.titles.c_str(), "primitive");
  for (std::size_t i = 0; i < result.grasps.size() && i < rows; ++i) {
    const ScoredGrasp& grasp = result.grasps[i];
    const std::string volume = volume_text(grasp);
    const std::string weight = weight_text(grasp);
    text +=
        formatted("%4zu  %8.4f  %9s  %9s  %8zu  %-17s  %-16s  %s%s\n", i + 1,
                  grasp.trial.epsilon.lower, volume.c_str(), weight.c_str(),
                  grasp.trial.contacts.size(), std::string(name_of(grasp.trial.outcome)).c_str(),
                  opening_text(scene, grasp.candidate).c_str(), optional.rows[i].c_str(),
                  origin_text(grasp, result).c_str());
  }
  return text;
}

std::string outcome_line(const PlanResult& result) {
  int total = 0;
  std::string counts;
  for (Outcome outcome : kAll<Outcome>) {
    const int count = result.outcomes[outcome];
    total += count;
    if (count == 0 && outcome >= Outcome::unreachable) continue;  // only arms have these
    add_part(counts, std::to_string(count) + " " + std::string(name_of(outcome)));
  }
  return std::to_string(total) + " tried: " + counts;
}

std::string preferred_line(const CompiledScene& scene, const PlanResult& result) {
  if (scene.preferred.empty() || result.grasps.empty()) return "";
  const bool any = result.grasps.front().trial.preferred;  // they come first
  return any ? "" : "no grasp touches preferred regions only\n";
}

std::string shapes_line(const PlanResult& result) {
  const auto all = [](const ScoredGrasp& grasp) {
    return grasp.shapes && grasp.shapes->held() == grasp.shapes->tried();
  };
  if (result.grasps.empty() || !result.grasps.front().shapes) return "";
  const auto count = std::count_if(result.grasps.begin(), result.grasps.end(), all);
  return formatted("%td of %zu grasps also hold on the thin and the thick shape that it may have\n",
                   count, result.grasps.size());
}

std::string untested_line(const PlanResult& result) {
  if (result.untested == 0) return "";
  const bool late = result.status == PlanStatus::out_of_time;
  std::string text = (late ? "out of time: " : "cancelled: ") + std::to_string(result.untested) +
                     " candidates untested";
  if (result.families > 0) {
    text += "; " + std::to_string(result.families_untested) + " of " +
            std::to_string(result.families) + " ways to grasp without a trial";
  }
  return text + "\n";
}

std::string blocker_line(const PlanResult& result) {
  // Counts are by link and body in the file. This line is about what is in the way, so the counts
  // of all links are added up.
  std::vector<CollisionCount> bodies;
  for (const CollisionCount& blocker : result.blockers) {
    const auto known = std::find_if(bodies.begin(), bodies.end(), [&](const CollisionCount& body) {
      return body.outcome == blocker.outcome && body.by == blocker.by;
    });
    if (known == bodies.end()) {
      bodies.push_back(blocker);
    } else {
      known->count += blocker.count;
    }
  }
  std::stable_sort(
      bodies.begin(), bodies.end(),
      [](const CollisionCount& a, const CollisionCount& b) { return a.count > b.count; });
  std::string text;
  for (const CollisionCount& body : bodies) {
    text += (text.empty() ? "blocked by: " : ", ") + body.by + " " + std::to_string(body.count) +
            " (" + std::string(name_of(body.outcome)) + ")";
  }
  return text.empty() ? text : text + "\n";
}

std::string advice_lines(const PlanResult& result) {
  std::string text;
  if (!result.rules.empty()) text += "no grasp holds; by rule:\n";
  for (const RuleCount& rule : result.rules) {
    std::string counts;
    for (const Outcome outcome : kAll<Outcome>) {
      const int count = rule.outcomes[outcome];
      if (count == 0) continue;
      add_part(counts, std::to_string(count) + " " + std::string(name_of(outcome)));
    }
    text += "  " + rule.rule + ": " + counts + "\n";
  }
  if (!result.advice.empty()) text += "what may help:\n";
  for (const Advice& advice : result.advice) text += "  " + advice.words + "\n";
  return text;
}

std::string grasp_title(const ScoredGrasp& grasp, std::size_t rank) {
  return formatted("rank %zu   epsilon %.4f   volume %s   %zu contacts", rank,
                   grasp.trial.epsilon.lower, volume_text(grasp).c_str(),
                   grasp.trial.contacts.size());
}

}  // namespace prehend
