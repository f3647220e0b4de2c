#include "planner/results/datasets/hdf5/chunk_arrays.h"

#include <bit>
#include <vector>

namespace prehend::hdf5 {
namespace {

constexpr std::uint64_t kMostPageBits = 32;
constexpr std::size_t kSizeOfChecksum = 4;

// The rest of a header of both kinds, of which the signature is read.
ChunkArray empty_array(const Image& image, ByteCursor& cursor, bool filtered) {
  if (cursor.number(1) != 0) throw damaged("an array of a version that is not known");
  if (cursor.number(1) != (filtered ? 1U : 0U)) throw damaged("an array of another kind");
  const std::size_t entry = cursor.number(1);
  const std::size_t least = image.offset_size + (filtered ? 5 : 0);
  const std::size_t most = image.offset_size + (filtered ? 12 : 0);
  if (entry < least || entry > most) throw damaged("an array of no sense");
  return ChunkArray(entry);
}

// How many bytes `count` entries take. No more than a file can have.
std::uint64_t bytes_of(const Image& image, std::uint64_t count, std::size_t entry_size) {
  if (count > image.bytes.size() / entry_size) throw damaged("an array beyond the file");
  return count * entry_size;
}

// The bit of a page: whether anything has been written to it. The highest bit of a byte is first.
bool is_set(Bytes bits, std::uint64_t bit) {
  return (std::uint32_t{bits[bit / 8]} << (bit % 8) & 0x80U) != 0;
}

// Pages of entries, each with a checksum, that follow each other; the last may be shorter.
struct Pages {
  std::uint64_t address = 0;
  std::uint64_t entries = 0;  // in all
  std::uint64_t in_page = 0;
  Bytes bits;
  std::uint64_t first_bit = 0;
};

void add_pages(const Image& image, const Pages& pages, std::uint64_t first, Budget& budget,
               ChunkArray& array) {
  const std::uint64_t stride = bytes_of(image, pages.in_page, array.entry_size()) + kSizeOfChecksum;
  for (std::uint64_t page = 0; page * pages.in_page < pages.entries; ++page) {
    if (!is_set(pages.bits, pages.first_bit + page)) continue;
    const std::uint64_t before = page * pages.in_page;
    const std::uint64_t count = std::min(pages.in_page, pages.entries - before);
    const std::uint64_t bytes = count * array.entry_size();
    budget.spend(bytes);
    array.add(first + before, image.checked_part(pages.address + page * stride, bytes));
  }
}

// What an extensible array says of itself. Its blocks grow: "super block" u stands for 2^(u/2) data
// blocks of 2^((u+1)/2) times the smallest size.
struct Growth {
  std::uint64_t in_index = 0;  // entries in the index block
  std::uint64_t smallest = 0;  // entries of a data block
  std::uint64_t super_blocks = 0;
  std::uint64_t direct = 0;  // super blocks whose data blocks the index block points to itself
  std::uint64_t in_page = 0;
  std::size_t place_size = 0;  // bytes of a block's place in the array

  std::uint64_t blocks(std::uint64_t super) const { return std::uint64_t{1} << super / 2; }
  std::uint64_t in_block(std::uint64_t super) const { return smallest << (super + 1) / 2; }
};

Growth growth_of(ByteCursor& cursor) {
  const std::uint64_t bits = cursor.number(1);
  Growth growth;
  growth.in_index = cursor.number(1);
  growth.smallest = cursor.number(1);
  const std::uint64_t pointers = cursor.number(1);
  const std::uint64_t page_bits = cursor.number(1);
  if (!std::has_single_bit(growth.smallest) || !std::has_single_bit(pointers) || bits > 64 ||
      page_bits > kMostPageBits) {
    throw damaged("an array of no sense");
  }
  growth.in_page = std::uint64_t{1} << page_bits;
  growth.place_size = (bits + 7) / 8;
  const auto smallest_bits = static_cast<std::uint64_t>(std::countr_zero(growth.smallest));
  growth.direct = 2 * static_cast<std::uint64_t>(std::countr_zero(pointers));
  if (bits < smallest_bits + growth.direct) throw damaged("an array of no sense");
  growth.super_blocks = 1 + bits - smallest_bits;
  return growth;
}

// Reads the blocks of an extensible array.
class Blocks {
 public:
  Blocks(const Image& image, const Growth& growth, ChunkArray& array)
      : image_(image), growth_(growth), array_(array), budget_(image) {}

  void read_index(std::uint64_t address) {
    std::uint64_t pointers = growth_.super_blocks - growth_.direct;
    for (std::uint64_t super = 0; super < growth_.direct; ++super) {
      pointers += growth_.blocks(super);
    }
    const std::uint64_t entries = growth_.in_index * array_.entry_size();
    const std::uint64_t prefix = 6 + image_.offset_size;
    ByteCursor cursor(
        image_.checked_part(address, prefix + entries + pointers * image_.offset_size));
    cursor.expect("EAIB");
    cursor.skip(prefix - 4);
    array_.add(0, cursor.take(entries));
    std::uint64_t first = growth_.in_index;
    for (std::uint64_t super = 0; super < growth_.super_blocks; ++super) {
      if (super < growth_.direct) {
        read_data_blocks(cursor, super, first, {});
      } else {
        read_super_block(image_.address(cursor), super, first);
      }
      first += growth_.blocks(super) * growth_.in_block(super);
    }
  }

 private:
  std::uint64_t prefix() const { return 6 + image_.offset_size + growth_.place_size; }
  bool paged(std::uint64_t super) const { return growth_.in_block(super) > growth_.in_page; }

  void read_super_block(std::uint64_t address, std::uint64_t super, std::uint64_t first) {
    if (address == kNowhere) return;
    const std::uint64_t blocks = growth_.blocks(super);
    const std::uint64_t pages = paged(super) ? growth_.in_block(super) / growth_.in_page : 0;
    const std::uint64_t bits = pages == 0 ? 0 : bytes_of(image_, blocks, (pages + 7) / 8);
    const std::uint64_t pointers = bytes_of(image_, blocks, image_.offset_size);
    budget_.spend(bits);
    budget_.spend(pointers);
    ByteCursor cursor(image_.checked_part(address, prefix() + bits + pointers));
    cursor.expect("EASB");
    cursor.skip(prefix() - 4);
    const Bytes page_bits = cursor.take(bits);
    read_data_blocks(cursor, super, first, page_bits);
  }

  void read_data_blocks(ByteCursor& cursor, std::uint64_t super, std::uint64_t first,
                        Bytes page_bits) {
    const std::uint64_t in_block = growth_.in_block(super);
    for (std::uint64_t block = 0; block < growth_.blocks(super); ++block) {
      const std::uint64_t address = image_.address(cursor);
      if (address != kNowhere) {
        read_data_block(address, super, first + block * in_block, block, page_bits);
      }
    }
  }

  void read_data_block(std::uint64_t address, std::uint64_t super, std::uint64_t first,
                       std::uint64_t block, Bytes page_bits) {
    const std::uint64_t in_block = growth_.in_block(super);
    const std::uint64_t entries =
        paged(super) ? 0 : bytes_of(image_, in_block, array_.entry_size());
    budget_.spend(prefix() + entries);
    ByteCursor cursor(image_.checked_part(address, prefix() + entries));
    cursor.expect("EADB");
    cursor.skip(prefix() - 4);
    if (!paged(super)) {
      array_.add(first, cursor.take(entries));
      return;
    }
    if (page_bits.empty()) throw damaged("an array of no sense");
    const std::uint64_t pages = in_block / growth_.in_page;
    add_pages(
        image_,
        {address + prefix() + kSizeOfChecksum, in_block, growth_.in_page, page_bits, block * pages},
        first, budget_, array_);
  }

  const Image& image_;
  const Growth& growth_;
  ChunkArray& array_;
  Budget budget_;
};

}  // namespace

std::optional<Bytes> ChunkArray::entry(std::uint64_t place) const {
  auto run = runs_.upper_bound(place);
  if (run == runs_.begin()) return {};
  --run;
  const auto& [first, entries] = *run;
  if (place - first >= entries.size() / entry_size_) return {};
  return entries.subspan((place - first) * entry_size_, entry_size_);
}

ChunkArray fixed_array(const Image& image, std::uint64_t header, bool filtered) {
  ByteCursor cursor(image.checked_part(header, 8 + image.length_size + image.offset_size));
  cursor.expect("FAHD");
  ChunkArray array = empty_array(image, cursor, filtered);
  const std::uint64_t page_bits = cursor.number(1);
  const std::uint64_t entries = image.length(cursor);
  const std::uint64_t address = image.address(cursor);
  if (page_bits > kMostPageBits) throw damaged("an array of no sense");
  if (address == kNowhere) return array;
  const std::uint64_t bytes = bytes_of(image, entries, array.entry_size());
  const std::uint64_t in_page = std::uint64_t{1} << page_bits;
  const bool paged = entries > in_page;
  const std::uint64_t pages = (entries + in_page - 1) / in_page;
  const std::uint64_t prefix = 6 + image.offset_size;
  const std::uint64_t behind = paged ? (pages + 7) / 8 : bytes;
  ByteCursor block(image.checked_part(address, prefix + behind));
  block.expect("FADB");
  block.skip(prefix - 4);
  if (!paged) {
    array.add(0, block.take(bytes));
    return array;
  }
  Budget budget(image);
  add_pages(image,
            {address + prefix + behind + kSizeOfChecksum, entries, in_page, block.take(behind), 0},
            0, budget, array);
  return array;
}

ChunkArray extensible_array(const Image& image, std::uint64_t header, bool filtered) {
  ByteCursor cursor(image.checked_part(header, 12 + 6 * image.length_size + image.offset_size));
  cursor.expect("EAHD");
  ChunkArray array = empty_array(image, cursor, filtered);
  const Growth growth = growth_of(cursor);
  cursor.skip(6 * image.length_size);  // statistics
  const std::uint64_t address = image.address(cursor);
  if (address != kNowhere) Blocks(image, growth, array).read_index(address);
  return array;
}

}  // namespace prehend::hdf5
