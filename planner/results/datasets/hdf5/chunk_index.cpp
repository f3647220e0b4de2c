#include "planner/results/datasets/hdf5/chunk_index.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <optional>

#include "planner/results/datasets/hdf5/chunk_arrays.h"
#include "planner/results/datasets/hdf5/tree1.h"
#include "planner/results/datasets/hdf5/tree2.h"

namespace prehend::hdf5 {
namespace {

constexpr std::size_t kLargestChunk = std::size_t{1} << 26U;  // bytes
// Chunks that any file may have: of those that were never written nothing is in the file.
constexpr std::size_t kChunksAtLeast = std::size_t{1} << 16U;

// The chunk at these places along each extent, unless it lies outside of them: HDF5 keeps chunks of
// data sets that were made smaller.
std::optional<std::size_t> number_of(const ChunkGrid& grid,
                                     const std::vector<std::uint64_t>& places) {
  std::size_t number = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i] >= grid.counts[i]) return {};
    number = number * grid.counts[i] + places[i];
  }
  return number;
}

std::vector<StoredChunk> in_tree1(const Image& image, const Layout& layout, const ChunkGrid& grid) {
  std::vector<StoredChunk> chunks;
  const std::size_t rank = grid.extents.size();
  for (const Tree1Entry& entry : tree1_entries(image, layout.address, Tree1Type::chunks,
                                               8 + 8 * (rank + 1), image.bytes.size())) {
    ByteCursor key(entry.key);
    const std::uint64_t size = key.number(4);
    const std::uint64_t mask = key.number(4);
    std::vector<std::uint64_t> places;
    for (const std::size_t values : grid.chunk) {
      const std::uint64_t first = key.number(8);
      if (first % values != 0) throw damaged("a chunk between two places");
      places.push_back(first / values);
    }
    const auto number = number_of(grid, places);
    if (number) chunks.push_back({*number, entry.child, size, mask});
  }
  return chunks;
}

std::vector<StoredChunk> in_tree2(const Image& image, const DataSet& data, const ChunkGrid& grid) {
  std::vector<StoredChunk> chunks;
  const bool filtered = !data.filters.empty();
  const Tree2Type type = filtered ? Tree2Type::filtered_chunks : Tree2Type::chunks;
  const std::size_t in_record = image.offset_size + 8 * grid.extents.size();
  for (const Bytes record : tree2_records(image, data.layout.address, type)) {
    ByteCursor cursor(record);
    StoredChunk chunk{.address = image.address(cursor), .size = grid.chunk_bytes()};
    if (filtered) {
      if (record.size() < in_record + 5 || record.size() > in_record + 12) {
        throw damaged("a tree of no sense");
      }
      chunk.size = cursor.number(record.size() - in_record - 4);
      chunk.mask = cursor.number(4);
    }
    std::vector<std::uint64_t> places;
    for (std::size_t i = 0; i < grid.extents.size(); ++i) places.push_back(cursor.number(8));
    const auto number = number_of(grid, places);
    if (!number) continue;
    chunk.number = *number;
    chunks.push_back(chunk);
  }
  return chunks;
}

// Arrays and runs of chunks count them over the extents that the data set may have at most, one
// without end being the slowest.
class Numbering {
 public:
  Numbering(const ChunkGrid& grid, const std::vector<std::size_t>& most) : grid_(grid) {
    for (std::size_t i = 0; i < most.size(); ++i) {
      const std::size_t along = most[i] / grid.chunk[i] + (most[i] % grid.chunk[i] != 0 ? 1 : 0);
      counts_.push_back(most[i] == kNowhere ? kNowhere : along);
      order_.push_back(i);
    }
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return counts_[a] == kNowhere && counts_[b] != kNowhere;
    });
  }

  // The place in the array of the chunk of this number.
  std::uint64_t operator()(std::size_t number) const {
    const std::vector<std::size_t> origin = grid_.origin(number);
    std::uint64_t place = 0;
    for (const std::size_t i : order_) {
      const std::uint64_t along = origin[i] / grid_.chunk[i];
      // Overflow wraps around: an address of no sense, which the array refuses.
      place = (counts_[i] == kNowhere ? 0 : place * counts_[i]) + along;
    }
    return place;
  }

 private:
  const ChunkGrid& grid_;
  std::vector<std::size_t> counts_;
  std::vector<std::size_t> order_;
};

std::vector<StoredChunk> in_array(const Image& image, const DataSet& data, const ChunkGrid& grid) {
  const Numbering numbering(grid, data.extents.most);
  const bool filtered = !data.filters.empty();
  const ChunkArray array = data.layout.index == ChunkIndex::fixed_array
                               ? fixed_array(image, data.layout.address, filtered)
                               : extensible_array(image, data.layout.address, filtered);
  std::vector<StoredChunk> chunks;
  for (std::size_t number = 0; number < grid.chunks(); ++number) {
    const auto entry = array.entry(numbering(number));
    if (!entry) continue;
    ByteCursor cursor(*entry);
    StoredChunk chunk{
        .number = number, .address = image.address(cursor), .size = grid.chunk_bytes()};
    if (chunk.address == kNowhere) continue;
    if (filtered) {
      chunk.size = cursor.number(cursor.left() - 4);
      chunk.mask = cursor.number(4);
    }
    chunks.push_back(chunk);
  }
  return chunks;
}

std::vector<StoredChunk> in_a_row(const Image& image, const DataSet& data, const ChunkGrid& grid) {
  const Numbering numbering(grid, data.extents.most);
  const std::uint64_t bytes = grid.chunk_bytes();
  std::vector<StoredChunk> chunks;
  for (std::size_t number = 0; number < grid.chunks(); ++number) {
    const std::uint64_t place = numbering(number);
    if (place > image.bytes.size()) throw damaged("a chunk outside of the file");
    chunks.push_back({number, data.layout.address + place * bytes, bytes});
  }
  return chunks;
}

}  // namespace

std::size_t ChunkGrid::chunk_bytes() const {
  return std::accumulate(chunk.begin(), chunk.end(), value_size, std::multiplies<>());
}

std::size_t ChunkGrid::chunks() const {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{1}, std::multiplies<>());
}

std::vector<std::size_t> ChunkGrid::origin(std::size_t number) const {
  std::vector<std::size_t> first(counts.size());
  for (std::size_t i = counts.size(); i > 0; --i) {
    first[i - 1] = number % counts[i - 1] * chunk[i - 1];
    number /= counts[i - 1];
  }
  return first;
}

ChunkGrid chunk_grid(const Image& image, const DataSet& data) {
  ChunkGrid grid{.extents = data.extents.sizes,
                 .chunk = data.layout.chunk,
                 .counts = {},
                 .value_size = data.type.size};
  std::size_t bytes = std::max<std::size_t>(data.type.size, 1);
  std::size_t chunks = 1;
  const std::size_t most = image.bytes.size() / image.offset_size + kChunksAtLeast;
  for (std::size_t i = 0; i < grid.extents.size(); ++i) {
    const std::size_t along = grid.chunk[i];
    if (along == 0) throw damaged("chunks of no size");
    if (along > kLargestChunk / bytes) {
      throw not_read("has too large chunks", "h5repack -l CHUNK=1000 OLD NEW makes smaller ones");
    }
    bytes *= along;
    const std::size_t count = grid.extents[i] / along + (grid.extents[i] % along != 0 ? 1 : 0);
    if (count != 0 && chunks > most / count) throw damaged("more chunks than the file can hold");
    chunks *= count;
    grid.counts.push_back(count);
  }
  return grid;
}

std::vector<StoredChunk> stored_chunks(const Image& image, const DataSet& data,
                                       const ChunkGrid& grid) {
  const Layout& layout = data.layout;
  if (layout.address == kNowhere || grid.chunks() == 0) return {};
  switch (layout.index) {
    case ChunkIndex::tree1:
      return in_tree1(image, layout, grid);
    case ChunkIndex::tree2:
      return in_tree2(image, data, grid);
    case ChunkIndex::implicit:
      return in_a_row(image, data, grid);
    case ChunkIndex::fixed_array:
    case ChunkIndex::extensible_array:
      return in_array(image, data, grid);
    case ChunkIndex::single:
      break;
  }
  const std::uint64_t size = layout.single_filtered ? layout.single_size : grid.chunk_bytes();
  return {{0, layout.address, size, layout.single_mask}};
}

}  // namespace prehend::hdf5
