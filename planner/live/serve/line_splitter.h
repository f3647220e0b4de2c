// Lines in a stream of bytes that is cut anywhere.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace prehend {

// Puts lines together of the pieces that come. A line ends with "\n" or "\r\n", which do not belong
// to it; empty lines are left out, and so is what follows the last end.
class LineSplitter {
 public:
  // What becomes of a line: `whole`, or its beginning alone as it is longer than `longest` bytes.
  // Returns whether to go on: after false, the rest of the piece is dropped.
  using Use = std::function<bool(std::string line, bool whole)>;

  explicit LineSplitter(std::size_t longest) : longest_(longest) {}

  // Takes the next piece of the stream. A line that is too long is passed on once, as soon as that
  // is known, with kBeginning bytes of it; the rest of it is not kept.
  void add(std::string_view piece, const Use& use);

  // Bytes of memory that are held for a line that has not ended.
  std::size_t held() const { return line_.capacity(); }

  static constexpr std::size_t kBeginning = 16;

 private:
  bool end_line(const Use& use);
  bool cut_line(const Use& use);

  std::size_t longest_;
  std::string line_;
  bool skips_ = false;  // the line was too long, and has not ended
};

}  // namespace prehend
