#include "sim/shape/cloud/files/lzf.h"

#include "sim/base/input_error.h"

namespace prehend {
namespace {

[[noreturn]] void fail() { throw InputError("the compressed points are damaged"); }

class LzfReader {
 public:
  LzfReader(std::string_view bytes, std::size_t size) : bytes_(bytes), size_(size) {
    constexpr std::size_t kMostPerByte = 88;  // 264 bytes take 3
    if (size / kMostPerByte > bytes.size()) fail();
    text_.reserve(size);
  }

  std::string run() {
    while (at_ < bytes_.size()) {
      const unsigned control = next();
      if (control < 32) {
        copy_literal(control + 1);
      } else {
        copy_earlier(control);
      }
    }
    if (text_.size() != size_) fail();
    return std::move(text_);
  }

 private:
  unsigned next() {
    if (at_ == bytes_.size()) fail();
    return static_cast<unsigned char>(bytes_[at_++]);
  }

  void copy_literal(std::size_t length) {
    if (length > bytes_.size() - at_ || length > size_ - text_.size()) fail();
    text_.append(bytes_.substr(at_, length));
    at_ += length;
  }

  // What was written `back` bytes ago; it may reach into what is being written.
  void copy_earlier(unsigned control) {
    std::size_t length = control >> 5U;
    if (length == 7) length += next();
    length += 2;
    const std::size_t back = ((control & 31U) << 8U | next()) + 1;
    if (back > text_.size() || length > size_ - text_.size()) fail();
    for (std::size_t i = 0; i < length; ++i) text_.push_back(text_[text_.size() - back]);
  }

  std::string_view bytes_;
  std::size_t size_;
  std::size_t at_ = 0;
  std::string text_;
};

}  // namespace

std::string decompressed_lzf(std::string_view bytes, std::size_t size) {
  return LzfReader(bytes, size).run();
}

}  // namespace prehend
