#include "planner/results/datasets/hdf5/tree2.h"

#include <bit>
#include <limits>

namespace prehend::hdf5 {
namespace {

constexpr std::size_t kNodePrefix = 6;  // bytes: signature, version, type
constexpr std::size_t kNodeFrame = 10;  // bytes: with the checksum behind the node
constexpr std::size_t kDeepest = 32;    // nodes have several children: no file has so many leaves

struct Tree2 {
  std::uint64_t type = 0;
  std::size_t record_size = 0;
  std::size_t depth = 0;
  std::uint64_t root = kNowhere;
  std::uint64_t root_records = 0;
  std::size_t count_size = 0;             // bytes of a child's number of records
  std::vector<std::size_t> pointer_size;  // bytes of what points to a child, for each level
};

std::size_t size_of_number(std::uint64_t largest) {
  return largest == 0 ? 1 : (static_cast<std::size_t>(std::bit_width(largest)) + 7) / 8;
}

// The sizes of numbers in nodes follow from how many records fit into nodes and subtrees.
void derive_sizes(Tree2& tree, std::size_t node_size, std::size_t offset_size) {
  // Records have an address or a hash, and more.
  constexpr std::size_t kLeastRecord = 8;
  if (tree.record_size < kLeastRecord || node_size < kNodeFrame + tree.record_size ||
      tree.depth > kDeepest) {
    throw damaged("a tree of no sense");
  }
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t in_leaf = (node_size - kNodeFrame) / tree.record_size;
  tree.count_size = size_of_number(in_leaf);
  tree.pointer_size = {0};
  std::uint64_t in_subtree = in_leaf;
  for (std::size_t level = 1; level <= tree.depth; ++level) {
    const std::size_t total_size = level == 1 ? 0 : size_of_number(in_subtree);
    const std::size_t pointer = offset_size + tree.count_size + total_size;
    if (node_size < kNodeFrame + pointer) throw damaged("a tree of no sense");
    const std::uint64_t in_node = (node_size - kNodeFrame - pointer) / (tree.record_size + pointer);
    tree.pointer_size.push_back(pointer);
    const bool too_many = in_subtree > (kMost - in_node) / (in_node + 1);
    in_subtree = too_many ? kMost : (in_node + 1) * in_subtree + in_node;
  }
}

Tree2 tree2_header(const Image& image, std::uint64_t address, Tree2Type type) {
  ByteCursor cursor(image.checked_part(address, 18 + image.offset_size + image.length_size));
  cursor.expect("BTHD");
  if (cursor.number(1) != 0) throw damaged("a tree of a version that is not known");
  Tree2 tree;
  tree.type = cursor.number(1);
  if (tree.type != static_cast<std::uint64_t>(type)) throw damaged("a tree of another type");
  const std::size_t node_size = cursor.number(4);
  tree.record_size = cursor.number(2);
  tree.depth = cursor.number(2);
  cursor.skip(2);
  tree.root = image.address(cursor);
  tree.root_records = cursor.number(2);
  derive_sizes(tree, node_size, image.offset_size);
  return tree;
}

}  // namespace

std::vector<Bytes> tree2_records(const Image& image, std::uint64_t header, Tree2Type type) {
  struct OpenNode {
    std::uint64_t address;
    std::uint64_t records;
    std::size_t level;
  };
  std::vector<Bytes> records;
  if (header == kNowhere) return records;
  const Tree2 tree = tree2_header(image, header, type);
  if (tree.root == kNowhere) return records;
  Budget budget(image);
  std::vector<OpenNode> open = {{tree.root, tree.root_records, tree.depth}};
  while (!open.empty()) {
    const OpenNode node = open.back();
    open.pop_back();
    const std::uint64_t children = node.level == 0 ? 0 : node.records + 1;
    // The numbers have few bytes, but a damaged one may have eight.
    if (node.records > image.bytes.size()) throw damaged("a tree node beyond the file");
    const std::uint64_t size =
        kNodePrefix + node.records * tree.record_size + children * tree.pointer_size[node.level];
    budget.spend(size);
    ByteCursor cursor(image.checked_part(node.address, size));
    cursor.expect(node.level == 0 ? "BTLF" : "BTIN");
    cursor.skip(1);
    if (cursor.number(1) != tree.type) throw damaged("a tree of another type");
    for (std::uint64_t i = 0; i < node.records; ++i) {
      records.push_back(cursor.take(tree.record_size));
    }
    for (std::uint64_t i = 0; i < children; ++i) {
      ByteCursor child(cursor.take(tree.pointer_size[node.level]));
      const std::uint64_t address = image.address(child);
      open.push_back({address, child.number(tree.count_size), node.level - 1});
    }
  }
  return records;
}

}  // namespace prehend::hdf5
