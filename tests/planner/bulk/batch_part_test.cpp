// The product of a batch and its shards.
#include "planner/bulk/batch_part.h"

#include <set>

#include <gtest/gtest.h>

#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

Batch small_batch() {
  Batch batch;
  batch.objects = {{"a", "a.obj", {}}, {"b/c", "b/c.obj", {}}};
  batch.scales = {0.5, 1.0, 2.0};
  batch.hands = {"barrett", "/robots/other.json"};
  batch.frictions = {0.4, 0.8};
  batch.settings = {{"draft", {}}, {"fine", {}}};
  batch.seeds = {1, 7, 9, 11};
  return batch;
}

TEST(BatchPart, ProductHasEveryCombinationOnce) {
  const Batch batch = small_batch();
  ASSERT_EQ(part_count(batch), 2U * 3 * 2 * 1 * 2 * 2 * 4);
  std::set<std::string> names;
  for (std::size_t i = 0; i < part_count(batch); ++i) {
    names.insert(part_name(batch, part_at(batch, i)));
  }
  EXPECT_EQ(names.size(), part_count(batch));
  EXPECT_TRUE(names.contains("b/c/other_scale0.5_friction0.8_draft_seed11"));
}

TEST(BatchPart, ObjectsAndScalesVarySlowest) {
  const Batch batch = small_batch();
  const std::size_t of_one_mesh = part_count(batch) / 6;
  for (std::size_t i = 0; i < part_count(batch); ++i) {
    const BatchPart part = part_at(batch, i);
    EXPECT_EQ(part.object * 3 + part.scale, i / of_one_mesh);
  }
}

TEST(BatchPart, NamesSayOnlyWhatVaries) {
  Batch batch;
  batch.objects = {{"mug", "mug", {}}};
  batch.hands = {"barrett"};
  batch.settings = {{"standard", {}}};
  EXPECT_EQ(part_name(batch, part_at(batch, 0)), "mug/barrett");
}

TEST(Shard, TogetherTheyAreAllPartsOnce) {
  for (const std::size_t count : {0U, 1U, 2U, 7U, 120U, 100'000'000U}) {
    for (const int of : {1, 2, 3, 7, 64, 1000}) {
      std::size_t next = 0;
      std::size_t most = 0;
      for (int number = 1; number <= of; ++number) {
        const PartRange range = parts_of({number, of}, count);
        EXPECT_EQ(range.begin, next);
        EXPECT_LE(range.begin, range.end);
        most = std::max(most, range.end - range.begin);
        next = range.end;
      }
      EXPECT_EQ(next, count);
      EXPECT_LE(most, count / static_cast<std::size_t>(of) + 1);
    }
  }
}

TEST(Shard, IsReadAndRefused) {
  EXPECT_EQ(read_shard("3/8").number, 3);
  EXPECT_EQ(read_shard("3/8").of, 8);
  for (const char* words : {"", "3", "0/8", "9/8", "-1/8", "1/0", "1/", "/2", "1/2/3", "1.5/2",
                            "a/b", " 1/2", "99999999999/99999999999"}) {
    EXPECT_EQ(test::refusal_of([&] { read_shard(words); }).field(), "--shard") << words;
  }
}

}  // namespace
}  // namespace prehend
