// The parts of a batch: one plan each, in a fixed order, and which of them a shard does.
#pragma once

#include <cstddef>
#include <string>

#include "planner/bulk/batch.h"

namespace prehend {

// One plan: indices into the lists of its batch.
struct BatchPart {
  std::size_t object = 0;
  std::size_t scale = 0;
  std::size_t hand = 0;
  std::size_t scene = 0;
  std::size_t friction = 0;
  std::size_t setting = 0;
  std::size_t seed = 0;
};

std::size_t part_count(const Batch& batch);

// Part `number` (< part_count). Objects vary slowest, then scales: neighbouring parts share their
// mesh. Seeds vary fastest.
BatchPart part_at(const Batch& batch, std::size_t number);

// "OBJECT/HAND", followed by the values of the lists that have more than one: "_scale0.5",
// "_table", "_friction0.8", "_draft", "_seed2". Unlike that of any other part of the batch, and
// made of what names of files may have.
std::string part_name(const Batch& batch, const BatchPart& part);

// The name of a hand in names of parts: of a file, that without folder and ending.
std::string hand_name(const std::string& hand);

// Shard `number` of `of`, counted from 1.
struct Shard {
  int number = 1;
  int of = 1;
};

// From "3/8". Throws InputError of the field "--shard" unless 1 <= number <= of.
Shard read_shard(const std::string& words);

// A range of parts: `begin` to `end` - 1.
struct PartRange {
  std::size_t begin = 0;
  std::size_t end = 0;
};

// The parts of a shard: they are neighbours, so that a mesh is read by one or two shards only.
// Those of all shards together are all parts, each once; none if there are more shards than parts.
PartRange parts_of(const Shard& shard, std::size_t count);

}  // namespace prehend
