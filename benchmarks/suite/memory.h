// How much memory a size takes: measured in a process that does nothing else.
#pragma once

#include <optional>
#include <string>

namespace prehend::bench {

// What was varied, and what was done with it.
struct MemoryCase {
  std::string size;  // "triangles", "candidates" or "obstacles" (names.h)
  int value = 0;
  int trials = 0;  // of "triangles" and "obstacles"
};

// Does it in this process, and returns the most memory that was resident [MB]; 0 where the system
// does not tell. Throws InputError for an unknown size.
double memory_here(const MemoryCase& what);

// Has `program` do it in a process of its own ("PROGRAM memory SIZE VALUE TRIALS"). Nothing where
// that failed, or the system does not tell.
std::optional<double> memory_elsewhere(const std::string& program, const MemoryCase& what);

}  // namespace prehend::bench
