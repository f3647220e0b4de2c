#include "tests/fuzz/session_messages.h"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <iterator>
#include <mutex>
#include <optional>
#include <set>
#include <vector>

#include "benchmarks/live_soak/judge_session.h"
#include "benchmarks/live_soak/random_request.h"
#include "planner/live/protocol/session_endpoint.h"
#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "tests/fuzz/untrusted_files.h"

namespace prehend::fuzz {
namespace {

using live_soak::Json;

// Of the lines of a file so many are sent, and no longer ones: what takes long is not looked for.
constexpr std::size_t kMostLines = 8;
constexpr std::size_t kLongestLine = 4000;
// The hand that a session begins with: hands of many parts take longer to compile.
constexpr const char* kHand = "parallel_jaw";
// Numbers that say how much there is to do end here.
constexpr int kMostTriangles = 100;
constexpr int kMostTrials = 3;
constexpr double kMostSeconds = 0.02;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  std::erase(lines, "");
  return lines;
}

std::string joined_lines(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

void limit(Json& request, const char* field, double most) {
  if (request.contains(field) && request[field].is_number() && request[field] > most) {
    request[field] = most == static_cast<int>(most) ? Json(static_cast<int>(most)) : Json(most);
  }
}

// The request of a line, made to ask for little work; discarded where there is none.
Json small_request(const std::string& line) {
  Json request = Json::parse(line, nullptr, false);
  if (!request.is_object()) return request;
  limit(request, "triangles", kMostTriangles);
  limit(request, "trials", kMostTrials);
  limit(request, "seconds", kMostSeconds);
  const Json command = request.value("command", Json());
  if (command == "plan.start") {
    request["accuracy"] = "draft";
    request["paths"] = false;
  }
  const bool tries = command == "plan.start" || command == "grasp.refine";
  if (tries && !request.contains("trials")) request["trials"] = kMostTrials;
  if (request.contains("generate") && !request.contains("triangles")) {
    request["triangles"] = kMostTriangles;
  }
  return request;
}

// What one client is told.
class Inbox {
 public:
  void put(std::string message) {
    const std::lock_guard hold(lock_);
    messages_.push_back(std::move(message));
    has_come_.notify_one();
  }
  Json next() {
    std::unique_lock hold(lock_);
    has_come_.wait(hold, [this] { return !messages_.empty(); });
    const std::string text = std::move(messages_.front());
    messages_.pop_front();
    const Json message = Json::parse(text, nullptr, false);
    promised(!message.is_discarded(), "a message is JSON");
    return message;
  }

 private:
  std::mutex lock_;
  std::condition_variable has_come_;
  std::deque<std::string> messages_;
};

class Client {
 public:
  explicit Client(SessionEndpoint& endpoint)
      : endpoint_(endpoint),
        id_(endpoint.connect([this](std::string message) { inbox_.put(std::move(message)); })) {}
  ~Client() { endpoint_.disconnect(id_); }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  // The reply to a message, whatever that is.
  Json reply_to_text(std::string text) {
    endpoint_.receive(id_, std::move(text));
    while (true) {
      Json message = inbox_.next();
      if (!message.contains("event")) return message;
      const std::string fault = live_soak::fault_of_event(message);
      promised(fault.empty(), fault.c_str());
    }
  }
  Json reply_to(Json request) {
    request["id"] = ++last_;
    Json reply = reply_to_text(request.dump(-1, ' ', false, Json::error_handler_t::replace));
    const std::string fault = live_soak::fault_of_reply(reply, last_);
    promised(fault.empty(), fault.c_str());
    return reply;
  }
  live_soak::Ask ask() {
    return [this](const Json& request) { return reply_to(request); };
  }

 private:
  SessionEndpoint& endpoint_;
  Inbox inbox_;
  ClientId id_;
  int last_ = 0;
};

// Motions that end before bodies overlap.
const std::set<std::string>& motions() {
  static const std::set<std::string> names = {"hand.move",   "hand.dofs",     "hand.preshape",
                                              "hand.open",   "hand.back_off", "hand.approach",
                                              "object.move", "obstacle.move"};
  return names;
}

class Talk {
 public:
  void run(const std::string& bytes) {
    one_.reply_to({{"command", "scene.new"}, {"hand", kHand}});
    std::vector<std::string> lines = lines_of(bytes);
    lines.resize(std::min(lines.size(), kMostLines));
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (lines[i].size() <= kLongestLine) say(lines[i], i + 1 == lines.size());
      if (!refusal_.empty() && refused_line_ == 0) refused_line_ = i + 1;
    }
    rest();
    if (closes_) {
      const live_soak::JudgedGrasp judged = live_soak::judge_grasp(one_.ask());
      promised(judged.fault.empty(), (judged.fault + " " + judged.detail).c_str());
    }
  }
  // Of the first line that was refused; empty: all were carried out.
  std::string refusal() const {
    return refusal_.empty() ? "" : "line " + std::to_string(refused_line_) + ": " + refusal_;
  }

 private:
  // What came of the last line is looked at more closely.
  void say(const std::string& line, bool is_last) {
    const bool second = line.front() == ' ';
    Client& speaker = second ? other_ : one_;
    Client& listener = second ? one_ : other_;
    const Json request = small_request(line);
    const Json name = request.is_object() ? request.value("command", Json()) : Json();
    // It reads the files of all robots, which takes as long as all else.
    if (name == "hello") return;
    const bool moves = name.is_string() && motions().contains(name.get<std::string>());
    const bool stays_free = moves &&
                            live_soak::promises_no_overlap(
                                live_soak::result_of(speaker.ask(), {{"command", "state"}})) &&
                            live_soak::overlap_of(speaker.ask()).empty();
    const auto send = [&] { return reply_of(speaker, line, request); };
    bool is_done = false;
    if (is_last) {
      const live_soak::JudgedChange judged =
          live_soak::judge_change(listener.ask(), speaker.ask(), send);
      promised(judged.fault.empty(), (judged.fault + " after " + line).c_str());
      is_done = judged.end != live_soak::ChangeEnd::refused;
    } else {
      is_done = send().value("ok", false);
    }
    if (stays_free) {
      promised(live_soak::overlap_of(speaker.ask()).empty(), "a motion ends before bodies overlap");
    }
    closes_ = name == "hand.auto_grasp" && is_done;
    if (name == "plan.start" || name == "path.plan") rest();
  }

  Json reply_of(Client& speaker, const std::string& line, const Json& request) {
    Json reply;
    if (!request.is_object()) {
      reply = speaker.reply_to_text(line);
    } else if (request.contains("id")) {
      reply = speaker.reply_to_text(request.dump(-1, ' ', false, Json::error_handler_t::replace));
    } else {
      reply = speaker.reply_to(request);
    }
    if (reply.value("ok", false) || !refusal_.empty()) return reply;
    refusal_ = reply["error"].value("problem", "");
    return reply;
  }

  // Until nothing runs.
  void rest() {
    other_.reply_to({{"command", "plan.cancel"}});
    other_.reply_to({{"command", "path.cancel"}});
    for (Json state = live_soak::result_of(one_.ask(), {{"command", "state"}});
         state["planning"] == true || state["finding_path"] == true;
         state = live_soak::result_of(one_.ask(), {{"command", "state"}})) {
    }
  }

  SessionEndpoint endpoint_{SessionOptions{.threads = 1}};
  Client one_{endpoint_};
  Client other_{endpoint_};
  bool closes_ = false;  // the last line has closed the hand
  std::string refusal_;
  std::size_t refused_line_ = 0;
};

const live_soak::KnownNames& known_names() {
  static const live_soak::KnownNames names = [] {
    SessionEndpoint endpoint{SessionOptions{}};
    Client client(endpoint);
    live_soak::KnownNames known =
        live_soak::names_of(live_soak::result_of(client.ask(), {{"command", "hello"}}));
    // Those of the program take long to compile.
    known.scenes = {"none"};
    known.hands = {kHand, "franka_hand"};
    return known;
  }();
  return names;
}

class ChangeLines {
 public:
  ChangeLines(std::vector<std::string>& lines, const std::vector<std::string>& others,
              Random& random, const ChangeText& change)
      : lines_(lines), others_(others), random_(random), change_(change) {}

  void run() {
    if (lines_.empty() || random_.index(4) == 0) return insert(random_message());
    std::string& line = lines_[random_.index(lines_.size())];
    switch (random_.index(8)) {
      case 0:
        lines_.erase(lines_.begin() + (&line - lines_.data()));
        break;
      case 1:
        insert(std::string(line));
        break;
      case 2:
        std::swap(line, lines_[random_.index(lines_.size())]);
        break;
      case 3:
        line = line.front() == ' ' ? line.substr(1) : " " + line;
        break;
      case 4:
        if (!others_.empty()) insert(others_[random_.index(others_.size())]);
        break;
      case 5:
        line = change_(line);
        break;
      default:
        change_json(line);
    }
  }

 private:
  void insert(std::string line) {
    const auto at = static_cast<std::ptrdiff_t>(random_.index(lines_.size() + 1));
    lines_.insert(lines_.begin() + at, std::move(line));
  }
  std::string random_message() {
    const Json request = live_soak::random_request(random_, known_names());
    const std::string client = random_.index(4) == 0 ? " " : "";
    return client + request.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  void change_json(std::string& line) {
    const std::string other = others_.empty() ? "" : others_[random_.index(others_.size())];
    const auto seed = static_cast<std::uint32_t>(random_.index(1U << 30U));
    const auto changed = mutated_json(line, other, seed, change_);
    if (changed) line = (line.front() == ' ' ? " " : "") + *changed;
  }

  std::vector<std::string>& lines_;
  const std::vector<std::string>& others_;
  Random& random_;
  const ChangeText& change_;
};

}  // namespace

std::string mutated_messages(const std::string& text, const std::string& other, std::uint32_t seed,
                             const ChangeText& change) {
  Random random(seed);
  std::vector<std::string> lines = lines_of(text);
  const std::vector<std::string> others = lines_of(other.empty() ? text : other);
  for (std::size_t left = 1 + random.index(4); left > 0; --left) {
    ChangeLines(lines, others, random, change).run();
    std::erase(lines, "");
  }
  if (lines.size() > kMostLines) lines.resize(kMostLines);
  return joined_lines(lines);
}

// Refused is what has a message that was refused.
void read_session_messages(std::string_view name, const std::string& bytes) {
  Talk talk;
  talk.run(bytes);
  if (const std::string refusal = talk.refusal(); !refusal.empty()) {
    throw InputError({.file = std::string(name), .problem = on_one_line(refusal)});
  }
}

}  // namespace prehend::fuzz
