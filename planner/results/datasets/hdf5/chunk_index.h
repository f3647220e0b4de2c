// Where the chunks of a data set are.
#pragma once

#include "planner/results/datasets/hdf5/data_set.h"

namespace prehend::hdf5 {

// How chunks cover the extents of a data set.
struct ChunkGrid {
  std::vector<std::size_t> extents;
  std::vector<std::size_t> chunk;   // values along each extent, none 0
  std::vector<std::size_t> counts;  // chunks along each extent
  std::size_t value_size = 0;       // bytes

  std::size_t chunk_bytes() const;
  std::size_t chunks() const;
  // The first value of a chunk along each extent. Chunks are numbered with the last extent running
  // fastest.
  std::vector<std::size_t> origin(std::size_t number) const;
};

// Throws damaged() for chunks of no or too much memory, and for more of them than bytes.
ChunkGrid chunk_grid(const Image& image, const DataSet& data);

struct StoredChunk {
  std::size_t number = 0;
  std::uint64_t address = 0;
  std::uint64_t size = 0;  // bytes in the file
  std::uint64_t mask = 0;  // bit i: the filter i was left out
};

// Those inside of the extents; the others have never been written. Throws damaged().
std::vector<StoredChunk> stored_chunks(const Image& image, const DataSet& data,
                                       const ChunkGrid& grid);

}  // namespace prehend::hdf5
