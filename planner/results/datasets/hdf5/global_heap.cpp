#include "planner/results/datasets/hdf5/global_heap.h"

namespace prehend::hdf5 {

GlobalHeap::Collection GlobalHeap::read(std::uint64_t address) {
  ByteCursor cursor(image_.from(address));
  cursor.expect("GCOL");
  cursor.skip(4);
  const std::uint64_t size = image_.length(cursor);
  budget_.spend(size);
  const std::size_t prefix = 8 + image_.length_size;
  cursor = ByteCursor(image_.part(address, size));
  cursor.skip(prefix);
  Collection objects;
  while (cursor.left() >= prefix) {
    const std::uint64_t number = cursor.number(2);
    cursor.skip(6);
    const std::uint64_t length = image_.length(cursor);
    if (number == 0) break;  // unused space
    objects[number] = cursor.take(length);
    cursor.skip(std::min<std::size_t>((8 - length % 8) % 8, cursor.left()));
  }
  return objects;
}

Bytes GlobalHeap::object(std::uint64_t collection, std::uint64_t number) {
  auto found = collections_.find(collection);
  if (found == collections_.end()) found = collections_.emplace(collection, read(collection)).first;
  const auto object = found->second.find(number);
  if (object == found->second.end()) throw damaged("a text is missing");
  return object->second;
}

}  // namespace prehend::hdf5
