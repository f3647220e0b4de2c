#include "planner/results/datasets/hdf5/byte_cursor.h"

#include <algorithm>

namespace prehend::hdf5 {

InputError damaged(const std::string& what) {
  return InputError("is damaged (" + what + "): copy or write the file again");
}

InputError not_read(const std::string& what, const std::string& next_step) {
  return InputError(what + ": " + next_step);
}

Bytes ByteCursor::take(std::uint64_t count) {
  if (count > left_.size()) throw damaged("it ends too early");
  const Bytes taken = left_.first(count);
  left_ = left_.subspan(count);
  return taken;
}

std::uint64_t ByteCursor::number(std::size_t size) {
  const Bytes bytes = take(size);
  std::uint64_t value = 0;
  for (std::size_t i = size; i > 0; --i) value = value << 8U | bytes[i - 1];
  return value;
}

void ByteCursor::expect(std::string_view signature) {
  const Bytes found = take(signature.size());
  const auto same = [](std::uint8_t byte, char c) { return byte == static_cast<std::uint8_t>(c); };
  if (!std::equal(found.begin(), found.end(), signature.begin(), same)) {
    throw damaged("no " + std::string(signature) + " where one belongs");
  }
}

}  // namespace prehend::hdf5
