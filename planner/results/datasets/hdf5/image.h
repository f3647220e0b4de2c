// A whole HDF5 file in memory: parts of it by their addresses, and how wide addresses are.
#pragma once

#include "planner/results/datasets/hdf5/byte_cursor.h"

namespace prehend::hdf5 {

// The address of what is not there.
inline constexpr std::uint64_t kNowhere = ~std::uint64_t{0};

struct Image {
  Bytes bytes;
  std::size_t offset_size = 8;  // of an address, 2, 4 or 8 bytes
  std::size_t length_size = 8;  // of a size, 2, 4 or 8 bytes

  // All throw damaged() for what lies outside of the file.
  Bytes part(std::uint64_t address, std::uint64_t size) const;
  // From there to the end of the file.
  Bytes from(std::uint64_t address) const;
  // A part that its checksum follows. Throws damaged() where the two do not agree.
  Bytes checked_part(std::uint64_t address, std::uint64_t size) const;

  std::uint64_t address(ByteCursor& cursor) const;
  std::uint64_t length(ByteCursor& cursor) const { return cursor.number(length_size); }
};

// The parts of a sound file do not overlap, so what belongs together is never larger than the file.
// Whoever follows addresses spends the size of each part: cycles and parts that are claimed many
// times end there.
class Budget {
 public:
  explicit Budget(const Image& image) : left_(image.bytes.size()) {}
  // Throws damaged() when more is spent than the file has.
  void spend(std::uint64_t bytes);

 private:
  std::uint64_t left_;
};

// The file's first structure: widths, and the object header of the root group.
struct Superblock {
  Image image;
  std::uint64_t root = kNowhere;
};

// Throws damaged(), and not_read() for a file that another program still writes.
Superblock read_superblock(Bytes file);

}  // namespace prehend::hdf5
