// What the fuzz targets do, with the files of tests/corpus. Names begin with good_ where a file is
// to be read, with bad_ where it is to be refused.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/input_file.h"
#include "tests/fuzz/untrusted_files.h"

namespace prehend::fuzz {
namespace {

std::filesystem::path corpus_folder() {
  return std::filesystem::path(PREHEND_SOURCE_DIR) / "tests/corpus";
}

std::vector<std::filesystem::path> corpus_of(const FileKind& kind) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(corpus_folder() / kind.name)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

class Corpus : public testing::TestWithParam<FileKind> {};

TEST_P(Corpus, IsReadOrRefusedAsItsNamesSay) {
  int good = 0;
  int bad = 0;
  for (const std::filesystem::path& file : corpus_of(GetParam())) {
    SCOPED_TRACE(file.string());
    const std::string name = file.filename().string();
    std::string why;
    EXPECT_NO_THROW(why = refusal(GetParam(), read_file(file)));
    good += int{name.starts_with("good_")};
    bad += int{name.starts_with("bad_")};
    EXPECT_EQ(why.empty(), name.starts_with("good_")) << why;
    EXPECT_TRUE(name.starts_with("good_") || name.starts_with("bad_"));
  }
  EXPECT_GT(good, 0);
  EXPECT_GT(bad, 0);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Corpus, testing::ValuesIn(file_kinds().begin(), file_kinds().end()),
                         [](const auto& kind) { return std::string(kind.param.name); });

TEST(Corpora, HaveNoFolderThatNoReaderReads) {
  for (const auto& entry : std::filesystem::directory_iterator(corpus_folder())) {
    EXPECT_NO_THROW((void)file_kind(entry.path().filename().string())) << entry.path();
  }
}

}  // namespace
}  // namespace prehend::fuzz
