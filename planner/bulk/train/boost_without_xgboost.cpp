#include "planner/bulk/train/boost_trees.h"
#include "sim/base/input_error.h"

namespace prehend {
namespace {

[[noreturn]] void refuse() {
  throw InputError(
      "this prehend was built without xgboost: install libxgboost-dev and build it again");
}

}  // namespace

bool can_boost() { return false; }

void require_training() { refuse(); }

BoostedTrees boost_trees(const BoostRows& /*rows*/, const BoostOptions& /*options*/) { refuse(); }

std::vector<float> boosted_predictions(const BoostRows& /*rows*/, const BoostOptions& /*options*/) {
  refuse();
}

}  // namespace prehend
