// A program behind a server that keeps what happens to its clients, and answers with what they say.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "planner/live/serve/endpoint.h"

namespace prehend::test {

// Answers each message with the same text at once, on the thread that brings it.
class EchoEndpoint : public Endpoint {
 public:
  struct Client {
    std::function<void(std::string)> send;
    std::vector<std::string> received;
    int disconnected = 0;
  };

  ClientId connect(std::function<void(std::string)> send) override {
    const std::lock_guard lock(lock_);
    const ClientId id = next_++;
    clients_[id].send = std::move(send);
    changed_.notify_all();
    return id;
  }

  void receive(ClientId id, std::string message) override {
    std::function<void(std::string)> send;
    {
      const std::lock_guard lock(lock_);
      send = clients_.at(id).send;
      clients_.at(id).received.push_back(message);
      changed_.notify_all();
    }
    send(std::move(message));
  }

  void disconnect(ClientId id) override {
    const std::lock_guard lock(lock_);
    ++clients_.at(id).disconnected;
    changed_.notify_all();
  }

  // Waits until `holds` of the clients, by their ids, which begin with 1.
  void wait_until(const std::function<bool(const std::map<ClientId, Client>&)>& holds) {
    std::unique_lock lock(lock_);
    changed_.wait(lock, [&] { return holds(clients_); });
  }

  // Waits until so many clients were disconnected.
  void wait_for_disconnected(int count) {
    wait_until([&](const std::map<ClientId, Client>& clients) {
      int gone = 0;
      for (const auto& [id, client] : clients) gone += client.disconnected;
      return gone >= count;
    });
  }

  std::map<ClientId, Client> clients() const {
    const std::lock_guard lock(lock_);
    return clients_;
  }

 private:
  mutable std::mutex lock_;
  std::condition_variable changed_;
  std::map<ClientId, Client> clients_;
  ClientId next_ = 1;
};

}  // namespace prehend::test
