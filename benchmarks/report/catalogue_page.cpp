#include "benchmarks/report/catalogue_page.h"

#include <utility>

#include "benchmarks/report/page_writer.h"
#include "sim/base/formatted.h"

namespace prehend::bench {
namespace {

std::string grasps_text(const CatalogueGrasps& grasps) {
  if (!(grasps.epsilon > 0.0)) return "–";
  return formatted("%.3f, %.0f %%", grasps.epsilon, 100.0 * grasps.holds);
}

std::vector<std::string> row_of(const CatalogueHand& hand, std::size_t objects) {
  std::vector<std::string> row = {hand.name + ": " + hand.source};
  if (!hand.refusal.empty()) {
    row.push_back("refused: " + hand.refusal);
    row.insert(row.end(), objects + 1, "");
    return row;
  }
  row.push_back(formatted("joints: %d, drives: %d, preshapes: %d, notes: %d, %.1f s", hand.joints,
                          hand.drives, hand.preshapes, hand.notes, hand.seconds));
  row.push_back(formatted("%.0f mm", 1e3 * hand.aperture));
  for (const CatalogueGrasps& grasps : hand.grasps) row.push_back(grasps_text(grasps));
  return row;
}

}  // namespace

std::string catalogue_page(const std::vector<CatalogueHand>& hands, int trials) {
  PageWriter page;
  page.heading(1, "Hands that others publish");
  page.paragraph(formatted(
      "Each file as it is published, without a sidecar: how it was read, how far it opens, and of "
      "a "
      "plan of %d trials on each object ε of the best grasp and the part of the trials that hold. "
      "Made by `hands_benchmark --catalogue`; the files are not part of the project.",
      trials));
  std::vector<std::string> headings = {"hand: source", "read as", "opens"};
  std::size_t objects = 0;
  for (const CatalogueHand& hand : hands) {
    if (!hand.refusal.empty() || objects > 0) continue;
    objects = hand.grasps.size();
    for (const CatalogueGrasps& grasps : hand.grasps) headings.push_back(grasps.object);
  }
  std::vector<std::vector<std::string>> rows;
  for (const CatalogueHand& hand : hands) rows.push_back(row_of(hand, objects));
  page.table(headings, rows);
  for (const CatalogueHand& hand : hands) {
    if (hand.picture.empty()) continue;
    page.heading(2, hand.name);
    page.paragraph("![" + hand.name + "](" + hand.picture + ")");
  }
  return std::move(page).files().back().content;
}

}  // namespace prehend::bench
