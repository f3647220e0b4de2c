// When a series of ever larger sizes ends.
#pragma once

namespace prehend::bench {

// Allows a size while its time, grown from that of the size before as much as the size did, is
// within a limit. Costs that grow faster than sizes overrun it once, costs that grow more slowly
// end a little early.
class Patience {
 public:
  explicit Patience(double longest) : longest_(longest) {}  // s

  bool allows(double size) const {
    return !(last_size_ > 0.0) || last_seconds_ * size / last_size_ <= longest_;
  }
  void took(double size, double seconds) {
    last_size_ = size;
    last_seconds_ = seconds;
  }

 private:
  double longest_;
  double last_size_ = 0.0;
  double last_seconds_ = 0.0;
};

}  // namespace prehend::bench
