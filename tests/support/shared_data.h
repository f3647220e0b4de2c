// Data that some tests use and that are not part of the repository: where they are, and how a test
// is skipped without them.
#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace prehend::test {

// The path of a file or folder relative to the folder of shared data (PREHEND_SHARED_DIR in CMake).
inline std::filesystem::path shared(const std::string& relative) {
  return std::filesystem::path(PREHEND_SHARED_DIR) / relative;
}

}  // namespace prehend::test

// Ends the test as skipped, naming the missing file or folder.
#define PREHEND_NEEDS_SHARED(relative)                           \
  if (!std::filesystem::exists(prehend::test::shared(relative))) \
  GTEST_SKIP() << "shared data absent: " << prehend::test::shared(relative)
