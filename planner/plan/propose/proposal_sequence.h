// The order in which candidates are tried: coarse to fine, without end, and none twice.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "planner/plan/propose/candidates.h"
#include "planner/plan/propose/grasp_rules.h"
#include "planner/plan/propose/pose_set.h"

namespace prehend {

struct CompiledScene;

// Combines every rule of every primitive with every preshape whose range of widths includes the
// width that the rule closes on, and with two depths: the hand's origin aimed at the target, so
// that the palm moves on until it touches, and stopping short by Preshape::depth, so that the
// target is between the fingertips. Each combination is a way to grasp, which leaves the freedoms
// of its rule open.
//
// The values of all freedoms form a grid that is refined from level to level. The sequence is all
// points of the coarsest grid, of all ways, then all that the next level adds, and so on, without
// those that CandidateOptions::approach does not allow, and those that would close on a region to
// keep out of. Where the approach allows no point of a way, there is no such way. Within a level it
// jumps by the golden section, so that any beginning of it is spread over all ways. The same
// arguments give the same sequence.
//
// For hands with suction cups the rules are suction_rules.h, and the only depth is one at which the
// hand moves on until a lip touches.
//
// There are two such sequences, of the solids and of the curves (rims and bars) among the
// primitives, so that a search can turn to the curves where the solids serve badly.
enum class Track { solids, curves };

class ProposalSequence {
 public:
  // The scene must outlive the sequence.
  ProposalSequence(const CompiledScene& scene, const std::vector<Primitive>& primitives,
                   const CandidateOptions& options);

  // The next grasp of a track; nothing where no rule of it has a width that a preshape takes.
  std::optional<ProposedGrasp> next(Track track);

  // What was not proposed yet beside `grasp`: the nearest points of the next level in each freedom,
  // and the same with another preshape or the other depth. next() will leave them out.
  std::vector<ProposedGrasp> beside(const ProposedGrasp& grasp);

  // Counts a grasp that another sequence of the same arguments proposed as proposed by this one;
  // false where this one had proposed it before, or the same (CandidateOptions).
  bool mark_proposed(const ProposedGrasp& grasp);

  // The track that proposed it.
  Track track_of(const ProposedGrasp& grasp) const;

  int families() const { return static_cast<int>(ways_.size()); }
  double smallest_width() const { return smallest_width_; }  // as in Proposals
  double largest_opening() const { return largest_opening_; }

 private:
  // A rule with a preshape and a depth.
  struct Way {
    int primitive = 0;
    int rule = 0;  // index into rules_
    int preshape = 0;
    double stand_off = 0.0;  // how far the hand's origin stops short of the target [m]
  };

  void add_ways(std::vector<GraspRule> rules, int number);
  // The place in the sequence of one track.
  struct Progress {
    std::vector<std::size_t> families;  // numbers of its ways
    PoseSet known;
    int level = 0;
    std::vector<std::size_t> first_point =
        {};  // per way, of its points at this level; and their number
    std::size_t stride = 1;
    std::size_t place = 0;   // in the level, in steps of the stride
    std::size_t passed = 0;  // points of the level so far
  };

  Progress& progress(Track track) { return progress_[static_cast<std::size_t>(track)]; }
  Progress& progress_of(const Way& way);
  void begin_level(Progress& track, int level);
  std::optional<ProposedGrasp> at(std::size_t way, std::size_t point, int level);
  std::optional<ProposedGrasp> proposed(std::size_t number, std::vector<double> choices, int level);

  const CompiledScene* scene_;
  CandidateOptions options_;
  std::vector<double> reach_;  // of the hand at each preshape, beyond its origin [m]
  std::vector<GraspRule> rules_;
  std::vector<Way> ways_;
  double smallest_width_ = 0.0;
  double largest_opening_ = 0.0;
  std::vector<bool> is_curve_;  // per primitive
  std::array<Progress, 2> progress_;
};

}  // namespace prehend
