// Masses of parts, against closed forms.
#include "sim/shape/mass_parts.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/box_tree.h"
#include "sim/shape/object_generator.h"
#include "sim/shape/winding_number.h"
#include "tests/support/refusal_of.h"
#include "tests/support/test_meshes.h"

namespace prehend {
namespace {

// Sums over some thousand triangles, at unit size.
constexpr double kRounding = 1e-11;

Primitive box_at(const Vector3& size, const Vector3& center) {
  return {Box{size}, translation(center)};
}

MassPart inside(const Primitive& shape, double density) {
  return {.where = InsideShape{shape}, .density = density};
}

MassPart beyond(const Vector3& point_O, const Vector3& normal_O, double density) {
  return {.where = BeyondPlane{point_O, normal_O}, .density = density};
}

MassPart point(const Vector3& p_O, double mass) { return {.where = AtPoint{p_O}, .mass = mass}; }

MassPart component(int index, double density) {
  return {.where = MeshComponent{index}, .density = density};
}

// The inertia of a box of this mass about its centre.
Matrix3 box_inertia(const Vector3& size, double mass) {
  const Vector3 s = size.cwiseAbs2();
  return mass / 12.0 * Vector3(s.y() + s.z(), s.z() + s.x(), s.x() + s.y()).asDiagonal();
}

// What a mass at `off` from the centre adds to the inertia.
Matrix3 lever(double mass, const Vector3& off) {
  return mass * (off.squaredNorm() * Matrix3::Identity() - off * off.transpose());
}

Pose pose_in_room(Random& random) {
  // One draw a statement: compilers evaluate arguments in different orders.
  const Vector3 axis = random.direction();
  Pose pose(Eigen::AngleAxisd(random.uniform(0.0, 3.0), axis));
  pose.translation() = 0.3 * random.direction();
  return pose;
}

void expect_same(const MassOfParts& a, const MassOfParts& b, const Pose& X_BA, double digits) {
  EXPECT_NEAR(a.mass / b.mass, 1.0, digits);
  EXPECT_LT((X_BA * a.center_of_mass - b.center_of_mass).norm(), digits);
  const Matrix3 turned = X_BA.linear() * a.inertia * X_BA.linear().transpose();
  EXPECT_LT((turned - b.inertia).norm(), digits * b.inertia.norm());
}

// A bar of two halves of different densities, by each way to state it.
TEST(MassParts, OfABarOfTwoDensitiesAreItsClosedForm) {
  const Vector3 size(0.3, 0.02, 0.03);
  const Vector3 half(0.15, 0.02, 0.03);
  const TriangleMesh bar = make_box(size, 4);
  const double light = 700.0 * half.prod();
  const double heavy = 7800.0 * half.prod();
  const double mass = light + heavy;
  const double center = 0.075 * (heavy - light) / mass;
  const Matrix3 inertia = box_inertia(half, mass) + lever(light, {0.075 + center, 0, 0}) +
                          lever(heavy, {0.075 - center, 0, 0});
  const std::vector<MassPart> ways = {
      inside(box_at(half, {0.075, 0, 0}), 7800.0),
      inside(box_at({1.0, 2.0, 3.0}, {0.5, 0, 0}), 7800.0),
      beyond(Vector3::Zero(), Vector3::UnitX(), 7800.0),
      {.where = BeyondPlane{Vector3::Zero(), Vector3::UnitX()}, .mass = heavy}};
  for (const MassPart& way : ways) {
    const MassOfParts found = mass_of_parts(bar, {.density = 700.0, .parts = {way}});
    EXPECT_NEAR(found.mass / mass, 1.0, kRounding);
    EXPECT_LT((found.center_of_mass - Vector3(center, 0, 0)).norm(), kRounding);
    EXPECT_LT((found.inertia - inertia).norm(), kRounding * inertia.norm());
    EXPECT_NEAR(found.parts[0].mass / heavy, 1.0, kRounding);
    EXPECT_NEAR(found.parts[0].volume / half.prod(), 1.0, kRounding);
    EXPECT_NEAR(found.rest->mass / light, 1.0, kRounding);
    EXPECT_EQ(found.scale, 1.0);
    // The same by the mass of the whole, of which the rest has what the part leaves.
    const MassOfParts whole = mass_of_parts(bar, {.mass = mass, .parts = {way}});
    expect_same(whole, found, Pose::Identity(), kRounding);
    // With both, all is scaled.
    const MassOfParts twice =
        mass_of_parts(bar, {.mass = 2.0 * mass, .density = 700.0, .parts = {way}});
    EXPECT_NEAR(twice.scale, 2.0, kRounding);
    EXPECT_LT((twice.center_of_mass - found.center_of_mass).norm(), kRounding);
    EXPECT_LT((twice.inertia - 2.0 * inertia).norm(), 2.0 * kRounding * inertia.norm());
  }
}

// Half a ball has its centre at 3/8 of the radius. The facets of the mesh leave 1e-3 of it.
TEST(MassParts, OfHalfABallAreItsClosedForm) {
  const double radius = 0.04;
  const double volume = 2.0 / 3.0 * std::numbers::pi * std::pow(radius, 3);
  Random random(5);
  for (int i = 0; i < 20; ++i) {
    const Vector3 normal = random.direction();
    const MassOfParts found = mass_of_parts(
        make_sphere(radius, 5), {.density = 0.0, .parts = {beyond({0, 0, 0}, normal, 1000.0)}});
    EXPECT_NEAR(found.mass / (1000.0 * volume), 1.0, 2e-3);
    EXPECT_LT((found.center_of_mass - 0.375 * radius * normal).norm(), 1e-3 * radius);
    // About the axis it is that of the ball: 2/5 m r^2.
    EXPECT_NEAR(normal.dot(found.inertia * normal) / (0.4 * found.mass * radius * radius), 1.0,
                4e-3);
  }
}

// A sphere and a cylinder as regions have the volumes that they stand for, wherever they are.
TEST(MassParts, RoundRegionsHaveTheirVolumes) {
  const TriangleMesh block = make_box({0.2, 0.2, 0.2}, 3);
  Random random(6);
  for (int i = 0; i < 20; ++i) {
    Pose X_OP = pose_in_room(random);
    X_OP.translation() *= 0.1;
    const auto volume = [&](const Shape& shape) {
      return mass_of_parts(block, {.mass = 1.0, .parts = {inside({shape, X_OP}, 10)}}).parts[0];
    };
    const MassShare cylinder = volume(Cylinder{0.02, 0.06});
    EXPECT_NEAR(cylinder.volume / (std::numbers::pi * 0.02 * 0.02 * 0.06), 1.0, 1e-9);
    EXPECT_LT((cylinder.center_O - X_OP.translation()).norm(), 1e-9);
    const MassShare ball = volume(Sphere{0.03});
    EXPECT_NEAR(ball.volume / (4.0 / 3.0 * std::numbers::pi * std::pow(0.03, 3)), 1.0, 1e-9);
    EXPECT_LT((ball.center_O - X_OP.translation()).norm(), 1e-9);
    EXPECT_NEAR(volume(Box{{0.05, 0.03, 0.02}}).volume / (0.05 * 0.03 * 0.02), 1.0, 1e-9);
  }
}

// Eight boxes around a random point cover a mug.
TEST(MassParts, AddUpToTheWhole) {
  const TriangleMesh mug = generate_object("mug", 3000);
  const MassProperties uniform = mass_properties(mug);
  Random random(7);
  for (int i = 0; i < 10; ++i) {
    const Vector3 middle = uniform.center_of_mass + 0.03 * random.direction();
    const Matrix3 turn = pose_in_room(random).linear();
    std::vector<MassPart> parts;
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3 side((corner & 1) - 0.5, ((corner >> 1) & 1) - 0.5, (corner >> 2) - 0.5);
      parts.push_back(
          inside({Box{Vector3::Ones()}, pose_from(turn, middle + turn * side)}, 1200.0));
    }
    const MassOfParts found = mass_of_parts(mug, {.parts = parts});
    EXPECT_FALSE(found.rest);
    EXPECT_NEAR(found.mass / (1200.0 * uniform.volume), 1.0, kRounding);
    EXPECT_LT((found.center_of_mass - uniform.center_of_mass).norm(), kRounding);
    EXPECT_LT((found.inertia - found.mass * uniform.unit_inertia).norm(),
              kRounding * found.inertia.norm());
  }
}

TEST(MassParts, MoveAndScaleWithTheObject) {
  const TriangleMesh mug = generate_object("mug", 2000);
  Random random(8);
  for (int i = 0; i < 10; ++i) {
    const Pose X_OP = pose_from(pose_in_room(random).linear(), {0.02, 0.01, 0.04});
    const Primitive region{Cylinder{0.03, 0.7}, X_OP};
    const StatedMass stated{.mass = {},
                            .density = 500.0,
                            .parts = {inside(region, 3000.0), point({0.01, 0.0, 0.2}, 0.1)}};
    const MassOfParts found = mass_of_parts(mug, stated);
    const Pose X_BO = pose_in_room(random);
    StatedMass moved = stated;
    moved.parts[0].where = InsideShape{{region.shape, X_BO * region.X_OP}};
    moved.parts[1].where = AtPoint{X_BO * Vector3(0.01, 0.0, 0.2)};
    expect_same(found, mass_of_parts(transformed(mug, X_BO), moved), X_BO, 1e-9);
    StatedMass grown = stated;
    Pose X_large = X_OP;
    X_large.translation() *= 10.0;
    grown.parts[0].where = InsideShape{{Cylinder{0.3, 7.0}, X_large}};
    grown.parts[1].where = AtPoint{{0.1, 0.0, 2.0}};
    grown.parts[1].mass = 100.0;
    const MassOfParts large = mass_of_parts(test::scaled(mug, 10.0), grown);
    EXPECT_NEAR(large.mass / found.mass, 1e3, 1e-6);
    EXPECT_LT((large.center_of_mass / 10.0 - found.center_of_mass).norm(), 1e-9);
    EXPECT_LT((large.inertia / 1e5 - found.inertia).norm(), 1e-9 * found.inertia.norm());
  }
}

// What a box at the rim and the handle of a mug holds, by points at random: some 10,000 within tell
// it to 1 %.
TEST(MassParts, AreWhatPointsAtRandomSay) {
  const TriangleMesh mug = generate_object("mug", 1500);
  const std::vector<BoxNode> tree = build_box_tree(mug);
  const BoundaryTree boundaries = build_boundary_tree(mug, tree);
  Random random(9);
  const Vector3 size(0.05, 0.04, 0.06);
  const Pose X_OP = pose_from(pose_in_room(random).linear(), {0.045, 0.01, 0.05});
  const MassShare found =
      mass_of_parts(mug, {.mass = 1.0, .parts = {inside({Box{size}, X_OP}, 100.0)}}).parts[0];
  constexpr int kPoints = 100000;
  int within = 0;
  Vector3 sum = Vector3::Zero();
  for (int i = 0; i < kPoints; ++i) {
    const Vector3 p_O = X_OP * size.cwiseProduct(random.in_box(0.5));
    if (winding_number(mug, tree, boundaries, p_O) < 0.5) continue;
    ++within;
    sum += p_O;
  }
  EXPECT_GT(within, 4000);
  EXPECT_NEAR(found.volume / (size.prod() * within / kPoints), 1.0, 0.05);
  EXPECT_LT((found.center_O - sum / within).norm(), 1e-3);
}

TEST(MassParts, PointsAddToTheSolid) {
  const Vector3 size(0.1, 0.04, 0.02);
  const Vector3 motor(0.04, 0.01, 0.0);
  const MassOfParts found =
      mass_of_parts(make_box(size), {.mass = 0.8, .parts = {point(motor, 0.6)}});
  EXPECT_NEAR(found.mass, 0.8, kRounding);
  EXPECT_NEAR(found.rest->mass, 0.2, kRounding);
  const Vector3 center = 0.75 * motor;
  EXPECT_LT((found.center_of_mass - center).norm(), kRounding);
  const Matrix3 inertia = box_inertia(size, 0.2) + lever(0.2, center) + lever(0.6, motor - center);
  EXPECT_LT((found.inertia - inertia).norm(), kRounding * inertia.norm());
}

// A hammer of two pieces, one of them hollow; the larger one is component 0.
TEST(MassParts, ComponentsAreCountedByVolumeAndKeepTheirCavities) {
  TriangleMesh hammer = test::moved(make_box({0.02, 0.02, 0.02}), {0.0, 0.0, 0.1});
  append(hammer, make_box({0.1, 0.02, 0.02}));
  append(hammer, test::turned_over(make_box({0.08, 0.01, 0.01})));
  const std::vector<ComponentVolume> volumes = component_volumes(hammer);
  ASSERT_EQ(volumes.size(), 2U);
  EXPECT_NEAR(volumes[0].volume, 4e-5 - 8e-6, 1e-15);
  EXPECT_NEAR(volumes[1].volume, 8e-6, 1e-15);
  EXPECT_LT((volumes[1].center_O - Vector3(0, 0, 0.1)).norm(), kRounding);
  const MassOfParts found =
      mass_of_parts(hammer, {.density = 1000.0, .parts = {component(1, 8000.0)}});
  EXPECT_NEAR(found.parts[0].mass, 0.064, kRounding);
  EXPECT_NEAR(found.rest->mass, 0.032, kRounding);
  EXPECT_NEAR(found.center_of_mass.z(), 0.1 * 2.0 / 3.0, kRounding);
}

TEST(MassParts, RegionsOfAMeshWithHolesCutTheSolidThatIsTakenForIt) {
  TriangleMesh box = make_box({0.1, 0.1, 0.1}, 2);
  box.triangles.pop_back();
  const StatedMass stated{.density = 0.0, .parts = {beyond({0, 0, 0}, {0, 0, 1}, 1000.0)}};
  const MassOfParts closed = mass_of_parts(box, stated);
  EXPECT_EQ(closed.source, MassSource::closed_holes);
  EXPECT_NEAR(closed.mass, 0.5, kRounding);
  // Triangles that are not connected: the hull is cut.
  TriangleMesh scraps;
  const TriangleMesh whole = make_box({0.1, 0.1, 0.1});
  for (std::size_t t = 0; t < whole.triangles.size(); t += 2) {
    const int first = static_cast<int>(scraps.vertices.size());
    for (const int v : whole.triangles[t]) {
      scraps.vertices.push_back(whole.vertices[static_cast<std::size_t>(v)]);
    }
    scraps.triangles.push_back({first, first + 1, first + 2});
  }
  const MassOfParts hull = mass_of_parts(scraps, stated);
  EXPECT_EQ(hull.source, MassSource::convex_hull);
  EXPECT_GT(hull.mass, 0.0);
  EXPECT_TRUE(component_volumes(scraps).empty());
}

std::string complaint(const StatedMass& stated, const TriangleMesh& mesh) {
  return test::refusal_of([&] { (void)mass_of_parts(mesh, stated); }).what();
}

TEST(MassParts, RefuseWhatCannotBe) {
  const TriangleMesh cube = make_box({0.1, 0.1, 0.1});
  const auto of = [&](const std::vector<MassPart>& parts) {
    return complaint({.density = 1000.0, .parts = parts}, cube);
  };
  const Primitive corner = box_at({0.1, 0.1, 0.1}, {0.05, 0.05, 0.05});
  EXPECT_EQ(of({inside(corner, -1.0)}), "parts[0].density: must be at least 0 (-1)");
  EXPECT_EQ(of({inside(corner, 2e6)}), "parts[0].density: must be at most 1e6 kg/m^3 (2e+06)");
  EXPECT_EQ(of({inside(corner, 10.0), inside(box_at({0.1, 0.1, 0.1}, {0.3, 0, 0}), 1.0)}),
            "parts[1].inside: must meet the object (box about [0.3, 0, 0])");
  EXPECT_EQ(of({inside(box_at({0.1, 0.1, 0.1}, {0.1, 0, 0}), 1.0)}),
            "parts[0].inside: must meet the object (box about [0.1, 0, 0])");
  EXPECT_EQ(of({beyond({0.2, 0, 0}, Vector3::UnitX(), 1.0)}),
            "parts[0].beyond: must meet the object (from [0.2, 0, 0] towards [1, 0, 0])");
  EXPECT_EQ(of({component(1, 1.0)}), "parts[0].component: the mesh has only one, 0 (1)");
  EXPECT_EQ(of({point({0, 0, 0}, -1.0)}), "parts[0].mass: must be positive (-1)");
  EXPECT_EQ(of({point({0, 0, 0.2}, 1.0)}),
            "parts[0].at: must be at most the object's diagonal from its middle ([0, 0, 0.2])");
  EXPECT_EQ(of({inside(corner, 10.0), beyond({0, 0, 0}, Vector3::UnitX(), 1.0)}),
            "parts[1]: must not overlap parts[0] (by 12.5 % of the object)");
  EXPECT_EQ(of({component(0, 10.0), inside(corner, 10.0)}),
            "parts[1]: must not overlap parts[0] (by 12.5 % of the object)");
  EXPECT_EQ(of({{.where = InsideShape{corner}, .density = 1.0, .mass = 1.0}}),
            "parts[0]: needs exactly one of density, mass");
  EXPECT_EQ(of({{.where = AtPoint{}, .density = 1.0}}), "parts[0]: a part at a point needs mass");
  EXPECT_EQ(of({{.where = InsideShape{{Cone{0.1, 0.0, 0.1}}}, .density = 1.0}}),
            "parts[0].inside.shape: must be box, cylinder or sphere (cone)");
  EXPECT_EQ(of(std::vector<MassPart>(33, point({0, 0, 0}, 1.0))), "parts: must be at most 32 (33)");
  EXPECT_EQ(complaint({.parts = {inside(corner, 1.0)}}, cube),
            "mass: needed, or density of what no part covers");
  EXPECT_EQ(complaint({.mass = 0.5, .parts = {point({0, 0, 0}, 0.7)}}, cube),
            "mass: must be more than what the parts weigh, 0.7 kg (0.5)");
  EXPECT_EQ(complaint({.density = 0.0, .parts = {point({0, 0, 0}, 0.7)}}, cube),
            "parts: the mass must not be all in one point or along a line");
  EXPECT_EQ(complaint({.density = 0.0, .parts = {}}, cube),
            "density: nothing of the object weighs anything");
  const TriangleMesh sheet{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  EXPECT_EQ(complaint({.mass = 1.0, .parts = {inside(corner, 1.0)}}, sheet),
            "parts[0]: the mesh encloses nothing that could have parts");
  EXPECT_EQ(complaint({.density = 1.0, .parts = {}}, sheet),
            "density: the mesh encloses nothing (1)");
}

}  // namespace
}  // namespace prehend
