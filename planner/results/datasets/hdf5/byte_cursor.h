// Bytes of a file that is not trusted, read one number after the other and never beyond their end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "sim/base/input_error.h"

namespace prehend::hdf5 {

using Bytes = std::span<const std::uint8_t>;

// The error about bytes that contradict the format, and the one about what the format has and this
// reader has not. Who knows the file and the data set adds them.
InputError damaged(const std::string& what);
InputError not_read(const std::string& what, const std::string& next_step);

// All throw damaged() where fewer bytes are left than asked for.
class ByteCursor {
 public:
  explicit ByteCursor(Bytes bytes) : left_(bytes) {}

  std::size_t left() const { return left_.size(); }
  Bytes take(std::uint64_t count);
  void skip(std::uint64_t count) { (void)take(count); }
  // An unsigned number of 1 to 8 bytes, the lowest first.
  std::uint64_t number(std::size_t size);
  // These bytes, which stand at the start of a structure.
  void expect(std::string_view signature);

 private:
  Bytes left_;
};

}  // namespace prehend::hdf5
