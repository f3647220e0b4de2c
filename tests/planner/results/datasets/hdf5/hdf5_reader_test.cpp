#include "planner/results/datasets/hdf5/hdf5_reader.h"

#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "tests/planner/results/datasets/hdf5/written_hdf5.h"
#include "tests/support/refusal_of.h"
#include "tests/support/shared_data.h"

namespace prehend {
namespace {

using test::HowStored;
using test::made_data_set;
using test::Superblock;
using test::write_values;
using test::written_hdf5;

constexpr hsize_t kEndless = H5S_UNLIMITED;

std::size_t count_of(const std::vector<hsize_t>& shape) {
  return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

// Repeats often enough that deflate makes the values smaller.
std::vector<double> sample_values(std::size_t count) {
  Random random(count);
  std::vector<double> values(count);
  for (double& value : values) value = static_cast<double>(random.index(50)) - 7.25;
  return values;
}

struct NamedStorage {
  std::string name;
  HowStored how;
};

std::vector<NamedStorage> storages() {
  return {
      {"scalar", {}},
      {"contiguous", {.shape = {7, 3}}},
      {"compact", {.shape = {7, 3}, .compact = true}},
      {"none", {.shape = {0, 3}}},
      {"none_in_chunks", {.shape = {0, 3}, .most = {kEndless, 3}, .chunk = {4, 3}}},
      {"chunked", {.shape = {50, 4, 4}, .chunk = {7, 3, 4}}},
      {"deflate", {.shape = {50, 4, 4}, .chunk = {7, 3, 4}, .deflate = true}},
      {"all_filters",
       {.shape = {61, 5}, .chunk = {8, 2}, .shuffle = true, .deflate = true, .fletcher32 = true}},
      {"only_shuffle", {.shape = {61}, .chunk = {8}, .shuffle = true}},
      {"whole_edges", {.shape = {61, 5}, .chunk = {8, 2}, .deflate = true, .whole_edges = true}},
      {"one_chunk", {.shape = {9, 5}, .chunk = {9, 5}}},
      {"one_chunk_deflate", {.shape = {9, 5}, .chunk = {9, 5}, .deflate = true}},
      {"in_a_row", {.shape = {50, 5}, .chunk = {7, 3}, .early = true}},
      {"in_a_row_growing", {.shape = {5, 5}, .most = {20, 9}, .chunk = {2, 2}, .early = true}},
      {"fixed_growing", {.shape = {5, 5}, .most = {20, 9}, .chunk = {2, 2}}},
      {"fixed_pages", {.shape = {3000}, .chunk = {1}}},
      {"fixed_pages_deflate", {.shape = {3000}, .chunk = {2}, .deflate = true}},
      {"endless", {.shape = {40, 3}, .most = {kEndless, 3}, .chunk = {3, 2}}},
      {"endless_last",
       {.shape = {4, 700, 3}, .most = {4, kEndless, 5}, .chunk = {3, 2, 2}, .deflate = true}},
      {"endless_super_blocks", {.shape = {1500}, .most = {kEndless}, .chunk = {1}}},
      {"endless_twice", {.shape = {40, 30}, .most = {kEndless, kEndless}, .chunk = {1, 2}}},
      {"endless_twice_deflate",
       {.shape = {40, 30}, .most = {kEndless, kEndless}, .chunk = {1, 2}, .deflate = true}},
  };
}

class Hdf5Storage : public testing::TestWithParam<Superblock> {};

TEST_P(Hdf5Storage, ReadsWhatTheLibraryWrote) {
  for (const NamedStorage& storage : storages()) {
    SCOPED_TRACE(storage.name);
    const HowStored& how = storage.how;
    const std::vector<double> values = sample_values(count_of(how.shape));
    const Hdf5Reader file("set.h5", written_hdf5(GetParam(), [&](hid_t id) {
                            write_values(id, "values", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, how,
                                         values.data());
                          }));
    const Hdf5Shape shape(how.shape.begin(), how.shape.end());
    EXPECT_EQ(file.shape("values"), shape);
    EXPECT_EQ(file.numbers("values", shape), values);
  }
}

TEST_P(Hdf5Storage, WhatWasNeverWrittenIsTheFillValue) {
  for (const NamedStorage& storage : storages()) {
    SCOPED_TRACE(storage.name);
    const HowStored& how = storage.how;
    if (how.shape.empty() || count_of(how.shape) == 0) continue;
    const double fill = -3.5;
    const Hdf5Shape shape(how.shape.begin(), how.shape.end());
    std::vector<double> expected(count_of(how.shape), fill);
    const std::string bytes = written_hdf5(GetParam(), [&](hid_t id) {
      const Hdf5Id data = made_data_set(id, "partly", H5T_IEEE_F64LE, how, &fill);
      (void)made_data_set(id, "zeros", H5T_IEEE_F64LE, how);
      // One value, in the middle.
      std::vector<hsize_t> place;
      for (const hsize_t extent : how.shape) place.push_back(extent / 2);
      const Hdf5Id space(H5Dget_space(data.id()), H5Sclose);
      const Hdf5Id one(H5Screate(H5S_SCALAR), H5Sclose);
      H5Sselect_elements(space.id(), H5S_SELECT_SET, 1, place.data());
      const double value = 8.0;
      EXPECT_GE(H5Dwrite(data.id(), H5T_NATIVE_DOUBLE, one.id(), space.id(), H5P_DEFAULT, &value),
                0);
      std::size_t index = 0;
      for (std::size_t i = 0; i < place.size(); ++i) index = index * how.shape[i] + place[i];
      expected[index] = value;
    });
    const Hdf5Reader file("set.h5", bytes);
    EXPECT_EQ(file.numbers("partly", shape), expected);
    EXPECT_EQ(file.numbers("zeros", shape), std::vector<double>(expected.size(), 0.0));
  }
}

TEST_P(Hdf5Storage, ReadsNumbersOfAllTypes) {
  struct Type {
    hid_t stored;
    std::vector<double> values;
    bool whole = true;
  };
  const std::vector<Type> types = {
      {H5T_STD_I8LE, {-128, 127, 0}},
      {H5T_STD_I8BE, {-128, 127, 0}},
      {H5T_STD_U8LE, {0, 255}},
      {H5T_STD_I16LE, {-32768, 32767}},
      {H5T_STD_I16BE, {-32768, 32767, 258}},
      {H5T_STD_U16BE, {0, 65535}},
      {H5T_STD_I32LE, {-2147483648.0, 2147483647.0}},
      {H5T_STD_I32BE, {-2147483648.0, 2147483647.0, 1.0}},
      {H5T_STD_U32LE, {4294967295.0}},
      {H5T_STD_I64LE, {-9007199254740992.0, 9007199254740992.0}},
      {H5T_STD_I64BE, {-9007199254740992.0, 9007199254740992.0}},
      {H5T_STD_U64BE, {9007199254740992.0}},
      {H5T_IEEE_F32LE, {-1.5, 0.0, 1e30F, INFINITY}, false},
      {H5T_IEEE_F32BE, {-1.5, 0.0, 1e-40F}, false},
      {H5T_IEEE_F64BE, {-1.1, 5e-324, 1.7e308, -INFINITY}, false},
  };
  const std::string bytes = written_hdf5(GetParam(), [&](hid_t id) {
    for (std::size_t i = 0; i < types.size(); ++i) {
      write_values(id, "n" + std::to_string(i), types[i].stored, H5T_NATIVE_DOUBLE,
                   {.shape = {types[i].values.size()}}, types[i].values.data());
    }
  });
  const Hdf5Reader file("set.h5", bytes);
  for (std::size_t i = 0; i < types.size(); ++i) {
    SCOPED_TRACE(i);
    const std::string path = "n" + std::to_string(i);
    const std::vector<double>& values = types[i].values;
    EXPECT_EQ(file.numbers_or_nan(path, {values.size()}), values);
    EXPECT_EQ(file.floats_or_nan(path, {values.size()}),
              std::vector<float>(values.begin(), values.end()));
    if (!types[i].whole) {
      EXPECT_THROW((void)file.integers(path, {values.size()}), InputError);
    } else {
      EXPECT_EQ(file.integers(path, {values.size()}),
                std::vector<std::int64_t>(values.begin(), values.end()));
    }
  }
}

TEST_P(Hdf5Storage, ReadsNumbersOfHalfPrecision) {
  std::vector<double> values = {
      0.0, -0.0, 1.0, -65504.0, 5.9604644775390625e-8, 0.333251953125, INFINITY, -INFINITY};
  const std::string bytes = written_hdf5(GetParam(), [&](hid_t id) {
    const Hdf5Id half(H5Tcopy(H5T_IEEE_F32LE), H5Tclose);
    H5Tset_fields(half.id(), 15, 10, 5, 0, 10);
    H5Tset_size(half.id(), 2);
    H5Tset_ebias(half.id(), 15);
    write_values(id, "half", half.id(), H5T_NATIVE_DOUBLE, {.shape = {values.size()}},
                 values.data());
  });
  EXPECT_EQ(Hdf5Reader("set.h5", bytes).numbers_or_nan("half", {values.size()}), values);
}

TEST_P(Hdf5Storage, ReadsBooleansAndTypesThatAreNamed) {
  const std::vector<std::int8_t> flags = {1, 0, 1};
  const std::string bytes = written_hdf5(GetParam(), [&](hid_t id) {
    const Hdf5Id type(H5Tenum_create(H5T_STD_I8LE), H5Tclose);
    const std::int8_t no = 0;
    const std::int8_t yes = 1;
    H5Tenum_insert(type.id(), "FALSE", &no);
    H5Tenum_insert(type.id(), "TRUE", &yes);
    write_values(id, "flags", type.id(), type.id(), {.shape = {3}}, flags.data());
    H5Tcommit2(id, "flag", type.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    write_values(id, "named", type.id(), type.id(), {.shape = {3}}, flags.data());
  });
  const Hdf5Reader file("set.h5", bytes);
  EXPECT_EQ(file.integers("flags", {3}), (std::vector<std::int64_t>{1, 0, 1}));
  EXPECT_EQ(file.integers("named", {3}), (std::vector<std::int64_t>{1, 0, 1}));
  EXPECT_THROW((void)file.numbers("flags", {3}), InputError);
  EXPECT_THROW((void)file.shape("flag"), InputError);
}

TEST_P(Hdf5Storage, ReadsTexts) {
  std::vector<std::string> texts = {"", "a", "\xC3\xA4\xC3\xB6", std::string(5000, 'x')};
  for (int i = 0; i < 3000; ++i) texts.push_back("text " + std::to_string(i));
  const std::string bytes = written_hdf5(GetParam(), [&](hid_t id) {
    const Hdf5Id any(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(any.id(), H5T_VARIABLE);
    std::vector<const char*> pointers;
    for (const std::string& text : texts) pointers.push_back(text.c_str());
    write_values(id, "any", any.id(), any.id(), {.shape = {texts.size()}}, pointers.data());
    write_values(id, "in_chunks", any.id(), any.id(),
                 {.shape = {texts.size()}, .chunk = {100}, .deflate = true}, pointers.data());
    write_values(id, "one", any.id(), any.id(), {}, &pointers[3]);
    (void)made_data_set(id, "unset", any.id(), {.shape = {2}});
    for (const H5T_str_t padding : {H5T_STR_NULLTERM, H5T_STR_NULLPAD, H5T_STR_SPACEPAD}) {
      const Hdf5Id fixed(H5Tcopy(H5T_C_S1), H5Tclose);
      H5Tset_size(fixed.id(), 5);
      H5Tset_strpad(fixed.id(), padding);
      const std::string values = padding == H5T_STR_SPACEPAD
                                     ? "ab   cdefg     "
                                     : std::string("ab\0\0\0cdef\0\0\0\0\0\0", 15);
      write_values(id, "fixed" + std::to_string(padding), fixed.id(), fixed.id(), {.shape = {3}},
                   values.data());
    }
  });
  const Hdf5Reader file("set.h5", bytes);
  EXPECT_EQ(file.texts("any"), texts);
  EXPECT_EQ(file.texts("in_chunks"), texts);
  EXPECT_EQ(file.text("one"), texts[3]);
  EXPECT_EQ(file.texts("unset"), (std::vector<std::string>{"", ""}));
  EXPECT_EQ(file.texts("fixed0"), (std::vector<std::string>{"ab", "cdef", ""}));
  EXPECT_EQ(file.texts("fixed1"), (std::vector<std::string>{"ab", "cdef", ""}));
  EXPECT_EQ(file.texts("fixed2"), (std::vector<std::string>{"ab", "cdefg", ""}));
}

// Groups change how they store their members when they grow.
TEST_P(Hdf5Storage, FindsTheMembersOfGroupsOfAllSizes) {
  const std::vector<int> sizes = {0, 1, 8, 9, 40, 1000};
  const std::string bytes = written_hdf5(GetParam(), [&](hid_t id) {
    for (const int size : sizes) {
      const std::string group = "group" + std::to_string(size);
      test::make_group(id, group);
      const std::int64_t value = size;
      for (int i = 0; i < size; ++i) {
        write_values(id, group + "/a_member_of_number_" + std::to_string(i), H5T_STD_I64LE,
                     H5T_NATIVE_INT64, {}, &value);
      }
    }
  });
  const Hdf5Reader file("set.h5", bytes);
  for (const int size : sizes) {
    const std::string group = "group" + std::to_string(size);
    const std::vector<std::string> members = file.members(group);
    ASSERT_EQ(members.size(), static_cast<std::size_t>(size));
    EXPECT_TRUE(std::is_sorted(members.begin(), members.end()));
    for (std::size_t i = 0; i < members.size(); i += 97) {
      EXPECT_EQ(file.integers(group + "/" + members[i], {}).front(), size);
    }
    EXPECT_FALSE(file.has(group + "/a_member"));
    EXPECT_FALSE(file.has(group + "/a_member_of_number_0/more"));
  }
}

TEST_P(Hdf5Storage, RefusesWhatItDoesNotReadAndSaysWhatToDo) {
  const std::vector<double> values = sample_values(64);
  const std::string bytes = written_hdf5(GetParam(), [&](hid_t id) {
    const std::vector<hsize_t> shape = {64};
    const Hdf5Id space(H5Screate_simple(1, shape.data(), nullptr), H5Sclose);
    const Hdf5Id scaled(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_chunk(scaled.id(), 1, shape.data());
    H5Pset_scaleoffset(scaled.id(), H5Z_SO_FLOAT_DSCALE, 2);
    const Hdf5Id filter(
        H5Dcreate2(id, "filter", H5T_IEEE_F64LE, space.id(), H5P_DEFAULT, scaled.id(), H5P_DEFAULT),
        H5Dclose);
    const Hdf5Id outside(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_external(outside.id(), "/etc/passwd", 0, 512);
    const Hdf5Id external(H5Dcreate2(id, "external", H5T_IEEE_F64LE, space.id(), H5P_DEFAULT,
                                     outside.id(), H5P_DEFAULT),
                          H5Dclose);
    const Hdf5Id nothing(H5Screate(H5S_NULL), H5Sclose);
    const Hdf5Id null(
        H5Dcreate2(id, "null", H5T_IEEE_F64LE, nothing.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
        H5Dclose);
    const Hdf5Id pair(H5Tcreate(H5T_COMPOUND, 16), H5Tclose);
    H5Tinsert(pair.id(), "x", 0, H5T_NATIVE_DOUBLE);
    (void)made_data_set(id, "pair", pair.id(), {.shape = {64}});
    H5Lcreate_soft("/values", id, "soft", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_external("/etc/other.h5", "/values", id, "elsewhere", H5P_DEFAULT, H5P_DEFAULT);
    write_values(id, "values", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, {.shape = shape}, values.data());
    (void)made_data_set(id, "huge", H5T_IEEE_F64LE, {.shape = {1U << 30U}, .chunk = {1U << 20U}});
    const std::uint64_t large = std::uint64_t{1} << 63U;
    write_values(id, "large", H5T_STD_U64LE, H5T_NATIVE_UINT64, {}, &large);
  });
  const Hdf5Reader file("set.h5", bytes);
  const std::vector<std::pair<std::string, std::string>> refused = {
      {"filter", "h5repack -f GZIP=6"}, {"external", "h5repack -l CONTI"},
      {"null", "has no values"},        {"pair", "must be numbers"},
      {"soft", "must not be a link"},   {"elsewhere", "must not be a link"},
      {"huge", "more values than"},     {"absent", "is missing"},
  };
  for (const auto& [path, problem] : refused) {
    const InputError error = test::refusal_of([&, &name = path] {
      (void)file.numbers(name, name == "huge" ? Hdf5Shape{1U << 30U} : Hdf5Shape{64});
    });
    EXPECT_EQ(error.field(), path);
    EXPECT_EQ(error.file(), "set.h5");
    EXPECT_NE(error.problem().find(problem), std::string::npos) << error.what();
  }
  EXPECT_THROW((void)file.numbers("values", {32, 2}), InputError);
  EXPECT_THROW((void)file.integers("large", {}), InputError);
  EXPECT_THROW((void)file.members("values"), InputError);
  EXPECT_THROW((void)file.texts("values"), InputError);
  EXPECT_EQ(file.numbers("values", {64}), values);
}

INSTANTIATE_TEST_SUITE_P(Versions, Hdf5Storage,
                         testing::Values(Superblock::version_0, Superblock::version_1,
                                         Superblock::version_2, Superblock::version_3),
                         [](const auto& version) {
                           return "superblock_" + std::to_string(static_cast<int>(version.param));
                         });

// So many chunks that the blocks of their array have pages.
TEST(Hdf5Reader, ReadsChunksOfPagedBlocks) {
  constexpr std::size_t kFar = 140000;
  std::vector<std::int64_t> expected(kFar + 1, 0);
  const std::string bytes = written_hdf5(Superblock::version_3, [&](hid_t id) {
    const Hdf5Id data = made_data_set(id, "sparse", H5T_STD_I8LE,
                                      {.shape = {kFar + 1}, .most = {kEndless}, .chunk = {1}});
    const Hdf5Id space(H5Dget_space(data.id()), H5Sclose);
    const Hdf5Id one(H5Screate(H5S_SCALAR), H5Sclose);
    for (hsize_t place = kFar; place > 132000; place -= 211) {
      const auto value = static_cast<std::int64_t>(place % 100);
      H5Sselect_elements(space.id(), H5S_SELECT_SET, 1, &place);
      H5Dwrite(data.id(), H5T_NATIVE_INT64, one.id(), space.id(), H5P_DEFAULT, &value);
      expected[place] = value;
    }
    // Room for all the chunks: a file that claims more than it can hold is refused.
    const std::vector<std::int8_t> room(1U << 20U, 1);
    write_values(id, "room", H5T_STD_I8LE, H5T_NATIVE_INT8, {.shape = {room.size()}}, room.data());
  });
  EXPECT_EQ(Hdf5Reader("set.h5", bytes).integers("sparse", {kFar + 1}), expected);
}

// Of real files each data set is what HDF5's own library reads.
TEST(Hdf5Reader, ReadsPublishedFilesAsTheLibraryDoes) {
  PREHEND_NEEDS_SHARED("data/acronym");
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(test::shared("data/acronym"))) {
    if (entry.path().extension() != ".h5") continue;
    ++files;
    SCOPED_TRACE(entry.path().string());
    const Hdf5Reader file(entry.path());
    const Hdf5Id id(H5Fopen(entry.path().c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    for (const std::string path :
         {"grasps/transforms", "grasps/qualities/flex/object_in_gripper",
          "grasps/qualities/flex/object_motion_during_closing_linear",
          "grasps/qualities/flex/object_motion_during_shaking_angular", "gripper/configuration",
          "object/com", "object/inertia", "object/mass", "object/scale", "object/volume"}) {
      const Hdf5Id data(H5Dopen2(id.id(), path.c_str(), H5P_DEFAULT), H5Dclose);
      ASSERT_TRUE(data.valid()) << path;
      const Hdf5Shape shape = file.shape(path);
      const std::vector<double> values = file.numbers_or_nan(path, shape);
      std::vector<double> theirs(values.size());
      H5Dread(data.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, theirs.data());
      for (std::size_t i = 0; i < values.size(); ++i) {
        ASSERT_TRUE(values[i] == theirs[i] || (std::isnan(values[i]) && std::isnan(theirs[i])))
            << path << " " << i;
      }
    }
    EXPECT_NE(file.text("object/file").find("Mug"), std::string::npos);
    EXPECT_EQ(file.text("gripper/type"), "panda");
  }
  EXPECT_GT(files, 0);
}

}  // namespace
}  // namespace prehend
