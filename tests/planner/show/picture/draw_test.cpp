#include "planner/show/picture/draw.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "planner/show/picture/marks.h"
#include "planner/show/picture/surface_detail.h"
#include "sim/base/input_error.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

using Bytes = std::array<int, 3>;

constexpr Color kOrange = {0.8, 0.4, 0.2, 1.0};
constexpr Color kBlue = {0.2, 0.2, 1.0, 1.0};

Bytes at(const Image& image, int x, int y) {
  const auto i = 3 * static_cast<std::size_t>(y * image.width + x);
  return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
}

Bytes bytes(const Light& light) {
  return {display_byte(light[0]), display_byte(light[1]), display_byte(light[2])};
}

Bytes bytes(const Color& color) { return bytes(light_of(color)); }

Light mixed(const Light& over, double opacity, const Light& under) {
  Light light{};
  for (std::size_t k = 0; k < 3; ++k) {
    light[k] = static_cast<float>(opacity * static_cast<double>(over[k]) +
                                  (1.0 - opacity) * static_cast<double>(under[k]));
  }
  return light;
}

// Light under which every surface shows its own color, and no lines.
DrawOptions flat_options() {
  return {.width = 40,
          .height = 40,
          .lighting = {.sky = 1.0, .ground = 1.0, .key = 0.0, .fill = 0.0, .gloss = 0.0},
          .line_width = 0.0};
}

// Looks down at the origin from height 4; 20 pixels a metre in the plane z = 0.
Camera camera_above() {
  return {.eye = Vector3(0, 0, 4),
          .target = Vector3::Zero(),
          .up = Vector3::UnitY(),
          .vertical_field_of_view = 2.0 * std::atan(0.25)};
}

// The square |x| <= half, |y| <= half, z = 0, with its front to +z.
TriangleMesh square(double half) {
  return {{Vector3(-half, -half, 0), Vector3(half, -half, 0), Vector3(half, half, 0),
           Vector3(-half, half, 0)},
          {{0, 1, 2}, {0, 2, 3}}};
}

TriangleMesh box(double half) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back((i & 1) != 0 ? half : -half, (i & 2) != 0 ? half : -half,
                               (i & 4) != 0 ? half : -half);
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

double volume(const TriangleMesh& mesh) {
  double sixfold = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    sixfold += mesh.vertices[static_cast<std::size_t>(mesh.triangles[t][0])].dot(
        doubled_area_vector(mesh, t));
  }
  return sixfold / 6.0;
}

// Each directed edge occurs once, and once the other way round.
bool closed(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> count;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++count[{t[k], t[(k + 1) % 3]}];
  }
  return std::all_of(count.begin(), count.end(), [&](const auto& edge) {
    return edge.second == 1 && count.contains({edge.first.second, edge.first.first});
  });
}

template <typename Function>
std::string error_of(Function function) {
  try {
    function();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(DrawTest, FacingSquareCoversItsPixelsInItsColor) {
  const Image image =
      draw({{square(0.5), Pose::Identity(), kOrange}}, camera_above(), flat_options());
  ASSERT_EQ(image.rgb.size(), 3U * 40U * 40U);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      const bool inside = x >= 10 && x < 30 && y >= 10 && y < 30;
      ASSERT_EQ(at(image, x, y), (inside ? Bytes{204, 102, 51} : Bytes{255, 255, 255}))
          << x << ", " << y;
    }
  }
}

TEST(DrawTest, RightIsRightAndUpIsUp) {
  const DrawnBody body{square(0.1), translation(Vector3(0.5, 0.75, 0)), kOrange};
  const Image image = draw({body}, camera_above(), flat_options());
  EXPECT_EQ(at(image, 30, 5), bytes(kOrange));
  EXPECT_EQ(at(image, 10, 5), bytes(Color{1, 1, 1, 1}));
  EXPECT_EQ(at(image, 30, 35), bytes(Color{1, 1, 1, 1}));
}

// A border through the middle of a column of pixels covers half of their samples.
TEST(DrawTest, PartlyCoveredPixelsAreAveragedAsLight) {
  for (const int samples : {2, 4, 8}) {
    DrawOptions options = flat_options();
    options.samples = samples;
    const DrawnBody body{square(0.5), translation(Vector3(0.025, 0, 0)), kOrange};
    const Image image = draw({body}, camera_above(), options);
    const Bytes half = bytes(mixed(light_of(kOrange), 0.5, {1, 1, 1}));
    EXPECT_EQ(at(image, 10, 20), half) << samples;
    EXPECT_EQ(at(image, 30, 20), half) << samples;
  }
}

TEST(DrawTest, NearerBodyHidesFartherInEitherOrder) {
  const DrawnBody near{square(0.25), translation(Vector3(0, 0, 0.01)), kOrange};
  const DrawnBody far{square(0.5), Pose::Identity(), kBlue};
  for (const auto& bodies : {std::vector{near, far}, std::vector{far, near}}) {
    const Image image = draw(bodies, camera_above(), flat_options());
    EXPECT_EQ(at(image, 20, 20), bytes(kOrange));
    EXPECT_EQ(at(image, 12, 20), bytes(kBlue));
  }
}

TEST(DrawTest, SurfacesThatCrossAreHiddenPixelByPixel) {
  const Pose tilt(Eigen::AngleAxisd(0.5, Vector3::UnitY()));  // lowers the right side
  const Image image = draw({{square(0.5), tilt, kOrange}, {square(0.5), Pose::Identity(), kBlue}},
                           camera_above(), flat_options());
  EXPECT_EQ(at(image, 15, 20), bytes(kOrange));
  EXPECT_EQ(at(image, 25, 20), bytes(kBlue));
}

// Opacity is exact only along the normal; at the center it is within half a byte of that.
void expect_near(const Bytes& a, const Bytes& b) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 1);
}

TEST(DrawTest, TranslucentBlendsOverSolid) {
  const double opacity = 0.3;
  const DrawnBody veil{square(0.5), translation(Vector3(0, 0, 0.1)), {1.0, 0.0, 0.0, opacity}};
  const DrawnBody wall{square(0.25), Pose::Identity(), kBlue};
  for (const auto& bodies : {std::vector{veil, wall}, std::vector{wall, veil}}) {
    const Image image = draw(bodies, camera_above(), flat_options());
    expect_near(at(image, 20, 20), bytes(mixed({1, 0, 0}, opacity, light_of(kBlue))));
    EXPECT_EQ(at(image, 2, 2), bytes(Color{1, 1, 1, 1}));
  }
}

TEST(DrawTest, TranslucentBehindSolidIsHidden) {
  const DrawnBody veil{square(0.5), translation(Vector3(0, 0, -0.1)), {1.0, 0.0, 0.0, 0.3}};
  const DrawnBody wall{square(0.25), Pose::Identity(), kBlue};
  EXPECT_EQ(at(draw({veil, wall}, camera_above(), flat_options()), 20, 20), bytes(kBlue));
}

TEST(DrawTest, TranslucentLayersBlendNearestLast) {
  const DrawnBody upper{square(0.5), translation(Vector3(0, 0, 0.1)), {1.0, 0.0, 0.0, 0.3}};
  const DrawnBody lower{square(0.5), Pose::Identity(), {0.0, 1.0, 0.0, 0.6}};
  const Bytes expected = bytes(mixed({1, 0, 0}, 0.3, mixed({0, 1, 0}, 0.6, {1, 1, 1})));
  expect_near(at(draw({upper, lower}, camera_above(), flat_options()), 20, 20), expected);
  expect_near(at(draw({lower, upper}, camera_above(), flat_options()), 20, 20), expected);
}

TEST(DrawTest, BackOfATranslucentSurfaceIsHalfAsOpaque) {
  const Pose turned(Eigen::AngleAxisd(std::numbers::pi, Vector3::UnitX()));
  const Image image =
      draw({{square(0.5), turned, {1.0, 0.0, 0.0, 0.4}}}, camera_above(), flat_options());
  expect_near(at(image, 20, 20), bytes(mixed({1, 0, 0}, 0.2, {1, 1, 1})));
}

// Tilted by an angle, a shell is seen through 1 / cos of its thickness.
TEST(DrawTest, TiltedTranslucentSurfaceIsDenser) {
  const Pose tilt(Eigen::AngleAxisd(std::numbers::pi / 3, Vector3::UnitX()));
  const Image image =
      draw({{square(0.5), tilt, {1.0, 0.0, 0.0, 0.4}}}, camera_above(), flat_options());
  const Bytes expected = bytes(mixed({1, 0, 0}, 1.0 - 0.6 * 0.6, {1, 1, 1}));
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(at(image, 20, 20)[k], expected[k], 3);
}

TEST(DrawTest, InvisibleBodyLeavesTheBackground) {
  DrawOptions options = flat_options();
  options.background = kBlue;
  options.line_width = 1.0;
  const Image image =
      draw({{box(0.5), Pose::Identity(), {1.0, 0.0, 0.0, 0.0}}}, camera_above(), options);
  EXPECT_EQ(image.rgb, draw({}, camera_above(), options).rgb);
  EXPECT_EQ(at(image, 20, 20), bytes(kBlue));
}

// Bodies that touch, cross, and lie in one plane, solid and translucent: with all lights and lines.
TEST(DrawTest, PictureDoesNotDependOnTheOrderOfBodies) {
  std::vector<DrawnBody> bodies = {
      {box(0.3), Pose::Identity(), kOrange},
      {box(0.3), translation(Vector3(0.2, 0, 0)), kBlue},
      {square(0.6), translation(Vector3(0, 0, 0.3)), {1.0, 0.0, 0.0, 0.3}},
      {square(0.5), translation(Vector3(0, 0, 0.3)), {0.0, 1.0, 0.0, 0.4}},
      {cone_mesh(Vector3(0, 0, 0.6), Vector3(0.1, 0.2, -1), 0.5, 0.5), Pose::Identity(), kBlue},
  };
  DrawOptions options{.width = 70, .height = 50};
  const Camera camera{.eye = Vector3(1.5, -2, 3)};
  const Image first = draw(bodies, camera, options);
  std::vector<std::size_t> order = {0, 1, 2, 3, 4};
  while (std::next_permutation(order.begin(), order.end())) {
    std::vector<DrawnBody> permuted;
    for (const std::size_t i : order) permuted.push_back(bodies[i]);
    ASSERT_EQ(draw(permuted, camera, options).rgb, first.rgb);
  }
}

TEST(DrawTest, MoreLayersThanAreKeptStillDoNotDependOnOrder) {
  std::vector<DrawnBody> bodies;
  for (int i = 0; i < 60; ++i) {
    bodies.push_back({square(0.5),
                      translation(Vector3(0, 0, 0.01 * i)),
                      {i % 2 == 0 ? 1.0 : 0.0, 0.5, i / 60.0, 0.05}});
  }
  const Image forward = draw(bodies, camera_above(), flat_options());
  std::reverse(bodies.begin(), bodies.end());
  EXPECT_EQ(draw(bodies, camera_above(), flat_options()).rgb, forward.rgb);
}

// A fan about an arbitrary point tiles the square: a gap would show the background and a sample
// drawn twice a denser color.
TEST(DrawTest, TrianglesAtAnEdgeNeitherMissNorRepeatASample) {
  constexpr int kBorderPoints = 200;
  TriangleMesh fan;
  fan.vertices.emplace_back(0.025, -0.05, 0);  // a pixel corner, so that edges pass through samples
  for (int i = 0; i < kBorderPoints; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kBorderPoints;
    const double reach = 0.5 / std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle)));
    fan.vertices.emplace_back(reach * std::cos(angle), reach * std::sin(angle), 0);
    fan.triangles.push_back({0, 1 + i, 1 + (i + 1) % kBorderPoints});
  }
  const Color veil{1.0, 0.0, 0.0, 0.5};
  const DrawOptions options = flat_options();
  const Image whole = draw({{square(0.5), Pose::Identity(), veil}}, camera_above(), options);
  const Image parts = draw({{fan, Pose::Identity(), veil}}, camera_above(), options);
  for (int y = 11; y < 29; ++y) {
    for (int x = 11; x < 29; ++x) {
      for (std::size_t k = 0; k < 3; ++k) {
        ASSERT_NEAR(at(parts, x, y)[k], at(whole, x, y)[k], 1) << x << ", " << y;
      }
    }
  }
}

// Seen from within, a closed box is everywhere, also across the plane of the eye.
TEST(DrawTest, CameraInsideABoxSeesItAllAround) {
  for (const Vector3& target : {Vector3(1, 0, 0), Vector3(-1, 2, 0.3), Vector3(0.1, 0.1, -1)}) {
    const Camera camera{
        .eye = Vector3(0.2, -0.1, 0.3), .target = target, .vertical_field_of_view = 2.5};
    const Image image = draw({{box(0.5), Pose::Identity(), kOrange}}, camera, flat_options());
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 40; ++x) ASSERT_EQ(at(image, x, y), bytes(kOrange)) << x << ", " << y;
    }
  }
}

TEST(DrawTest, EyeOnTheSurfaceOrInFrontOfNothingIsFine) {
  const DrawnBody body{box(0.5), Pose::Identity(), {0.2, 0.5, 0.8, 0.5}};
  const DrawOptions options{.width = 40, .height = 30};
  for (const Vector3& eye : {Vector3(0.5, 0, 0), Vector3(0.5, 0.5, 0.5), Vector3(0.5, 0.5, 0)}) {
    EXPECT_EQ(draw({body}, {.eye = eye}, options).rgb.size(), 3U * 40U * 30U);
  }
  const Image away = draw({body}, {.eye = Vector3(2, 0, 0), .target = Vector3(3, 0, 0)}, options);
  EXPECT_EQ(away.rgb, draw({}, Camera{}, options).rgb);
}

TEST(DrawTest, TrianglesWithoutAreaAreIgnored) {
  TriangleMesh mesh = box(0.3);
  const DrawOptions options{.width = 60, .height = 40};
  const Image clean = draw({{mesh, Pose::Identity(), kOrange}}, Camera{}, options);
  mesh.triangles.push_back({0, 0, 7});
  mesh.triangles.push_back({3, 3, 3});
  mesh.vertices.push_back(0.5 * (mesh.vertices[0] + mesh.vertices[1]));
  mesh.triangles.push_back({0, 1, 8});
  EXPECT_EQ(draw({{mesh, Pose::Identity(), kOrange}}, Camera{}, options).rgb, clean.rgb);
}

TEST(DrawTest, UpperFacesAreLighterThanLowerOnes) {
  DrawOptions options = flat_options();
  options.lighting = {};
  const DrawnBody body{square(1.0), Pose::Identity(), kOrange};
  const Image above = draw({body}, {.eye = Vector3(0, -3, 3)}, options);
  const Image below = draw({body}, {.eye = Vector3(0, -3, -3)}, options);
  EXPECT_GT(at(above, 20, 20)[0], at(below, 20, 20)[0] + 20);
}

TEST(DrawTest, LinesDarkenTheBorder) {
  DrawOptions options = flat_options();
  options.line_width = 2.0;
  const Image image = draw({{square(0.5), Pose::Identity(), kOrange}}, camera_above(), options);
  EXPECT_LT(at(image, 10, 20)[0], 150);
  EXPECT_EQ(at(image, 20, 20), bytes(kOrange));  // no line along the diagonal
}

TEST(DrawTest, MistakesAreNamed) {
  DrawnBody body{box(0.5), Pose::Identity(), kOrange};
  const auto error = [&](const DrawOptions& options, const Camera& camera) {
    return error_of([&] { draw({DrawnBody{}, body}, camera, options); });
  };
  EXPECT_NE(error({.width = 0}, {}).find("width"), std::string::npos);
  EXPECT_NE(error({.samples = 9}, {}).find("samples"), std::string::npos);
  EXPECT_NE(error({.line_width = std::nan("")}, {}).find("line_width"), std::string::npos);
  EXPECT_NE(error({}, {.eye = Vector3::Zero()}).find("target"), std::string::npos);
  EXPECT_NE(error({}, {.vertical_field_of_view = 3.2}).find("vertical_field"), std::string::npos);
  TriangleMesh mesh = *body.mesh;
  mesh.triangles[3] = {0, 1, 8};
  body.mesh = mesh;
  EXPECT_EQ(error({}, {}), "bodies[1].mesh.triangles[3]: names a vertex that is not there (8)");
  mesh.vertices[5].y() = std::numeric_limits<double>::quiet_NaN();
  mesh.triangles[3] = {0, 1, 7};
  body.mesh = mesh;
  EXPECT_EQ(error({}, {}), "bodies[1].mesh.vertices[5]: must be finite");
  const InputError width = test::refusal_of([] { draw({}, {}, {.width = 0}); });
  EXPECT_EQ(width.field(), "width");
  EXPECT_EQ(width.value(), "0.000000");
  const InputError angle = test::refusal_of([] { draw({}, {.vertical_field_of_view = 3.2}); });
  EXPECT_EQ(angle.field(), "camera.vertical_field_of_view");
  EXPECT_EQ(angle.value(), "3.200000");
}

TEST(CameraTest, PixelAndLineOfSightAreInverse) {
  const Projection projection({.eye = Vector3(1, 2, 3)}, 90, 70);
  const Vector3 p_C = projection.X_CW() * Vector3(0.2, -0.1, 0.4);
  ASSERT_GT(p_C.z(), 0.0);
  EXPECT_TRUE((p_C.z() * projection.line_of_sight(projection.pixel(p_C))).isApprox(p_C, 1e-12));
  const Vector3 target_C = projection.X_CW() * Vector3::Zero();
  EXPECT_TRUE(projection.pixel(target_C).isApprox(Eigen::Vector2d(45, 35), 1e-12));
  // Upward in the world is upward in the picture.
  EXPECT_LT(projection.pixel(projection.X_CW() * Vector3(0, 0, 0.1)).y(), 35.0);
}

// All corners keep the margin of 5 %, and two opposite ones use it up: the camera is the nearest.
TEST(CameraTest, AroundABoxSeesAllCornersAndNoMoreThanNeeded) {
  const std::vector<Vector3> directions = {{1, -1, 0.5}, {0, 0, 1},      {0, 0, -2},
                                           {-3, 0, 0},   {0.01, 0, 1.0}, {-1, 2, -4}};
  const std::vector<Vector3> sizes = {{1, 1, 1}, {0.1, 2, 0.3}, {3, 0.01, 0}, {0, 0, 0.001}};
  for (const Vector3& direction : directions) {
    for (const Vector3& size : sizes) {
      for (const DrawOptions& options : {DrawOptions{}, DrawOptions{.width = 300, .height = 800}}) {
        const Bounds bounds{Vector3(5, -2, 1), Vector3(5, -2, 1) + size};
        const Camera camera = camera_around(bounds, direction, options);
        EXPECT_GT((camera.eye - camera.target).normalized().dot(direction.normalized()), 1 - 1e-9);
        const Projection projection(camera, options.width, options.height);
        const Eigen::Vector2d center(0.5 * options.width, 0.5 * options.height);
        Eigen::Vector2d farthest = Eigen::Vector2d::Zero();  // from the center, 1 at the margin
        for (int i = 0; i < 8; ++i) {
          const Vector3 corner((i & 1) != 0 ? bounds.upper.x() : bounds.lower.x(),
                               (i & 2) != 0 ? bounds.upper.y() : bounds.lower.y(),
                               (i & 4) != 0 ? bounds.upper.z() : bounds.lower.z());
          const Vector3 p_C = projection.X_CW() * corner;
          ASSERT_GT(p_C.z(), projection.near_depth());
          const Eigen::Vector2d from_center = projection.pixel(p_C) - center;
          farthest = farthest.cwiseMax(from_center.cwiseQuotient(0.9 * center).cwiseAbs());
        }
        EXPECT_LT(farthest.maxCoeff(), 1.0 + 1e-9);
        const bool looks_end_on = size.cross(direction).norm() < 0.3 * size.norm();
        if (size.norm() > 0.5 && !looks_end_on) {
          EXPECT_GT(farthest.maxCoeff(), 1.0 - 1e-9);
        }
      }
    }
  }
}

TEST(CameraTest, AroundBodiesSkipsInvisibleOnesAndUsesPoses) {
  const DrawnBody body{box(0.1), translation(Vector3(3, 0, 0)), kOrange};
  const DrawnBody hidden{box(50.0), Pose::Identity(), {0, 0, 0, 0}};
  const Camera camera = camera_around(std::vector{body, hidden}, Vector3(1, -1, 1));
  const Camera expected =
      camera_around(Bounds{Vector3(2.9, -0.1, -0.1), Vector3(3.1, 0.1, 0.1)}, Vector3(1, -1, 1));
  EXPECT_TRUE(camera.eye.isApprox(expected.eye, 1e-12));
  EXPECT_TRUE(camera.target.isApprox(expected.target, 1e-12));
}

TEST(CameraTest, AroundNothingIsAnError) {
  const Vector3 direction(1, 0, 0);
  EXPECT_NE(error_of([&] { camera_around(Bounds{}, direction); }).find("box"), std::string::npos);
  EXPECT_NE(error_of([&] {
              camera_around(std::vector<DrawnBody>{}, direction);
            }).find("nothing to look at"),
            std::string::npos);
  const Bounds unit{Vector3::Zero(), Vector3::Ones()};
  EXPECT_NE(error_of([&] { camera_around(unit, Vector3::Zero()); }).find("direction"),
            std::string::npos);
}

TEST(SurfaceDetailTest, BoxStaysHard) {
  const TriangleMesh mesh = box(0.5);
  const SurfaceDetail detail = surface_detail(mesh, 0.7);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const Vector3& normal : detail.corner_normals[t]) {
      EXPECT_TRUE(normal.isApprox(detail.face_normals[t], 1e-12));
    }
  }
  EXPECT_EQ(detail.edges.size(), 18U);  // 12 of the box and 6 diagonals
  for (const SurfaceEdge& edge : detail.edges) EXPECT_GE(edge.second, 0);
}

// The side of a cone is round: at its rim the normals are those of the true cone. Also when every
// triangle has its own vertices.
TEST(SurfaceDetailTest, ConeIsRoundAlsoAsLooseTriangles) {
  const TriangleMesh cone = cone_mesh(Vector3::Zero(), Vector3::UnitZ(), 1.0, 1.0);
  TriangleMesh loose;
  for (const Triangle& t : cone.triangles) {
    const int first = static_cast<int>(loose.vertices.size());
    for (const int v : t) loose.vertices.push_back(cone.vertices[static_cast<std::size_t>(v)]);
    loose.triangles.push_back({first, first + 1, first + 2});
  }
  const SurfaceDetail detail = surface_detail(loose, 0.7);
  EXPECT_EQ(detail.edges.size(), surface_detail(cone, 0.7).edges.size());
  for (std::size_t t = 0; t < loose.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3& p = loose.vertices[static_cast<std::size_t>(loose.triangles[t][k])];
      if (detail.face_normals[t].z() > 0.5 || p.z() < 0.5) continue;  // the base; the apex
      const Vector3 expected = (Vector3(p.x(), p.y(), 0) - Vector3::UnitZ()).normalized();
      // The chord of a polygon with 32 sides leans a little from the tangent cone.
      EXPECT_GT(detail.corner_normals[t][k].dot(expected), 1.0 - 1e-4);
    }
  }
}

TEST(MarksTest, ConeIsClosedAndHasItsVolume) {
  const Vector3 apex(0.1, 0.2, 0.3);
  const Vector3 axis(1, -2, 0.5);
  const double slope = 0.6;
  const double length = 0.02;
  for (const int sides : {3, 12, kRoundSides}) {
    const TriangleMesh cone = cone_mesh(apex, axis, slope, length, sides);
    EXPECT_TRUE(closed(cone));
    // A polygon with n corners on a circle has the area n / 2 sin(2 pi / n) r^2.
    const double base =
        0.5 * sides * std::sin(2.0 * std::numbers::pi / sides) * std::pow(slope * length, 2);
    EXPECT_NEAR(volume(cone), base * length / 3.0, 1e-12);
    for (const Vector3& p : cone.vertices) {
      const double along = (p - apex).dot(axis.normalized());
      const double aside = (p - apex - along * axis.normalized()).norm();
      EXPECT_LE(along, length + 1e-12);
      EXPECT_NEAR(aside, p.isApprox(apex) || aside < 1e-12 ? aside : slope * along, 1e-12);
    }
  }
}

TEST(MarksTest, ArrowIsClosedAndReachesItsEnds) {
  const Vector3 from(0, 0, 0.1);
  const Vector3 to(0.03, 0.04, 0.1);
  for (const double radius : {0.001, 0.02}) {
    const TriangleMesh arrow = arrow_mesh(from, to, radius);
    EXPECT_TRUE(closed(arrow));
    EXPECT_GT(volume(arrow), 0.5 * std::numbers::pi * radius * radius * 0.05);
    double least = 1.0;
    double most = -1.0;
    for (const Vector3& p : arrow.vertices) {
      least = std::min(least, (p - from).dot(Vector3(0.6, 0.8, 0)));
      most = std::max(most, (p - from).dot(Vector3(0.6, 0.8, 0)));
    }
    EXPECT_NEAR(least, 0.0, 1e-12);
    EXPECT_NEAR(most, 0.05, 1e-12);
  }
}

TEST(MarksTest, WithoutVolumeIsEmpty) {
  const Vector3 o = Vector3::Zero();
  EXPECT_TRUE(arrow_mesh(o, o, 0.01).empty());
  EXPECT_TRUE(arrow_mesh(o, Vector3::UnitX(), 0.0).empty());
  EXPECT_TRUE(cone_mesh(o, o, 0.5, 1.0).empty());
  EXPECT_TRUE(cone_mesh(o, Vector3::UnitX(), 0.0, 1.0).empty());
  EXPECT_TRUE(cone_mesh(o, Vector3::UnitX(), 0.5, 0.0).empty());
}

}  // namespace
}  // namespace prehend
