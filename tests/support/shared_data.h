// Where tests find data that the project does not ship, and how they skip without it.
#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace prehend::test {

inline std::filesystem::path shared(const std::string& relative) {
  return std::filesystem::path(PREHEND_SHARED_DIR) / relative;
}

}  // namespace prehend::test

// Ends the test as skipped, naming the missing file or folder.
#define PREHEND_NEEDS_SHARED(relative)                           \
  if (!std::filesystem::exists(prehend::test::shared(relative))) \
  GTEST_SKIP() << "shared data absent: " << prehend::test::shared(relative)
