#include "sim/robot/files/xacro_parser.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <optional>
#include <span>
#include <utility>

#include "sim/base/input_error.h"

namespace prehend {
namespace {

constexpr std::size_t kLongestExpression = 2000;
constexpr int kDeepestNesting = 50;

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

// Recursive descent, one function a level of precedence, from the loosest.
class XacroParser {
 public:
  explicit XacroParser(std::string_view text) : text_(text), rest_(text) {
    if (text.size() > kLongestExpression) fail("is longer than 2,000 characters");
  }

  XacroNode whole() {
    XacroNode node = choice();
    if (!at_end()) fail("is no expression that can be read");
    return node;
  }

 private:
  using Kind = XacroNode::Kind;
  using Level = XacroNode (XacroParser::*)();

  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError({.problem = "the expression " + problem, .value = std::string(text_)});
  }

  bool at_end() {
    while (!rest_.empty() && std::isspace(static_cast<unsigned char>(rest_.front()))) {
      rest_.remove_prefix(1);
    }
    return rest_.empty();
  }

  // Takes a sign, or a word that ends there.
  bool take(std::string_view token) {
    if (at_end() || !rest_.starts_with(token)) return false;
    const bool goes_on = rest_.size() > token.size() &&
                         (is_letter(rest_[token.size()]) || is_digit(rest_[token.size()]));
    if (is_letter(token.front()) && goes_on) return false;
    rest_.remove_prefix(token.size());
    return true;
  }

  std::optional<std::string> take_any(std::span<const std::string_view> tokens) {
    for (const std::string_view token : tokens) {
      if (take(token)) return std::string(token);
    }
    return std::nullopt;
  }

  void need(std::string_view token) {
    if (!take(token)) fail("lacks a " + std::string(token));
  }

  // Operators of one level, from left to right.
  XacroNode row(std::span<const std::string_view> tokens, Level next) {
    XacroNode node = (this->*next)();
    while (const auto word = take_any(tokens)) {
      XacroNode second = (this->*next)();
      node = {Kind::binary, *word, {}, {std::move(node), std::move(second)}};
    }
    return node;
  }

  XacroNode choice() {
    if (++depth_ > kDeepestNesting) fail("is nested deeper than 50");
    XacroNode node = either();
    if (take("if")) {
      XacroNode condition = either();
      need("else");
      XacroNode other = choice();
      node = {Kind::choose, "", {}, {std::move(condition), std::move(node), std::move(other)}};
    }
    --depth_;
    return node;
  }

  XacroNode either() {
    constexpr std::array<std::string_view, 1> kOr = {"or"};
    return row(kOr, &XacroParser::both);
  }

  XacroNode both() {
    constexpr std::array<std::string_view, 1> kAnd = {"and"};
    return row(kAnd, &XacroParser::inverted);
  }

  XacroNode inverted() {
    std::size_t times = 0;
    while (take("not")) ++times;
    XacroNode node = comparison();
    // Twice is no less than bool().
    for (std::size_t k = 0; k < (times > 1 ? 2 - times % 2 : times); ++k) {
      node = {Kind::unary, "not", {}, {std::move(node)}};
    }
    return node;
  }

  // a < b < c is not read as in Python: refused.
  XacroNode comparison() {
    constexpr std::array<std::string_view, 7> kSigns = {"==", "!=", "<=", ">=", "<", ">", "in"};
    XacroNode node = sum();
    std::optional<std::string> word = take_any(kSigns);
    if (!word && take("not")) {
      need("in");
      word = "not in";
    }
    if (!word) return node;
    XacroNode second = sum();
    if (take_any(kSigns)) fail("compares several at once");
    return {Kind::binary, *word, {}, {std::move(node), std::move(second)}};
  }

  XacroNode sum() {
    constexpr std::array<std::string_view, 2> kSigns = {"+", "-"};
    return row(kSigns, &XacroParser::product);
  }

  XacroNode product() {
    XacroNode node = signed_power();
    for (;;) {
      // "**" binds closer and was taken there.
      constexpr std::array<std::string_view, 4> kSigns = {"//", "/", "%", "*"};
      const auto word = take_any(kSigns);
      if (!word) return node;
      XacroNode second = signed_power();
      node = {Kind::binary, *word, {}, {std::move(node), std::move(second)}};
    }
  }

  // -a ** b is -(a ** b).
  XacroNode signed_power() {
    if (++depth_ > kDeepestNesting) fail("is nested deeper than 50");
    XacroNode node;
    if (take("-")) {
      node = {Kind::unary, "-", {}, {signed_power()}};
    } else if (take("+")) {
      node = {Kind::unary, "+", {}, {signed_power()}};
    } else {
      node = indexed();
      if (take("**")) node = {Kind::binary, "**", {}, {std::move(node), signed_power()}};
    }
    --depth_;
    return node;
  }

  XacroNode indexed() {
    XacroNode node = atom();
    for (;;) {
      if (take("[")) {
        XacroNode which = choice();
        need("]");
        node = {Kind::index, "", {}, {std::move(node), std::move(which)}};
      } else if (take(".")) {
        node = member(std::move(node), name());
      } else {
        return node;
      }
    }
  }

  XacroNode member(XacroNode of, std::string word) {
    if (!take("(")) return {Kind::member, std::move(word), {}, {std::move(of)}};
    XacroNode node{Kind::method, std::move(word), {}, {std::move(of)}};
    for (XacroNode& part : listed(")")) node.parts.push_back(std::move(part));
    return node;
  }

  std::string name() {
    if (at_end() || !is_letter(rest_.front())) fail("lacks a name");
    std::size_t size = 1;
    while (size < rest_.size() && (is_letter(rest_[size]) || is_digit(rest_[size]))) ++size;
    std::string word(rest_.substr(0, size));
    rest_.remove_prefix(size);
    return word;
  }

  std::vector<XacroNode> listed(std::string_view end) {
    std::vector<XacroNode> parts;
    while (!take(end)) {
      parts.push_back(choice());
      if (take(",")) continue;
      need(end);
      break;
    }
    return parts;
  }

  XacroNode atom() {
    if (at_end()) fail("ends too early");
    const char first = rest_.front();
    if (is_digit(first) || first == '.') return number();
    if (first == '\'' || first == '"') return quoted(first);
    if (is_letter(first)) return named();
    if (take("(")) {
      XacroNode node = choice();
      if (take(",")) {
        node = {Kind::list, "", {}, {std::move(node)}};
        for (XacroNode& part : listed(")")) node.parts.push_back(std::move(part));
        return node;
      }
      need(")");
      return node;
    }
    if (take("[")) return {Kind::list, "", {}, listed("]")};
    fail("is no expression that can be read");
  }

  XacroNode number() {
    const char* const begin = rest_.data();
    const char* const end = rest_.data() + rest_.size();
    double real = 0.0;
    const auto [last, error] = std::from_chars(begin, end, real);
    if (error != std::errc()) fail("has a number that cannot be read");
    const std::string_view digits(begin, static_cast<std::size_t>(last - begin));
    rest_.remove_prefix(digits.size());
    long long whole = 0;
    const auto [stop, wrong] = std::from_chars(begin, last, whole);
    if (wrong == std::errc() && stop == last) return {Kind::literal, "", {whole}, {}};
    return {Kind::literal, "", {real}, {}};
  }

  XacroNode quoted(char mark) {
    const std::size_t end = rest_.find(mark, 1);
    if (end == std::string_view::npos) fail("has a text without an end");
    const std::string text(rest_.substr(1, end - 1));
    rest_.remove_prefix(end + 1);
    return {Kind::literal, "", {text}, {}};
  }

  // Modules of Python and xacro are left out; what else stands before a dot is looked up.
  XacroNode named() {
    std::string word = name();
    for (const char* module : {"math", "python", "xacro"}) {
      if (word != module || !take(".")) continue;
      word = name();
      break;
    }
    if (take("(")) return {Kind::call, word, {}, listed(")")};
    if (word == "True" || word == "true") return {Kind::literal, "", {true}, {}};
    if (word == "False" || word == "false") return {Kind::literal, "", {false}, {}};
    if (word == "None") return {};
    return {Kind::name, word, {}, {}};
  }

  std::string_view text_;
  std::string_view rest_;
  int depth_ = 0;
};

}  // namespace

XacroNode parse_xacro(std::string_view text) { return XacroParser(text).whole(); }

}  // namespace prehend
