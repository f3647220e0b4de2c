// A client of an endpoint that waits for what it is sent.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "planner/live/serve/endpoint.h"

namespace prehend::test {

using Reply = nlohmann::json;

class ListeningClient {
 public:
  explicit ListeningClient(Endpoint& endpoint) : endpoint_(endpoint) {
    id_ = endpoint.connect([this](const std::string& text) {
      const std::lock_guard hold(lock_);
      Reply message = Reply::parse(text);
      (message.contains("event") ? events_ : replies_).push_back(std::move(message));
      came_.notify_all();
    });
  }
  ~ListeningClient() { endpoint_.disconnect(id_); }
  ListeningClient(const ListeningClient&) = delete;
  ListeningClient& operator=(const ListeningClient&) = delete;

  ClientId id() const { return id_; }

  Reply next_reply() {
    std::unique_lock hold(lock_);
    came_.wait(hold, [this] { return !replies_.empty(); });
    Reply reply = std::move(replies_.front());
    replies_.pop_front();
    return reply;
  }

  // The next event of this name; others that came before it stay.
  Reply next_event(const std::string& name) {
    std::unique_lock hold(lock_);
    const auto find = [&] {
      return std::find_if(events_.begin(), events_.end(),
                          [&](const Reply& event) { return event["event"] == name; });
    };
    came_.wait(hold, [&] { return find() != events_.end(); });
    Reply event = *find();
    events_.erase(find());
    return event;
  }

  Reply reply_to_text(const std::string& message) {
    endpoint_.receive(id_, message);
    return next_reply();
  }
  Reply reply(const Reply& request) { return reply_to_text(request.dump()); }
  // The result of a request that must succeed.
  Reply result(const Reply& request) {
    const Reply answer = reply(request);
    EXPECT_EQ(answer["ok"], true) << request << " " << answer;
    return answer.value("result", Reply::object());
  }

  std::ptrdiff_t events_left(const std::string& name) {
    const std::lock_guard hold(lock_);
    return std::count_if(events_.begin(), events_.end(),
                         [&](const Reply& event) { return event["event"] == name; });
  }
  std::size_t replies_left() {
    const std::lock_guard hold(lock_);
    return replies_.size();
  }

 private:
  Endpoint& endpoint_;
  ClientId id_ = 0;
  std::mutex lock_;
  std::condition_variable came_;
  std::deque<Reply> replies_;
  std::deque<Reply> events_;
};

}  // namespace prehend::test
