// Searches of objects by hands, with what is learnt from and what is compared.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "planner/plan/search_grasps.h"
#include "planner/results/datasets/grasp_set.h"

namespace prehend::bench {

// An object: a mesh file, or a name of the generator (object_generator.h).
struct LearnObject {
  std::string name;
  std::filesystem::path file;  // empty: generated
};

// The mesh files of these folders, in the order of their names, then the generated objects.
std::vector<LearnObject> learn_objects(const std::vector<std::filesystem::path>& folders);

// What a search found.
struct LearnRun {
  std::string object;
  std::string hand;
  std::uint64_t seed = 1;    // of the object's decomposition into primitives
  GraspSet set;              // its trials, with their features where they were wanted
  std::vector<double> best;  // largest epsilon after each trial that counts
};

struct LearnSearch {
  std::uint64_t seed = 1;
  int trials = 800;
  // 0: the object as it is. Others: larger or smaller by up to 1.6, and stretched along each axis
  // by up to 1.35, differently for each number.
  int variant = 0;
  bool follow = true;  // false: only the sequence of proposals, without neighbours of good grasps
  std::optional<LearnedOrder> learned;
  bool features = false;
  int threads = 2;
};

// A search of the object by the hand; nothing where the hand cannot try any grasp of it. Throws
// InputError for a mesh or a hand that cannot be read.
std::optional<LearnRun> run_learn_case(const LearnObject& object, const std::string& hand,
                                       const LearnSearch& search);

// The largest epsilon after each trial of the set that was not blocked.
std::vector<double> best_so_far(const GraspSet& set);

}  // namespace prehend::bench
