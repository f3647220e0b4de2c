#include "planner/results/datasets/hdf5/group.h"

#include <algorithm>

#include "planner/results/datasets/hdf5/fractal_heap.h"
#include "planner/results/datasets/hdf5/tree1.h"
#include "planner/results/datasets/hdf5/tree2.h"

namespace prehend::hdf5 {
namespace {

constexpr std::size_t kLongestName = 1024;  // bytes

void add_link(std::vector<Link>& links, Bytes name, std::uint64_t object) {
  if (links.size() == kMostLinks) {
    throw InputError(
        {.problem = "has too many members", .value = std::to_string(kMostLinks) + "+"});
  }
  if (name.size() > kLongestName) throw damaged("a very long name");
  links.push_back({{name.begin(), name.end()}, object});
}

// The names of a symbol table: texts that end with a byte 0.
Bytes local_heap(const Image& image, std::uint64_t address) {
  ByteCursor cursor(image.from(address));
  cursor.expect("HEAP");
  cursor.skip(4);
  const std::uint64_t size = image.length(cursor);
  (void)image.length(cursor);  // of its unused space
  return image.part(image.address(cursor), size);
}

Bytes name_at(Bytes heap, std::uint64_t offset) {
  if (offset > heap.size()) throw damaged("a name outside of its heap");
  const Bytes from = heap.subspan(offset);
  const Bytes most = from.first(std::min(from.size(), kLongestName + 1));
  const auto end = std::find(most.begin(), most.end(), std::uint8_t{0});
  if (end == most.end()) throw damaged("a name without an end");
  return most.first(static_cast<std::size_t>(end - most.begin()));
}

void add_symbols(const Image& image, Bytes heap, std::uint64_t address, std::vector<Link>& links) {
  ByteCursor cursor(image.from(address));
  cursor.expect("SNOD");
  cursor.skip(2);
  const std::uint64_t count = cursor.number(2);
  for (std::uint64_t i = 0; i < count; ++i) {
    const Bytes name = name_at(heap, image.address(cursor));
    const std::uint64_t object = image.address(cursor);
    constexpr std::uint64_t kSoftLink = 2;
    const bool soft = cursor.number(4) == kSoftLink;
    cursor.skip(20);
    add_link(links, name, soft ? kNowhere : object);
  }
}

void add_symbol_table(const Image& image, Bytes message, std::vector<Link>& links) {
  ByteCursor cursor(message);
  const std::uint64_t tree = image.address(cursor);
  const Bytes heap = local_heap(image, image.address(cursor));
  const auto nodes = tree1_entries(image, tree, Tree1Type::group, image.length_size, kMostLinks);
  for (const Tree1Entry& node : nodes) add_symbols(image, heap, node.child, links);
}

void add_link_message(const Image& image, Bytes message, std::vector<Link>& links) {
  ByteCursor cursor(message);
  if (cursor.number(1) != 1) throw damaged("a link of a version that is not known");
  const std::uint64_t flags = cursor.number(1);
  const bool hard = (flags & 8U) == 0 || cursor.number(1) == 0;
  if ((flags & 4U) != 0) cursor.skip(8);   // when it was made
  if ((flags & 16U) != 0) cursor.skip(1);  // how its name is written
  const Bytes name = cursor.take(cursor.number(std::size_t{1} << (flags & 3U)));
  add_link(links, name, hard ? image.address(cursor) : kNowhere);
}

void add_heap(const Image& image, Bytes message, std::vector<Link>& links) {
  ByteCursor cursor(message);
  cursor.skip(1);
  if ((cursor.number(1) & 1U) != 0) cursor.skip(8);  // how many were made
  const std::uint64_t heap_address = image.address(cursor);
  if (heap_address == kNowhere) return;
  FractalHeap heap(image, heap_address);
  const auto records = tree2_records(image, image.address(cursor), Tree2Type::link_names);
  for (const Bytes record : records) {
    ByteCursor id(record);
    id.skip(4);  // a hash of the name
    add_link_message(image, heap.object(id.take(id.left())), links);
  }
}

}  // namespace

bool is_group(const Messages& header) {
  return find(header, MessageType::symbol_table) != nullptr ||
         find(header, MessageType::link_info) != nullptr;
}

std::vector<Link> links_of(const Image& image, const Messages& header) {
  std::vector<Link> links;
  for (const auto& [type, data] : header) {
    if (type == MessageType::symbol_table) add_symbol_table(image, data, links);
    if (type == MessageType::link) add_link_message(image, data, links);
    if (type == MessageType::link_info) add_heap(image, data, links);
  }
  return links;
}

}  // namespace prehend::hdf5
