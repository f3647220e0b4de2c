// A list that can be filled again and again without allocating.
#pragma once

#include <cstddef>
#include <vector>

namespace prehend {

// Unlike a vector it keeps its elements when it is cleared, with the memory that they own: for
// elements that hold vectors themselves.
template <typename T>
class ReusedList {
 public:
  // The next element, as it was left when the list was cleared, or a new one: the caller gives it
  // its value. Invalidates references to elements.
  T& add() {
    if (size_ == elements_.size()) elements_.emplace_back();
    return elements_[size_++];
  }
  void clear() { size_ = 0; }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T& operator[](std::size_t i) { return elements_[i]; }
  T* begin() { return elements_.data(); }
  T* end() { return elements_.data() + size_; }
  const T* begin() const { return elements_.data(); }
  const T* end() const { return elements_.data() + size_; }

 private:
  std::vector<T> elements_;
  std::size_t size_ = 0;
};

}  // namespace prehend
