#include "planner/live/protocol/session_endpoint.h"

#include <exception>
#include <utility>

#include "planner/live/protocol/session_json.h"

namespace prehend {

SessionEndpoint::SessionEndpoint(SessionOptions options, RecordLine record)
    : record_(std::move(record)), session_(std::move(options)), worker_([this] { work(); }) {}

SessionEndpoint::~SessionEndpoint() {
  {
    const std::lock_guard hold(tasks_lock_);
    is_over_ = true;
    if (running_) running_->cancellation.request();
  }
  has_task_.notify_one();
  worker_.join();
}

ClientId SessionEndpoint::connect(std::function<void(std::string)> send) {
  const std::lock_guard hold(clients_lock_);
  clients_[++last_client_].send = std::move(send);
  return last_client_;
}

void SessionEndpoint::disconnect(ClientId client) {
  const std::lock_guard hold(clients_lock_);
  clients_.erase(client);
}

void SessionEndpoint::receive(ClientId client, std::string message) {
  Task task{client, {}};
  {
    const std::lock_guard hold(clients_lock_);
    const auto found = clients_.find(client);
    if (found == clients_.end()) return;
    if (found->second.waiting >= kMostWaiting) {
      message.clear();
      task.request.error = InputError("too many requests wait for their replies");
    }
    ++found->second.waiting;
  }
  if (!task.request.error) task.request = read_request(message);
  put(std::move(task));
}

void SessionEndpoint::put(Task task) {
  {
    const std::lock_guard hold(tasks_lock_);
    // The thread of commands may be busy for long; what is cancelled should not wait for that.
    if (running_ && task.request.command == running_->cancelled_by) {
      running_->cancellation.request();
    }
    tasks_.push_back(std::move(task));
  }
  has_task_.notify_one();
}

void SessionEndpoint::work() {
  while (true) {
    Task task;
    {
      std::unique_lock hold(tasks_lock_);
      has_task_.wait(hold, [this] { return is_over_ || !tasks_.empty(); });
      if (is_over_) return;
      task = std::move(tasks_.front());
      tasks_.pop_front();
    }
    if (task.client) {
      carry_out(task);
    } else {
      end_running();
    }
  }
}

void SessionEndpoint::carry_out(const Task& task) {
  const std::uint64_t revision = session_.revision();
  const bool was_running = running().has_value();
  const CommandScope scope{session_, [this] { return listener(); }, true};
  if (record_ && !task.request.error) record_(recorded_request(task.request));
  const std::string reply = reply_to(task.request, scope);
  {
    const std::lock_guard hold(tasks_lock_);
    running_ = running();
  }
  send_to(*task.client, reply);
  if (session_.revision() != revision || running().has_value() != was_running) tell_state();
}

std::optional<SessionEndpoint::Running> SessionEndpoint::running() const {
  if (const auto plan = session_.plan_cancellation()) return Running{*plan, "plan.cancel"};
  if (const auto path = session_.path_cancellation()) return Running{*path, "path.cancel"};
  return std::nullopt;
}

void SessionEndpoint::end_running() {
  const bool is_path = session_.is_finding_path();
  ProtocolJson event;
  try {
    event = is_path ? end_path() : end_plan();
  } catch (const std::exception& error) {
    event = {{"event", is_path ? "path" : "plan"}, {"status", "failed"}};
    if (!is_path) event["size"] = 0;
    event["problem"] = on_one_line(error.what());
  }
  {
    const std::lock_guard hold(tasks_lock_);
    running_.reset();
  }
  send_all(message_text(event));
  tell_state();
}

ProtocolJson SessionEndpoint::end_plan() {
  const std::string results = session_.finish_plan();
  if (record_) record_(recorded_end_of_plan(results));
  const PlanResult& kept = *session_.state().results;
  return {{"event", "plan"}, {"status", name_of(kept.status)}, {"size", kept.grasps.size()}};
}

ProtocolJson SessionEndpoint::end_path() {
  const PathEnd end = session_.finish_path();
  if (record_) record_(recorded_end_of_path(end));
  return {{"event", "path"}, {"status", name_of(end)}};
}

void SessionEndpoint::send_to(ClientId client, const std::string& text) {
  const std::lock_guard hold(clients_lock_);
  const auto found = clients_.find(client);
  if (found == clients_.end()) return;
  --found->second.waiting;
  found->second.send(text);
}

void SessionEndpoint::send_all(const std::string& text) {
  const std::lock_guard hold(clients_lock_);
  for (const auto& [id, client] : clients_) client.send(text);
}

void SessionEndpoint::tell_state() {
  send_all(message_text({{"event", "state"}, {"state", state_json(session_)}}));
}

PlanListener SessionEndpoint::listener() {
  PlanListener listener;
  listener.progress = [this](const Progress& progress) {
    send_all(message_text({{"event", "progress"},
                           {"stage", name_of(progress.stage)},
                           {"done", progress.done},
                           {"total", progress.total},
                           {"stable", progress.stable}}));
  };
  listener.found = [this](const Candidate& /*candidate*/, const Trial& trial) {
    send_all(
        message_text({{"event", "grasps"}, {"grasps", ProtocolJson::array({found_json(trial)})}}));
  };
  listener.ended = [this] { put({}); };
  return listener;
}

}  // namespace prehend
