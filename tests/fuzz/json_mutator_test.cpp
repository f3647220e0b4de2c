#include "tests/fuzz/json_mutator.h"

#include <set>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/base/input_file.h"

namespace prehend::fuzz {
namespace {

const ChangeText kAppend = [](const std::string& text) { return text + "\xff"; };

TEST(MutatedJson, IsJsonAndTheSameForTheSameSeed) {
  const std::string text = R"({"a": [1, 2.5, "x"], "b": {"c": null, "d": [true]}})";
  std::set<std::string> all;
  for (std::uint32_t seed = 0; seed < 1000; ++seed) {
    const auto changed = mutated_json(text, R"([{"e": 1e9}])", seed, kAppend);
    ASSERT_TRUE(changed.has_value());
    EXPECT_TRUE(nlohmann::json::accept(*changed)) << *changed;
    EXPECT_EQ(changed, mutated_json(text, R"([{"e": 1e9}])", seed, kAppend));
    all.insert(*changed);
  }
  EXPECT_GT(all.size(), 800U);
}

TEST(MutatedJson, IsNothingForTextThatIsNoJsonOrTooDeep) {
  EXPECT_FALSE(mutated_json("{", "", 1, kAppend));
  EXPECT_FALSE(mutated_json("", "", 1, kAppend));
  EXPECT_FALSE(mutated_json(std::string(1000, '[') + std::string(1000, ']'), "", 1, kAppend));
}

TEST(MutatedGlb, StaysOneWithItsDataInPlace) {
  const std::string bytes = read_file(PREHEND_SOURCE_DIR "/tests/corpus/glb/good_tetra.glb");
  const std::string data = bytes.substr(bytes.size() - 72);
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    const auto changed = mutated_glb(bytes, seed, kAppend);
    ASSERT_TRUE(changed.has_value());
    EXPECT_TRUE(changed->starts_with("glTF"));
    EXPECT_TRUE(changed->ends_with(data));
    EXPECT_EQ(changed->size() % 4, 0U);
  }
}

TEST(MutatedGlb, IsNothingForOtherBytes) {
  EXPECT_FALSE(mutated_glb("glTF", 1, kAppend));
  EXPECT_FALSE(mutated_glb(std::string(40, '\xff'), 1, kAppend));
}

}  // namespace
}  // namespace prehend::fuzz
