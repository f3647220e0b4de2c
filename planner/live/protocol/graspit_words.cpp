#include "planner/live/protocol/graspit_words.h"

#include <charconv>
#include <cmath>
#include <sstream>

#include "sim/base/input_error.h"
#include "sim/base/json/json_field.h"
#include "sim/base/range.h"

namespace prehend {
namespace {

template <typename Value>
bool reads_as(std::string_view word, Value& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const char* end = word.data() + word.size();
  const auto [last, error] = std::from_chars(word.data(), end, value);
  return error == std::errc() && last == end;
}

}  // namespace

GraspitWords::GraspitWords(std::string_view line) {
  std::istringstream stream{std::string(line)};
  for (std::string word; stream >> word;) words_.push_back(std::move(word));
}

std::string_view GraspitWords::word(const char* what) {
  if (at_end()) throw InputError(std::string("the line ends before ") + what + ".");
  return words_[next_++];
}

int GraspitWords::integer(const char* what) {
  int value = 0;
  if (!reads_as(word(what), value)) throw InputError(std::string(what) + " is no integer.");
  return value;
}

double GraspitWords::number(const char* what) {
  double value = 0.0;
  const bool is_number = reads_as(word(what), value) && std::abs(value) <= kLargestNumber;
  if (!is_number) throw InputError(std::string(what) + " is no number.");
  return value;
}

std::vector<double> GraspitWords::numbers(std::size_t count, const char* what) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(number(what));
  return values;
}

void GraspitWords::end() const {
  if (!at_end()) throw InputError("the line has more words than the command takes.");
}

GraspitWords::List GraspitWords::list() {
  if (!at_end() && words_[next_] == "ALL") {
    ++next_;
    return {true, {}};
  }
  List list;
  const int count = integer("the length of the list");
  if (count < 0) throw InputError("the length of the list is negative.");
  for (int i = 0; i < count; ++i) list.numbers.push_back(integer("a number of the list"));
  return list;
}

}  // namespace prehend
