// Goes through text by lines and words, keeping the line number for messages.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace prehend {

class TextScan {
 public:
  explicit TextScan(std::string_view text) : text_(text) {}

  // Moves to the next line (ended by LF, CR or CR LF); false at the end of the text.
  bool next_line();
  // The next word of the line, empty at its end. Words are separated by spaces and tabs.
  std::string_view next_word();
  // From 1; 0 before the first line.
  int line_number() const { return line_number_; }
  // Where the line after this one starts.
  std::size_t position() const { return next_; }

  // Ends with InputError "line N: WHAT".
  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::string_view text_;
  std::string_view line_;
  std::size_t next_ = 0;
  int line_number_ = 0;
};

// The whole word as a decimal number ("1", "-2.", "+.5e3"), infinite and NaN included; none when it
// is anything else.
std::optional<double> number_in(std::string_view word);
std::optional<long long> integer_in(std::string_view word);

// The word in quotes, fit for a message: printable and not long.
std::string in_quotes(std::string_view word);

// A coordinate: InputError with the line unless it is a finite number within the range of float.
double coordinate_in(const TextScan& scan, std::string_view word);

}  // namespace prehend
