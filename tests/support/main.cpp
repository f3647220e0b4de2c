// main() of all test programs. Each run gets a temporary folder of its own, because ctest runs
// several at the same time; it is removed at the end.
#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

int main(int argc, char** argv) {
  std::string folder = (std::filesystem::temp_directory_path() / "prehend_test_XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr) return EXIT_FAILURE;
  setenv("TEST_TMPDIR", folder.c_str(), 1);  // testing::TempDir() returns this folder
  testing::InitGoogleTest(&argc, argv);
  const int status = RUN_ALL_TESTS();
  std::error_code ignored;
  std::filesystem::remove_all(folder, ignored);
  return status;
}
