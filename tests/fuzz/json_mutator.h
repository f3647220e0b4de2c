// Changes JSON files so that they stay JSON: a fuzzer that changes bytes breaks the syntax nearly
// every time and never gets past the parser.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace prehend::fuzz {

// Changes a text, as libFuzzer's own mutator does with the words that it has learnt.
using ChangeText = std::function<std::string(const std::string&)>;

// The text with one to four random changes: a value replaced by an extreme or another type, a
// number nudged, an entry removed, repeated or renamed, two entries exchanged, a part of the file
// or of `other` (may be empty) put elsewhere, a string changed by `change`. Nothing where the text
// is not JSON or nested too deep. The same seed gives the same text.
std::optional<std::string> mutated_json(const std::string& text, const std::string& other,
                                        std::uint32_t seed, const ChangeText& change);

// The same for the JSON in a binary glTF (GLB); its other chunks stay as they are.
std::optional<std::string> mutated_glb(const std::string& bytes, std::uint32_t seed,
                                       const ChangeText& change);

}  // namespace prehend::fuzz
