#include "planner/live/serve/connection.h"

#include <utility>

namespace prehend {

void Connection::begin() {
  if (is_over_) return;
  // The task may come when the connection is gone.
  const std::weak_ptr<Connection> weak = weak_from_this();
  outbox_ = std::make_shared<Outbox>(ground_.largest_waiting, [weak, post = ground_.post] {
    post([weak] {
      if (const std::shared_ptr<Connection> self = weak.lock()) self->write_next();
    });
  });
  open();
}

void Connection::end() {
  if (std::exchange(is_over_, true)) return;
  const std::shared_ptr<Connection> self = shared_from_this();
  close();
  leave();
  // Only now: the endpoint may send until it has been told.
  if (outbox_) outbox_->close();
  ground_.forget(self);
}

bool Connection::join() {
  try {
    client_ = ground_.endpoint.connect(
        [outbox = outbox_](std::string message) { outbox->put(std::move(message)); });
  } catch (...) {
    end();
  }
  return !is_over_;
}

bool Connection::deliver(std::string message) {
  try {
    ground_.endpoint.receive(*client_, std::move(message));
  } catch (...) {
    // One client's trouble is not that of the others.
    end();
  }
  return !is_over_;
}

void Connection::finish() {
  if (is_finished()) return;
  is_finishing_ = true;
  leave();
  write_next();
}

void Connection::leave() {
  if (!client_) return;
  const ClientId client = *std::exchange(client_, std::nullopt);
  try {
    ground_.endpoint.disconnect(client);
  } catch (...) {
    // Whatever is wrong there, this client is gone.
  }
}

void Connection::write_next() {
  if (is_over_ || (is_writing_ && !outbox_->overflowed())) return;
  if (!outbox_->overflowed() && outbox_->take(writing_)) {
    is_writing_ = true;
    write(writing_);
  } else if (outbox_->overflowed()) {
    end();
  } else if (is_finishing_ && !std::exchange(is_parting_, true)) {
    part();
  }
}

void Connection::written(bool well) {
  is_writing_ = false;
  if (well) {
    write_next();
  } else {
    end();
  }
}

}  // namespace prehend
