// The page of hands that others publish: how each was read, and what it grasps.
#pragma once

#include <string>
#include <vector>

namespace prehend::bench {

// What a plan with the hand found on an object.
struct CatalogueGrasps {
  std::string object;
  double epsilon = 0.0;  // of the best grasp, 0: none holds
  double holds = 0.0;    // part of the trials
};

struct CatalogueHand {
  std::string name;
  std::string source;        // who publishes it, and the file there
  std::string refusal = {};  // why it is no hand; empty: it is one, and the rest is known
  int joints = 0;
  int drives = 0;  // degrees of freedom
  int preshapes = 0;
  int notes = 0;                             // on what was assumed or left out
  double aperture = 0.0;                     // of the preshape that opens widest [m]
  double seconds = 0.0;                      // to read the file and derive how the hand grasps
  std::string picture = {};                  // file beside the page; empty: none
  std::vector<CatalogueGrasps> grasps = {};  // of every hand on the same objects
};

// Markdown; `trials`: of each plan.
std::string catalogue_page(const std::vector<CatalogueHand>& hands, int trials);

}  // namespace prehend::bench
