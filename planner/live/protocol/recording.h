// Recorded sessions: one JSON text a line. A line is a request as a client sent it, or tells that a
// plan, or the search for a path, ended there:
//   {"recorded": "plan.finished"}                      with all that it was to do
//   {"recorded": "plan.finished", "results": "..."}    cut short: what it had found (grasps.json)
//   {"recorded": "path.finished"}                      with all that it was to do
//   {"recorded": "path.finished", "cancelled": true}   cut short, without a path
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "planner/live/protocol/request.h"

namespace prehend {

// Takes one line without its end. Throws InputError where it cannot be kept; the recording has
// ended then.
using RecordLine = std::function<void(const std::string&)>;

// The lines of a recording.
std::string recorded_request(const Request& request);
std::string recorded_end_of_plan(const std::string& results);
std::string recorded_end_of_path(PathEnd end);

// What a replayed session comes to.
struct Replayed {
  std::vector<std::string> replies;  // one for each request
  int refused = 0;                   // replies that are errors
  std::string scene;                 // the scene file; empty where the session ends without object
  std::string state;                 // JSON text, as the command `state` replies it
};

// Is shown the session as it begins, and after each line that has changed it (Session::revision).
using WatchSession = std::function<void(const Session&)>;

// Bytes that the replies of a replayed session may have together, since all are kept.
inline constexpr std::size_t kMostReplies = std::size_t{256} << 20U;

// Carries out the lines of `recording` (empty ones are skipped) in a new session. The same
// recording gives the same, byte for byte, on any number of threads, and the same as the session
// that was recorded. `file` is what errors call it. Throws InputError for a line that no recording
// has, or whose reply is one too many (kMostReplies), and Cancelled between two lines or while a
// plan or a path is waited for.
Replayed replay(const std::string& recording, const std::string& file, SessionOptions options,
                const RunContext& context = {}, const WatchSession& watch = {});

// The result as a file, which ends with a line break: "scene" as text, "state" and "replies".
std::string replay_text(const Replayed& replayed);

}  // namespace prehend
