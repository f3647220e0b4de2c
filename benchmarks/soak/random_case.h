// Random tasks for the planner: an object, a hand, sometimes an arm among obstacles, and options.
#pragma once

#include <cstdint>
#include <string>

#include "planner/plan/plan_options.h"
#include "tests/support/judge_grasp.h"

namespace prehend::soak {

struct RandomCase {
  test::KnownScene known;
  PlanOptions options;
  bool twice = false;      // planned on one thread and on two, which must give the same bytes
  std::string words;       // what it is, in one line
  std::uint64_t seed = 0;  // of what remains to be chosen while it runs
};

// Depends on the two numbers alone.
RandomCase random_case(std::uint64_t seed, std::uint64_t number);

}  // namespace prehend::soak
