// Regions of contact against what geometry says they are.
#include "sim/shape/contact/contact_region.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/shape/basic_shapes.h"
#include "tests/sim/shape/contact/touching.h"
#include "tests/support/turns.h"

namespace prehend {
namespace {

using test::each_frame;
using test::expect_places;
using test::expect_sound;
using test::Touching;

// From a link above the object into it.
const Vector3 kDown(0.0, 0.0, -1.0);

// The mesh moved so that its lowest vertex is at height z.
TriangleMesh lowered_to(double z, const TriangleMesh& mesh) {
  return transformed(mesh, translation({0.0, 0.0, z - bounds(mesh).lower.z()}));
}

// Top face at z = 0.
TriangleMesh table(int cells = 1) {
  return transformed(make_box_grid({0.1, 0.08, 0.04}, {cells, cells, 1}),
                     translation({0.0, 0.0, -0.02}));
}

TEST(ContactRegion, BoxOnBoxHasTheCornersOfTheOverlap) {
  const std::vector<Vector3> corners = {
      {0.01, 0.005, 0.0}, {0.05, 0.005, 0.0}, {0.05, 0.04, 0.0}, {0.01, 0.04, 0.0}};
  for (const int cells : {1, 3, 7}) {
    const TriangleMesh object = table(cells);
    each_frame(51, 15, [&](const Pose& X_WO, const Pose& X_WL, double gap) {
      const TriangleMesh link =
          lowered_to(gap, transformed(make_box_grid({0.06, 0.05, 0.03}, {cells + 1, cells, 1}),
                                      translation({0.04, 0.03, 0.0})));
      const auto contacts = Touching(object, link, X_WO, X_WL).regions();
      expect_sound(contacts, object, link);
      expect_places(contacts, corners, kDown);
      for (const SurfaceContact& contact : contacts) {
        EXPECT_NEAR(contact.gap, gap, test::kFrameRounding);
      }
    });
  }
}

TEST(ContactRegion, TurnedTessellatedFacesHaveTheCornersOfTheSmaller) {
  const TriangleMesh object = table(6);
  each_frame(52, 15, [&](const Pose& X_WO, const Pose& X_WL, double gap) {
    const Pose X = translation({0.004, -0.003, 0.0}) * test::turned(0.4, Vector3::UnitZ());
    const TriangleMesh link =
        lowered_to(gap, transformed(make_box_grid({0.03, 0.04, 0.02}, {5, 4, 2}), X));
    const auto contacts = Touching(object, link, X_WO, X_WL).regions();
    expect_sound(contacts, object, link);
    std::vector<Vector3> corners;
    for (const double x : {-0.015, 0.015}) {
      for (const double y : {-0.02, 0.02}) corners.push_back(X * Vector3(x, y, 0.0));
    }
    expect_places(contacts, corners, kDown);
  });
}

TEST(ContactRegion, TiltedFacesTouchAlongTheLowEdgeAndWithinTheThreshold) {
  const TriangleMesh object = table(2);
  Random random(53);
  each_frame(53, 40, [&](const Pose& X_WO, const Pose& X_WL, double gap) {
    // Over 40 mm, 0.05 degrees are 35 um: more than the evenness, less than the threshold.
    const double tilt = random.uniform(0.0, 0.05) * test::kDegree;
    const TriangleMesh link =
        lowered_to(gap, transformed(make_box_grid({0.04, 0.04, 0.02}, {2, 3, 1}),
                                    test::turned(tilt, Vector3::UnitX())));
    const auto contacts = Touching(object, link, X_WO, X_WL).regions();
    expect_sound(contacts, object, link);
    ASSERT_GE(contacts.size(), 2U);
    double left = 1.0;
    double right = -1.0;
    for (const SurfaceContact& contact : contacts) {
      EXPECT_LT((contact.normal - kDown).norm(), 0.05 * test::kDegree + 1e-9);
      if (contact.gap > gap + 1e-6) continue;
      left = std::min(left, contact.position.x());
      right = std::max(right, contact.position.x());
    }
    EXPECT_NEAR(left, -0.02, 1e-6);
    EXPECT_NEAR(right, 0.02, 1e-6);
  });
}

TEST(ContactRegion, BoxOnItsEdgeHasTheTwoEndsOfTheEdge) {
  const TriangleMesh object = table(3);
  each_frame(54, 15, [&](const Pose& X_WO, const Pose& X_WL, double gap) {
    const Pose X =
        test::turned(0.3, Vector3::UnitZ()) * test::turned(37.0 * test::kDegree, Vector3::UnitX());
    const TriangleMesh link = transformed(make_box({0.06, 0.03, 0.03}, 2), X);
    const double lowest = bounds(link).lower.z();
    std::vector<Vector3> ends;
    for (const Vector3& p : link.vertices) {
      const bool is_end = std::abs(std::abs((X.inverse() * p).x()) - 0.03) < 1e-9;
      if (p.z() < lowest + 1e-9 && is_end) ends.push_back({p.x(), p.y(), 0.0});
    }
    ASSERT_EQ(ends.size(), 2U);
    const TriangleMesh lowered = lowered_to(gap, link);
    const auto contacts = Touching(object, lowered, X_WO, X_WL).regions();
    expect_sound(contacts, object, lowered);
    expect_places(contacts, ends, kDown);
  });
}

TEST(ContactRegion, AnEdgeLongerThanTheFaceEndsWhereTheFaceDoes) {
  const TriangleMesh object = table();
  each_frame(55, 15, [&](const Pose& X_WO, const Pose& X_WL, double gap) {
    const TriangleMesh link =
        lowered_to(gap, transformed(make_box({0.3, 0.03, 0.03}),
                                    translation({0.0, 0.01, 0.0}) *
                                        test::turned(45.0 * test::kDegree, Vector3::UnitX())));
    const auto contacts = Touching(object, link, X_WO, X_WL).regions();
    expect_sound(contacts, object, link);
    expect_places(contacts, {{-0.05, 0.01, 0.0}, {0.05, 0.01, 0.0}}, kDown);
  });
}

TEST(ContactRegion, ABoxOnItsCornerHasOnePoint) {
  const TriangleMesh object = table(4);
  each_frame(56, 15, [&](const Pose& X_WO, const Pose& X_WL, double gap) {
    const TriangleMesh link = lowered_to(
        gap, transformed(make_box({0.03, 0.03, 0.03}), test::turned(0.6, Vector3::UnitX()) *
                                                           test::turned(0.5, Vector3::UnitY())));
    const auto lowest =
        std::min_element(link.vertices.begin(), link.vertices.end(),
                         [](const Vector3& p, const Vector3& q) { return p.z() < q.z(); });
    const auto contacts = Touching(object, link, X_WO, X_WL).regions();
    expect_sound(contacts, object, link);
    expect_places(contacts, {{lowest->x(), lowest->y(), 0.0}}, kDown);
  });
}

TEST(ContactRegion, ACylinderLyingOnAnEdgeOfItsSideHasTheEndsOfALine) {
  const TriangleMesh object = table(2);
  each_frame(57, 15, [&](const Pose& X_WO, const Pose& X_WL, double gap) {
    // The first corner of the polygon turned down, the axis along x. Neighbouring facets rise by
    // 3.75 degrees, more than the angular tolerance.
    const TriangleMesh link =
        lowered_to(gap, transformed(make_cylinder(0.02, 0.06, 48, 2),
                                    test::turned(90.0 * test::kDegree, Vector3::UnitY())));
    const auto contacts = Touching(object, link, X_WO, X_WL).regions();
    expect_sound(contacts, object, link);
    expect_places(contacts, {{-0.03, 0.0, 0.0}, {0.03, 0.0, 0.0}}, kDown);
  });
}

TEST(ContactRegion, AFineCylinderLyingHasANarrowStrip) {
  const TriangleMesh object = table(2);
  const ContactOptions options;
  each_frame(58, 8, [&](const Pose& X_WO, const Pose& X_WL, double gap) {
    const TriangleMesh link =
        lowered_to(gap, transformed(make_cylinder(0.02, 0.06, 400),
                                    test::turned(90.0 * test::kDegree, Vector3::UnitY())));
    const auto contacts = Touching(object, link, X_WO, X_WL).regions();
    expect_sound(contacts, object, link);
    double left = 1.0;
    double right = -1.0;
    for (const SurfaceContact& contact : contacts) {
      // As wide as the side is level within the tolerance, and a facet (0.3 mm) more.
      EXPECT_LT(std::abs(contact.position.y()), options.angular_tolerance * 0.02 + 3.2e-4);
      left = std::min(left, contact.position.x());
      right = std::max(right, contact.position.x());
    }
    EXPECT_NEAR(left, -0.03, 1e-9);
    EXPECT_NEAR(right, 0.03, 1e-9);
  });
}

double area_seen_from_above(const std::vector<SurfaceContact>& corners) {
  double doubled = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector3& p = corners[i].position;
    const Vector3& q = corners[(i + 1) % corners.size()].position;
    doubled += p.x() * q.y() - p.y() * q.x();
  }
  return 0.5 * std::abs(doubled);
}

TEST(ContactRegion, AStandingCylinderHasAtMostEightCornersOfItsEnd) {
  const TriangleMesh object = table(2);
  for (const int sides : {16, 48, 200}) {
    each_frame(59, 8, [&](const Pose& X_WO, const Pose& X_WL, double gap) {
      const TriangleMesh link = lowered_to(gap, make_cylinder(0.02, 0.06, sides));
      const auto contacts = Touching(object, link, X_WO, X_WL).regions();
      expect_sound(contacts, object, link);
      ASSERT_EQ(contacts.size(), 8U);
      for (const SurfaceContact& contact : contacts) {
        EXPECT_NEAR(contact.position.norm(), 0.02, 1e-9);
        EXPECT_LT((contact.normal - kDown).norm(), 1e-6);
      }
      // A regular octagon has 0.90 of its circle.
      EXPECT_GT(area_seen_from_above(contacts), 0.85 * std::numbers::pi * 0.02 * 0.02);
    });
  }
}

TEST(ContactRegion, ABallOnAFaceTouchesWhereItIsLevel) {
  const TriangleMesh object = table(2);
  const ContactOptions options;
  for (const int subdivisions : {2, 3, 5}) {
    const TriangleMesh ball = make_sphere(0.03, subdivisions);
    // Edges subtend about 63 degrees / 2^subdivisions: beyond this from the lowest point a facet
    // rises by more than the tolerance.
    const double reach = 0.03 * (options.angular_tolerance + 1.3 * std::pow(0.5, subdivisions));
    each_frame(60, 10, [&](const Pose& X_WO, const Pose& X_WL, double gap) {
      const TriangleMesh link =
          lowered_to(gap, transformed(ball, pose_from(X_WL.linear(), Vector3::Zero())));
      const auto contacts = Touching(object, link, X_WO, X_WL).regions();
      expect_sound(contacts, object, link);
      ASSERT_FALSE(contacts.empty());
      for (const SurfaceContact& contact : contacts) {
        EXPECT_LT(contact.position.norm(), reach);
        EXPECT_LT((contact.normal - kDown).norm(), options.angular_tolerance)
            << test::described(contacts);
      }
    });
  }
}

// Contacts at points of a plane, in any frame.
std::vector<SurfaceContact> on_plane(const std::vector<Vector3>& points, const Pose& X) {
  std::vector<SurfaceContact> contacts;
  for (const Vector3& p : points) contacts.push_back({X * p, X.linear() * kDown, 5e-5});
  return contacts;
}

TEST(ContactRegion, OfAGridIsItsFourCornersHoweverItIsTurned) {
  Random random(161);
  std::vector<Vector3> grid;
  std::vector<Vector3> corners;
  for (int i = 0; i <= 8; ++i) {
    for (int k = 0; k <= 5; ++k) {
      grid.emplace_back(0.005 * i, 0.004 * k, 0.0);
      if (i % 8 == 0 && k % 5 == 0) corners.push_back(grid.back());
    }
  }
  for (int n = 0; n < 200; ++n) {
    // Turned about the normal only, rounding decides which points of a side come first.
    const Pose X =
        n % 2 == 0 ? random.pose(0.2) : test::turned(n * test::kDegree, Vector3::UnitZ());
    for (std::size_t i = grid.size(); i-- > 1;) std::swap(grid[i], grid[random.index(i + 1)]);
    const auto region = contact_regions(on_plane(grid, X), {});
    std::vector<Vector3> expected;
    for (const Vector3& corner : corners) expected.push_back(X * corner);
    expect_places(region, expected, X.linear() * kDown);
    ASSERT_FALSE(HasFailure()) << n;
  }
}

TEST(ContactRegion, KeepsTheCornersThatMatterMost) {
  std::vector<Vector3> circle;
  for (int i = 0; i < 90; ++i) {
    circle.emplace_back(0.03 * std::cos(4.0 * i * test::kDegree),
                        0.03 * std::sin(4.0 * i * test::kDegree), 0.0);
  }
  const auto contacts = on_plane(circle, Pose::Identity());
  for (const int most : {3, 4, 8, 16}) {
    const auto region = contact_regions(contacts, {.max_region_corners = most});
    ASSERT_EQ(region.size(), static_cast<std::size_t>(most));
    // At least three quarters of the regular polygon with that many corners.
    const double regular = 0.5 * most * std::sin(2.0 * std::numbers::pi / most) * 0.03 * 0.03;
    EXPECT_GT(area_seen_from_above(region), 0.75 * regular) << most;
  }
}

TEST(ContactRegion, NormalsThatDifferAreRegionsOfTheirOwnNearestFirst) {
  std::vector<SurfaceContact> contacts;
  const Vector3 sideways = Vector3::UnitX();
  contacts.push_back({Vector3(0.0, 0.0, 0.0), kDown, 1e-5});
  contacts.push_back({Vector3(0.0, 0.01, 0.0), sideways, 2e-5});
  contacts.push_back({Vector3(0.02, 0.0, 0.0), kDown, 3e-5});
  contacts.push_back({Vector3(0.0, 0.02, 0.01), -kDown, 4e-5});
  contacts.push_back({Vector3(0.01, 0.0, 0.0), kDown, 5e-5});      // between the ends of a line
  contacts.push_back({Vector3(0.0, 0.01, 5e-5), sideways, 6e-5});  // where the other one is
  const auto regions = contact_regions(contacts, {});
  ASSERT_EQ(regions.size(), 4U);
  EXPECT_EQ(regions[0].normal, kDown);
  EXPECT_EQ(regions[1].normal, kDown);
  EXPECT_NEAR((regions[0].position - regions[1].position).norm(), 0.02, 1e-15);
  EXPECT_EQ(regions[2].normal, sideways);
  EXPECT_EQ(regions[2].gap, 2e-5);
  EXPECT_EQ(regions[3].normal, -kDown);
}

TEST(ContactRegion, OfNothingIsNothing) { EXPECT_TRUE(contact_regions({}, {}).empty()); }

}  // namespace
}  // namespace prehend
