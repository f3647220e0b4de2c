#include "sim/shape/loft.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/shape/mass_properties.h"
#include "sim/shape/mesh_checks.h"

namespace prehend {
namespace {

LoftSection regular_section(double at, double radius, int corners) {
  LoftSection section{.at = at, .corners = {}};
  for (int k = 0; k < corners; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / corners;
    section.corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return section;
}

void expect_closed_outward(const TriangleMesh& mesh) {
  const MeshChecks checks = check_mesh(mesh);
  EXPECT_TRUE(checks.solid());
  EXPECT_FALSE(checks.inward);
  EXPECT_EQ(checks.degenerate_triangles, 0);
}

// Area of the regular polygon with n corners at the distance r.
double regular_area(double r, int n) {
  return 0.5 * n * r * r * std::sin(2.0 * std::numbers::pi / n);
}

double frustum_volume(double height, double low, double high) {
  return height / 3.0 * (low + high + std::sqrt(low * high));
}

double enclosed_volume(const TriangleMesh& mesh) { return mass_properties(mesh).volume; }

TEST(Loft, FrustumsHaveTheirVolumeAndBounds) {
  for (const int corners : {4, 8, 12}) {
    const TriangleMesh mesh =
        make_loft({regular_section(-0.01, 0.01, corners), regular_section(0.02, 0.02, corners),
                   regular_section(0.03, 0.005, corners)});
    expect_closed_outward(mesh);
    const double a = regular_area(0.01, corners);
    const double b = regular_area(0.02, corners);
    const double c = regular_area(0.005, corners);
    EXPECT_NEAR(enclosed_volume(mesh), frustum_volume(0.03, a, b) + frustum_volume(0.01, b, c),
                1e-15);
    EXPECT_EQ(static_cast<int>(mesh.triangles.size()), 4 * corners + 2 * (corners - 2));
    const Bounds box = bounds(mesh);
    EXPECT_TRUE(box.lower.isApprox(Vector3(-0.02, -0.02, -0.01), 1e-12));
    EXPECT_TRUE(box.upper.isApprox(Vector3(0.02, 0.02, 0.03), 1e-12));
  }
}

TEST(Loft, OfAConcaveSectionIsAPrism) {
  const std::vector<Eigen::Vector2d> l = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
  const TriangleMesh mesh = make_loft({{.at = 1.0, .corners = l}, {.at = 4.0, .corners = l}});
  expect_closed_outward(mesh);
  EXPECT_NEAR(enclosed_volume(mesh), 12.0, 1e-12);
}

std::string loft_complaint(const std::vector<LoftSection>& sections) {
  try {
    make_loft(sections);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Loft, RefusesSectionsThatDoNotMakeASolid) {
  const LoftSection square = regular_section(0.0, 1.0, 4);
  EXPECT_EQ(loft_complaint({square}), "loft sections: must be at least two (1)");
  EXPECT_EQ(loft_complaint({square, regular_section(0.0, 1.0, 4)}),
            "loft section 1: must be higher than the one before it (0)");
  EXPECT_EQ(loft_complaint({square, regular_section(1.0, 1.0, 5)}),
            "loft section 1: must have as many corners as the first one (5 corners)");
  LoftSection turned = regular_section(1.0, 1.0, 4);
  std::reverse(turned.corners.begin(), turned.corners.end());
  EXPECT_EQ(loft_complaint({square, turned}),
            "loft section 1: must be simple, counter-clockwise and of positive area (4 corners)");
}

// A stack of frustums between the rings of corners.
double polygonal_capsule_volume(double length, double radius, int sides) {
  const int bands = std::max(1, sides / 4);
  double volume = length * regular_area(radius, sides);
  for (int i = 0; i < bands; ++i) {
    const double low = 0.5 * std::numbers::pi * i / bands;
    const double high = 0.5 * std::numbers::pi * (i + 1) / bands;
    volume += 2.0 * frustum_volume(radius * (std::sin(high) - std::sin(low)),
                                   regular_area(radius * std::cos(low), sides),
                                   regular_area(radius * std::cos(high), sides));
  }
  return volume;
}

TEST(Capsule, IsClosedAndHasTheVolumeOfItsFrustums) {
  const Vector3 from(0.01, -0.02, 0.03);
  for (const Vector3& along : {Vector3(0, 0, 0.05), Vector3(0, 0, -0.05), Vector3(0.03, 0, 0.04),
                               Vector3(-0.05, 0, 0), Vector3(0, 0, 0)}) {
    for (const int sides : {4, 6, 12, 40}) {
      const TriangleMesh mesh = make_capsule(from, from + along, 0.01, sides);
      expect_closed_outward(mesh);
      EXPECT_NEAR(enclosed_volume(mesh), polygonal_capsule_volume(along.norm(), 0.01, sides),
                  1e-15);
    }
  }
}

TEST(Capsule, LiesOnTheRoundOneAndReachesItsPoles) {
  const Vector3 from(0.0, 0.0, -0.02);
  const Vector3 to(0.0, 0.0, 0.06);
  const TriangleMesh mesh = make_capsule(from, to, 0.01, 12);
  for (const Vector3& p : mesh.vertices) {
    const double along = std::clamp(p.z(), from.z(), to.z());
    EXPECT_NEAR((p - Vector3(0, 0, along)).norm(), 0.01, 1e-12);
  }
  const Bounds box = bounds(mesh);
  EXPECT_TRUE(box.lower.isApprox(Vector3(-0.01, -0.01, -0.03), 1e-12));
  EXPECT_TRUE(box.upper.isApprox(Vector3(0.01, 0.01, 0.07), 1e-12));
}

TEST(Capsule, RefusesSizesOutOfRange) {
  const Vector3 o = Vector3::Zero();
  EXPECT_THROW(make_capsule(o, Vector3::UnitX(), 0.0), InputError);
  EXPECT_THROW(make_capsule(o, Vector3::UnitX(), 1.0, 3), InputError);
  EXPECT_THROW(make_capsule(o, Vector3::UnitX(), 1.0, 361), InputError);
}

}  // namespace
}  // namespace prehend
