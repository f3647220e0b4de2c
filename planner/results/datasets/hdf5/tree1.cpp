#include "planner/results/datasets/hdf5/tree1.h"

#include <optional>

namespace prehend::hdf5 {

std::vector<Tree1Entry> tree1_entries(const Image& image, std::uint64_t root, Tree1Type type,
                                      std::size_t key_size, std::size_t most) {
  struct OpenNode {
    std::uint64_t address;
    std::optional<std::uint64_t> level;  // none: the root's, which it says itself
  };
  std::vector<Tree1Entry> entries;
  if (root == kNowhere) return entries;
  Budget budget(image);
  std::vector<OpenNode> open = {{root, {}}};
  while (!open.empty()) {
    const OpenNode node = open.back();
    open.pop_back();
    ByteCursor cursor(image.from(node.address));
    const std::size_t all = cursor.left();
    cursor.expect("TREE");
    if (cursor.number(1) != static_cast<std::uint64_t>(type))
      throw damaged("a tree of another type");
    const std::uint64_t level = cursor.number(1);
    if (level != node.level.value_or(level)) throw damaged("a tree whose levels do not agree");
    const std::uint64_t count = cursor.number(2);
    cursor.skip(2 * image.offset_size);  // its neighbours
    for (std::uint64_t i = 0; i < count; ++i) {
      if (entries.size() + open.size() >= most) throw damaged("a tree of too many entries");
      const Bytes key = cursor.take(key_size);
      const std::uint64_t child = image.address(cursor);
      if (level == 0) {
        entries.push_back({key, child});
      } else {
        open.push_back({child, level - 1});
      }
    }
    budget.spend(all - cursor.left());
  }
  return entries;
}

}  // namespace prehend::hdf5
