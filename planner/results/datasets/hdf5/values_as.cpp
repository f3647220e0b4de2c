#include "planner/results/datasets/hdf5/values_as.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <type_traits>

#include "planner/results/datasets/hdf5/global_heap.h"

namespace prehend::hdf5 {
namespace {

std::uint64_t bits_of(const ValueType& type, Bytes value) {
  if (!type.big_endian) return ByteCursor(value).number(value.size());
  std::uint64_t bits = 0;
  for (const std::uint8_t byte : value) bits = bits << 8U | byte;
  return bits;
}

// IEEE 754 binary16.
float half_of(std::uint64_t bits) {
  const auto mantissa = static_cast<float>(bits & 0x3ffU);
  const int exponent = static_cast<int>(bits >> 10U & 0x1fU);
  constexpr int kSpecial = 31;
  float value = std::ldexp(mantissa, -24);
  if (exponent > 0) value = std::ldexp(mantissa + 1024.0F, exponent - 25);
  if (exponent == kSpecial) {
    value = mantissa == 0.0F ? std::numeric_limits<float>::infinity()
                             : std::numeric_limits<float>::quiet_NaN();
  }
  return (bits & 0x8000U) != 0 ? -value : value;
}

template <typename T>
T real_of(std::uint64_t bits, std::size_t size) {
  if (size == 8) return static_cast<T>(std::bit_cast<double>(bits));
  if (size == 4) {
    return static_cast<T>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
  }
  return static_cast<T>(half_of(bits));
}

template <typename T>
T whole_of(std::uint64_t bits, const ValueType& type) {
  const std::uint64_t sign = std::uint64_t{1} << (8 * type.size - 1);
  if (type.is_signed) {
    // In two's complement the sign's bit fills all higher ones.
    return static_cast<T>(static_cast<std::int64_t>((bits ^ sign) - sign));
  }
  if (std::is_same_v<T, std::int64_t> && bits > std::numeric_limits<std::int64_t>::max()) {
    throw InputError({.problem = "must be below 2^63", .value = std::to_string(bits)});
  }
  return static_cast<T>(bits);
}

std::string text_of(Bytes bytes, bool blanks) {
  std::string text(bytes.begin(), std::find(bytes.begin(), bytes.end(), std::uint8_t{0}));
  if (blanks) text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

}  // namespace

template <typename T>
std::vector<T> numbers_of(const ValueType& type, Bytes values) {
  std::vector<T> numbers;
  numbers.reserve(values.size() / type.size);
  for (; values.size() >= type.size; values = values.subspan(type.size)) {
    const std::uint64_t bits = bits_of(type, values.first(type.size));
    if constexpr (std::is_floating_point_v<T>) {
      if (type.kind == ValueKind::real) {
        numbers.push_back(real_of<T>(bits, type.size));
        continue;
      }
    }
    numbers.push_back(whole_of<T>(bits, type));
  }
  return numbers;
}

template std::vector<double> numbers_of(const ValueType& type, Bytes values);
template std::vector<float> numbers_of(const ValueType& type, Bytes values);
template std::vector<std::int64_t> numbers_of(const ValueType& type, Bytes values);

std::vector<std::string> texts_of(const Image& image, const ValueType& type, Bytes values) {
  std::vector<std::string> texts;
  GlobalHeap heap(image);
  Budget budget(image);
  for (; values.size() >= type.size; values = values.subspan(type.size)) {
    const Bytes value = values.first(type.size);
    if (type.kind == ValueKind::fixed_text) {
      texts.push_back(text_of(value, type.blanks));
      continue;
    }
    ByteCursor cursor(value);
    const std::uint64_t length = cursor.number(4);
    const std::uint64_t collection = image.address(cursor);
    if (length == 0 || collection == 0 || collection == kNowhere) {
      texts.emplace_back();
      continue;
    }
    const Bytes object = heap.object(collection, cursor.number(4));
    if (length > object.size()) throw damaged("a text that is longer than what is stored");
    budget.spend(length);
    texts.push_back(text_of(object.first(length), false));
  }
  return texts;
}

}  // namespace prehend::hdf5
