#include "tests/fuzz/extreme_numbers.h"

#include <algorithm>
#include <regex>
#include <utility>
#include <vector>

namespace prehend::fuzz {
namespace {

struct Place {
  std::size_t at = 0;
  std::size_t size = 0;
};

std::vector<Place> numbers_in(const std::string& text) {
  static const std::regex number(R"([-+]?[0-9]+(\.[0-9]*)?([eE][-+]?[0-9]+)?)");
  std::vector<Place> places;
  for (std::sregex_iterator at(text.begin(), text.end(), number), end; at != end; ++at) {
    const auto from = static_cast<std::size_t>(at->position());
    const auto size = static_cast<std::size_t>(at->length());
    const auto is_word = [&](std::size_t i) {
      return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) != 0 ||
                                 text[i] == '_' || text[i] == '#');
    };
    if ((from > 0 && is_word(from - 1)) || is_word(from + size)) continue;
    places.push_back({from, size});
  }
  return places;
}

}  // namespace

void for_each_extreme(const std::string& text, std::size_t most,
                      const std::function<void(const std::string& changed)>& use) {
  const std::vector<Place> places = numbers_in(text);
  const std::size_t step = std::max<std::size_t>(1, (places.size() + most - 1) / most);
  for (std::size_t i = 0; i < places.size(); i += step) {
    for (const std::string_view extreme : kExtremeNumbers) {
      std::string changed = text;
      use(changed.replace(places[i].at, places[i].size, extreme));
    }
  }
}

}  // namespace prehend::fuzz
