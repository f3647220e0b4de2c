#include "planner/live/protocol/session_endpoint.h"

#include <exception>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "planner/live/protocol/session_json.h"

namespace prehend {
namespace {

Request refused(const std::string& problem) {
  Request request;
  request.error = InputError(problem);
  return request;
}

}  // namespace

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
  if (!end_of_recording_.empty()) send(end_of_recording_);
  clients_[++last_client_].send = std::move(send);
  return last_client_;
}

void SessionEndpoint::disconnect(ClientId client) {
  const std::lock_guard hold(clients_lock_);
  clients_.erase(client);
}

std::string SessionEndpoint::Waiting::refusal(std::size_t size, std::size_t times) const {
  if (requests >= times * kMostWaiting) return "too many requests wait for their replies";
  // One message is let through whatever its size: read_request says what is too long.
  const bool fits = bytes <= times * kMostWaitingBytes && size <= times * kMostWaitingBytes - bytes;
  return fits || requests == 0 ? "" : "too many bytes waiting";
}

void SessionEndpoint::Waiting::add(const Task& task) {
  if (task.refusal.empty()) {
    ++requests;
    bytes += task.message.size();
  } else {
    ++refusals;
  }
}

void SessionEndpoint::Waiting::remove(const Task& task) {
  if (task.refusal.empty()) {
    --requests;
    bytes -= task.message.size();
  } else {
    --refusals;
  }
}

void SessionEndpoint::receive(ClientId client, std::string message) {
  Task task{client, std::move(message), {}};
  {
    const std::lock_guard hold(clients_lock_);
    const auto found = clients_.find(client);
    if (found == clients_.end()) return;
    Waiting& waiting = found->second.waiting;
    task.refusal = waiting.refusal(task.message.size(), 1);
    if (task.refusal.empty()) task.refusal = all_.refusal(task.message.size(), kWaitingOfAll);
    if (!task.refusal.empty()) task.message = {};
    waiting.add(task);
    all_.add(task);
    if (waiting.refusals > kMostWaiting || all_.refusals > kWaitingOfAll * kMostWaiting) {
      waiting.remove(task);
      all_.remove(task);
      throw std::runtime_error(task.refusal);
    }
  }
  if (task.refusal.empty()) cancel_for(task.message);
  put(std::move(task));
}

// The thread of commands may be busy for long; what is cancelled should not wait for that.
void SessionEndpoint::cancel_for(const std::string& message) {
  // The commands that cancel, with room for an id. Longer messages are parsed once only.
  constexpr std::size_t kLongest = 4096;
  std::optional<Running> running;
  {
    const std::lock_guard hold(tasks_lock_);
    running = running_;
  }
  if (!running || message.size() > kLongest) return;
  if (read_request(message).command == running->cancelled_by) running->cancellation.request();
}

void SessionEndpoint::put(Task task) {
  {
    const std::lock_guard hold(tasks_lock_);
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
  const Request request = task.refusal.empty() ? read_request(task.message) : refused(task.refusal);
  if (!request.error) record(recorded_request(request));
  const std::string reply = reply_to(request, scope);
  {
    const std::lock_guard hold(tasks_lock_);
    running_ = running();
  }
  answer(task, reply);
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
  record(recorded_end_of_plan(results));
  const PlanResult& kept = *session_.state().results;
  return {{"event", "plan"}, {"status", name_of(kept.status)}, {"size", kept.grasps.size()}};
}

ProtocolJson SessionEndpoint::end_path() {
  const PathEnd end = session_.finish_path();
  record(recorded_end_of_path(end));
  return {{"event", "path"}, {"status", name_of(end)}};
}

void SessionEndpoint::record(const std::string& line) {
  if (!record_) return;
  try {
    record_(line);
  } catch (const std::exception& error) {
    record_ = nullptr;
    const std::lock_guard hold(clients_lock_);
    end_of_recording_ = message_text(
        {{"event", "recording"}, {"status", "failed"}, {"problem", on_one_line(error.what())}});
    for (const auto& [id, client] : clients_) client.send(end_of_recording_);
  }
}

void SessionEndpoint::answer(const Task& task, const std::string& text) {
  const std::lock_guard hold(clients_lock_);
  all_.remove(task);
  const auto found = clients_.find(*task.client);
  if (found == clients_.end()) return;
  found->second.waiting.remove(task);
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
