#include "sim/shape/files/inventor_tokens.h"

#include <algorithm>

#include "sim/base/input_error.h"
#include "sim/shape/files/text_scan.h"

namespace prehend {
namespace {

constexpr std::string_view kInventorBlanks = " \t\r\n\f\v,|";
constexpr std::string_view kInventorBreaks = " \t\r\n\f\v,|{}[]()\"#";

}  // namespace

bool InventorToken::is_numeric() const {
  constexpr std::string_view kFirst = "0123456789+-.";
  return kind == Kind::word && kFirst.find(text.front()) != std::string_view::npos;
}

void fail_in_line(int line, const std::string& problem, std::string_view value) {
  throw InputError({.field = "line " + std::to_string(line),
                    .problem = problem + (value.empty() ? "" : " (" + in_quotes(value) + ")")});
}

InventorTokens::InventorTokens(std::string_view text) : text_(text) {
  current_ = scan();
  second_ = scan();
}

InventorToken InventorTokens::next() {
  const InventorToken token = current_;
  current_ = second_;
  if (current_.kind != InventorToken::Kind::end) second_ = scan();
  return token;
}

void InventorTokens::skip_blanks() {
  while (at_ < text_.size()) {
    if (text_[at_] == '#') {
      at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
    } else if (kInventorBlanks.find(text_[at_]) != std::string_view::npos) {
      // A line ends with LF, CR LF or a CR alone.
      const bool lone_return =
          text_[at_] == '\r' && (at_ + 1 == text_.size() || text_[at_ + 1] != '\n');
      line_ += int{text_[at_] == '\n' || lone_return};
      ++at_;
    } else {
      return;
    }
  }
}

InventorToken InventorTokens::scan() {
  skip_blanks();
  if (at_ == text_.size()) return {.line = line_};
  const std::size_t first = at_;
  const char c = text_[first];
  if (c == '"') {
    const int line = line_;
    for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
      if (text_[at_] == '\\' && at_ + 1 < text_.size()) ++at_;
      line_ += int{text_[at_] == '\n'};
    }
    if (at_ >= text_.size()) fail_in_line(line, "a text in quotes is not closed");
    ++at_;
    return {InventorToken::Kind::text, text_.substr(first + 1, at_ - first - 2), line};
  }
  if (kInventorBreaks.find(c) != std::string_view::npos) {
    ++at_;
    const bool opens = c == '{' || c == '[' || c == '(';
    return {opens ? InventorToken::Kind::open : InventorToken::Kind::close, text_.substr(first, 1),
            line_};
  }
  at_ = std::min(text_.find_first_of(kInventorBreaks, first), text_.size());
  return {InventorToken::Kind::word, text_.substr(first, at_ - first), line_};
}

}  // namespace prehend
