#include "planner/results/datasets/hdf5/image.h"

#include "planner/results/datasets/hdf5/checksum.h"

namespace prehend::hdf5 {
namespace {

constexpr std::string_view kSignature = "\x89HDF\r\n\x1a\n";

std::size_t width(ByteCursor& cursor) {
  const std::uint64_t size = cursor.number(1);
  if (size != 2 && size != 4 && size != 8) throw damaged("addresses of a width that none has");
  return size;
}

void require_whole(const Image& image, std::uint64_t base, std::uint64_t end) {
  if (base != 0) throw damaged("it does not begin where it says");
  if (end <= image.bytes.size()) return;
  throw damaged(std::to_string(image.bytes.size()) + " of " + std::to_string(end) +
                " bytes are there");
}

Superblock read_early(Image image, ByteCursor cursor, bool version_1) {
  cursor.skip(4);
  image.offset_size = width(cursor);
  image.length_size = width(cursor);
  cursor.skip(version_1 ? 13 : 9);
  const std::uint64_t base = image.address(cursor);
  (void)image.address(cursor);  // of unused space
  require_whole(image, base, image.address(cursor));
  (void)image.address(cursor);  // of the driver
  (void)image.address(cursor);  // the name of the root group
  return {image, image.address(cursor)};
}

Superblock read_late(Image image, ByteCursor cursor, bool version_3) {
  image.offset_size = width(cursor);
  image.length_size = width(cursor);
  (void)image.checked_part(0, 12 + 4 * image.offset_size);
  constexpr std::uint64_t kOpen = 1;
  if ((cursor.number(1) & kOpen) != 0 && version_3) {
    throw not_read("was not closed by the program that writes it", "close it, or h5clear -s FILE");
  }
  const std::uint64_t base = image.address(cursor);
  (void)image.address(cursor);  // of its extension
  require_whole(image, base, image.address(cursor));
  return {image, image.address(cursor)};
}

}  // namespace

Bytes Image::part(std::uint64_t address, std::uint64_t size) const {
  return ByteCursor(from(address)).take(size);
}

Bytes Image::from(std::uint64_t address) const {
  if (address > bytes.size()) throw damaged("an address outside of the file");
  return bytes.subspan(address);
}

Bytes Image::checked_part(std::uint64_t address, std::uint64_t size) const {
  ByteCursor cursor(from(address));
  const Bytes checked = cursor.take(size);
  if (cursor.number(4) != lookup3(checked) && kChecksumsCount) throw damaged("a checksum is wrong");
  return checked;
}

std::uint64_t Image::address(ByteCursor& cursor) const {
  const std::uint64_t value = cursor.number(offset_size);
  return value == kNowhere >> (64 - 8 * offset_size) ? kNowhere : value;
}

void Budget::spend(std::uint64_t bytes) {
  if (bytes > left_) throw damaged("its parts overlap");
  left_ -= bytes;
}

Superblock read_superblock(Bytes file) {
  ByteCursor cursor(file);
  cursor.expect(kSignature);
  const std::uint64_t version = cursor.number(1);
  if (version > 3) throw damaged("a version that is not known");
  return version < 2 ? read_early({file}, cursor, version == 1)
                     : read_late({file}, cursor, version == 3);
}

}  // namespace prehend::hdf5
