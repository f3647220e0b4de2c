#include "planner/bulk/batch_tally.h"

#include <algorithm>
#include <numeric>

namespace prehend {

std::size_t OutcomeCounts::all() const {
  return std::accumulate(of.entries.begin(), of.entries.end(), std::size_t{0});
}

void OutcomeCounts::add(const OutcomeCounts& other) {
  for (const Outcome outcome : kAll<Outcome>) of[outcome] += other.of[outcome];
}

void Histogram::add(double value) {
  const double bin = std::clamp(value / width, 0.0, static_cast<double>(bins.size() - 1));
  ++bins[static_cast<std::size_t>(bin)];
}

void Histogram::add(const Histogram& other) {
  for (std::size_t i = 0; i < bins.size(); ++i) bins[i] += other.bins[i];
}

void BatchTally::add(const std::string& object, const GraspSet& set) {
  OutcomeCounts counts;
  for (const GraspSetEntry& grasp : set.grasps) {
    ++counts.of[grasp.outcome];
    if (grasp.outcome == Outcome::stable) epsilon.add(grasp.epsilon.lower);
    if (!grasp.contacts.empty()) contacts.add(static_cast<double>(grasp.contacts.size()));
  }
  ++sets;
  outcomes.add(counts);
  hands[set.hand].add(counts);
  objects[object].add(counts);
}

void BatchTally::add(const BatchTally& other) {
  sets += other.sets;
  outcomes.add(other.outcomes);
  for (const auto& [name, counts] : other.hands) hands[name].add(counts);
  for (const auto& [name, counts] : other.objects) objects[name].add(counts);
  epsilon.add(other.epsilon);
  contacts.add(other.contacts);
}

void BatchTally::count_shares() {
  std::fill(objects_by_share.bins.begin(), objects_by_share.bins.end(), 0);
  for (const auto& [name, counts] : objects) {
    if (counts.all() == 0) continue;
    objects_by_share.add(static_cast<double>(counts.stable()) / static_cast<double>(counts.all()));
  }
}

}  // namespace prehend
