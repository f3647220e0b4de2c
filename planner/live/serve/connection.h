// One client's connection, without the network: what it does with messages.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "planner/live/serve/endpoint.h"
#include "planner/live/serve/outbox.h"

namespace prehend {

// The kinds of connections say how bytes are written and closed. All calls are made one after the
// other: by the tasks that `post` runs, and once these have ended for good, by whoever ends it.
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  // What a connection needs of its surroundings.
  struct ConnectionContext {
    Endpoint& endpoint;
    std::size_t largest_waiting;  // see ServerOptions
    // Runs a task after those that run now. Any thread.
    std::function<void(std::function<void()>)> post;
    // The connection has ended.
    std::function<void(const std::shared_ptr<Connection>&)> forget;
  };

  explicit Connection(ConnectionContext ground) : ground_(std::move(ground)) {}
  virtual ~Connection() = default;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  void begin();

  // Closes the connection at once, and disconnects the client. Again: nothing.
  void end();

 protected:
  // The connection is open: what comes first.
  virtual void open() = 0;
  // Begins to write this message, which stays as it is until written() is called.
  virtual void write(std::string& message) = 0;
  // From now on nothing is read and written, and no more tasks are begun.
  virtual void close() = 0;

  // All is written that will be, and nothing more is read: ends, at once or soon.
  virtual void part() { end(); }

  // Makes it a client of the endpoint. False, and ended, where the endpoint throws.
  bool join();
  // Passes a message on. False, and ended, where the endpoint throws.
  bool deliver(std::string message);
  // Sends a message that does not come from the endpoint.
  void say(std::string message) { outbox_->put(std::move(message)); }
  // Reads no more: disconnects the client, sends what waits, then ends.
  void finish();
  // To be called when a write has ended, well or not.
  void written(bool well);

  // Whether nothing is to be read any more.
  bool is_finished() const { return is_over_ || is_finishing_; }
  bool is_over() const { return is_over_; }

 private:
  void write_next();
  void leave();

  ConnectionContext ground_;
  std::shared_ptr<Outbox> outbox_;  // the endpoint may keep it for longer than the connection
  std::optional<ClientId> client_;
  std::string writing_;
  bool is_writing_ = false;
  bool is_finishing_ = false;
  bool is_parting_ = false;
  bool is_over_ = false;
};

}  // namespace prehend
