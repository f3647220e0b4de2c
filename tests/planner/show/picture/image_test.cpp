#include "planner/show/picture/image.h"

#include <cmath>
#include <csignal>
#include <filesystem>
#include <string>
#include <sys/resource.h>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>
#include <png.h>

#include "planner/show/picture/color.h"
#include "planner/show/picture/label.h"
#include "sim/base/input_error.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

namespace fs = std::filesystem;

Image plain(int width, int height, std::uint8_t value) {
  return {width, height,
          std::vector<std::uint8_t>(
              3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), value)};
}

int red_at(const Image& image, int x, int y) {
  return image.rgb[3 * static_cast<std::size_t>(y * image.width + x)];
}

int dark_pixels(const Image& image) {
  int count = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) count += image.rgb[i] == 0 ? 1 : 0;
  return count;
}

// An empty folder for one test, removed with it.
class PngTest : public ::testing::Test {
 protected:
  PngTest() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) / (std::string("prehend_png_") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~PngTest() override { fs::remove_all(folder_); }

  int files_in_folder() const {
    return static_cast<int>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  fs::path folder_;
};

Image read_png(const fs::path& file) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_file(&png, file.c_str()), 0) << png.message;
  png.format = PNG_FORMAT_RGB;
  Image image{static_cast<int>(png.width), static_cast<int>(png.height), {}};
  image.rgb.resize(PNG_IMAGE_SIZE(png));
  EXPECT_NE(png_image_finish_read(&png, nullptr, image.rgb.data(), 0, nullptr), 0) << png.message;
  return image;
}

std::string write_error(const fs::path& file, const Image& image) {
  try {
    write_png(file, image);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST_F(PngTest, ReadsBackAsWritten) {
  Image image = plain(37, 11, 0);
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    image.rgb[i] = static_cast<std::uint8_t>((i * 73) % 256);
  }
  const fs::path file = folder_ / "picture.png";
  write_png(file, image);
  const Image read = read_png(file);
  EXPECT_EQ(read.width, 37);
  EXPECT_EQ(read.height, 11);
  EXPECT_EQ(read.rgb, image.rgb);
  EXPECT_EQ(files_in_folder(), 1);
}

TEST_F(PngTest, ReplacesAnOlderPicture) {
  const fs::path file = folder_ / "picture.png";
  write_png(file, plain(4, 4, 10));
  write_png(file, plain(5, 3, 20));
  EXPECT_EQ(read_png(file).rgb, plain(5, 3, 20).rgb);
  EXPECT_EQ(files_in_folder(), 1);
}

TEST_F(PngTest, MissingFolderIsAnErrorAndLeavesNothing) {
  const fs::path file = folder_ / "absent" / "picture.png";
  const std::string error = write_error(file, plain(4, 4, 0));
  EXPECT_NE(error.find(file.string()), std::string::npos) << error;
  EXPECT_NE(error.find("No such file or directory"), std::string::npos) << error;
  EXPECT_EQ(files_in_folder(), 0);
}

TEST_F(PngTest, FailedRenameLeavesNoPartialFile) {
  fs::create_directories(folder_ / "taken" / "inside");
  EXPECT_NE(write_error(folder_ / "taken", plain(4, 4, 0)), "");
  EXPECT_EQ(files_in_folder(), 1);
}

TEST_F(PngTest, FailedWriteKeepsTheOlderPicture) {
  const fs::path file = folder_ / "picture.png";
  write_png(file, plain(4, 4, 10));
  Image torn = plain(4, 4, 20);
  torn.rgb.pop_back();
  EXPECT_NE(write_error(file, torn).find("4 x 4, 47 bytes"), std::string::npos);
  EXPECT_NE(write_error(file, Image{}).find("0 x 0"), std::string::npos);
  EXPECT_EQ(read_png(file).rgb, plain(4, 4, 10).rgb);
}

// A file that may not grow is as good as a full disk: libpng or the closing must notice.
TEST_F(PngTest, FullDiskIsAnError) {
  const auto earlier_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit earlier{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &earlier), 0);
  const rlimit small{100, earlier.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  EXPECT_THROW(write_png(folder_ / "picture.png", plain(600, 600, 7)), std::exception);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &earlier), 0);
  std::signal(SIGXFSZ, earlier_handler);
  EXPECT_EQ(files_in_folder(), 0);
}

TEST(GridTest, PutsImagesInReadingOrder) {
  const Image whole = grid({plain(2, 3, 10), plain(2, 3, 20), plain(2, 3, 30)}, 2);
  ASSERT_EQ(whole.width, 4);
  ASSERT_EQ(whole.height, 6);
  EXPECT_EQ(red_at(whole, 1, 2), 10);
  EXPECT_EQ(red_at(whole, 2, 0), 20);
  EXPECT_EQ(red_at(whole, 0, 5), 30);
  EXPECT_EQ(red_at(whole, 3, 5), 255);  // no fourth image
}

TEST(GridTest, CentersSmallerImages) {
  const Image whole = grid({plain(6, 6, 10), plain(2, 4, 20)}, 5);
  ASSERT_EQ(whole.width, 12);
  ASSERT_EQ(whole.height, 6);
  EXPECT_EQ(red_at(whole, 7, 1), 255);
  EXPECT_EQ(red_at(whole, 8, 0), 255);
  EXPECT_EQ(red_at(whole, 8, 1), 20);
  EXPECT_EQ(red_at(whole, 9, 4), 20);
  EXPECT_EQ(red_at(whole, 10, 4), 255);
}

TEST(GridTest, OfNothingIsEmptyAndOfNoColumnsAnError) {
  EXPECT_TRUE(grid({}, 3).rgb.empty());
  const InputError error = test::refusal_of([] { grid({plain(1, 1, 0)}, 0); });
  EXPECT_EQ(error.field(), "columns");
  EXPECT_EQ(error.value(), "0");
}

TEST(LabelTest, DrawsTheDotsOfALetterAtScale) {
  Image image = plain(20, 20, 255);
  label(image, 2, 3, "-", {0, 0, 0, 1}, 2);  // one row of five dots, the fourth from the top
  EXPECT_EQ(dark_pixels(image), 5 * 2 * 2);
  EXPECT_EQ(red_at(image, 2, 3 + 6), 0);
  EXPECT_EQ(red_at(image, 11, 3 + 7), 0);
  EXPECT_EQ(red_at(image, 12, 3 + 7), 255);
}

TEST(LabelTest, EveryPrintableLetterButTheSpaceIsDistinct) {
  std::vector<std::vector<std::uint8_t>> seen;
  for (char letter = '!'; letter <= '~'; ++letter) {
    Image image = plain(6, 8, 255);
    label(image, 0, 0, std::string(1, letter), {0, 0, 0, 1}, 1);
    EXPECT_GT(dark_pixels(image), 0) << letter;
    for (const auto& other : seen) EXPECT_NE(image.rgb, other) << letter;
    seen.push_back(image.rgb);
  }
}

TEST(LabelTest, OtherBytesShowAsABox) {
  Image box = plain(6, 8, 255);
  label(box, 0, 0, "\x7f", {0, 0, 0, 1}, 1);
  Image other = plain(6, 8, 255);
  label(other, 0, 0, "\xe9", {0, 0, 0, 1}, 1);
  EXPECT_EQ(other.rgb, box.rgb);
  EXPECT_EQ(dark_pixels(box), 2 * 5 + 2 * 5);
}

TEST(LabelTest, IsCutOffAtTheEdges) {
  Image image = plain(10, 10, 255);
  label(image, -3, -3, "########\n########", {0, 0, 0, 1}, 3);
  EXPECT_GT(dark_pixels(image), 0);
  Image untouched = plain(10, 10, 255);
  label(untouched, 500, -500, "###", {0, 0, 0, 1}, 3);
  EXPECT_EQ(dark_pixels(untouched), 0);
}

TEST(LabelTest, SizeIsTheRoomTheTextTakes) {
  EXPECT_EQ(text_size("", 2).width, 0);
  EXPECT_EQ(text_size("", 2).height, 0);
  EXPECT_EQ(text_size("ab", 2).width, 2 * 11);
  EXPECT_EQ(text_size("ab", 2).height, 2 * 8);
  EXPECT_EQ(text_size("ab\nabc", 1).width, 17);
  EXPECT_EQ(text_size("ab\nabc", 1).height, 19);
}

TEST(ColorTest, EveryByteSurvivesTheWayThroughLight) {
  for (int i = 0; i < 256; ++i) {
    const double part = i / 255.0;
    EXPECT_EQ(display_byte(light_of({part, 0, 0, 1})[0]), i);
  }
}

TEST(ColorTest, OutOfRangeIsClamped) {
  const Light light = light_of({-1.0, 2.0, std::nan(""), 1.0});
  EXPECT_EQ(light[0], 0.0F);
  EXPECT_EQ(light[1], 1.0F);
  EXPECT_EQ(light[2], 0.0F);
  EXPECT_EQ(display_byte(-0.5F), 0);
  EXPECT_EQ(display_byte(3.0F), 255);
  EXPECT_EQ(display_byte(std::nanf("")), 0);
}

}  // namespace
}  // namespace prehend
