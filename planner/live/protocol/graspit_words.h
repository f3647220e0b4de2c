// The words of a line of GraspIt!'s text protocol, taken one after the other.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace prehend {

// Words are separated by blanks. Functions throw InputError without a field, whose problem is what
// the client is told behind "Error: ".
class GraspitWords {
 public:
  explicit GraspitWords(std::string_view line);

  bool at_end() const { return next_ == words_.size(); }
  // `what` is what errors call it.
  std::string_view word(const char* what);
  int integer(const char* what);
  double number(const char* what);  // finite, of at most 1e30 in size
  std::vector<double> numbers(std::size_t count, const char* what);
  // Nothing is left.
  void end() const;

  // "ALL", or how many there are and their numbers.
  struct List {
    bool all = false;
    std::vector<int> numbers;
  };
  List list();

 private:
  std::vector<std::string> words_;
  std::size_t next_ = 0;
};

}  // namespace prehend
