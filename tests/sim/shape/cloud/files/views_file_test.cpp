// Files of depth images with their cameras, and what is refused of them.
#include "sim/shape/cloud/files/views_file.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/sim/shape/cloud/files/written_cloud.h"
#include "tests/support/depth_images.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

namespace fs = std::filesystem;
using test::refusal_of;

const DepthCamera kSmall = test::camera_at({0.5, -0.3, 0.6}, {0.0, 0.0, 0.0}, {40, 30, 37.0});

class ViewsFile : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    test::write_png(folder_ / "a.png", view_);
  }

  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  std::string why(const std::string& text) const {
    const fs::path file = write("in.json", text);
    const InputError error = refusal_of([&] { load_views(file); });
    std::string message = error.what();
    const std::string place = folder_.string() + "/";
    for (std::size_t at = message.find(place); at != std::string::npos; at = message.find(place)) {
      message.erase(at, place.size());
    }
    return message;
  }

  fs::path folder_ = fs::path(testing::TempDir()) / "views_file";
  DepthView view_ = test::view_of({{}}, kSmall);
  std::string camera_ = test::camera_json(kSmall);
};

void expect_same(const DepthView& view, const DepthView& wanted) {
  EXPECT_EQ(view.camera.fx, wanted.camera.fx);
  EXPECT_EQ(view.camera.cy, wanted.camera.cy);
  EXPECT_EQ(view.camera.width, wanted.camera.width);
  EXPECT_TRUE(view.camera.X_WC.isApprox(wanted.camera.X_WC));
  ASSERT_EQ(view.depth.size(), wanted.depth.size());
  for (std::size_t i = 0; i < view.depth.size(); ++i) {
    EXPECT_NEAR(view.depth[i], wanted.depth[i], 0.5e-4 + 1e-6) << i;  // half a count
  }
}

TEST_F(ViewsFile, AnImageWithItsCamera) {
  const std::string entry = R"({"depth": "a.png", "camera": )" + camera_ + "}";
  const ViewsInput one = load_views(write("one.json", entry));
  ASSERT_EQ(one.views.size(), 1U);
  expect_same(one.views[0], view_);
  const ViewsInput two = load_views(write(
      "two.json", R"({"voxel": 0.004, "plane": false, "views": [)" + entry + "," + entry + "]}"));
  ASSERT_EQ(two.views.size(), 2U);
  expect_same(two.views[1], view_);
  EXPECT_EQ(two.steps.voxel, 0.004);
  EXPECT_FALSE(two.steps.find_plane);
  EXPECT_TRUE(two.steps.drop_outliers);
}

TEST_F(ViewsFile, ACameraInAFileOfItsOwn) {
  write("camera.json", camera_);
  expect_same(
      load_views(write("in.json", R"({"depth": "a.png", "camera": "camera.json"})")).views[0],
      view_);
  write("a.json", camera_);
  expect_same(load_views(folder_ / "a.png").views[0], view_);
}

TEST_F(ViewsFile, AUnitBesideTheImageCounts) {
  const ViewsInput larger = load_views(
      write("in.json", R"({"depth": "a.png", "unit": 0.0002, "camera": )" + camera_ + "}"));
  EXPECT_NEAR(larger.views[0].depth.back(), 2.0F * view_.depth.back(), 1e-3);
}

TEST_F(ViewsFile, CloudsByThemselvesAndInJson) {
  std::vector<Vector3> points = test::points_of(view_);
  for (Vector3& p : points) p *= 1000.0;
  write("a.pcd",
        test::pcd_file(test::columns_of(points), "binary_compressed", 0, "500 -300 600 1 0 0 0"));
  write("a.ply", test::ply_file(test::columns_of(points), "binary_big_endian"));
  EXPECT_EQ(load_views(folder_ / "a.pcd", "mm").views.size(), 1U);
  const ViewsInput input = load_views(write(
      "in.json",
      R"({"cloud": "a.ply", "unit": "mm", "viewpoint": [0.5, -0.3, 0.6], "pose": {"position": [0, 0, 1]}})"));
  ASSERT_EQ(input.views.size(), 1U);
  EXPECT_TRUE(input.views[0].camera.X_WC.translation().isApprox(Vector3(0.5, -0.3, 1.6)));
  EXPECT_EQ(input.notes.size(), 0U);
  EXPECT_EQ(std::string(refusal_of([&] { load_views(folder_ / "a.pcd"); }).what())
                .find(folder_.string() + "/a.pcd: unit: distances look like millimetres"),
            0U);
}

TEST_F(ViewsFile, WhichFilesAreViews) {
  EXPECT_TRUE(is_views_file(folder_ / "a.png"));
  EXPECT_TRUE(is_views_file(write("one.json", R"({"depth": "a.png"})")));
  EXPECT_FALSE(is_views_file(write("two.json", R"({"object": {"generate": "mug"}})")));
  EXPECT_TRUE(
      is_views_file(write("a.ply", test::ply_file(test::columns_of({{1, 2, 3}}), "ascii"))));
  EXPECT_FALSE(is_views_file(
      write("b.ply", "ply\nformat ascii 1.0\nelement vertex 1\nelement face 1\nend_header\n")));
  EXPECT_FALSE(is_views_file(folder_ / "none.json"));
}

TEST_F(ViewsFile, WrongCamerasAreRefused) {
  const auto with = [&](const std::string& what, const std::string& by) {
    std::string camera = camera_;
    camera.replace(camera.find(what), what.size(), by);
    return R"({"depth": "a.png", "camera": )" + camera + "}";
  };
  EXPECT_EQ(why(with("\"fx\": 37", "\"fx\": 0")),
            "in.json: camera.fx: must be above 0 and at most 1e6 (0)");
  EXPECT_EQ(why(with("\"fy\": 37", "\"fy\": -37")),
            "in.json: camera.fy: must be above 0 and at most 1e6 (-37)");
  EXPECT_EQ(why(with("\"cx\": 19.5", "\"cx\": 400")),
            "in.json: camera.cx: is far outside the image, which has 40 pixels there (400)");
  EXPECT_EQ(why(with("\"width\": 40", "\"width\": 640")),
            "in.json: camera.width: the image has another size: 40 (640)");
  EXPECT_EQ(
      why(with("\"fx\"", "\"focal\"")),
      "in.json: camera.focal: unknown field, known here are fx, fy, cx, cy, width, height, pose, "
      "unit (37)");
  EXPECT_EQ(why(with("0.0001", "0.1")).find("in.json: unit: distances look like millimetres"), 0U);
  EXPECT_EQ(why(R"({"depth": "a.png"})"), "in.json: camera: must be given");
  EXPECT_EQ(why(R"({"depth": "a.png", "cloud": "a.pcd"})"),
            "in.json: needs either a depth image or a cloud "
            "({\"cloud\":\"a.pcd\",\"depth\":\"a.png\"})");
  EXPECT_EQ(why(R"({"views": []})"), "in.json: views: must have at least one view ([])");
  EXPECT_EQ(why(R"({"voxel": 3, "depth": "a.png", "camera": {}})"),
            "in.json: voxel: must be at least 0.0005 and at most 0.05 (3)");
  fs::copy_file(folder_ / "a.png", folder_ / "b.png");
  EXPECT_EQ(std::string(refusal_of([&] { load_views(folder_ / "b.png"); }).what()),
            folder_.string() +
                "/b.png: no camera: a JSON file beside it must state fx, fy, cx, cy (b.json)");
}

TEST_F(ViewsFile, OtherImagesAreRefused) {
  const std::string entry = R"({"depth": "b.png", "camera": )" + camera_ + "}";
  const std::vector<std::uint16_t> counts(1200, 1000);
  test::write_png(folder_ / "b.png", 40, 30, counts, 8);
  EXPECT_EQ(why(entry), "b.png: must be a 16-bit grey image, whose counts are depths (8-bit grey)");
  test::write_png(folder_ / "b.png", 40, 30, counts, 16, PNG_COLOR_TYPE_RGB);
  EXPECT_EQ(why(entry),
            "b.png: must be a 16-bit grey image, whose counts are depths (16-bit colour)");
  test::write_png(folder_ / "b.png", 40, 30, std::vector<std::uint16_t>(1200, 0));
  EXPECT_EQ(why(entry), "in.json: only 0 readings; at least 10 are needed");
  write("b.png", "no image");
  EXPECT_EQ(why(entry), "b.png: no PNG image, or damaged: Not a PNG file");
  std::ifstream whole(folder_ / "a.png", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(whole), {}};
  for (std::size_t length = 1; length < bytes.size() - 12; length += 7) {
    write("b.png", bytes.substr(0, length));
    EXPECT_EQ(why(entry).find("b.png: no PNG image, or damaged: "), 0U) << length;
  }
}

}  // namespace
}  // namespace prehend
