// Single contacts: edges, corners, what is no contact at all.
#include "sim/shape/contact/surface_contact.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "sim/shape/basic_shapes.h"
#include "sim/shape/object_generator.h"
#include "tests/sim/shape/contact/touching.h"
#include "tests/support/turns.h"

namespace prehend {
namespace {

using test::each_frame;
using test::expect_places;
using test::expect_sound;
using test::Touching;

const Vector3 kDownwards(0.0, 0.0, -1.0);

// A bar along x whose lowest (or highest) edge is the x axis.
TriangleMesh bar_above() {
  return transformed(make_box({0.08, 0.02, 0.02}),
                     translation({0.0, 0.0, 0.01 * std::sqrt(2.0)}) *
                         test::turned(45.0 * test::kDegree, Vector3::UnitX()));
}
TriangleMesh bar_below() {
  return transformed(bar_above(), test::turned(std::numbers::pi, Vector3::UnitX()));
}

TEST(SurfaceContact, EdgeAcrossEdgeIsOnePointWithTheNormalOfBoth) {
  Random random(61);
  const TriangleMesh object = bar_below();
  each_frame(61, 40, [&](const Pose& X_WO, const Pose& X_WL, double gap) {
    const double angle = random.uniform(5.0, 175.0) * test::kDegree;
    const Vector3 at(random.uniform(-0.02, 0.02), 0.0, 0.0);
    const TriangleMesh link = transformed(bar_above(), translation(at + gap * Vector3::UnitZ()) *
                                                           test::turned(angle, Vector3::UnitZ()));
    const auto contacts = Touching(object, link, X_WO, X_WL).regions();
    expect_sound(contacts, object, link);
    expect_places(contacts, {at}, kDownwards);
  });
}

// Figure 7 of the paper: an edge near an edge between coplanar triangles is no contact of its own.
TEST(SurfaceContact, ACornerNearAFlatEdgeIsOnePoint) {
  Random random(62);
  const TriangleMesh object =
      transformed(make_box_grid({0.1, 0.08, 0.04}, {2, 2, 1}), translation({0.0, 0.0, -0.02}));
  each_frame(62, 60, [&](const Pose& X_WO, const Pose& X_WL, double gap) {
    TriangleMesh link =
        transformed(make_box({0.03, 0.03, 0.03}),
                    test::turned(random.uniform(0.0, 6.2), Vector3::UnitZ()) *
                        test::turned(0.4, Vector3::UnitX()) * test::turned(0.7, Vector3::UnitY()));
    const auto lowest =
        std::min_element(link.vertices.begin(), link.vertices.end(),
                         [](const Vector3& p, const Vector3& q) { return p.z() < q.z(); });
    // Up to 0.1 mm beside the edges along x = 0, so that edges of the link pass over them.
    const Vector3 at = random.in_box({-1e-4, 0.001, 0.0}, {1e-4, 0.03, 0.0});
    link = transformed(link, translation(at + gap * Vector3::UnitZ() - *lowest));
    const auto contacts = Touching(object, link, X_WO, X_WL).points();
    expect_sound(contacts, object, link);
    expect_places(contacts, {at}, kDownwards);
  });
}

TEST(SurfaceContact, AReEntrantEdgeGivesTheContactsOfItsFacesOnly) {
  // An L: a floor at z = 0 and a wall at x = 0, meeting in a re-entrant edge along y.
  const std::vector<Eigen::Vector2d> outline = {{-0.02, -0.02}, {0.06, -0.02}, {0.06, 0.0},
                                                {0.0, 0.0},     {0.0, 0.05},   {-0.02, 0.05}};
  const TriangleMesh object = transformed(make_prism(outline, -0.03, 0.03),
                                          test::turned(90.0 * test::kDegree, Vector3::UnitX()));
  each_frame(63, 20, [&](const Pose& X_WO, const Pose& X_WL, double gap) {
    const TriangleMesh link =
        transformed(make_box({0.02, 0.03, 0.02}), translation({0.01 + gap, 0.0, 0.01 + gap}));
    const auto contacts = Touching(object, link, X_WO, X_WL).regions();
    expect_sound(contacts, object, link);
    EXPECT_EQ(contacts.size(), 8U) << test::described(contacts);
    int floor = 0;
    for (const SurfaceContact& contact : contacts) {
      const bool on_floor = (contact.normal - kDownwards).norm() < 1e-6;
      const bool on_wall = (contact.normal + Vector3::UnitX()).norm() < 1e-6;
      EXPECT_TRUE(on_floor || on_wall) << contact.normal.transpose();
      floor += on_floor;
    }
    EXPECT_EQ(floor, 4);
  });
}

TEST(SurfaceContact, NothingBeyondTheThresholdTouches) {
  const TriangleMesh object = make_box({0.1, 0.1, 0.1});
  Random random(64);
  each_frame(64, 10, [&](const Pose& X_WO, const Pose& X_WL, double) {
    const double gap = 1e-4 + random.uniform(1e-9, 1e-4);
    const TriangleMesh link = transformed(object, translation({0.0, 0.0, 0.1 + gap}));
    EXPECT_TRUE(Touching(object, link, X_WO, X_WL).points().empty());
    EXPECT_FALSE(Touching(object, link, X_WO, X_WL).points({.threshold = gap + 1e-9}).empty());
  });
}

// Whatever touches has a contact: the nearest points of two bodies always support each other.
TEST(SurfaceContact, BodiesWithinTheThresholdHaveAContactAtTheirNearestPoints) {
  Random random(65);
  const std::vector<TriangleMesh> bodies = {generate_object("mug", 600), make_sphere(0.03, 2),
                                            make_box({0.03, 0.05, 0.02}, 2),
                                            generate_object("wine_glass", 600)};
  int touching = 0;
  for (int i = 0; i < 300; ++i) {
    const TriangleMesh& object = bodies[random.index(bodies.size())];
    const TriangleMesh& tool = bodies[random.index(bodies.size())];
    const Matrix3 turn = random.rotation();
    Pose X_OL = pose_from(turn, 0.3 * random.direction());
    const ProximityMesh a(object);
    const ProximityMesh b(tool);
    const TriangleGap far = triangle_gap(a, b, X_OL, find_gap(a, b, X_OL).pair);
    // Nearly as far as the nearest points say; curved around, others are nearer by then, so once
    // more.
    const double gap = random.uniform(2e-5, 9e-5);
    X_OL = translation((1.0 - gap / far.distance) * (far.p_A - X_OL * far.p_B)) * X_OL;
    if (surfaces_cross(a, b, X_OL)) continue;
    const double nearest = find_gap(a, b, X_OL).upper;
    if (nearest > 9.5e-5) continue;
    ++touching;
    const TriangleMesh link = transformed(tool, X_OL);
    const Pose X_WO = random.pose(0.2);
    const Touching pair(object, link, X_WO, random.pose(0.2));
    const auto contacts = pair.points();
    expect_sound(contacts, object, link);
    ASSERT_FALSE(contacts.empty()) << "pair " << i;
    EXPECT_NEAR(contacts.front().gap, nearest, 1e-9) << "pair " << i;
    EXPECT_FALSE(pair.regions().empty());
  }
  EXPECT_GT(touching, 100);
}

TEST(SurfaceContact, EqualPlacesWithEqualNormalsComeOnceNearestFirst) {
  const TriangleMesh object = make_box({0.1, 0.08, 0.04}, 5);
  const TriangleMesh link =
      transformed(make_box({0.06, 0.06, 0.02}, 4), translation({0.01, 0.02, 0.03 + 5e-5}));
  const ContactOptions options;
  const auto contacts = Touching(object, link, Pose::Identity(), Pose::Identity()).points(options);
  ASSERT_GT(contacts.size(), 20U);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_LE(contacts[k].gap, contacts[i].gap);
      const bool same = (contacts[k].position - contacts[i].position).norm() <= options.threshold &&
                        contacts[k].normal.dot(contacts[i].normal) > 0.999;
      EXPECT_FALSE(same) << k << " and " << i;
    }
  }
}

TEST(SurfaceContact, ATriangleWithoutAreaMakesNoContactWithoutANormal) {
  // A corner in the middle of a top edge, joined by a triangle that is a line.
  TriangleMesh object = make_box({0.1, 0.1, 0.1});
  const int a = static_cast<int>(object.vertices.size());
  for (const double x : {-0.05, 0.0, 0.05}) object.vertices.push_back({x, 0.0, 0.05});
  object.triangles.push_back({a, a + 1, a + 2});
  const TriangleMesh link =
      transformed(make_box({0.04, 0.04, 0.04}), translation({0.0, 0.0, 0.07 + 5e-5}));
  const auto contacts = Touching(object, link, Pose::Identity(), Pose::Identity()).points();
  EXPECT_GE(contacts.size(), 4U);
  for (const SurfaceContact& contact : contacts) EXPECT_NEAR(contact.normal.norm(), 1.0, 1e-9);
}

// A foil of 20 um: its far side is nearer to the link than the threshold.
TEST(SurfaceContact, TheFarSideOfAThinWallIsNoContact) {
  constexpr double kFoil = 2e-5;
  const TriangleMesh object =
      transformed(make_box({0.02, 0.02, kFoil}, 4), translation({0.0, 0.0, -0.5 * kFoil}));
  each_frame(67, 20, [&](const Pose& X_WO, const Pose& X_WL, double /*gap*/) {
    const TriangleMesh link =
        transformed(make_box({0.03, 0.03, 0.03}), translation({0.0, 0.0, 0.015 + 5e-5}));
    const auto contacts = Touching(object, link, X_WO, X_WL).points();
    EXPECT_GE(contacts.size(), 4U);
    for (const SurfaceContact& contact : contacts) EXPECT_NEAR(contact.position.z(), 0.0, 1e-9);
  });
}

// A block of glass with a bubble 20 um under its face: a box that faces inwards. At its upper edges
// the sides of the bubble neither face the link nor away from it.
TEST(SurfaceContact, WhatLiesBehindAThinWallIsNoContact) {
  constexpr double kWall = 2e-5;
  TriangleMesh object = transformed(make_box({0.02, 0.02, 0.01}), translation({0.0, 0.0, -0.005}));
  TriangleMesh bubble =
      transformed(make_box({0.01, 0.01, 0.004}), translation({0.0, 0.0, -0.002 - kWall}));
  for (Triangle& t : bubble.triangles) std::swap(t[1], t[2]);
  append(object, bubble);
  // In the bubble, another block 10 um below its ceiling: it faces the link.
  append(object, transformed(make_box({0.004, 0.004, 0.002}),
                             translation({0.0, 0.0, -0.001 - 1.5 * kWall})));
  each_frame(68, 20, [&](const Pose& X_WO, const Pose& X_WL, double /*gap*/) {
    for (const double turn : {0.0, 1e-3}) {
      const TriangleMesh link =
          transformed(make_box({0.03, 0.03, 0.03}),
                      translation({0.0, 0.0, 5e-5}) * test::turned(turn, Vector3::UnitX()) *
                          translation({0.0, 0.015 * std::sin(turn), 0.015}));
      const auto contacts = Touching(object, link, X_WO, X_WL).points();
      EXPECT_FALSE(contacts.empty());
      for (const SurfaceContact& contact : contacts) EXPECT_NEAR(contact.position.z(), 0.0, 1e-9);
    }
  });
}

// A surface without thickness may face either way: nothing stands before it.
TEST(SurfaceContact, ASheetThatFacesAwayIsTouched) {
  TriangleMesh sheet;
  sheet.vertices = {{-0.01, -0.01, 0.0}, {0.01, -0.01, 0.0}, {0.0, 0.01, 0.0}};
  sheet.triangles = {{0, 2, 1}};
  const TriangleMesh link =
      transformed(make_box({0.03, 0.03, 0.03}), translation({0.0, 0.0, 0.015 + 5e-5}));
  const Pose X = Pose::Identity();
  expect_places(Touching(sheet, link, X, X).regions(), sheet.vertices, kDownwards);
}

}  // namespace
}  // namespace prehend
