#include "benchmarks/report/peers.h"

#include <array>

#include "benchmarks/report/names.h"
#include "benchmarks/report/page_parts.h"
#include "sim/base/formatted.h"

namespace prehend::bench {
namespace {

constexpr const char* kGraspIt = "GraspIt!";
constexpr const char* kGraspItSource = "built and run by us: commit 83a6d4c (2020), one thread";
constexpr const char* kSimox = "Simox / GraspStudio";
constexpr const char* kSimoxSource = "built and run by us: commit 14f4056 (2025), one thread";
constexpr const char* kPublished = "published by its authors";

constexpr std::array<PeerFigure, 12> kFigures = {{
    {kGraspIt, "one pre-grasp to ε, Barrett hand on a mug", "26 ms, mean", kGraspItSource,
     "trials/trial in contact/barrett, mug"},
    {kGraspIt, "candidates a second, Barrett hand on a mug, up to 20 back-offs each", "8.1",
     kGraspItSource, "trials/trials a second/barrett, mug"},
    {kGraspIt, "hull of wrenches at the end of a trial", "11.2 ms, mean", kGraspItSource,
     "kernels/call/ε, 8 contacts"},
    {kGraspIt, "distance from the palm to an object", "270 to 1,400 µs", kGraspItSource,
     "kernels/call/mesh distance, 10 mm apart"},
    {kGraspIt, "best ε, Barrett hand on a mug, 752 candidates in 86 s", "0.155", kGraspItSource,
     ""},
    {kSimox, "candidates a second, 4 hands and 5 objects", "72 to 202", kSimoxSource,
     "trials/trials a second/barrett, mug"},
    {kSimox, "hull of wrenches, 8 contacts, 8 edges", "6.8 ms", kSimoxSource,
     "kernels/call/hull of wrenches by qhull, 8 contacts"},
    {kSimox, "the same, for ε alone: ours needs no hull", "6.8 ms", kSimoxSource,
     "kernels/call/ε, 8 contacts"},
    {kSimox, "path of 10 degrees of freedom by BiRRT", "44 ms, mean", kSimoxSource,
     "trials/path with its check/living_room"},
    {kSimox, "inverse kinematics of a set of grasps, and RRT", "10.6 ms", kSimoxSource,
     "trials/path with its check/shelf"},
    {"BODex", "grasps a second that work, one A100 GPU; no arm, no obstacles, no approach",
     "30 to 50", kPublished, "trials/holding grasps a second/barrett, mug"},
    {"Lightning Grasp",
     "grasps a second that work, one A100 GPU; no arm, no obstacles, no approach", "300 to 1,000",
     kPublished, "trials/holding grasps a second/barrett, mug"},
}};

}  // namespace

std::span<const PeerFigure> peer_figures() { return kFigures; }

void add_peers(const Results& results, PageWriter& page) {
  if (results.entries.empty()) return;
  page.heading(2, "Other planners");
  page.paragraph(
      "**Measured elsewhere**, on other runs than this one: where it says so, by us on a machine "
      "with 2 cores and Debian 12, built from public sources with -O2 or -O3. Objects, hands and "
      "what counts as a candidate or as a grasp that works differ; read these as orders of "
      "magnitude. Ours are of this file; compare a mean with a mean: a few trials "
      "take many times the median.");
  std::vector<std::vector<std::string>> rows;
  for (const PeerFigure& figure : peer_figures()) {
    const Entry* ours = find_entry(results, figure.ours);
    rows.push_back({figure.peer, figure.what, figure.figure, figure.source,
                    ours == nullptr ? "–" : value_text(ours->value.median, ours->unit),
                    ours == nullptr ? "–" : value_text(ours->value.mean, ours->unit),
                    ours == nullptr ? "–" : formatted("`%s`", name_of(*ours).c_str())});
  }
  page.table({"planner", "what", "theirs", "source", "ours: median", "mean", "entry"}, rows);
}

}  // namespace prehend::bench
