// Epsilon of sets of wrenches in exact arithmetic (tests/support/exact_hull.h), as JSON: see
// README.md. Not part of the build.
#include "tests/support/exact_hull.h"

#include <cstdio>
#include <cstdlib>
#include <ios>
#include <iostream>
#include <string>

namespace {

using namespace prehend::test;  // NOLINT(google-build-using-namespace): a program of its own

exact::Columns read_columns(std::istream& in, int count) {
  exact::Columns columns(6, count);
  for (int j = 0; j < count; ++j) {
    for (int i = 0; i < 6; ++i) {
      std::string text;
      in >> text;
      columns(i, j) = std::strtod(text.c_str(), nullptr);
    }
  }
  return columns;
}

std::string decimal(const exact::Real& value) {
  return value == 0 ? "0" : value.str(19, std::ios::scientific);
}

}  // namespace

int main() {
  std::string name;
  const char* separator = "[\n";
  while (std::getline(std::cin >> std::ws, name)) {
    int count = 0;
    std::cin >> count;
    std::cerr << name << std::flush;
    const exact::Epsilon answer = exact::epsilon(read_columns(std::cin, count), {.whole = 64});
    std::cerr << ": " << answer.points << " points, " << answer.facets << " facets, "
              << decimal(answer.lower) << "\n";
    std::printf(
        "%s  {\"name\": \"%s\", \"force_closure\": %s, \"epsilon\": \"%s\", \"upper\": \"%s\",\n"
        "   \"dimension\": %d, \"points\": %zu, \"points_used\": %zu, \"facets\": %zu}",
        separator, name.c_str(), answer.force_closure ? "true" : "false",
        decimal(answer.lower).c_str(), decimal(answer.upper).c_str(), answer.dimension,
        answer.points, answer.corners, answer.facets);
    std::fflush(stdout);
    separator = ",\n";
  }
  std::printf("\n]\n");
}
