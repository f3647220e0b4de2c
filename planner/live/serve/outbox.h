// Messages on their way to one client.
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <utility>

namespace prehend {

// Takes messages from any thread, and gives them to the one that writes them, in order. What waits
// is bounded: a client that does not read what is sent to it overflows, and gets nothing any more.
class Outbox {
 public:
  // `wake` is called when there is something to take, or when the outbox has overflowed, though not
  // again before take() has found nothing. It must not call the outbox.
  Outbox(std::size_t largest, std::function<void()> wake)
      : largest_(largest), wake_(std::move(wake)) {}

  // Any thread; does not block. What does not fit overflows; after that, or after close(), it is
  // dropped.
  void put(std::string message);

  // The oldest message, and whether there was one. It counts as waiting until the next call.
  bool take(std::string& message);

  bool overflowed() const;
  // Bytes of memory that wait to be written.
  std::size_t waiting() const;

  // Drops all. wake() is not called any more once this has returned.
  void close();

 private:
  void drop_all();

  const std::size_t largest_;
  mutable std::mutex lock_;  // of what follows
  std::function<void()> wake_;
  std::deque<std::string> messages_;
  std::size_t waiting_ = 0;
  std::size_t taken_ = 0;
  bool awake_ = false;
  bool overflowed_ = false;
};

}  // namespace prehend
