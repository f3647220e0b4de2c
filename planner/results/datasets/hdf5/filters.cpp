#include "planner/results/datasets/hdf5/filters.h"

#include <zlib.h>

#include "planner/results/datasets/hdf5/checksum.h"

namespace prehend::hdf5 {
namespace {

std::vector<std::uint8_t> inflated(const std::vector<std::uint8_t>& bytes, std::size_t most) {
  std::vector<std::uint8_t> values(most);
  uLongf size = most;
  if (uncompress(values.data(), &size, bytes.data(), bytes.size()) != Z_OK) {
    throw damaged("a chunk that deflate has not made");
  }
  values.resize(size);
  return values;
}

// The first bytes of all values, then the second ones, ...; what makes no whole value stays behind.
std::vector<std::uint8_t> unshuffled(const std::vector<std::uint8_t>& bytes, std::uint64_t width) {
  if (width < 2 || width > bytes.size()) return bytes;
  const std::size_t count = bytes.size() / width;
  std::vector<std::uint8_t> values = bytes;
  for (std::size_t byte = 0; byte < width; ++byte) {
    for (std::size_t i = 0; i < count; ++i) values[i * width + byte] = bytes[byte * count + i];
  }
  return values;
}

void check_sum(std::vector<std::uint8_t>& bytes) {
  constexpr std::size_t kSum = 4;
  if (bytes.size() < kSum) throw damaged("a chunk without its checksum");
  const Bytes all = bytes;
  const std::uint64_t expected = ByteCursor(all.last(kSum)).number(kSum);
  if (fletcher32(all.first(all.size() - kSum)) != expected && kChecksumsCount) {
    throw damaged("the checksum of a chunk is wrong");
  }
  bytes.resize(bytes.size() - kSum);
}

}  // namespace

std::vector<std::uint8_t> unfiltered(Bytes stored, const std::vector<Filter>& filters,
                                     std::uint64_t mask, std::size_t size) {
  std::vector<std::uint8_t> bytes(stored.begin(), stored.end());
  for (std::size_t i = filters.size(); i > 0; --i) {
    if ((mask >> (i - 1) & 1U) != 0) continue;
    const Filter& filter = filters[i - 1];
    switch (filter.type) {
      // Checksums before it are compressed as well.
      case FilterType::deflate:
        bytes = inflated(bytes, size + 4 * filters.size());
        break;
      case FilterType::shuffle:
        bytes = unshuffled(bytes, filter.value);
        break;
      case FilterType::fletcher32:
        check_sum(bytes);
        break;
    }
  }
  if (bytes.size() != size) throw damaged("a chunk of another size");
  return bytes;
}

}  // namespace prehend::hdf5
