// What somebody may have meant who misspelt a name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace prehend {

// How many letters have to be put in, left out, replaced or exchanged with their neighbour to make
// one text of the other, where no part is changed twice (optimal string alignment). Bytes count as
// letters.
int edit_distance(std::string_view a, std::string_view b);

// The name with the least distance from `word`, of equal ones the first; empty where more than a
// third of the word's letters, and more than one, would have to be changed.
std::string nearest_name(std::string_view word, const std::vector<std::string>& names);

// "did you mean NAME? " of the nearest name; empty where there is none.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& names);

}  // namespace prehend
