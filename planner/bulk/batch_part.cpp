#include "planner/bulk/batch_part.h"

#include <charconv>
#include <filesystem>

#include "sim/base/formatted.h"
#include "sim/base/input_error.h"
#include "sim/base/number_text.h"

namespace prehend {

namespace {

// The index in a list of `size`, as the fastest of what is left of `number`.
std::size_t take(std::size_t& number, std::size_t size) {
  const std::size_t index = number % size;
  number /= size;
  return index;
}

bool read_whole(std::string_view words, int& number) {
  const auto [end, error] = std::from_chars(words.data(), words.data() + words.size(), number);
  return error == std::errc() && end == words.data() + words.size();
}

}  // namespace

std::size_t part_count(const Batch& batch) {
  std::size_t count = 1;
  for (const std::size_t size :
       {batch.objects.size(), batch.scales.size(), batch.hands.size(), batch.scenes.size(),
        batch.frictions.size(), batch.settings.size(), batch.seeds.size()}) {
    // Saturates instead of wrapping around.
    if (size > 0 && count > kMostParts * 10 / size) return kMostParts + 1;
    count *= size;
  }
  return count;
}

BatchPart part_at(const Batch& batch, std::size_t number) {
  BatchPart part;
  part.seed = take(number, batch.seeds.size());
  part.setting = take(number, batch.settings.size());
  part.friction = take(number, batch.frictions.size());
  part.scene = take(number, batch.scenes.size());
  part.hand = take(number, batch.hands.size());
  part.scale = take(number, batch.scales.size());
  part.object = number;
  return part;
}

std::string hand_name(const std::string& hand) {
  return std::filesystem::path(hand).stem().string();
}

std::string part_name(const Batch& batch, const BatchPart& part) {
  std::string name = batch.objects[part.object].name + "/" + hand_name(batch.hands[part.hand]);
  if (batch.scales.size() > 1) name += "_scale" + shortest_text(batch.scales[part.scale]);
  if (batch.scenes.size() > 1) name += "_" + batch.scenes[part.scene].name;
  if (batch.frictions.size() > 1)
    name += "_friction" + shortest_text(*batch.frictions[part.friction]);
  if (batch.settings.size() > 1) name += "_" + batch.settings[part.setting].name;
  if (batch.seeds.size() > 1) name += "_seed" + std::to_string(batch.seeds[part.seed]);
  return name;
}

Shard read_shard(const std::string& words) {
  Shard shard;
  const std::size_t slash = words.find('/');
  const std::string_view all = words;
  const bool is_read = slash != std::string::npos &&
                       read_whole(all.substr(0, slash), shard.number) &&
                       read_whole(all.substr(slash + 1), shard.of);
  require(is_read && shard.number >= 1 && shard.number <= shard.of,
          {.field = "--shard", .problem = "must be I/N with 1 <= I <= N", .value = words});
  return shard;
}

PartRange parts_of(const Shard& shard, std::size_t count) {
  const auto of = static_cast<std::size_t>(shard.of);
  const auto number = static_cast<std::size_t>(shard.number);
  // Without overflow: count is at most kMostParts, and `of` an int.
  return {count * (number - 1) / of, count * number / of};
}

}  // namespace prehend
