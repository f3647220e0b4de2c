// Deep JSON is refused by the text, before anything recurses into it.
#include "sim/base/json/json_depth.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "sim/base/json/json_field.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

std::filesystem::path written_json(const std::string& name, const std::string& text) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / name;
  std::ofstream(file) << text;
  return file;
}

TEST(JsonDepth, CountsOpenListsAndObjects) {
  EXPECT_EQ(json_depth("1"), 0);
  EXPECT_EQ(json_depth("[]"), 1);
  EXPECT_EQ(json_depth(R"({"a": [1, {"b": 2}], "c": [[]]})"), 3);
  EXPECT_EQ(json_depth(R"(["[[[[", "\"[[[", "\\"])"), 1);
  EXPECT_EQ(json_depth(repeated("[", 100'000)), 100'000);
}

TEST(JsonFile, RefusesDeepNesting) {
  const int deep = 100'000;
  for (const auto& [open, close] : {std::pair<std::string, std::string>{"[", "]"},
                                    std::pair<std::string, std::string>{"{\"a\":", "}"}}) {
    const std::string text = repeated(open, deep) + "1" + repeated(close, deep);
    const auto file = written_json("deep.json", text);
    const InputError error = test::refusal_of([&] { JsonFile{file}; });
    EXPECT_EQ(error.file(), file.string());
    EXPECT_EQ(error.problem(), "must be nested in at most 200 levels");
  }
  const std::string shallow = repeated("[", 200) + repeated("]", 200);
  EXPECT_NO_THROW(JsonFile{written_json("shallow.json", shallow)});
}

TEST(JsonFile, QuotesLittleOfALongValue) {
  const std::string name(1'000'000, 'x');
  const JsonFile file(written_json("long.json", "{\"number\": \"" + name + "\"}"));
  const InputError error = test::refusal_of([&] { (void)file.root()["number"].number(); });
  EXPECT_LE(error.value().size(), 70U);
  const auto broken = written_json("broken.json", "{\"number\": " + name + "}");
  EXPECT_LE(test::refusal_of([&] { JsonFile{broken}; }).problem().size(), 220U);
}

TEST(JsonFile, NamesAFieldWithLineBreaksOnOneLine) {
  const JsonFile file(written_json("break.json", "{\"a\\nb\": 1}"));
  const InputError error = test::refusal_of([&] { file.root().allow_only({"c"}); });
  EXPECT_EQ(error.field(), "a\nb");
  EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
}

}  // namespace
}  // namespace prehend
