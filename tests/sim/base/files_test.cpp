// Reading and writing whole files, and what is refused as one.
#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <sys/stat.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/input_file.h"
#include "sim/base/output_file.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

namespace fs = std::filesystem;

// A fresh folder for the running test.
fs::path own_folder() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const fs::path folder = fs::path(testing::TempDir()) / (std::string("files_") + test->name());
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

std::string content(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

std::string reason_against_reading(const fs::path& file) {
  const InputError error = test::refusal_of([&] { (void)read_file(file); });
  EXPECT_EQ(error.file(), file.string());
  return error.problem();
}

TEST(ReadFile, IsTheWholeFile) {
  const fs::path file = own_folder() / "bytes";
  const std::string bytes("a\0b\r\n\xff", 6);
  std::ofstream(file, std::ios::binary) << bytes;
  EXPECT_EQ(read_file(file), bytes);
}

TEST(ReadFile, SaysWhyItCannot) {
  const fs::path folder = own_folder();
  std::ofstream(folder / "empty").flush();
  ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
  EXPECT_EQ(reason_against_reading(folder / "none"), "cannot be read: no such file");
  EXPECT_EQ(reason_against_reading(folder), "cannot be read: is a folder");
  EXPECT_EQ(reason_against_reading(folder / "fifo"), "cannot be read: is not a regular file");
  EXPECT_EQ(reason_against_reading("/dev/zero"), "cannot be read: is not a regular file");
  EXPECT_EQ(reason_against_reading("/proc/self/status"), "cannot be read: the file is empty");
  EXPECT_EQ(reason_against_reading(folder / "empty"), "cannot be read: the file is empty");
  EXPECT_EQ(reason_against_reading(folder / std::string(300, 'n')),
            "cannot be read: File name too long");
}

TEST(WriteFile, KeepsPermissionsAndLinks) {
  const fs::path folder = own_folder();
  write_file(folder / "file", "old");
  fs::permissions(folder / "file", fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink(folder / "file", folder / "link");
  write_file(folder / "link", "new");
  EXPECT_EQ(content(folder / "file"), "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(fs::status(folder / "file").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST(WriteFile, ReplacesRegularFilesOnly) {
  const fs::path folder = own_folder();
  ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
  fs::create_directory(folder / "folder");
  for (const char* name : {"fifo", "folder"}) {
    const InputError error = test::refusal_of([&] { write_file(folder / name, "text"); });
    EXPECT_EQ(error.problem(), "cannot be written: is not a regular file");
  }
  EXPECT_TRUE(fs::is_fifo(folder / "fifo"));
}

// Parts are named after the process that writes them and its machine. The process of the test
// itself is alive, and ids above the system's largest belong to nobody.
TEST(WriteFile, RemovesWhatKilledProgramsLeft) {
  const fs::path folder = own_folder();
  std::array<char, 256> host{};
  ASSERT_EQ(::gethostname(host.data(), host.size() - 1), 0);
  const std::string here = std::string("@") + host.data();
  const std::string gone = "grasps.json.part999999999" + here;
  const std::vector<std::string> others = {"grasps.json.part" + std::to_string(::getppid()) + here,
                                           "grasps.json.parts", "grasps.json.part999999999@another",
                                           "grasps.json.part" + here, "other.part9" + here};
  std::ofstream(folder / gone) << "part";
  for (const std::string& name : others) std::ofstream(folder / name) << "part";
  write_file(folder / "grasps.json", "{}");
  EXPECT_FALSE(fs::exists(folder / gone));
  for (const std::string& name : others) EXPECT_TRUE(fs::exists(folder / name)) << name;
}

// The size of files that this process may write, for as long as this lives.
class LargestFile {
 public:
  explicit LargestFile(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
  }
  LargestFile(const LargestFile&) = delete;
  LargestFile& operator=(const LargestFile&) = delete;
  ~LargestFile() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int) = SIG_DFL;
};

std::ptrdiff_t files_in(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

// A failure of the machine is no mistake of the caller, and leaves what was there.
TEST(WriteFile, FailsWithTheErrorOfTheSystem) {
  const fs::path folder = own_folder();
  write_file(folder / "file", "old");
  std::string said;
  std::error_code code;
  {
    const LargestFile limit(1000);
    try {
      write_file(folder / "file", std::string(2000, 'x'));
    } catch (const std::system_error& error) {
      said = error.what();
      code = error.code();
    }
  }
  EXPECT_EQ(code, std::errc::file_too_large);
  EXPECT_EQ(said, (folder / "file").string() + ": cannot be written: File too large");
  EXPECT_EQ(content(folder / "file"), "old");
  EXPECT_EQ(files_in(folder), 1);
}

TEST(WriteFile, ThrowsWhereItFailsAndNotAtTheEnd) {
  const fs::path folder = own_folder();
  const LargestFile limit(1000);
  int lines = 0;
  const auto endless = [&](std::ostream& stream) {
    for (; lines < 1'000'000; ++lines) stream << "a line of the file\n";
  };
  EXPECT_THROW(write_file(folder / "file", endless), std::system_error);
  EXPECT_LT(lines, 100'000);
  EXPECT_EQ(files_in(folder), 0);
}

TEST(WriteFile, RefusesNames) {
  const fs::path folder = own_folder();
  for (const fs::path& bad : {folder / "none" / "file", folder / std::string(300, 'n')}) {
    const InputError error = test::refusal_of([&] { write_file(bad, "text"); });
    EXPECT_EQ(error.file(), bad.string());
    EXPECT_TRUE(error.problem().starts_with("cannot be written: ")) << error.problem();
  }
}

TEST(WriteFile, IsWrittenByManyThreadsAtOnce) {
  const fs::path folder = own_folder();
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&, thread] {
      const std::string text(100'000, static_cast<char>('a' + thread));
      for (int i = 0; i < 10; ++i) EXPECT_NO_THROW(write_file(folder / "file", text));
    });
  }
  for (std::thread& thread : threads) thread.join();
  const std::string text = content(folder / "file");
  EXPECT_EQ(text, std::string(100'000, text.at(0)));
  EXPECT_EQ(files_in(folder), 1);
}

TEST(WriteFolder, ReplacesAFolderAsAWhole) {
  const fs::path folder = own_folder();
  const auto with = [](const std::string& name) {
    return [name](const fs::path& made) { write_file(made / name, name); };
  };
  write_folder(folder / "set", with("one"));
  EXPECT_EQ(content(folder / "set" / "one"), "one");
  write_folder(folder / "set", with("two"));
  EXPECT_FALSE(fs::exists(folder / "set" / "one"));
  EXPECT_EQ(content(folder / "set" / "two"), "two");
  const auto half = [](const fs::path& made) {
    write_file(made / "three", "three");
    throw std::runtime_error("no more");
  };
  EXPECT_THROW(write_folder(folder / "set", half), std::runtime_error);
  EXPECT_EQ(content(folder / "set" / "two"), "two");
  EXPECT_EQ(files_in(folder), 1);
  EXPECT_EQ(files_in(folder / "set"), 1);
}

TEST(WriteFolder, KeepsLinksAndRemovesWhatKilledProgramsLeft) {
  const fs::path folder = own_folder();
  std::array<char, 256> host{};
  ASSERT_EQ(::gethostname(host.data(), host.size() - 1), 0);
  const fs::path left = folder / ("set.part999999999.0@" + std::string(host.data()));
  fs::create_directories(left / "below");
  fs::create_directory(folder / "set");
  fs::create_directory_symlink(folder / "set", folder / "link");
  write_folder(folder / "link", [](const fs::path& made) { write_file(made / "one", "1"); });
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(content(folder / "set" / "one"), "1");
  EXPECT_FALSE(fs::exists(left));
}

TEST(WriteFolder, IsWrittenByManyThreadsAtOnce) {
  const fs::path folder = own_folder();
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&, thread] {
      const auto write = [&](const fs::path& made) {
        for (const char* name : {"one", "two", "three"}) {
          write_file(made / name, std::to_string(thread));
        }
      };
      for (int i = 0; i < 10; ++i) EXPECT_NO_THROW(write_folder(folder / "set", write));
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(files_in(folder), 1);
  EXPECT_EQ(files_in(folder / "set"), 3);
  EXPECT_EQ(content(folder / "set" / "one"), content(folder / "set" / "three"));
}

TEST(RequireWritable, LooksAtTheNearestFolderThatExists) {
  const fs::path folder = own_folder();
  std::ofstream(folder / "file") << "text";
  EXPECT_NO_THROW(require_writable(folder));
  EXPECT_NO_THROW(require_writable(folder / "new" / "newer"));
  EXPECT_FALSE(fs::exists(folder / "new"));
  for (const fs::path& bad : {folder / "file", folder / "file" / "below"}) {
    EXPECT_EQ(test::refusal_of([&] { require_writable(bad); }).file(), bad.string());
  }
}

TEST(RemoveRegularFiles, LeavesLinksFoldersAndWhatWasNotChosen) {
  const fs::path folder = own_folder();
  std::ofstream(folder / "old") << "x";
  std::ofstream(folder / "other") << "x";
  fs::create_directories(folder / "old_folder");
  fs::create_symlink(folder / "other", folder / "old_link");
  fs::create_symlink(folder / "none", folder / "old_broken");
  remove_regular_files(folder, [](const std::string& name) { return name.starts_with("old"); });
  EXPECT_FALSE(fs::exists(folder / "old"));
  EXPECT_EQ(content(folder / "other"), "x");
  EXPECT_TRUE(fs::is_directory(folder / "old_folder"));
  EXPECT_TRUE(fs::is_symlink(folder / "old_link"));
  EXPECT_TRUE(fs::is_symlink(folder / "old_broken"));
}

TEST(RemoveRegularFiles, OfNoFolderDoesNothing) {
  remove_regular_files(own_folder() / "none", [](const std::string&) { return true; });
}

// Neither half of a new file nor a temporary one is left where making the content fails.
TEST(WriteFile, LeavesTheOldFileWhereMakingTheContentFails) {
  const fs::path folder = own_folder();
  write_file(folder / "file", "old");
  const auto half = [](std::ostream& stream) {
    stream << "half of it";
    throw std::runtime_error("no more");
  };
  EXPECT_THROW(write_file(folder / "file", half), std::runtime_error);
  EXPECT_EQ(content(folder / "file"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
  write_file(folder / "file", [](std::ostream& stream) { stream << "made " << 2; });
  EXPECT_EQ(content(folder / "file"), "made 2");
}

// What is behind a NUL the system does not see.
TEST(Files, NamesWithControlCharactersNameNothing) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "plain_names";
  std::filesystem::create_directories(folder);
  const std::filesystem::path file = folder / "pear.obj";
  write_file(file, "pear");
  EXPECT_TRUE(is_there(file) && is_file(file));
  for (int c = 0; c < 256; ++c) {
    const char letter = static_cast<char>(c);
    if (letter == '/') continue;
    const bool is_plain = c >= 0x20 && c != 0x7F;
    const std::filesystem::path other = file.string() + letter + ".obj";
    EXPECT_EQ(is_plain_name(other), is_plain) << c;
    if (is_plain) continue;
    EXPECT_FALSE(is_there(other) || is_file(other)) << c;
    for (const InputError& error : {test::refusal_of([&] { (void)read_file(other); }),
                                    test::refusal_of([&] { write_file(other, "x"); }),
                                    test::refusal_of([&] { make_folder(other); })}) {
      EXPECT_EQ(error.file(), other.string());
      EXPECT_NE(error.problem().find("control character"), std::string::npos);
    }
  }
  EXPECT_EQ(read_file(file), "pear");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
}

}  // namespace
}  // namespace prehend
