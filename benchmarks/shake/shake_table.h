// The table of who survives: a line for each scene and protocol, and what it adds up to.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "benchmarks/shake/opinions.h"

namespace prehend::bench {

// What a simulator says of the grasps of a line.
struct OpinionTally {
  int survived = 0;
  double seconds = 0.0;  // of a processor, for all grasps together
  double steps = 0.0;
  std::vector<int> failures =
      std::vector<int>(kAll<PhaseFailure>.size(), 0);  // tests, by PhaseFailure

  void add(const ShakeResult& result, double processor_seconds);
};

struct ShakeTally {
  int grasps = 0;
  OpinionTally ours;
  OpinionTally theirs;
  int agreed = 0;
};

class ShakeTable {
 public:
  // `explain`: whether the cause of each disagreement is searched.
  explicit ShakeTable(bool explain) : explain_(explain) {}

  static void print_head();
  // Carries out the protocol on all grasps and prints its line, then one for each grasp on which
  // the simulators do not agree.
  void add(const ShakeCase& shaken, const TestProcedure& procedure);
  // Sums over the scenes by hand and protocol, and how often each cause was found.
  void print_sums() const;

 private:
  std::string disagreement(const ShakeCase& shaken, const ShakenGrasp& grasp,
                           const TestProcedure& procedure, const ShakeResult& ours,
                           const ShakeResult& theirs);

  bool explain_ = true;
  std::map<std::string, ShakeTally> sums_;  // by "hand protocol"
  std::map<std::string, int> causes_;
};

}  // namespace prehend::bench
