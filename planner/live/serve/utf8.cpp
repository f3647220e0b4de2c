#include "planner/live/serve/utf8.h"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace prehend {
namespace {

// A character by its first byte: how many bytes follow, and within what the first of them lies,
// which is where overlong forms, surrogates and too large values show.
struct Utf8Form {
  std::size_t more = 0;
  unsigned lowest = 0x80;
  unsigned highest = 0xBF;
};

std::optional<Utf8Form> form_of(unsigned first) {
  if (first < 0x80) return Utf8Form{};
  if (first < 0xC2) return std::nullopt;
  if (first < 0xE0) return Utf8Form{1};
  if (first == 0xE0) return Utf8Form{2, 0xA0, 0xBF};
  if (first == 0xED) return Utf8Form{2, 0x80, 0x9F};
  if (first < 0xF0) return Utf8Form{2};
  if (first == 0xF0) return Utf8Form{3, 0x90, 0xBF};
  if (first < 0xF4) return Utf8Form{3};
  if (first == 0xF4) return Utf8Form{3, 0x80, 0x8F};
  return std::nullopt;
}

unsigned byte_at(std::string_view bytes, std::size_t i) {
  return static_cast<unsigned char>(bytes[i]);
}

}  // namespace

bool is_utf8(std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size();) {
    const std::optional<Utf8Form> form = form_of(byte_at(bytes, i));
    if (!form || form->more >= bytes.size() - i) return false;
    for (std::size_t k = 1; k <= form->more; ++k) {
      const unsigned byte = byte_at(bytes, i + k);
      const unsigned lowest = k == 1 ? form->lowest : 0x80;
      const unsigned highest = k == 1 ? form->highest : 0xBF;
      if (byte < lowest || byte > highest) return false;
    }
    i += form->more + 1;
  }
  return true;
}

bool is_plain_text(std::string_view bytes) {
  constexpr char kDelete = 0x7F;
  const auto is_control = [](char c) {
    return (static_cast<unsigned char>(c) < 0x20 && c != '\t') || c == kDelete;
  };
  return is_utf8(bytes) && std::none_of(bytes.begin(), bytes.end(), is_control);
}

}  // namespace prehend
