// What libFuzzer calls. One program for all kinds of files: the name under which it was started
// says which, so that the readers are linked once.
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>

#include "tests/fuzz/json_mutator.h"
#include "tests/fuzz/session_messages.h"
#include "tests/fuzz/untrusted_files.h"

// The names are libFuzzer's.
// NOLINTBEGIN(readability-identifier-naming)
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace prehend::fuzz {
namespace {

const FileKind* kind = nullptr;  // set before anything else is called

std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

// libFuzzer's own changes of a short text.
std::string changed(const std::string& text) {
  constexpr std::size_t kMoreAtMost = 16;
  std::string bytes = text;
  bytes.resize(text.size() + kMoreAtMost);
  bytes.resize(
      LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(bytes.data()), text.size(), bytes.size()));
  return bytes;
}

// 0 where the result does not fit.
std::size_t put(const std::optional<std::string>& text, std::uint8_t* data, std::size_t most) {
  if (!text || text->size() > most) return 0;
  std::memcpy(data, text->data(), text->size());
  return text->size();
}

std::optional<std::string> mutated(const std::string& text, std::uint32_t seed) {
  if (kind->grammar == Grammar::json) return mutated_json(text, "", seed, changed);
  if (kind->grammar == Grammar::glb) return mutated_glb(text, seed, changed);
  if (kind->grammar == Grammar::messages) return mutated_messages(text, "", seed, changed);
  return std::nullopt;
}

}  // namespace
}  // namespace prehend::fuzz

using prehend::fuzz::Grammar;

extern "C" int LLVMFuzzerInitialize(int* /*count*/, char*** words) {
  const std::filesystem::path program = (*words)[0];
  prehend::fuzz::kind = &prehend::fuzz::file_kind(program.filename().string());
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)prehend::fuzz::refusal(*prehend::fuzz::kind, prehend::fuzz::text_of(data, size));
  return 0;
}

// One change of eight is one of bytes, for the parser of JSON.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  if (seed % 8 != 0) {
    const auto text = prehend::fuzz::mutated(prehend::fuzz::text_of(data, size), seed);
    if (const std::size_t length = prehend::fuzz::put(text, data, most)) return length;
  }
  return LLVMFuzzerMutate(data, size, most);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* data, std::size_t size,
                                                 const std::uint8_t* other, std::size_t other_size,
                                                 std::uint8_t* out, std::size_t most,
                                                 unsigned seed) {
  const std::string one = prehend::fuzz::text_of(data, size);
  const std::string two = prehend::fuzz::text_of(other, other_size);
  const Grammar grammar = prehend::fuzz::kind->grammar;
  std::optional<std::string> text;
  if (grammar == Grammar::json) {
    text = prehend::fuzz::mutated_json(one, two, seed, prehend::fuzz::changed);
  } else if (grammar == Grammar::messages) {
    text = prehend::fuzz::mutated_messages(one, two, seed, prehend::fuzz::changed);
  }
  return prehend::fuzz::put(text, out, most);
}
// NOLINTEND(readability-identifier-naming)
