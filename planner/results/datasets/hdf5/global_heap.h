// Global heaps, in which data sets keep texts of any length.
#pragma once

#include <map>

#include "planner/results/datasets/hdf5/image.h"

namespace prehend::hdf5 {

class GlobalHeap {
 public:
  explicit GlobalHeap(const Image& image) : image_(image), budget_(image) {}

  // The object of this number in the collection at this address. Throws damaged().
  Bytes object(std::uint64_t collection, std::uint64_t number);

 private:
  using Collection = std::map<std::uint64_t, Bytes>;
  Collection read(std::uint64_t address);

  Image image_;
  Budget budget_;
  std::map<std::uint64_t, Collection> collections_;
};

}  // namespace prehend::hdf5
