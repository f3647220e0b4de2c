// What stands between a server and the program behind it.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace prehend {

// What a server needs of the program behind it. All calls may come from different threads.
using ClientId = std::uint64_t;
class Endpoint {
 public:
  virtual ~Endpoint() = default;
  // A client has come. `send` takes one message to it; it may be called from any thread, until
  // disconnect() of this client has returned, and does not block.
  virtual ClientId connect(std::function<void(std::string)> send) = 0;
  // One message of a client: one JSON text. Its reply goes through `send`, in the order of the
  // messages.
  virtual void receive(ClientId client, std::string message) = 0;
  virtual void disconnect(ClientId client) = 0;
};

}  // namespace prehend
