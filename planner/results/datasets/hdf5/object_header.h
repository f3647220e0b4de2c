// What an HDF5 file says of a group or a data set: a list of messages.
#pragma once

#include <vector>

#include "planner/results/datasets/hdf5/image.h"

namespace prehend::hdf5 {

// Numbers of the specification (IV.A.2).
enum class MessageType : std::uint8_t {
  dataspace = 0x01,
  link_info = 0x02,
  datatype = 0x03,
  old_fill_value = 0x04,
  fill_value = 0x05,
  link = 0x06,
  external_files = 0x07,
  layout = 0x08,
  filters = 0x0b,
  continuation = 0x10,
  symbol_table = 0x11,
};

struct Message {
  MessageType type{};
  Bytes data;
};

using Messages = std::vector<Message>;

// Messages of versions 1 and 2 of the header, those of its continuations too; a message that other
// objects share (a committed datatype) is looked up where it stands. Throws damaged().
Messages object_header(const Image& image, std::uint64_t address);

// The first of this type, else nullptr.
const Message* find(const Messages& messages, MessageType type);

}  // namespace prehend::hdf5
