// Messages to a live session as a file: lines that are sent one after the other. Those that begin
// with a space come from the second of two clients.
#pragma once

#include <cstdint>
#include <string>

#include "tests/fuzz/json_mutator.h"

namespace prehend::fuzz {

// The lines with one to four random changes: one removed, repeated, put elsewhere, sent by the
// other client, taken from `other` (may be empty), a random request put in, or a change of one as
// JSON or, by `change`, as text. The same seed gives the same lines.
std::string mutated_messages(const std::string& text, const std::string& other, std::uint32_t seed,
                             const ChangeText& change);

}  // namespace prehend::fuzz
