// Commands that few users need have programs of their own, which stand beside prehend and are
// started by it: `prehend studio` is a command of prehend-live. So they take no time to build until
// then.
#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): that of CLI11
class App;
}

namespace prehend {

struct OtherCommand {
  const char* name;
  const char* summary;
  const char* program;
};

inline constexpr OtherCommand kStudio{"studio", "take hold of a scene in the browser",
                                      "prehend-live"};
inline constexpr OtherCommand kServe{"serve", "take the commands of other programs",
                                     "prehend-live"};
inline constexpr OtherCommand kMcp{"mcp", "give an assistant the commands as tools, on stdio",
                                   "prehend-live"};
inline constexpr OtherCommand kReplay{"replay", "carry out a recorded session again",
                                      "prehend-live"};
inline constexpr OtherCommand kBatch{
    "batch", "plan many objects with many hands, on one machine or many", "prehend-bulk"};
inline constexpr OtherCommand kLearn{"learn", "learn from data sets what to try first",
                                     "prehend-bulk"};
inline constexpr OtherCommand kTruth{"truth", "compare scores with executed grasps",
                                     "prehend-bulk"};

inline constexpr OtherCommand kDesign{"design", "vary a measure of a hand and see what it grasps",
                                      "prehend-bulk"};

// Declares the commands of the other programs, for the help and for what is said of unknown
// commands.
void add_other_commands(CLI::App& app);

// Where argv[1] is a command of another program, becomes that program; returns where it is none.
// Throws InputError where the program is not there.
void start_other_program(int argc, char** argv);

}  // namespace prehend
