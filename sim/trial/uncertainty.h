// What is not known exactly when a grasp is carried out, as random errors that are the same for all
// grasps.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/base/pose.h"
#include "sim/base/settings.h"
#include "sim/quality/contact.h"

namespace prehend {

struct CompiledScene;

// The defaults are those of an object that a depth camera sees and of a calibrated arm.
struct UncertaintyOptions {
  static constexpr AboutSettings kAbout{
      "UncertaintyOptions",
      "Standard deviations of what is not known when a grasp is carried out: errors that are "
      "normally distributed and independent."};
  int samples = 16;
  double across = 5e-3;
  double along = 5e-3;
  double angle = 0.0524;  // 3 degrees
  double hand = 1e-3;
  double hand_angle = 5e-3;
  double friction = 0.25;
  // Where nothing is known of the object but its shape, and materials by name. Of a centre that is
  // stated, or follows from stated parts, it is kStatedCenter times that; along a long object that
  // is taken as uniform (long_object_of_uniform_mass) kLongCenter times.
  double center_of_mass = 0.05;
};

template <SettingsOf<UncertaintyOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [samples, across, along, angle, hand, hand_angle, friction, center_of_mass] = options;
  visit("samples", samples, kSampleCount, "",
        "Trials with errors of each grasp: more make narrower intervals.");
  visit("across", across, kDistance, "m", "Of the object, along each horizontal axis.");
  visit("along", along, kDistance, "m", "Of the object, along gravity.");
  visit("angle", angle, kAngle, "rad",
        "Of the object, about each axis through its centre of mass.");
  visit("hand", hand, kDistance, "m", "Of the hand, along each axis.");
  visit("hand_angle", hand_angle, kAngle, "rad", "Of the hand, about each axis.");
  visit("friction", friction, kRatio, "",
        "Of the logarithm of each friction coefficient that has none of its own.");
  visit("center_of_mass", center_of_mass, kRatio, "",
        "Of the centre of mass, along each axis, as a part of the object's largest distance from "
        "it; a quarter where the centre is stated, three times along a long object of uniform "
        "mass.");
}

// Who states a centre of mass has found where the object balances, or weighed its parts.
inline constexpr double kStatedCenter = 0.25;
// Of a bar whose one half is twice as dense as the other the centre of mass is off by 1/6 of its
// half length: with the default about as much as the standard deviation.
inline constexpr double kLongCenter = 3.0;

// One set of errors.
struct Perturbation {
  // The object is seen at O and is at C, in the frame O: the hand, which goes where it would for an
  // object at O, is at X_OC.inverse() * X_OH relative to it.
  Pose X_OC = Pose::Identity();
  double friction = 1.0;  // factor of all coefficients
  // The error of which that factor is made, as a part of the standard deviation: coefficients with
  // a deviation of their own (Contact::friction_deviation) follow from it.
  double friction_error = 0.0;
  Vector3 center_of_mass_O = Vector3::Zero();  // shift of it [m]
};

// The contacts with disturbed coefficients.
std::vector<Contact> with_friction_of(const Perturbation& perturbation,
                                      std::vector<Contact> contacts);

// options.samples disturbances of the scene's object. They are quasi-random: spread more evenly
// than random ones, so that fewer are enough. The first n of them do not depend on how many are
// asked for. Errors of the hand are counted as those of the object, which is the same for their
// relative pose up to the small lever of turns. Source of the sequence: an additive recurrence with
// the powers of the generalised golden ratio (Roberts, "The unreasonable effectiveness of
// quasirandom sequences", 2018), shifted by the seed, mapped to the normal distribution by Box and
// Muller 1958.
std::vector<Perturbation> perturbations(const CompiledScene& scene,
                                        const UncertaintyOptions& options, std::uint64_t seed);

}  // namespace prehend
