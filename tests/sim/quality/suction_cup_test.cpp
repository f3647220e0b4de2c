#include "sim/quality/suction_cup.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/quality/cup_balance.h"
#include "sim/quality/grasp_matrix.h"
#include "sim/quality/task.h"
#include "sim/quality/wrench.h"
#include "sim/quality/wrench_space.h"

namespace prehend::test {
namespace {

// Of solutions of the conic program, which stops at a gap of 1e-10 of the equilibrated program.
constexpr double kSolved = 1e-6;

constexpr double kLipRadius = 0.015;  // m
constexpr double kLipFriction = 0.5;
constexpr double kCupVacuum = 40.0;  // N
constexpr double kStiff = 1e6;       // N/m: no elastic bound below that of the relaxed side

struct Loads {
  double pull = 0.0;   // along the normal, away from the cup [N]
  double slide = 0.0;  // along the first tangent [N]
  double twist = 0.0;  // about the normal [N m]
  double tilt = 0.0;   // about the second tangent [N m]
};

Contact cup_of(double lip_stiffness, const Eigen::Vector3d& normal = Eigen::Vector3d::UnitZ(),
               const Eigen::Vector3d& position = Eigen::Vector3d::Zero()) {
  return cup_contact(position, normal, kLipRadius, kLipFriction, kCupVacuum, lip_stiffness, 0.1);
}

// What acts on the object, about the origin.
Wrench external(const Contact& cup, const WrenchFrame& frame, const Loads& loads) {
  const ContactMap map = contact_map(cup, frame);
  return map * Eigen::Vector4d(loads.pull, loads.slide, 0.0, loads.twist) +
         tilt_map(cup, frame).col(1) * loads.tilt;
}

// The part of its vacuum that the cup needs.
double part(const Contact& cup, const Loads& loads) {
  const WrenchFrame frame{.torque_scale = 20.0};
  const CupForces forces = cup_forces({&cup, 1}, frame, external(cup, frame, loads),
                                      ForceMeasure::largest_normal, CupUnit::newtons);
  EXPECT_EQ(forces.outcome, ForceOutcome::balanced);
  EXPECT_NEAR(forces.lowest, forces.measure, kSolved * forces.measure);
  return forces.measure;
}

std::vector<Contact> turned_cups(double lip_stiffness) {
  Random random(5);
  std::vector<Contact> cups = {cup_of(lip_stiffness)};
  for (int i = 0; i < 8; ++i) cups.push_back(cup_of(lip_stiffness, random.direction()));
  return cups;
}

TEST(SuctionCup, IsPulledOffByTheForceOfItsVacuum) {
  for (const Contact& cup : turned_cups(kStiff)) {
    EXPECT_NEAR(part(cup, {.pull = kCupVacuum}), 1.0, kSolved);
    EXPECT_NEAR(part(cup, {.pull = 0.25 * kCupVacuum}), 0.25, kSolved);
  }
}

// Slides at mu (V + P), P the force that presses the object onto the cup, or -P that pulls it.
TEST(SuctionCup, SlidesAtTheFrictionOfVacuumAndPreload) {
  for (const Contact& cup : turned_cups(kStiff)) {
    for (const double pressed : {-30.0, -10.0, 0.0, 10.0, 30.0}) {
      const double slides = kLipFriction * (kCupVacuum + pressed);
      EXPECT_NEAR(part(cup, {.pull = -pressed, .slide = slides}), 1.0, kSolved) << pressed;
      const double twists = kLipRadius * slides;
      EXPECT_NEAR(part(cup, {.pull = -pressed, .twist = twists}), 1.0, kSolved) << pressed;
      const double both = std::sqrt(0.5);
      EXPECT_NEAR(part(cup, {.pull = -pressed, .slide = both * slides, .twist = both * twists}),
                  1.0, kSolved);
    }
  }
}

// Pulled at the distance a from its axis it is peeled off at F = V r / (2 a + r): the torque F a is
// all that the ring bears, r (V - F) / 2.
TEST(SuctionCup, IsPeeledOffWhereOneSideOfTheRingIsRelaxed) {
  for (const Contact& cup : turned_cups(kStiff)) {
    for (const double arm : {0.0, 0.5 * kLipRadius, kLipRadius, 0.05, 0.2}) {
      const double peels = kCupVacuum * kLipRadius / (2.0 * arm + kLipRadius);
      EXPECT_NEAR(part(cup, {.pull = peels, .tilt = peels * arm}), 1.0, kSolved) << arm;
    }
  }
}

// The torque of a lip that is bent by the strain 0.1 is K r^2 0.1 / 2, that is pi r kappa.
TEST(SuctionCup, OfSoftLipTiltsAtItsElasticTorque) {
  constexpr double kLip = 8000.0;
  constexpr double kElastic = 0.5 * kLip * 0.1 * kLipRadius * kLipRadius;
  static_assert(kElastic < 0.5 * kLipRadius * kCupVacuum);
  for (const Contact& cup : turned_cups(kLip)) {
    EXPECT_NEAR(cup.moment * kCupVacuum, kElastic, 1e-12);
    EXPECT_NEAR(part(cup, {.tilt = kElastic}), 1.0, kSolved);
  }
}

TEST(SuctionCup, SeveralCupsShareALoad) {
  std::vector<Contact> cups;
  for (const double x : {-0.03, 0.03}) {
    for (const double y : {-0.03, 0.03}) {
      cups.push_back(cup_of(8000.0, Eigen::Vector3d::UnitZ(), {x, y, 0.0}));
    }
  }
  Wrench pull = Wrench::Zero();
  pull[2] = kCupVacuum;
  const auto measure = [&](ForceMeasure kind) {
    return cup_forces(cups, {}, pull, kind, CupUnit::newtons).measure;
  };
  EXPECT_NEAR(measure(ForceMeasure::largest_normal), 0.25, kSolved);
  EXPECT_NEAR(measure(ForceMeasure::sum_of_normals), 1.0, kSolved);
}

// Random forces within the bounds of the header.
Wrench random_wrench(const Contact& cup, const WrenchFrame& frame, Random& random) {
  const double lip = random.uniform(0.0, 2.0);
  const Eigen::Vector3d grip = random.uniform(0.0, 1.0) * random.direction();
  const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
  const double tilt = random.uniform(0.0, 1.0) * std::min(0.5 * cup.torsion * lip, cup.moment);
  Wrench wrench =
      contact_map(cup, frame) * Eigen::Vector4d(lip - 1.0, cup.friction * lip * grip.x(),
                                                cup.friction * lip * grip.y(),
                                                cup.friction * lip * cup.torsion * grip.z());
  wrench += tilt_map(cup, frame) * (tilt * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  return wrench;
}

TEST(SuctionCup, SupportIsThatOfItsSet) {
  Random random(8);
  for (const double stiffness : {0.0, 8000.0, kStiff}) {
    const Eigen::Vector3d normal = random.direction();
    const Contact cup = cup_of(stiffness, normal, Eigen::Vector3d(0.02, -0.05, 0.03));
    const WrenchFrame frame{.torque_scale = 15.0};
    const Wrenches few = contact_wrenches({&cup, 1}, frame, 8);
    const Wrenches many = contact_wrenches({&cup, 1}, frame, 64);
    ASSERT_EQ(few.cols(), cup_corner_count(8));
    for (int i = 0; i < 100; ++i) {
      Wrench u;
      for (double& entry : u) entry = random.uniform(-1.0, 1.0);
      const double exact = u.dot(cup_support(cup, frame, u));
      for (int j = 0; j < 50; ++j) {
        EXPECT_LE(u.dot(random_wrench(cup, frame, random)), exact + 1e-12);
      }
      const double largest = (u.transpose() * few).maxCoeff();
      const double finer = (u.transpose() * many).maxCoeff();
      EXPECT_LE(largest, exact + 1e-12);
      EXPECT_LE(finer, exact + 1e-12);
      EXPECT_GE(exact, -1e-12);  // the set contains the origin
      // Inscribed polygons of 8 and 16 corners leave 1 - cos(pi / 8) and 1 - cos(pi / 16) of what
      // is not along the normal out; the latitudes of the ellipsoid a little more.
      const double width = cup_support(cup, frame, u).norm() * u.norm();
      EXPECT_GE(largest, exact - 0.1 * width);
      EXPECT_GE(finer, exact - 0.08 * width);
    }
  }
}

// A ball around the origin is in the set while it is on the inner side of each bound: of the pull,
// of the cones of friction and of the relaxed side, and of the elastic torque.
TEST(SuctionCup, EpsilonOfOneCupIsItsWeakestBound) {
  const auto cone = [](double slope) { return slope / std::hypot(1.0, slope); };
  for (const double stiffness : {2000.0, 8000.0, 30000.0, kStiff}) {
    for (const double scale : {5.0, 20.0, 200.0}) {
      const Contact cup = cup_of(stiffness);
      const WrenchFrame frame{.torque_scale = scale};
      const double exact =
          std::min({1.0, cone(kLipFriction), cone(scale * kLipFriction * kLipRadius),
                    cone(0.5 * scale * kLipRadius), scale * cup.moment});
      const EpsilonBracket smooth = grasp_epsilon({&cup, 1}, frame, {.cone = FrictionCone::exact});
      EXPECT_LE(smooth.lower, exact * (1.0 + 1e-9));
      EXPECT_GE(smooth.upper, exact * (1.0 - 1e-9));
      EXPECT_TRUE(smooth.force_closure());
      const EpsilonBracket pyramid = grasp_epsilon({&cup, 1}, frame);
      EXPECT_LE(pyramid.lower, exact * (1.0 + 1e-9));
      EXPECT_GE(pyramid.lower, 0.85 * exact);
    }
  }
}

TEST(SuctionCup, WithoutFrictionOrStiffnessIsNotInForceClosure) {
  Contact slippery = cup_of(8000.0);
  slippery.friction = 0.0;
  const Contact soft = cup_of(0.0);
  for (const Contact& cup : {slippery, soft}) {
    EXPECT_FALSE(grasp_epsilon({&cup, 1}, {}).force_closure());
  }
  EXPECT_EQ(
      cup_forces({&soft, 1}, {}, Wrench::Unit(4), ForceMeasure::largest_normal, CupUnit::vacuum)
          .outcome,
      ForceOutcome::impossible);
}

// The resistance to a wrench is the distance of the border of the set along it: never below
// epsilon, and on the border where the support point is balanced.
TEST(SuctionCup, ResistsWhatIsInItsSet) {
  Random random(9);
  const WrenchFrame frame{.torque_scale = 20.0};
  const std::vector<Contact> cups = {cup_of(8000.0),
                                     cup_of(8000.0, random.direction(), {0.02, 0.01, 0.0})};
  const WrenchSpaceOptions exact{.cone = FrictionCone::exact};
  const double epsilon = grasp_epsilon(cups, frame, exact).lower;
  ASSERT_GT(epsilon, 0.0);
  const auto set = wrench_space(cups, frame, exact);
  for (int i = 0; i < 20; ++i) {
    Wrench u;
    for (double& entry : u) entry = random.uniform(-1.0, 1.0);
    const Interval any =
        task_resistance(cups, frame, TaskWrenches{{Wrench(u.normalized())}}, exact);
    EXPECT_GE(any.upper, epsilon);
    EXPECT_NEAR(any.lower, any.upper, 1e-5 * any.upper);
    const Wrench border = -set->support(u);
    const Interval one = task_resistance(cups, frame, TaskWrenches{{border}}, exact);
    EXPECT_NEAR(one.lower, 1.0, 1e-5);
  }
}

TEST(SuctionCup, TransmitsSixComponents) {
  const Contact cup = cup_of(8000.0);
  const Eigen::MatrixXd matrix = grasp_matrix({&cup, 1}, {});
  EXPECT_EQ(matrix.cols(), 6);
  EXPECT_NEAR(smallest_singular_value(matrix), 1.0, 1e-12);
}

TEST(SuctionCup, RefusesWhatItCannotAnswer) {
  Contact cup = cup_of(8000.0);
  EXPECT_THROW((void)balancing_forces({&cup, 1}, {}, Wrench::Unit(0)), InputError);
  cup.moment = -1.0;
  EXPECT_THROW((void)contact_wrenches({&cup, 1}, {}), InputError);
  cup = cup_of(8000.0);
  cup.vacuum = -1.0;
  EXPECT_THROW((void)contact_wrenches({&cup, 1}, {}), InputError);
}

}  // namespace
}  // namespace prehend::test
