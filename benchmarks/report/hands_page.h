// The page of a run of all hands on many objects.
#pragma once

#include <string>
#include <vector>

namespace prehend::bench {

// What one plan found.
struct HandOnObject {
  std::string hand;
  std::string object;
  bool of_its_size = false;  // whether the hand's preshapes take the object's smallest extent
  double epsilon = 0.0;      // of the best grasp, 0: none holds
  double seconds = 0.0;      // of the whole plan, on all processors
  int stable = 0;            // trials that hold
  std::string rule;          // that proposed the best grasp
};

// Markdown: for each hand how many of the objects of its size it can grasp, then all plans. Hands
// and objects are in the order in which they first occur.
std::string hands_page(const std::vector<HandOnObject>& plans);

}  // namespace prehend::bench
