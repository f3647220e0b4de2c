// Hands with one measure changed, for those who design them.
#pragma once

#include <string>
#include <string_view>

#include "sim/base/named_enum.h"
#include "sim/robot/robot.h"

namespace prehend {

enum class HandMeasure {
  length,   // of a link, from its joint to the next or to its end: a factor
  size,     // of the whole hand: a factor
  lower,    // limit of a degree of freedom [rad or m]
  upper,    // the same
  friction  // of the hand with the object: the coefficient
};

constexpr auto enum_names(HandMeasure /*of*/) {
  return std::to_array<std::string_view>({"length", "size", "lower", "upper", "friction"});
}

// What is varied, and over which values.
struct HandVariation {
  std::string part;  // a link, a degree of freedom; "finger": all links that move; "hand"
  HandMeasure measure = HandMeasure::length;
  double from = 0.0;
  double to = 0.0;
  int count = 5;  // values from `from` to `to`, evenly spread

  std::string name() const;   // "finger.length"
  double value(int i) const;  // of values 0 to count - 1
};

// Of words "finger.length=0.8:1.2" or "finger.length=0.8:1.2:9". Throws InputError of the field
// "--vary" for other words, for fewer than 2 values and more than 100, and for factors that are not
// above 0.
HandVariation hand_variation(const std::string& words);

// The hand with the measure at this value; with the friction it is as it was. A longer link is
// stretched along the line from its joint to the joints that it carries, or to its end, and what it
// carries moves along; masses are forgotten. Openings are derived anew (with_hand), and what the
// hand states of its axes stays. Throws InputError for a part that the hand has not (it lists
// those that it has), for a hand with suction cups or pads whose measures change, for limits that
// exclude each other, and as with_hand.
Robot with_measure(const Robot& hand, const HandVariation& variation, double value);

}  // namespace prehend
