// Splits text into lines and words and keeps the line number for error messages; converts words to
// numbers.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace prehend {

// A cursor over text. The text must outlive it.
class TextScan {
 public:
  explicit TextScan(std::string_view text) : text_(text) {}

  // Moves to the next line (lines end with LF, CR or CR LF). False at the end of the text.
  bool next_line();
  // The next word of the current line; empty when there is none left. Words are separated by spaces
  // and tabs, and by nothing else: what other parsers do with a vertical tab differs.
  std::string_view next_word();
  // Number of the current line, from 1; 0 before the first line.
  int line_number() const { return line_number_; }
  // Offset in bytes of the start of the next line.
  std::size_t position() const { return next_; }

  // Throws InputError "line N: WHAT".
  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::string_view text_;
  std::string_view line_;
  std::size_t next_ = 0;
  int line_number_ = 0;
};

// The word as a decimal number ("1", "-2.", "+.5e3", also infinity and NaN), or nullopt unless the
// whole word is one. Numbers too large for a double become infinity, too small ones 0.
std::optional<double> number_in(std::string_view word);
// The word as a decimal integer, or nullopt unless the whole word is one that fits.
std::optional<long long> integer_in(std::string_view word);

// Throws InputError unless the text may be UTF-8 or another superset of ASCII: no zero bytes, no
// byte order mark of UTF-16.
void need_text(std::string_view bytes);

// The word in quotes for an error message: at most 40 characters, others than printable ones
// replaced by ?.
std::string in_quotes(std::string_view word);

// The word as a coordinate. Throws InputError with the line number unless it is a finite number
// within the range of float.
double coordinate_in(const TextScan& scan, std::string_view word);

}  // namespace prehend
