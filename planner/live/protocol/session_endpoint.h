// One session for all clients.
#pragma once

#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "planner/live/protocol/command.h"
#include "planner/live/protocol/recording.h"
#include "planner/live/serve/endpoint.h"
#include "planner/live/session.h"

namespace prehend {

// Requests that one client may have waiting, and their bytes. What comes on top of them is refused,
// in its turn; a client with more than kMostWaiting refusals ahead of it is not listened to any
// more.
inline constexpr std::size_t kMostWaiting = 1000;
inline constexpr std::size_t kMostWaitingBytes = std::size_t{64} << 20U;
// All clients together, those that have left before they were answered among them, may have so many
// times as much.
inline constexpr std::size_t kWaitingOfAll = 8;

// All clients work on the same session. Commands are carried out one after the other on a thread of
// their own, in the order in which they came; plan.cancel ends the plan already when it comes, as
// path.cancel does the search for a path.
// After a change every client gets the event `state`, the one that made it after its reply.
//
// A plan or the search for a path runs beside that: commands that change the scene, undo and redo
// are refused until it has ended, all others work. Events tell of it: `progress`, `grasps` as they
// are found, `plan` or `path` when the results are there.
//
// Where a recording ends early, the event `recording` tells all clients, and those that come later.
class SessionEndpoint : public Endpoint {
 public:
  // `record` gets every line of the session (recording.h), one after the other, until it throws
  // std::system_error; may be empty. The `send` of clients must not throw.
  explicit SessionEndpoint(SessionOptions options, RecordLine record = {});
  // Ends a running plan; what waits is not answered any more.
  ~SessionEndpoint() override;
  SessionEndpoint(const SessionEndpoint&) = delete;
  SessionEndpoint& operator=(const SessionEndpoint&) = delete;

  ClientId connect(std::function<void(std::string)> send) override;
  // Does nothing for a client that is not connected. Throws std::runtime_error for one that goes on
  // sending while kMostWaiting refusals wait to be told.
  void receive(ClientId client, std::string message) override;
  void disconnect(ClientId client) override;

 private:
  // What the thread of commands has to do: a message of a client, or none for a plan or a path that
  // ended.
  struct Task {
    std::optional<ClientId> client;
    std::string message;
    std::string refusal;  // why it is not carried out, and not kept; empty: it is
  };
  // A plan or the search for a path.
  struct Running {
    Cancellation cancellation;
    std::string_view cancelled_by;  // the command
  };
  // What is not answered yet.
  struct Waiting {
    std::size_t requests = 0;
    std::size_t bytes = 0;  // of requests
    std::size_t refusals = 0;

    // Why no message of this size is taken, where the limits are so many times those of a client.
    std::string refusal(std::size_t size, std::size_t times) const;
    void add(const Task& task);
    void remove(const Task& task);
  };
  struct Client {
    std::function<void(std::string)> send;
    Waiting waiting;
  };

  void work();
  void carry_out(const Task& task);
  std::optional<Running> running() const;
  void end_running();
  ProtocolJson end_plan();
  ProtocolJson end_path();
  void put(Task task);
  void cancel_for(const std::string& message);
  void record(const std::string& line);
  void answer(const Task& task, const std::string& text);
  void send_all(const std::string& text);
  void tell_state();
  PlanListener listener();

  RecordLine record_;
  std::mutex clients_lock_;  // held while something is sent, so that disconnect() waits for it
  std::map<ClientId, Client> clients_;
  ClientId last_client_ = 0;
  Waiting all_;                   // guarded by clients_lock_, as is what follows
  std::string end_of_recording_;  // the event that tells of it; empty: it goes on
  std::mutex tasks_lock_;
  std::condition_variable has_task_;
  std::deque<Task> tasks_;
  bool is_over_ = false;
  std::optional<Running> running_;  // guarded by tasks_lock_
  Session session_;                 // of the thread of commands
  std::thread worker_;              // last: it uses all others
};

}  // namespace prehend
