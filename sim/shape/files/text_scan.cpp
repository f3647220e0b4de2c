#include "sim/shape/files/text_scan.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <system_error>

#include "sim/base/input_error.h"

namespace prehend {
namespace {

// std::from_chars does not accept a leading plus.
std::string_view without_plus(std::string_view word) {
  const bool signed_plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  return signed_plus ? word.substr(1) : word;
}

// The whole word as a number: nothing may be left over behind it. std::from_chars does not depend
// on the locale, unlike strtod, which in some locales expects a decimal comma.
template <typename Value>
std::optional<Value> parse(std::string_view word) {
  word = without_plus(word);
  Value value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || word.empty()) return std::nullopt;
  if (error == std::errc()) return value;
  return std::nullopt;
}

}  // namespace

bool TextScan::next_line() {
  if (next_ >= text_.size()) return false;
  const std::size_t end = std::min(text_.find_first_of("\r\n", next_), text_.size());
  line_ = text_.substr(next_, end - next_);
  next_ = end;
  if (next_ < text_.size()) {
    const bool pair = text_.substr(next_, 2) == "\r\n";
    next_ += pair ? 2 : 1;
  }
  ++line_number_;
  return true;
}

std::string_view TextScan::next_word() {
  constexpr std::string_view kBlank = " \t";
  const std::size_t first = std::min(line_.find_first_not_of(kBlank), line_.size());
  line_.remove_prefix(first);
  const std::size_t length = std::min(line_.find_first_of(kBlank), line_.size());
  const std::string_view word = line_.substr(0, length);
  line_.remove_prefix(length);
  return word;
}

void TextScan::fail(const std::string& what) const {
  throw InputError({.field = "line " + std::to_string(line_number_), .problem = what});
}

std::optional<double> number_in(std::string_view word) {
  const std::optional<double> value = parse<double>(word);
  if (value) return value;
  // Out of range for a double: from_chars leaves the value unset for both overflow and underflow.
  // strtod tells them apart: it returns infinity or a number next to 0.
  const std::string_view digits = without_plus(word);
  double ignored = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), ignored);
  if (error != std::errc::result_out_of_range || end != digits.data() + digits.size()) {
    return std::nullopt;
  }
  const double nearest = std::strtod(std::string(digits).c_str(), nullptr);
  return std::isinf(nearest) ? std::numeric_limits<double>::infinity() : 0.0;
}

std::optional<long long> integer_in(std::string_view word) { return parse<long long>(word); }

// Text in UTF-16 has a byte order mark or, without one, zero bytes, as have nearly all binary
// files. Text in UTF-8 has none.
void need_text(std::string_view bytes) {
  const std::string_view mark = bytes.substr(0, 2);
  if (mark == "\xFE\xFF" || mark == "\xFF\xFE") {
    throw InputError("the text is UTF-16, save it as UTF-8");
  }
  if (bytes.find('\0') != bytes.npos) throw InputError("binary data where text was expected");
}

std::string in_quotes(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  std::string text = "'";
  for (const char c : word.substr(0, kLongest)) {
    text += std::isprint(static_cast<unsigned char>(c)) != 0 ? c : '?';
  }
  return text + (word.size() > kLongest ? "...'" : "'");
}

double coordinate_in(const TextScan& scan, std::string_view word) {
  if (word.empty()) scan.fail("a vertex with fewer than three coordinates");
  const std::optional<double> value = number_in(word);
  if (!value) scan.fail("a coordinate is not a number (" + in_quotes(word) + ")");
  if (!(std::abs(*value) <= static_cast<double>(std::numeric_limits<float>::max()))) {
    scan.fail("a coordinate is not finite or too large (" + in_quotes(word) + ")");
  }
  return *value;
}

}  // namespace prehend
