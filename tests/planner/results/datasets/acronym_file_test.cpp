#include "planner/results/datasets/acronym_file.h"

#include <cmath>
#include <limits>
#include <span>
#include <thread>

#include <gtest/gtest.h>

#include "planner/results/datasets/hdf5/hdf5_reader.h"
#include "planner/results/datasets/hdf5_writer.h"
#include "sim/base/input_error.h"
#include "tests/planner/results/datasets/sample_sets.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

using test::file_with;
using test::refusal_of;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// A file with the layout of ACRONYM's authors, made by hand: what is in it can be changed before it
// is written.
struct TheirFile {
  std::string quality = "flex";
  std::vector<double> transforms = std::vector<double>(32, 0.0);
  Hdf5Shape shape = {2, 4, 4};
  std::vector<std::int64_t> held = {1, 0};
  std::vector<double> shaken_linear = {0.01, kNaN};
  std::vector<double> shaken_angular = {0.2, kNaN};
  double scale = 0.5;
  bool with_object = true;

  TheirFile() {
    for (const std::size_t grasp : {0U, 16U}) {
      for (std::size_t i = 0; i < 16; ++i) transforms[grasp + i] = i % 5 == 0 ? 1.0 : 0.0;
    }
    transforms[11] = -0.1;
  }

  std::string bytes() const {
    Hdf5Writer file;
    file.group("grasps");
    file.group("grasps/qualities");
    const std::string group = "grasps/qualities/" + quality;
    file.group(group);
    file.array("grasps/transforms", shape, std::span<const double>(transforms));
    file.array(group + "/object_in_gripper", {held.size()}, std::span<const std::int64_t>(held));
    const std::string shaken = group + "/object_motion_during_shaking_";
    file.array(shaken + "linear", {shaken_linear.size()}, std::span<const double>(shaken_linear));
    file.array(shaken + "angular", {shaken_angular.size()},
               std::span<const double>(shaken_angular));
    file.group("gripper");
    file.text("gripper/type", "panda");
    const double opening = 0.04;
    file.array("gripper/configuration", {1}, std::span(&opening, 1));
    if (!with_object) return file.bytes();
    file.group("object");
    file.text("object/file", "meshes/Mug/1.obj");
    file.scalar("object/scale", scale);
    file.scalar("object/mass", 0.25);
    return file.bytes();
  }

  InputError refusal() const {
    const auto file = file_with(bytes(), ".h5");
    return refusal_of([&] { (void)read_acronym(file); });
  }
};

class AcronymFileOfSize : public testing::TestWithParam<std::size_t> {};

TEST_P(AcronymFileOfSize, ReadsBackTheSameToTheBitAndIsWrittenAsTheSameBytes) {
  Random random(GetParam() + 1);
  for (const double known : {0.0, 0.7, 1.0}) {
    const GraspSet set = test::random_set(random, GetParam(), known);
    const std::string bytes = acronym_bytes(set);
    const GraspSet read = read_acronym(file_with(bytes, ".h5"));
    test::expect_same(read, set);
    EXPECT_EQ(acronym_bytes(read), bytes);
    EXPECT_EQ(acronym_bytes(set), bytes);
  }
}

// The largest takes several chunks of every array.
INSTANTIATE_TEST_SUITE_P(Sizes, AcronymFileOfSize, testing::Values(0, 1, 2, 7, 64, 9000));

TEST(AcronymFile, ManySmallSetsReadBackTheSame) {
  Random random(11);
  for (int i = 0; i < 100; ++i) {
    const GraspSet set = test::random_set(random, random.index(20));
    test::expect_same(read_acronym(file_with(acronym_bytes(set), ".h5")), set);
  }
}

TEST(AcronymFile, IsWrittenAndReadOnSeveralThreads) {
  Random random(12);
  std::vector<GraspSet> sets;
  for (std::size_t i = 0; i < 8; ++i) sets.push_back(test::random_set(random, 50 * i));
  std::vector<std::string> together(sets.size());
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < sets.size(); ++i) {
      threads.emplace_back([&, i] {
        const auto file = file_with(acronym_bytes(sets[i]), std::to_string(i) + ".h5");
        together[i] = acronym_bytes(read_acronym(file));
      });
    }
  }
  for (std::size_t i = 0; i < sets.size(); ++i) EXPECT_EQ(together[i], acronym_bytes(sets[i]));
}

TEST(AcronymFile, HasTheNamesTypesAndShapesOfAcronym) {
  Random random(3);
  GraspSet set = test::random_set(random, 5, 1.0);
  set.configuration = 0.08;
  const Hdf5Reader file(file_with(acronym_bytes(set), ".h5"));
  EXPECT_EQ(file.shape("grasps/transforms"), (Hdf5Shape{5, 4, 4}));
  const std::string quality = "grasps/qualities/prehend/";
  EXPECT_EQ(file.shape(quality + "object_in_gripper"), Hdf5Shape{5});
  for (const std::string motion :
       {"closing_linear", "closing_angular", "shaking_linear", "shaking_angular"}) {
    EXPECT_EQ(file.shape(quality + "object_motion_during_" + motion), Hdf5Shape{5});
  }
  EXPECT_EQ(file.text("gripper/type"), set.hand);
  EXPECT_EQ(file.numbers("gripper/configuration", {1}).front(), 0.08);
  EXPECT_EQ(file.text("object/file"), set.object.file);
  for (const std::string scalar : {"scale", "density", "friction", "mass", "volume"}) {
    EXPECT_EQ(file.shape("object/" + scalar), Hdf5Shape{}) << scalar;
  }
  EXPECT_EQ(file.shape("object/com"), Hdf5Shape{3});
  EXPECT_EQ(file.shape("object/inertia"), (Hdf5Shape{3, 3}));
  // Row by row, the translation in the last column.
  const std::vector<double> matrices = file.numbers("grasps/transforms", {5, 4, 4});
  EXPECT_EQ(matrices[3], set.grasps[0].X_OH.translation().x());
  EXPECT_EQ(matrices[4], set.grasps[0].X_OH.linear()(1, 0));
}

TEST(AcronymFile, WhatNoGraspHasIsLeftOut) {
  Random random(4);
  GraspSet set = test::random_set(random, 5, 0.0);
  set.configuration = {};
  const Hdf5Reader file(file_with(acronym_bytes(set), ".h5"));
  EXPECT_EQ(file.members("grasps/qualities/prehend"),
            std::vector<std::string>{"object_in_gripper"});
  EXPECT_EQ(file.members("gripper"), std::vector<std::string>{"type"});
}

TEST(AcronymFile, ReadsWhatAcronymHas) {
  for (const std::string quality : {"flex", "another"}) {
    TheirFile their;
    their.quality = quality;
    const GraspSet set = read_acronym(file_with(their.bytes(), ".h5"));
    ASSERT_EQ(set.grasps.size(), 2U);
    EXPECT_EQ(set.grasps[0].outcome, Outcome::stable);
    EXPECT_EQ(set.grasps[1].outcome, Outcome::not_force_closure);
    EXPECT_EQ(set.grasps[0].X_OH.translation(), Vector3(0.0, 0.0, -0.1));
    EXPECT_EQ(set.grasps[0].X_OH_aim.matrix(), set.grasps[0].X_OH.matrix());
    ASSERT_TRUE(set.grasps[0].shaking.has_value());
    EXPECT_EQ(set.grasps[0].shaking->linear, 0.01);
    EXPECT_EQ(set.grasps[0].shaking->angular, 0.2);
    EXPECT_FALSE(set.grasps[1].shaking.has_value());
    EXPECT_FALSE(set.grasps[0].closing.has_value());
    EXPECT_EQ(set.hand, "panda");
    EXPECT_EQ(set.configuration, 0.04);
    EXPECT_EQ(set.object.file, "meshes/Mug/1.obj");
    EXPECT_EQ(set.object.scale, 0.5);
    EXPECT_EQ(set.object.mass, 0.25);
    EXPECT_EQ(set.object.density, 0.0);
  }
}

// Seven digits, as some files are printed.
TEST(AcronymFile, MatricesOfFewDigitsBecomeTheNearestRotation) {
  TheirFile their;
  const double angle = 0.3;
  their.transforms[0] = their.transforms[5] = std::round(1e7 * std::cos(angle)) / 1e7;
  their.transforms[4] = std::round(1e7 * std::sin(angle)) / 1e7;
  their.transforms[1] = -their.transforms[4];
  const GraspSet set = read_acronym(file_with(their.bytes(), ".h5"));
  const Matrix3 rotation = set.grasps[0].X_OH.linear();
  EXPECT_LT((rotation.transpose() * rotation - Matrix3::Identity()).norm(), 1e-14);
  EXPECT_NEAR(rotation(0, 0), std::cos(angle), 1e-7);
  EXPECT_NEAR(rotation(1, 0), std::sin(angle), 1e-7);
}

TEST(AcronymFile, NamesTheDataSetThatCannotBeUsed) {
  struct Mistake {
    void (*make)(TheirFile&);
    std::string field;
    std::string problem;
  };
  const std::string quality = "grasps/qualities/flex/";
  const std::vector<Mistake> mistakes = {
      {[](TheirFile& f) { f.transforms[17] = 0.5; }, "grasps/transforms[1]", "rigid"},
      {[](TheirFile& f) { f.transforms[0] = -1.0; }, "grasps/transforms[0]", "rigid"},
      {[](TheirFile& f) { f.transforms[15] = 2.0; }, "grasps/transforms[0]", "rigid"},
      {[](TheirFile& f) { f.transforms[3] = 1e31; }, "grasps/transforms[0]", "rigid"},
      {[](TheirFile& f) { f.transforms[19] = kNaN; }, "grasps/transforms[1]", "must be finite"},
      {[](TheirFile& f) {
         f.shape = {2, 16};
       },
       "grasps/transforms", "must have the shape"},
      {[](TheirFile& f) { f.shape = {32}; }, "grasps/transforms", "must have the shape"},
      {[](TheirFile& f) { f.held = {1}; }, quality + "object_in_gripper", "must have the shape"},
      {[](TheirFile& f) { f.held[1] = 2; }, quality + "object_in_gripper[1]", "must be 0 or 1"},
      {[](TheirFile& f) { f.shaken_linear[0] = kNaN; },
       quality + "object_motion_during_shaking_linear[0]", "must be finite"},
      {[](TheirFile& f) { f.shaken_angular = {0.0}; },
       quality + "object_motion_during_shaking_angular", "must have the shape"},
      {[](TheirFile& f) { f.scale = 0.0; }, "object/scale", "must be above 0"},
      {[](TheirFile& f) { f.scale = kNaN; }, "object/scale", "must be finite"},
      {[](TheirFile& f) { f.with_object = false; }, "object/file", "is missing"},
  };
  for (const Mistake& mistake : mistakes) {
    TheirFile file;
    mistake.make(file);
    const InputError error = file.refusal();
    EXPECT_EQ(error.field(), mistake.field) << error.what();
    EXPECT_NE(error.problem().find(mistake.problem), std::string::npos) << error.what();
    EXPECT_FALSE(error.file().empty());
  }
}

TEST(AcronymFile, RefusesToWriteWhatNoReaderCouldUse) {
  struct Mistake {
    void (*make)(GraspSet&);
    std::string field;
  };
  const std::vector<Mistake> mistakes = {
      {[](GraspSet& s) { s.grasps[1].X_OH.linear()(0, 0) += 1e-6; }, "grasps[1].X_OH"},
      {[](GraspSet& s) { s.grasps[0].X_OH_aim.translation().x() = kNaN; }, "grasps[0].X_OH_aim"},
      {[](GraspSet& s) {
         s.grasps[0].approach_O = {0.0, 0.0, 2.0};
       },
       "grasps[0].approach_O"},
      {[](GraspSet& s) { s.grasps[0].epsilon.upper = kNaN; }, "grasps[0].epsilon"},
      {[](GraspSet& s) {
         s.grasps[0].dofs = {1.0, 2.0, 3.0};
       },
       "grasps[0].dofs"},
      {[](GraspSet& s) { s.grasps[0].features = {1.0F}; }, "grasps[0].features"},
      {[](GraspSet& s) {
         s.grasps[0].closing = ObjectShift{kNaN, 0.0};
       },
       "grasps[0].closing"},
      {[](GraspSet& s) { s.grasps[0].contacts = {{.link = 1}}; }, "grasps[0].contacts[0].link"},
      {[](GraspSet& s) {
         s.grasps[0].contacts = {{.n_O = {0.0, 0.0, 0.5}}};
       },
       "grasps[0].contacts[0].n_O"},
      {[](GraspSet& s) { s.hand.push_back('\0'); }, "hand"},
      {[](GraspSet& s) { s.object.scale = 0.0; }, "object.scale"},
      {[](GraspSet& s) { s.object.inertia(1, 2) = kNaN; }, "object.inertia"},
  };
  GraspSet sound;
  sound.dofs = {"opening"};
  sound.links = {"finger"};
  sound.grasps.resize(2);
  (void)acronym_bytes(sound);
  for (const Mistake& mistake : mistakes) {
    GraspSet set = sound;
    mistake.make(set);
    EXPECT_EQ(refusal_of([&] { (void)acronym_bytes(set); }).field(), mistake.field);
  }
}

TEST(AcronymFile, RefusesWhatIsNoHdf5File) {
  const auto file = file_with("no such file", ".h5");
  EXPECT_FALSE(is_hdf5_file(file));
  EXPECT_NE(refusal_of([&] { (void)read_acronym(file); }).problem().find("HDF5"),
            std::string::npos);
  const auto written = file_with(TheirFile().bytes(), "_written.h5");
  EXPECT_TRUE(is_hdf5_file(written));
  EXPECT_FALSE(is_hdf5_file("no_such_file.h5"));
}

// Cut off anywhere it is refused, and never crashes.
TEST(AcronymFile, RefusesWhatWasCutOff) {
  const std::string bytes = TheirFile().bytes();
  for (std::size_t size = 1; size < bytes.size(); size += 61) {
    const auto file = file_with(bytes.substr(0, size), ".h5");
    EXPECT_THROW((void)read_acronym(file), InputError) << size;
  }
}

}  // namespace
}  // namespace prehend
