#include "planner/results/datasets/hdf5/fractal_heap.h"

#include <algorithm>
#include <bit>
#include <vector>

#include "planner/results/datasets/hdf5/checksum.h"

namespace prehend::hdf5 {
namespace {

constexpr std::uint64_t kLargestHeap = std::uint64_t{1} << 40U;  // bytes
constexpr std::uint64_t kMostRows = 40;
constexpr std::uint64_t kMostColumns = 64;  // HDF5 makes heaps of 4 for groups

std::uint64_t log2_of(std::uint64_t power) {
  return static_cast<std::uint64_t>(std::countr_zero(power));
}

}  // namespace

FractalHeap::FractalHeap(const Image& image, std::uint64_t header) : image_(image), budget_(image) {
  const std::size_t length = image.length_size;
  ByteCursor cursor(image.checked_part(header, 22 + 12 * length + 3 * image.offset_size));
  cursor.expect("FRHP");
  if (cursor.number(1) != 0) throw damaged("a heap of a version that is not known");
  cursor.skip(2);
  if (cursor.number(2) != 0) {
    throw not_read("has its names in a compressed heap",
                   "h5repack OLD NEW writes one that is read");
  }
  has_checksums_ = (cursor.number(1) & 2U) != 0;
  // The largest object, other kinds of objects, unused space.
  cursor.skip(4 + 10 * length + 2 * image.offset_size);
  width_ = cursor.number(2);
  start_size_ = image.length(cursor);
  largest_direct_ = image.length(cursor);
  const std::uint64_t bits = cursor.number(2);
  cursor.skip(2);
  root_.address = image.address(cursor);
  root_.rows = cursor.number(2);
  id_offset_size_ = (bits + 7) / 8;
  const bool powers = std::has_single_bit(width_) && std::has_single_bit(start_size_) &&
                      std::has_single_bit(largest_direct_);
  if (!powers || start_size_ > largest_direct_ || largest_direct_ > kLargestHeap || bits == 0 ||
      bits > 64 || root_.rows > kMostRows || width_ > kMostColumns) {
    throw damaged("a heap of no sense");
  }
  root_.size = root_.rows == 0 ? start_size_ : kLargestHeap;
}

// The first two rows have blocks of the same size, each further one of twice the size.
std::uint64_t FractalHeap::row_size(std::uint64_t row) const {
  return row < 2 ? start_size_ : start_size_ << (row - 1);
}

std::uint64_t FractalHeap::child_address(const Block& block, std::uint64_t entry) const {
  const std::size_t prefix = 5 + image_.offset_size + id_offset_size_;
  ByteCursor cursor(
      image_.checked_part(block.address, prefix + block.rows * width_ * image_.offset_size));
  cursor.expect("FHIB");
  cursor.skip(prefix - 4 + entry * image_.offset_size);
  return image_.address(cursor);
}

// The checksum stands inside of what it is made of, and counts as 0 there.
void FractalHeap::check(const Block& block, Bytes bytes) {
  ByteCursor cursor(bytes);
  cursor.expect("FHDB");
  if (!has_checksums_ || !checked_.insert(block.address).second) return;
  budget_.spend(bytes.size());
  const std::size_t prefix = 5 + image_.offset_size + id_offset_size_;
  cursor.skip(prefix - 4);
  const std::uint64_t expected = cursor.number(4);
  std::vector<std::uint8_t> copy(bytes.begin(), bytes.end());
  std::fill_n(copy.begin() + static_cast<std::ptrdiff_t>(prefix), 4, std::uint8_t{0});
  if (lookup3(copy) != expected && kChecksumsCount) throw damaged("a checksum is wrong");
}

Bytes FractalHeap::object(Bytes id) {
  ByteCursor cursor(id);
  constexpr std::uint64_t kManaged = 0;
  if (cursor.number(1) != kManaged) {
    throw not_read("has a member of a very long name", "h5repack OLD NEW may help");
  }
  std::uint64_t offset = cursor.number(id_offset_size_);
  const std::uint64_t length = cursor.number(std::min<std::size_t>(cursor.left(), 8));
  Block block = root_;
  while (block.rows > 0) {
    std::uint64_t row = 0;
    for (; row < block.rows && offset >= width_ * row_size(row); ++row) {
      offset -= width_ * row_size(row);
    }
    if (row == block.rows) throw damaged("an object outside of its heap");
    const std::uint64_t size = row_size(row);
    block.address = child_address(block, row * width_ + offset / size);
    block.size = size;
    offset %= size;
    // A block with rows is as large as these: the last is half as large as all of them.
    const std::uint64_t rows =
        size <= largest_direct_ ? 0 : log2_of(size / (start_size_ * width_)) + 1;
    if (rows >= block.rows) throw damaged("a heap of no sense");
    block.rows = rows;
  }
  if (offset > block.size || length > block.size - offset) {
    throw damaged("an object outside of its heap");
  }
  const Bytes bytes = image_.part(block.address, block.size);
  check(block, bytes);
  return bytes.subspan(offset, length);
}

}  // namespace prehend::hdf5
