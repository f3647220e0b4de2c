// What all cases together gave.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "benchmarks/soak/run_case.h"

namespace prehend::soak {

class Tally {
 public:
  void add(std::uint64_t number, const CaseFindings& findings);

  int cases() const { return cases_; }
  int failed() const { return failed_; }  // cases with a fault

  // "120 cases, 0 failed, 345 grasps, 12 paths".
  std::string line() const;

  // The table at the end, with failures by kind and refusals by message.
  std::string table() const;

 private:
  int cases_ = 0;
  int failed_ = 0;
  int without_grasp_ = 0;
  int refused_ = 0;
  CaseFindings sum_;  // counts added up; of differences, times and sizes the largest
  double seconds_ = 0.0;
  std::uint64_t slowest_ = 0;  // number of the case
  std::uint64_t largest_ = 0;
  std::map<std::string, int> kinds_;     // of faults
  std::map<std::string, int> refusals_;  // by message, numbers left out
};

}  // namespace prehend::soak
