#include "planner/results/datasets/hdf5/object_header.h"

#include <algorithm>

namespace prehend::hdf5 {
namespace {

constexpr std::uint64_t kShared = 2;               // flag of a message
constexpr std::uint64_t kMustBeUnderstood = 0x80;  // flag of a message
constexpr std::size_t kMostMessages = 65535;       // version 1 counts them in two bytes
constexpr std::uint64_t kLastKnown = 0x18;         // type of a message

struct FoundMessage {
  Message message;
  bool shared = false;
};

// How messages are laid out in all blocks of a header.
struct HeaderForm {
  bool version_2 = false;
  bool ordered = false;  // each message has its order of creation

  std::size_t prefix() const { return version_2 ? (ordered ? 6 : 4) : 8; }
};

struct HeaderBlock {
  std::uint64_t address = 0;
  std::uint64_t size = 0;
};

FoundMessage next_message(ByteCursor& cursor, const HeaderForm& form) {
  const std::uint64_t type = cursor.number(form.version_2 ? 1 : 2);
  const std::uint64_t size = cursor.number(2);
  const std::uint64_t flags = cursor.number(1);
  cursor.skip(form.prefix() - (form.version_2 ? 4 : 5));
  if (type > kLastKnown) {
    if ((flags & kMustBeUnderstood) != 0) throw damaged("a message of a type that is not known");
    return {{MessageType{}, cursor.take(size)}};
  }
  return {{static_cast<MessageType>(type), cursor.take(size)}, (flags & kShared) != 0};
}

// The messages of one block; adds the continuations among them to `blocks`.
void read_block(const Image& image, Bytes block, const HeaderForm& form,
                std::vector<FoundMessage>& messages, std::vector<HeaderBlock>& blocks) {
  ByteCursor cursor(block);
  while (cursor.left() >= form.prefix()) {
    const FoundMessage found = next_message(cursor, form);
    if (found.message.type != MessageType::continuation) {
      if (messages.size() == kMostMessages) throw damaged("too many messages");
      messages.push_back(found);
      continue;
    }
    ByteCursor where(found.message.data);
    const std::uint64_t address = image.address(where);
    blocks.push_back({address, image.length(where)});
  }
}

// The first block of a header, and the form of all of them.
std::pair<Bytes, HeaderForm> first_block(const Image& image, std::uint64_t address) {
  const Bytes start = image.from(address);
  ByteCursor cursor(start);
  if (cursor.number(1) == 1) {
    cursor.skip(7);
    const std::uint64_t size = cursor.number(4);
    cursor.skip(4);
    return {cursor.take(size), {}};
  }
  cursor = ByteCursor(start);
  cursor.expect("OHDR");
  if (cursor.number(1) != 2) throw damaged("a header of a version that is not known");
  const std::uint64_t flags = cursor.number(1);
  if ((flags & 0x20U) != 0) cursor.skip(16);  // times
  if ((flags & 0x10U) != 0) cursor.skip(4);   // when attributes are stored elsewhere
  const std::uint64_t size = cursor.number(std::size_t{1} << (flags & 3U));
  const std::uint64_t prefix = start.size() - cursor.left();
  if (size > cursor.left()) throw damaged("it ends too early");
  return {image.checked_part(address, prefix + size).subspan(prefix),
          {.version_2 = true, .ordered = (flags & 4U) != 0}};
}

Bytes next_block(const Image& image, const HeaderBlock& block, const HeaderForm& form) {
  if (!form.version_2) return image.part(block.address, block.size);
  constexpr std::uint64_t kFrame = 4;  // bytes of the signature, and of the checksum
  if (block.size < 2 * kFrame) throw damaged("a continuation of no size");
  const Bytes bytes = image.checked_part(block.address, block.size - kFrame);
  ByteCursor(bytes).expect("OCHK");
  return bytes.subspan(kFrame);
}

std::vector<FoundMessage> read_header(const Image& image, std::uint64_t address) {
  const auto [first, form] = first_block(image, address);
  Budget budget(image);
  budget.spend(first.size());
  std::vector<FoundMessage> messages;
  std::vector<HeaderBlock> blocks;
  read_block(image, first, form, messages, blocks);
  while (!blocks.empty()) {
    const HeaderBlock block = blocks.back();
    blocks.pop_back();
    budget.spend(block.size);
    read_block(image, next_block(image, block, form), form, messages, blocks);
  }
  return messages;
}

// Where a shared message stands: in the header of another object.
Message shared_message(const Image& image, const Message& message) {
  ByteCursor cursor(message.data);
  const std::uint64_t version = cursor.number(1);
  const std::uint64_t kind = cursor.number(1);
  if (version == 1) cursor.skip(6);
  constexpr std::uint64_t kInHeader = 2;
  if (version > 3 || (version == 3 && kind != kInHeader)) {
    throw not_read("is described in a heap that objects share",
                   "write the file without shared messages");
  }
  for (const FoundMessage& found : read_header(image, image.address(cursor))) {
    if (found.message.type == message.type && !found.shared) return found.message;
  }
  throw damaged("a shared message is missing");
}

}  // namespace

Messages object_header(const Image& image, std::uint64_t address) {
  Messages messages;
  for (const FoundMessage& found : read_header(image, address)) {
    const MessageType type = found.message.type;
    const bool needed = type == MessageType::dataspace || type == MessageType::datatype ||
                        type == MessageType::fill_value || type == MessageType::filters;
    if (found.shared && (!needed || find(messages, type) != nullptr)) continue;
    messages.push_back(found.shared ? shared_message(image, found.message) : found.message);
  }
  return messages;
}

const Message* find(const Messages& messages, MessageType type) {
  const auto found = std::find_if(messages.begin(), messages.end(),
                                  [type](const Message& message) { return message.type == type; });
  return found == messages.end() ? nullptr : &*found;
}

}  // namespace prehend::hdf5
