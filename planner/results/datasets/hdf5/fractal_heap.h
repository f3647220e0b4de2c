// Fractal heaps, in which groups of many members keep their links.
#pragma once

#include <set>

#include "planner/results/datasets/hdf5/image.h"

namespace prehend::hdf5 {

class FractalHeap {
 public:
  // Throws damaged(), and not_read() for a heap that is compressed.
  FractalHeap(const Image& image, std::uint64_t header);

  // The object of this identifier. Throws damaged(), and not_read() for one that is not in a block
  // of the heap (those of more than 4 kB, in groups).
  Bytes object(Bytes id);

 private:
  // A block of the heap: `rows` of addresses of others, or none for one with objects.
  struct Block {
    std::uint64_t address;
    std::uint64_t size;
    std::uint64_t rows;
  };
  std::uint64_t row_size(std::uint64_t row) const;
  std::uint64_t child_address(const Block& block, std::uint64_t entry) const;
  void check(const Block& block, Bytes bytes);

  Image image_;
  std::size_t id_offset_size_ = 0;    // bytes of an offset in an identifier
  std::uint64_t width_ = 0;           // blocks in a row
  std::uint64_t start_size_ = 0;      // bytes of a block in the first row
  std::uint64_t largest_direct_ = 0;  // bytes; larger blocks have rows themselves
  Block root_{};
  bool has_checksums_ = false;
  std::set<std::uint64_t> checked_;  // addresses of blocks
  Budget budget_;
};

}  // namespace prehend::hdf5
