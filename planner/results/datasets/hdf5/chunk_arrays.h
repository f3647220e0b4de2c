// Arrays of the addresses of chunks, of a fixed length or one that grows.
#pragma once

#include <map>
#include <optional>

#include "planner/results/datasets/hdf5/image.h"

namespace prehend::hdf5 {

// The entries of an array that are in the file, each with the address of a chunk first, and of
// filtered ones with its size and its filter mask (4 bytes).
class ChunkArray {
 public:
  explicit ChunkArray(std::size_t entry_size) : entry_size_(entry_size) {}

  std::size_t entry_size() const { return entry_size_; }
  // Entries that follow each other, beginning with this one.
  void add(std::uint64_t first, Bytes entries) { runs_.emplace(first, entries); }
  // Nothing for an entry that has never been written.
  std::optional<Bytes> entry(std::uint64_t place) const;

 private:
  std::size_t entry_size_;
  std::map<std::uint64_t, Bytes> runs_;
};

// Read the array with this header. Throw damaged().
ChunkArray fixed_array(const Image& image, std::uint64_t header, bool filtered);
ChunkArray extensible_array(const Image& image, std::uint64_t header, bool filtered);

}  // namespace prehend::hdf5
