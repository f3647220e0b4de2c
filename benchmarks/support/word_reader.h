// The words of a command line, one after another.
#pragma once

#include <charconv>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "sim/base/input_error.h"

namespace prehend::bench {

class WordReader {
 public:
  explicit WordReader(std::vector<std::string> words) : words_(std::move(words)) {}

  // Goes to the next word, at first to the first; false after the last.
  bool next() { return ++at_ <= words_.size(); }
  const std::string& word() const { return words_[at_ - 1]; }

  // What follows the word, as its value. Throw InputError where nothing does, or no whole number.
  std::string text() {
    const std::string& flag = word();
    require(at_ < words_.size(), {.field = flag, .problem = "needs a value"});
    return words_[at_++];
  }
  int number() {
    const std::string flag = word();
    const std::string value = text();
    int number = 0;
    const char* const end = value.data() + value.size();
    const auto [stop, error] = std::from_chars(value.data(), end, number);
    require(error == std::errc() && stop == end,
            {.field = flag, .problem = "is no whole number", .value = value});
    return number;
  }

 private:
  std::vector<std::string> words_;
  std::size_t at_ = 0;  // the number of the word, from 1
};

}  // namespace prehend::bench
