#include "sim/shape/files/ply_elements.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "sim/base/input_error.h"

namespace prehend {
namespace {

PlyScalar scalar_named(const TextScan& scan, std::string_view name) {
  constexpr std::array<std::pair<std::string_view, PlyScalar>, 16> kScalars{{
      {"char", {PlyScalar::Kind::signed_integer, 1}},
      {"int8", {PlyScalar::Kind::signed_integer, 1}},
      {"uchar", {PlyScalar::Kind::unsigned_integer, 1}},
      {"uint8", {PlyScalar::Kind::unsigned_integer, 1}},
      {"short", {PlyScalar::Kind::signed_integer, 2}},
      {"int16", {PlyScalar::Kind::signed_integer, 2}},
      {"ushort", {PlyScalar::Kind::unsigned_integer, 2}},
      {"uint16", {PlyScalar::Kind::unsigned_integer, 2}},
      {"int", {PlyScalar::Kind::signed_integer, 4}},
      {"int32", {PlyScalar::Kind::signed_integer, 4}},
      {"uint", {PlyScalar::Kind::unsigned_integer, 4}},
      {"uint32", {PlyScalar::Kind::unsigned_integer, 4}},
      {"float", {PlyScalar::Kind::real, 4}},
      {"float32", {PlyScalar::Kind::real, 4}},
      {"double", {PlyScalar::Kind::real, 8}},
      {"float64", {PlyScalar::Kind::real, 8}},
  }};
  for (const auto& [known, scalar] : kScalars) {
    if (known == name) return scalar;
  }
  scan.fail("unknown PLY type " + in_quotes(name));
}

// "element NAME COUNT". Each takes at least a byte, so a count beyond the size of the file is
// wrong. Vertices and faces stand in one list each.
void read_element(TextScan& scan, PlyHeader& header, std::size_t file_size) {
  PlyElement element;
  element.name = scan.next_word();
  const std::string_view word = scan.next_word();
  const std::optional<long long> count = integer_in(word);
  if (!count || *count < 0) scan.fail("a PLY element has the count " + in_quotes(word));
  if (*count > static_cast<long long>(file_size)) {
    scan.fail("promises " + std::to_string(*count) + " of element " + in_quotes(element.name) +
              ", more than the file can hold");
  }
  element.count = *count;
  for (const PlyElement& other : header.elements) {
    if (other.name == element.name) scan.fail("element " + in_quotes(other.name) + " given twice");
  }
  header.elements.push_back(std::move(element));
}

// "property TYPE NAME" or "property list COUNT_TYPE TYPE NAME", of the last element.
void read_property(TextScan& scan, PlyHeader& header) {
  if (header.elements.empty()) scan.fail("a PLY property of no element");
  PlyProperty property;
  std::string_view type = scan.next_word();
  if (type == "list") {
    property.count = scalar_named(scan, scan.next_word());
    if (property.count->kind == PlyScalar::Kind::real) scan.fail("a PLY list counted in fractions");
    type = scan.next_word();
  }
  property.value = scalar_named(scan, type);
  property.name = scan.next_word();
  header.elements.back().properties.push_back(std::move(property));
}

}  // namespace

const PlyElement* PlyHeader::element(std::string_view name) const {
  const auto found = std::find_if(elements.begin(), elements.end(),
                                  [&](const PlyElement& one) { return one.name == name; });
  return found == elements.end() ? nullptr : &*found;
}

PlyHeader read_ply_header(std::string_view bytes) {
  TextScan scan(bytes);
  if (!scan.next_line() || scan.next_word() != "ply") throw InputError("no PLY header");
  PlyHeader header;
  bool has_format = false;
  while (scan.next_line()) {
    const std::string_view word = scan.next_word();
    if (word == "format") {
      const std::string_view name = scan.next_word();
      has_format = true;
      if (name == "binary_little_endian") {
        header.encoding = PlyHeader::Encoding::little_endian;
      } else if (name == "binary_big_endian") {
        header.encoding = PlyHeader::Encoding::big_endian;
      } else if (name != "ascii") {
        scan.fail("unknown PLY format " + in_quotes(name));
      }
    } else if (word == "element") {
      read_element(scan, header, bytes.size());
    } else if (word == "property") {
      read_property(scan, header);
    } else if (word == "end_header") {
      if (!has_format) scan.fail("the PLY header names no format");
      header.end = scan.position();
      return header;
    }  // other lines are comments, with or without the word for it
  }
  throw InputError("the PLY header does not end");
}

bool has_ply_surface(std::string_view bytes) {
  const PlyHeader header = read_ply_header(bytes);
  return std::any_of(header.elements.begin(), header.elements.end(), [](const PlyElement& element) {
    return element.count > 0 && (element.name == "face" || element.name == "tristrips");
  });
}

PlyBody::PlyBody(std::string_view bytes, const PlyHeader& header)
    : bytes_(bytes), text_(bytes), header_(header), at_(header.end) {
  // The text cursor starts over and passes the header, so that its line numbers count from the
  // start of the file.
  while (text_.position() < header.end && text_.next_line()) {
  }
  text_.next_word();  // end_header
}

double PlyBody::next(const PlyScalar& scalar, const PlyElement& element) {
  return header_.encoding == PlyHeader::Encoding::text ? next_word(element)
                                                       : next_binary(scalar, element);
}

// A length within the limit fits an int. Comparisons are negated so that they also reject NaN.
int PlyBody::next_length(const PlyProperty& property, const PlyElement& element) {
  constexpr double kLongest = 1e6;
  const double count = next(*property.count, element);
  if (!(count >= 0.0) || count > kLongest || count != std::floor(count)) {
    fail("a PLY list of length " + std::to_string(count));
  }
  return static_cast<int>(count);
}

void PlyBody::fail(const std::string& what) const {
  if (header_.encoding == PlyHeader::Encoding::text) text_.fail(what);
  throw InputError(what);
}

void PlyBody::too_short(const PlyElement& element) const {
  fail("the file ends inside element " + in_quotes(element.name) + " (" +
       std::to_string(element.count) + " promised)");
}

double PlyBody::next_word(const PlyElement& element) {
  std::string_view word = text_.next_word();
  while (word.empty()) {
    if (!text_.next_line()) too_short(element);
    word = text_.next_word();
  }
  const std::optional<double> value = number_in(word);
  if (!value) text_.fail("not a number (" + in_quotes(word) + ")");
  return *value;
}

namespace {

// The bytes in native order: reversed where the file has the other byte order.
template <typename Value>
double decoded(const char* data, bool big_endian) {
  std::array<char, sizeof(Value)> raw;
  const bool swap = big_endian != (std::endian::native == std::endian::big);
  for (std::size_t i = 0; i < raw.size(); ++i) raw[i] = data[swap ? raw.size() - 1 - i : i];
  return static_cast<double>(std::bit_cast<Value>(raw));
}

}  // namespace

double PlyBody::next_binary(const PlyScalar& scalar, const PlyElement& element) {
  if (bytes_.size() - at_ < scalar.bytes) too_short(element);
  const char* data = bytes_.data() + at_;
  at_ += scalar.bytes;
  const bool big = header_.encoding == PlyHeader::Encoding::big_endian;
  if (scalar.kind == PlyScalar::Kind::real) {
    return scalar.bytes == 4 ? decoded<float>(data, big) : decoded<double>(data, big);
  }
  const bool is_signed = scalar.kind == PlyScalar::Kind::signed_integer;
  if (scalar.bytes == 1) {
    return is_signed ? decoded<std::int8_t>(data, big) : decoded<std::uint8_t>(data, big);
  }
  if (scalar.bytes == 2) {
    return is_signed ? decoded<std::int16_t>(data, big) : decoded<std::uint16_t>(data, big);
  }
  return is_signed ? decoded<std::int32_t>(data, big) : decoded<std::uint32_t>(data, big);
}

}  // namespace prehend
