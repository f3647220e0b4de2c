#include "sim/shape/files/gltf_buffers.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"

namespace prehend {
namespace {

TEST(Base64, GivesTheVectorsOfRfc4648) {
  const std::vector<std::pair<std::string, std::string>> vectors{{"", ""},
                                                                 {"Zg==", "f"},
                                                                 {"Zm8=", "fo"},
                                                                 {"Zm9v", "foo"},
                                                                 {"Zm9vYg==", "foob"},
                                                                 {"Zm9vYmE=", "fooba"},
                                                                 {"Zm9vYmFy", "foobar"}};
  for (const auto& [text, bytes] : vectors) EXPECT_EQ(from_base64(text), bytes);
}

TEST(Base64, GivesAllBytesAndNeedsNoPadding) {
  EXPECT_EQ(from_base64("/+8A"), std::string("\xFF\xEF\0", 3));
  EXPECT_EQ(from_base64("Zg"), "f");
  EXPECT_EQ(from_base64("Zm8"), "fo");
}

TEST(Base64, RefusesWhatIsNone) {
  for (const char* text : {"Z", "Zm9vY", "Zm 9v", "Z===", "Zm9v====", "Zm9\xC4", "-_8A"}) {
    EXPECT_THROW(from_base64(text), InputError) << text;
  }
}

TEST(GltfBuffers, LieOneBehindTheOther) {
  const nlohmann::json list = nlohmann::json::parse(R"([{"byteLength": 3},
      {"byteLength": 5, "uri": "data:;base64,Zm9vYmFy"},
      {"byteLength": 0, "uri": "data:x;base64,"}])");
  const GltfBuffers buffers = fetch_gltf_buffers(list, "chunk", ".");
  EXPECT_EQ(buffers.bytes, std::string("chu\0fooba\0\0\0", 12));
  EXPECT_EQ(buffers.starts, (std::vector<std::size_t>{0, 4, 12}));
  EXPECT_EQ(buffers.lengths, (std::vector<std::size_t>{3, 5, 0}));
}

TEST(GltfBuffers, AreRefusedWithAReason) {
  const std::vector<std::pair<std::string, std::string>> bad{
      {R"([{"byteLength": 6}])", "promise 6 bytes, there are 5"},
      {R"([{"byteLength": 4, "uri": "data:;base64,Zm9v"}])", "promise 4 bytes, there are 3"},
      {R"([{"byteLength": 1}, {"byteLength": 1}])", "one has no uri"},
      {R"([{"byteLength": 1, "uri": "data:text/plain,foo"}])", "has data but no base64"},
      {R"([{"byteLength": 1, "uri": "/etc/passwd"}])", "only files *.bin"},
      {R"([{"byteLength": 1, "uri": 7}])", "is not text"},
      {R"([{"byteLength": -1}])", "is not a count"},
      {R"([7])", "one is not an object"}};
  for (const auto& [list, reason] : bad) {
    try {
      fetch_gltf_buffers(nlohmann::json::parse(list), "chunk", ".");
      ADD_FAILURE() << list;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
  }
}

// A list of buffers without a length that name a large file again and again would be read for ever.
TEST(GltfBuffers, AreCountedByWhatIsFetched) {
  const std::filesystem::path folder = testing::TempDir();
  const std::filesystem::path file = folder / "large_buffer.bin";
  std::ofstream(file) << "x";
  std::filesystem::resize_file(file, std::uintmax_t{1} << 29);
  const nlohmann::json one = {{"uri", "large_buffer.bin"}};
  const nlohmann::json list(5, one);
  EXPECT_THROW(fetch_gltf_buffers(list, {}, folder), InputError);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace prehend
