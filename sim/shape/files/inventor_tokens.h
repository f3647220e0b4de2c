// Splits the text of Inventor and VRML files into tokens, each with its line.
#pragma once

#include <string>
#include <string_view>

namespace prehend {

// A token of an Inventor file. White space, commas, '|' and comments (from # to the end of a line)
// separate tokens.
struct InventorToken {
  enum class Kind { end, word, text, open, close };
  Kind kind = Kind::end;
  // A word as it is, a text without its quotes, or one of the characters { } [ ] ( ).
  std::string_view text = {};
  int line = 0;

  bool is(std::string_view symbol) const { return kind != Kind::text && text == symbol; }
  bool is_word() const { return kind == Kind::word; }
  // Whether it is a word that begins as a number does.
  bool is_numeric() const;
};

// Throws InputError "line N: PROBLEM (VALUE)".
[[noreturn]] void fail_in_line(int line, const std::string& problem, std::string_view value = {});

// A cursor over the tokens of a text, which must outlive it.
class InventorTokens {
 public:
  explicit InventorTokens(std::string_view text);

  // The token at the cursor, and the one behind it.
  const InventorToken& peek() const { return current_; }
  const InventorToken& peek_second() const { return second_; }
  // Moves on and returns the token that the cursor was at. Throws InputError for a text that is not
  // closed.
  InventorToken next();

 private:
  InventorToken scan();
  void skip_blanks();

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
  InventorToken current_;
  InventorToken second_;
};

}  // namespace prehend
