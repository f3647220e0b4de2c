// Files that are damaged: every one of them is read, or refused with an InputError, and takes no
// more memory than its size allows.
#include <functional>

#include <gtest/gtest.h>

#include "planner/results/datasets/hdf5/checksum.h"
#include "planner/results/datasets/hdf5/hdf5_reader.h"
#include "sim/base/random.h"
#include "tests/planner/results/datasets/hdf5/written_hdf5.h"
#include "tests/support/peak_memory.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

using test::Superblock;
using test::written_hdf5;

constexpr long kMuch = 600000;  // kB: what the sanitizers keep of freed memory is in it

// A file with some of everything.
std::string sample_file(Superblock version) {
  return written_hdf5(version, [](hid_t id) {
    const std::vector<double> values(96, 0.25);
    const std::vector<hsize_t> shape = {8, 12};
    const auto write = [&](const std::string& path, const test::HowStored& how) {
      test::write_values(id, path, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, how, values.data());
    };
    test::make_group(id, "group");
    write("group/plain", {.shape = shape});
    write("group/compact", {.shape = shape, .compact = true});
    write("group/chunks", {.shape = shape, .chunk = {3, 5}});
    write("group/filters",
          {.shape = shape, .chunk = {4, 6}, .shuffle = true, .deflate = true, .fletcher32 = true});
    write("group/endless", {.shape = shape, .most = {H5S_UNLIMITED, 12}, .chunk = {1, 4}});
    write("group/endless_twice",
          {.shape = shape, .most = {H5S_UNLIMITED, H5S_UNLIMITED}, .chunk = {1, 4}});
    test::make_group(id, "many");
    for (int i = 0; i < 20; ++i) {
      const std::int64_t value = i;
      test::write_values(id, "many/" + std::to_string(i), H5T_STD_I32BE, H5T_NATIVE_INT64, {},
                         &value);
    }
    const Hdf5Id text(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(text.id(), H5T_VARIABLE);
    const std::vector<const char*> texts = {"one", "two", "three"};
    test::write_values(id, "texts", text.id(), text.id(), {.shape = {3}}, texts.data());
  });
}

// Every data set, as users of the reader do.
void read_all(const std::string& bytes) {
  const Hdf5Reader file("set.h5", bytes);
  const auto attempt = [](const std::function<void()>& read) {
    try {
      read();
    } catch (const InputError& error) {
      EXPECT_EQ(error.file(), "set.h5");
      EXPECT_FALSE(error.problem().empty());
    }
  };
  for (const std::string name :
       {"plain", "compact", "chunks", "filters", "endless", "endless_twice"}) {
    attempt([&] { (void)file.numbers("group/" + name, {8, 12}); });
    attempt([&] { (void)file.numbers_or_nan("group/" + name, file.shape("group/" + name)); });
  }
  attempt([&] {
    for (const std::string& name : file.members("many")) (void)file.integers("many/" + name, {});
  });
  attempt([&] { (void)file.texts("texts"); });
}

class Hdf5Damage : public testing::TestWithParam<Superblock> {};

TEST_P(Hdf5Damage, OfAFewBytesIsReadOrRefused) {
  const std::string sound = sample_file(GetParam());
  EXPECT_NO_THROW(read_all(sound));
  const long before = test::peak_memory();
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    std::string bytes = sound;
    for (std::size_t changes = 1 + random.index(4); changes > 0; --changes) {
      bytes[random.index(bytes.size())] = static_cast<char>(random.index(256));
    }
    try {
      read_all(bytes);
    } catch (const InputError& error) {
      EXPECT_EQ(error.file(), "set.h5") << i;
    }
  }
  EXPECT_LT(test::peak_memory() - before, kMuch);
}

TEST_P(Hdf5Damage, OfACutIsRefusedAtOnce) {
  const std::string sound = sample_file(GetParam());
  for (std::size_t size = 1; size < sound.size(); size += 61) {
    const InputError error =
        test::refusal_of([&] { (void)Hdf5Reader("set.h5", sound.substr(0, size)); });
    EXPECT_NE(error.problem().find("no HDF5 file, or a damaged one"), std::string::npos);
  }
}

INSTANTIATE_TEST_SUITE_P(Versions, Hdf5Damage,
                         testing::Values(Superblock::version_0, Superblock::version_1,
                                         Superblock::version_2, Superblock::version_3),
                         [](const auto& version) {
                           return "superblock_" + std::to_string(static_cast<int>(version.param));
                         });

// The number of the lowest byte first.
void put(std::string& bytes, std::size_t place, std::uint64_t value, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) bytes.at(place + i) = static_cast<char>(value >> 8 * i);
}

std::size_t last_place(const std::string& bytes, const std::string& text) {
  const std::size_t place = bytes.rfind(text);
  EXPECT_NE(place, std::string::npos);
  return place;
}

void expect_damaged(const std::string& bytes, const std::string& problem,
                    const std::function<void(const Hdf5Reader&)>& read) {
  const Hdf5Reader file("set.h5", bytes);
  const InputError error = test::refusal_of([&] { read(file); });
  EXPECT_NE(error.problem().find(problem), std::string::npos) << error.what();
}

// Where a data set refers to a text of this length in the last collection of texts: length (4
// bytes), collection (8), number in it (4).
std::size_t place_of_text(const std::string& bytes, std::size_t length) {
  std::string reference(12, '\0');
  put(reference, 0, length, 4);
  put(reference, 4, last_place(bytes, "GCOL"), 8);
  return last_place(bytes, reference);
}

TEST(Hdf5Damage, ValuesThatDoNotMatchTheirChecksumAreRefused) {
  const std::string values = "eight_by";
  std::string bytes = written_hdf5(Superblock::version_0, [&](hid_t id) {
    test::write_values(id, "values", H5T_STD_I8LE, H5T_NATIVE_INT8,
                       {.shape = {8}, .chunk = {8}, .fletcher32 = true}, values.data());
  });
  const auto read = [](const Hdf5Reader& file) { return file.integers("values", {8}); };
  EXPECT_EQ(read({"set.h5", bytes}), std::vector<std::int64_t>(values.begin(), values.end()));
  bytes.at(last_place(bytes, values) + 3) ^= 1;
  expect_damaged(bytes, "the checksum of a chunk is wrong", read);
}

TEST(Hdf5Damage, FilesThatAreStillWrittenAreRefused) {
  std::string bytes = sample_file(Superblock::version_3);
  const auto read = [&] { (void)Hdf5Reader("set.h5", bytes); };
  put(bytes, 11, 1, 1);
  EXPECT_NE(test::refusal_of(read).problem().find("checksum"), std::string::npos);
  put(bytes, 44, hdf5::lookup3({reinterpret_cast<const std::uint8_t*>(bytes.data()), 44}), 4);
  EXPECT_NE(test::refusal_of(read).problem().find("h5clear"), std::string::npos);
}

// The texts of the reports: HDF5's own library takes as much memory as a text claims to be long.
TEST(Hdf5Damage, TextsThatClaimGigabytesAreRefused) {
  const std::string sound = sample_file(Superblock::version_0);
  const std::size_t heap = last_place(sound, "GCOL");
  const std::size_t text = place_of_text(sound, 3);
  const auto read = [](const Hdf5Reader& file) { (void)file.texts("texts"); };
  std::string bytes = sound;
  put(bytes, text, 0xfffffff0U, 4);
  expect_damaged(bytes, "longer than what is stored", read);
  bytes = sound;
  put(bytes, heap + 24, std::uint64_t{1} << 40U, 8);  // the first object's size
  expect_damaged(bytes, "ends too early", read);
  bytes = sound;
  put(bytes, heap + 8, std::uint64_t{1} << 40U, 8);  // the collection's size
  expect_damaged(bytes, "its parts overlap", read);
  bytes = sound;
  put(bytes, text + 12, 77, 4);  // an object that is not there
  expect_damaged(bytes, "a text is missing", read);
}

TEST(Hdf5Damage, TextsThatAllClaimTheSameBytesAreRefused) {
  const std::string long_text(50000, 'x');
  constexpr std::size_t kTexts = 1000;
  std::string bytes = written_hdf5(Superblock::version_0, [&](hid_t id) {
    const Hdf5Id text(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(text.id(), H5T_VARIABLE);
    std::vector<const char*> texts(kTexts, "");
    texts[0] = long_text.c_str();
    test::write_values(id, "texts", text.id(), text.id(), {.shape = {kTexts}}, texts.data());
  });
  const std::size_t first = place_of_text(bytes, long_text.size());
  for (std::size_t i = 1; i < kTexts; ++i) bytes.replace(first + 16 * i, 16, bytes, first, 16);
  expect_damaged(bytes, "its parts overlap",
                 [](const Hdf5Reader& file) { (void)file.texts("texts"); });
}

TEST(Hdf5Damage, TreesThatLeadBackToThemselvesAreRefused) {
  const std::string sound = sample_file(Superblock::version_0);
  int trees = 0;
  for (std::size_t tree = sound.find("TREE"); tree != std::string::npos;
       tree = sound.find("TREE", tree + 1)) {
    ++trees;
    const bool of_names = sound.at(tree + 4) == 0;
    std::string bytes = sound;
    // Its root says that it is not a leaf; the first child is the root itself.
    for (int level = 1; level < 256; level += 127) {
      put(bytes, tree + 5, static_cast<std::uint64_t>(level), 1);
      put(bytes, tree + 24 + (of_names ? 8 : 32), tree, 8);
      EXPECT_NO_THROW(read_all(bytes));
    }
  }
  EXPECT_GT(trees, 3);
  std::string bytes = sound;
  const std::size_t root = sound.find("TREE");
  put(bytes, root + 5, 1, 1);
  put(bytes, root + 32, root, 8);
  expect_damaged(bytes, "levels do not agree", [](const Hdf5Reader& file) { (void)file.has("a"); });
}

// Values of which a file can hold no more than a few.
TEST(Hdf5Damage, ShapesBeyondTheFileAreRefusedBeforeAnyMemoryIsTaken) {
  const std::vector<test::HowStored> ways = {{.shape = {96}},
                                             {.shape = {96}, .compact = true},
                                             {.shape = {96}, .chunk = {32}},
                                             {.shape = {96}, .chunk = {32}, .deflate = true}};
  for (const test::HowStored& how : ways) {
    const std::vector<double> values(96, 0.5);
    const std::string sound = written_hdf5(Superblock::version_0, [&](hid_t id) {
      test::write_values(id, "values", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, how, values.data());
    });
    std::string extent(8, '\0');
    put(extent, 0, 96, 8);
    for (const std::uint64_t claimed :
         {std::uint64_t{97}, std::uint64_t{1} << 20U, std::uint64_t{1} << 32U, ~std::uint64_t{0}}) {
      std::string bytes = sound;
      const std::size_t place = sound.find(extent);
      ASSERT_NE(place, std::string::npos);
      put(bytes, place, claimed, 8);
      put(bytes, place + 8, claimed, 8);  // how far it may grow
      const long before = test::peak_memory();
      const Hdf5Reader file("set.h5", bytes);
      // One value more lies behind the others, or is the fill value of a chunk.
      if (claimed > 97) {
        EXPECT_THROW((void)file.numbers("values", {claimed}), InputError) << claimed;
      }
      EXPECT_LT(test::peak_memory() - before, kMuch);
    }
  }
}

}  // namespace
}  // namespace prehend
