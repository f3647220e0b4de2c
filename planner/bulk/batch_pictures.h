// Pictures of grasps of a batch, chosen at random.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "planner/bulk/batch.h"
#include "planner/bulk/batch_inputs.h"
#include "planner/results/datasets/grasp_set.h"
#include "planner/show/picture/image.h"
#include "sim/base/run_context.h"

namespace prehend {

// A grasp that was drawn by lot.
struct ChosenGrasp {
  std::uint64_t lot = 0;  // the grasps with the smallest lots are shown
  std::size_t part = 0;   // its number in the batch
  GraspSetEntry grasp;
};

// Keeps the grasps with the smallest lots, one a part at most. A part's lot depends on its key
// alone: the same are chosen in whatever order parts are added.
class GraspLottery {
 public:
  explicit GraspLottery(std::size_t places) : places_(places) {}

  // Takes part with one grasp of the set, of those that are stable, or, with `stable` false, of the
  // others.
  void add(std::size_t part, const std::string& key, const GraspSet& set, bool stable);
  void add(const GraspLottery& other);
  // Those with the smallest lots first.
  const std::vector<ChosenGrasp>& chosen() const { return chosen_; }

 private:
  void add(ChosenGrasp grasp);

  std::size_t places_;
  std::vector<ChosenGrasp> chosen_;
};

// A picture and its words.
struct BatchPicture {
  Image image;
  std::string title;
};

// Throws InputError where the part's object cannot be read any more, and Cancelled.
BatchPicture batch_picture(const Batch& batch, const BatchInputs& inputs, const ChosenGrasp& chosen,
                           const RunContext& context = {});

}  // namespace prehend
