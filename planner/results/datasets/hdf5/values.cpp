#include "planner/results/datasets/hdf5/values.h"

#include <algorithm>

#include "planner/results/datasets/hdf5/chunk_index.h"
#include "planner/results/datasets/hdf5/filters.h"
#include "sim/base/joined.h"

namespace prehend::hdf5 {
namespace {

// Deflate makes at most 1,032 bytes of one. Data sets that claim more than that of what is stored
// are mostly unwritten, which no program that writes grasps leaves.
constexpr std::size_t kMostPerByte = 1032;
constexpr std::size_t kSlack = std::size_t{1} << 16U;  // bytes that any file may claim

std::string words_of_extents(const Extents& extents) {
  return joined(extents.sizes, " x ", [](std::size_t size) { return std::to_string(size); });
}

InputError too_many(const Extents& extents) {
  return InputError({.problem = "has more values than a file of this size can hold: write the file "
                                "again, without values that are never set",
                     .value = words_of_extents(extents)});
}

std::vector<std::uint8_t> filled(std::size_t bytes, Bytes fill) {
  std::vector<std::uint8_t> values(bytes, 0);
  for (std::size_t i = 0; i + fill.size() <= bytes && !fill.empty(); i += fill.size()) {
    std::copy(fill.begin(), fill.end(), values.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return values;
}

// Copies what of a chunk lies inside of the extents.
void place(const ChunkGrid& grid, std::size_t number, Bytes chunk,
           std::vector<std::uint8_t>& values) {
  const std::vector<std::size_t> origin = grid.origin(number);
  const std::size_t rank = grid.extents.size();
  std::vector<std::size_t> width(rank);
  std::size_t rows = 1;
  for (std::size_t i = 0; i < rank; ++i) {
    width[i] = std::min(grid.chunk[i], grid.extents[i] - origin[i]);
    if (i + 1 < rank) rows *= width[i];
  }
  const std::size_t bytes = width.back() * grid.value_size;
  for (std::size_t row = 0; row < rows; ++row) {
    std::size_t from = 0;
    std::size_t to = origin.back();
    std::size_t from_stride = grid.chunk.back();
    std::size_t to_stride = grid.extents.back();
    for (std::size_t i = rank - 1, rest = row; i > 0; --i) {
      const std::size_t along = rest % width[i - 1];
      rest /= width[i - 1];
      from += along * from_stride;
      to += (origin[i - 1] + along) * to_stride;
      from_stride *= grid.chunk[i - 1];
      to_stride *= grid.extents[i - 1];
    }
    const Bytes part = chunk.subspan(from * grid.value_size, bytes);
    std::copy(part.begin(), part.end(),
              values.begin() + static_cast<std::ptrdiff_t>(to * grid.value_size));
  }
}

bool is_cut(const ChunkGrid& grid, std::size_t number) {
  const std::vector<std::size_t> origin = grid.origin(number);
  for (std::size_t i = 0; i < origin.size(); ++i) {
    if (grid.chunk[i] > grid.extents[i] - origin[i]) return true;
  }
  return false;
}

std::vector<std::uint8_t> chunked_values(const Image& image, const DataSet& data,
                                         std::size_t bytes) {
  if (data.extents.sizes.empty()) throw damaged("a scalar in chunks");
  const ChunkGrid grid = chunk_grid(image, data);
  const std::vector<StoredChunk> chunks = stored_chunks(image, data, grid);
  Budget budget(image);
  std::size_t stored = 0;
  for (const StoredChunk& chunk : chunks) {
    budget.spend(chunk.size);
    stored += chunk.size;
  }
  if (bytes > stored * kMostPerByte + image.bytes.size() + kSlack) throw too_many(data.extents);
  std::vector<std::uint8_t> values = filled(bytes, data.fill);
  for (const StoredChunk& chunk : chunks) {
    const Bytes part = image.part(chunk.address, chunk.size);
    const bool plain = data.layout.whole_edges && is_cut(grid, chunk.number);
    const std::uint64_t mask = plain ? ~std::uint64_t{0} : chunk.mask;
    if (grid.chunk_bytes() > chunk.size * kMostPerByte + kSlack) throw too_many(data.extents);
    place(grid, chunk.number, unfiltered(part, data.filters, mask, grid.chunk_bytes()), values);
  }
  return values;
}

}  // namespace

std::size_t value_count(const Image& image, const Extents& extents, std::size_t value_size) {
  const std::size_t size = std::max<std::size_t>(value_size, 1);
  const std::size_t in_file = image.bytes.size() * kMostPerByte + kSlack;
  std::size_t count = 1;
  for (const std::size_t extent : extents.sizes) {
    if (extent != 0 && count > in_file / size / extent) throw too_many(extents);
    count *= extent;
  }
  if (count > kMostDecoded / size) {
    throw InputError({.problem = "has more values than are read, which is 256 MB of them: split it",
                      .value = words_of_extents(extents)});
  }
  return extents.none ? 0 : count;
}

std::vector<std::uint8_t> raw_values(const Image& image, const DataSet& data) {
  const std::size_t bytes = value_count(image, data.extents, data.type.size) * data.type.size;
  if (bytes == 0) return {};
  const Layout& layout = data.layout;
  if (layout.kind == Layout::Kind::chunked) return chunked_values(image, data, bytes);
  if (layout.kind == Layout::Kind::contiguous && layout.address == kNowhere) {
    if (bytes > image.bytes.size() + kSlack) throw too_many(data.extents);
    return filled(bytes, data.fill);
  }
  const Bytes part = layout.kind == Layout::Kind::compact ? ByteCursor(layout.compact).take(bytes)
                                                          : image.part(layout.address, bytes);
  return {part.begin(), part.end()};
}

}  // namespace prehend::hdf5
