// Whether what a session sends can be right, whatever was asked.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace prehend::live_soak {

using Json = nlohmann::json;

// What is wrong with the reply to the request of this id; empty: nothing. An error must name its
// parts and not be one of ours; a result must have a finite number wherever numbers belong.
std::string fault_of_reply(const Json& reply, int id);
// The same of an event.
std::string fault_of_event(const Json& event);

// A state without what undo and redo change besides what they lead back to.
Json without_history(Json state);

}  // namespace prehend::live_soak
