#include "planner/live/serve/outbox.h"

#include <utility>

namespace prehend {
namespace {

// With what the queue takes itself, so that empty messages are bounded as well.
std::size_t cost_of(const std::string& message) { return message.size() + sizeof(std::string); }

}  // namespace

void Outbox::put(std::string message) {
  const std::lock_guard lock(lock_);
  if (!wake_ || overflowed_) return;
  // Compared so that a sum cannot be too large for its type.
  if (cost_of(message) > largest_ - waiting_) {
    overflowed_ = true;
    drop_all();
    // Also while a message is being written: that may take as long as the client likes.
    wake_();
    return;
  }
  waiting_ += cost_of(message);
  messages_.push_back(std::move(message));
  if (!std::exchange(awake_, true)) wake_();
}

bool Outbox::take(std::string& message) {
  const std::lock_guard lock(lock_);
  waiting_ -= std::exchange(taken_, 0);
  if (messages_.empty()) {
    awake_ = false;
    return false;
  }
  message = std::move(messages_.front());
  messages_.pop_front();
  taken_ = cost_of(message);
  return true;
}

bool Outbox::overflowed() const {
  const std::lock_guard lock(lock_);
  return overflowed_;
}

std::size_t Outbox::waiting() const {
  const std::lock_guard lock(lock_);
  return waiting_;
}

void Outbox::close() {
  const std::lock_guard lock(lock_);
  wake_ = nullptr;
  drop_all();
}

void Outbox::drop_all() {
  messages_.clear();
  waiting_ = taken_;
}

}  // namespace prehend
