// What is known of a candidate before its trial, as numbers without a unit: what a model that was
// learnt from earlier trials judges it by (tree_model.h).
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "planner/plan/propose/candidates.h"
#include "sim/scene/compiled_scene.h"
#include "sim/shape/primitive.h"

namespace prehend {

// The meaning of the features. A model made for another number cannot be used.
inline constexpr int kGraspFeaturesVersion = 1;

// Lengths are in units of the opening, the largest width of the candidate's preshape, unless they
// say "of the radius": the largest distance of the object's surface from its centre of mass. So
// features stay the same when object and hand are scaled together, or moved and turned together.
// Directions are the approach, the closing direction, and the lateral one across both. The target
// is the point of the object that the hand is aimed at; "facing" is the cosine between the closing
// (or approach) direction and the inward normal of the surface that a ray meets: 1 is a surface
// that it meets head on, negative one that it meets from inside, and 0 also says that it meets
// none.
//
// Gravity is not among them: epsilon does not depend on it.
inline constexpr std::array<std::string_view, 43> kGraspFeatures = {
    // The primitive: 1 for its kind, the others 0.
    "box", "sphere", "cylinder", "cone", "rim", "bar",
    "axis_approach",       // of a cylinder or a cone: |cosine| of its axis and the approach; else 0
    "axis_closing",        // the same with the closing direction
    "width",               // that the rule closes on
    "primitive_approach",  // size of the primitive along the approach
    "primitive_lateral",   // and along the lateral direction
    "surface_share",       // of the object's surface, which the primitive explains
    // The preshape.
    "opening",         // of the largest opening of the hand
    "least_width",     // the smallest width that the preshape takes
    "depth",           // of the fingers
    "stand_off",       // of the hand before the target; 0: the palm touches
    "spread",          // of the hand's links along the lateral direction, standard deviation
    "finger_lengths",  // largest distance of a link's middle before the palm
    // The target.
    "center_approach",   // from the centre of mass to the target along the approach, of the radius
    "center_closing",    // |the same along the closing direction|
    "center_lateral",    // |the same along the lateral direction|
    "center_line",       // distance of the centre of mass from the line along which the hand closes
    "primitive_offset",  // distance of the target from the primitive's origin
    // How the object is spread: standard deviations of its mass, and what of it is where.
    "mass_approach", "mass_closing", "mass_lateral",
    "before",        // how far the object reaches from the target towards the palm
    "behind",        // and beyond the target
    "closing_most",  // the larger of how far it reaches from the target along the closing direction
    "closing_least",  // and the smaller, against it
    "lateral_most", "lateral_least",
    "radius",  // of the largest opening
    // Where the hand closes: rays from both sides, from half the opening, along the closing
    // direction; through the target, a part of the opening beside it to both sides, and before and
    // behind it.
    "thickness",                                    // between the two surfaces that the rays meet
    "off_middle",                                   // |distance of their middle from the target|
    "facing_least", "facing_most",                  // of the two surfaces
    "side_thickness_least", "side_thickness_most",  // of the lines beside it
    "side_facing",                                  // the least of their four
    "near_facing",                                  // the least of the line nearer to the palm
    "far_facing",                                   // and of the line beyond the target
    // Where the palm comes: a ray along the approach through the target.
    "under_surface",  // how far the target is behind the surface; 0: nothing is before it
};

using GraspFeatures = std::array<float, kGraspFeatures.size()>;

// The names as a list.
std::vector<std::string> grasp_feature_names();

// Computes the features of candidates for one object and hand. What is the same for all candidates
// is computed once. May be shared by threads.
class FeatureMaker {
 public:
  // The scene must outlive it. `primitives` as given to the sequence of proposals.
  FeatureMaker(const CompiledScene& scene, std::vector<Primitive> primitives);

  // A finite number for each of kGraspFeatures; takes some microseconds (eleven rays). `grasp` is a
  // proposal for these primitives and the scene's hand.
  GraspFeatures features(const ProposedGrasp& grasp) const;

 private:
  // Of a preshape: the hand before it closes, as lengths [m].
  struct OpenHand {
    double spread = 0.0;
    double reach = 0.0;
  };

  const CompiledScene* scene_;
  std::vector<Primitive> primitives_;
  std::vector<double> surface_share_;         // per primitive
  std::vector<OpenHand> open_hands_;          // per preshape
  double largest_opening_ = 0.0;              // m
  double radius_ = 0.0;                       // m
  Matrix3 second_moments_ = Matrix3::Zero();  // of the mass, about its centre, for 1 kg [m^2]
};

}  // namespace prehend
