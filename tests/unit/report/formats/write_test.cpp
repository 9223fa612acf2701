#include "report/formats/write.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace report::write_test {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// A folder of its own for every test.
class Write : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = testing::TempDir() + "luxgate_write_XXXXXX";
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator{}));
  }

  fs::path folder_;
};

TEST_F(Write, NewFileAndReplacement) {
  const fs::path path = folder_ / "a.txt";
  EXPECT_EQ(write_file_atomically(path, "one"), "");
  EXPECT_EQ(content(path), "one");
  EXPECT_EQ(write_file_atomically(path, std::string("t\0wo", 4)), "");
  EXPECT_EQ(content(path), std::string("t\0wo", 4));
  EXPECT_EQ(files(), 1U);
}

TEST_F(Write, MissingFoldersAreMade) {
  EXPECT_EQ(write_file_atomically(folder_ / "b" / "c" / "a.txt", "x"), "");
  EXPECT_EQ(content(folder_ / "b" / "c" / "a.txt"), "x");
}

TEST_F(Write, RespectsTheUmask) {
  const mode_t before = umask(0027);
  EXPECT_EQ(write_file_atomically(folder_ / "a.txt", "x"), "");
  umask(before);
  EXPECT_EQ(fs::status(folder_ / "a.txt").permissions(), fs::perms(0640));
}

// The disk "fills up" in the middle of the new text.
TEST_F(Write, FailureLeavesTheOldFileAndNothingElse) {
  const fs::path path = folder_ / "a.txt";
  ASSERT_EQ(write_file_atomically(path, "old"), "");
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 1000;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string error = write_file_atomically(path, std::string(5000, 'x'));
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_EQ(error, "File too large");
  EXPECT_EQ(content(path), "old");
  EXPECT_EQ(files(), 1U);
}

TEST_F(Write, PieceByPiece) {
  const fs::path path = folder_ / "a.txt";
  std::string expected;
  EXPECT_EQ(write_file_atomically(path,
                                  [&](Sink& sink) {
                                    for (int size = 0; size < 200000; size += 9999) {
                                      const std::string piece(static_cast<std::size_t>(size), 'x');
                                      sink.write(piece + "\n");
                                      expected += piece + "\n";
                                    }
                                    EXPECT_FALSE(fs::exists(path));
                                  }),
            "");
  EXPECT_EQ(content(path), expected);
  EXPECT_EQ(files(), 1U);
}

TEST_F(Write, WhatIsThrownBetweenPiecesLeavesTheOldFile) {
  const fs::path path = folder_ / "a.txt";
  ASSERT_EQ(write_file_atomically(path, "old"), "");
  const auto throws = [](const auto& thrown) {
    return [thrown](Sink& sink) {
      sink.write(std::string(100000, 'x'));
      throw thrown;
    };
  };
  EXPECT_EQ(write_file_atomically(path, throws(WriteFailure("no room"))), "no room");
  EXPECT_THROW(write_file_atomically(path, throws(std::logic_error("other"))), std::logic_error);
  EXPECT_EQ(content(path), "old");
  EXPECT_EQ(files(), 1U);
}

TEST_F(Write, ReadOnlyFolderIsAnError) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  const fs::path path = folder_ / "a.txt";
  ASSERT_EQ(write_file_atomically(path, "old"), "");
  fs::permissions(folder_, fs::perms(0555));
  EXPECT_EQ(write_file_atomically(path, "new"), "Permission denied");
  fs::permissions(folder_, fs::perms(0755));
  EXPECT_EQ(content(path), "old");
}

TEST_F(Write, FolderOrFileInTheWayIsAnError) {
  EXPECT_EQ(write_file_atomically(folder_, "x"), "this is a folder");
  EXPECT_EQ(write_file_atomically("", "x"), "the file name is empty");
  ASSERT_EQ(write_file_atomically(folder_ / "a", "x"), "");
  EXPECT_EQ(write_file_atomically(folder_ / "a" / "b", "y"), "Not a directory");
  EXPECT_EQ(content(folder_ / "a"), "x");
}

TEST_F(Write, LinkIsFollowed) {
  ASSERT_EQ(write_file_atomically(folder_ / "target", "old"), "");
  fs::create_symlink("target", folder_ / "link");
  EXPECT_EQ(write_file_atomically(folder_ / "link", "new"), "");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(content(folder_ / "target"), "new");
}

TEST_F(Write, DevicesAreWrittenDirectly) {
  EXPECT_EQ(write_file_atomically("/dev/null", "x"), "");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_EQ(write_file_atomically("/dev/full", "x"), "No space left on device");
}

// What belongs together takes its place together, and not before all of it is there.
TEST_F(Write, SetsAppearTogether) {
  ASSERT_EQ(write_file_atomically(folder_ / "a", "old"), "");
  const auto text = [](std::string_view bytes) {
    return [bytes](Sink& sink) { sink.write(bytes); };
  };
  {
    FileSet set;
    EXPECT_EQ(set.add(folder_ / "a", text("new")), "");
    EXPECT_EQ(set.add(folder_ / "b", text("new")), "");
    EXPECT_NE(set.add(folder_ / "c", [](Sink&) { throw WriteFailure("no"); }), "");
    EXPECT_EQ(content(folder_ / "a"), "old");
    EXPECT_FALSE(fs::exists(folder_ / "b"));
    EXPECT_EQ(files(), 3U);  // two wait beside it
    std::vector<std::string> published;
    EXPECT_TRUE(set.publish(published).empty());
    EXPECT_EQ(published, (std::vector<std::string>{folder_ / "a", folder_ / "b"}));
    EXPECT_EQ(content(folder_ / "a"), "new");
    EXPECT_EQ(content(folder_ / "b"), "new");
    EXPECT_EQ(files(), 2U);
  }
  {
    FileSet set;
    EXPECT_EQ(set.add(folder_ / "a", text("never")), "");
  }
  EXPECT_EQ(content(folder_ / "a"), "new");
  EXPECT_EQ(files(), 2U);
}

TEST_F(Write, WritersAtOnceLeaveOneWholeFile) {
  const fs::path path = folder_ / "a.txt";
  std::vector<std::thread> writers;
  for (char c = 'a'; c < 'i'; ++c) {
    writers.emplace_back([&path, c] {
      for (int i = 0; i < 20; ++i) EXPECT_EQ(write_file_atomically(path, std::string(5000, c)), "");
    });
  }
  for (std::thread& writer : writers) writer.join();
  const std::string text = content(path);
  ASSERT_EQ(text.size(), 5000U);
  EXPECT_EQ(text, std::string(5000, text[0]));
  EXPECT_EQ(files(), 1U);
}

}  // namespace
}  // namespace report::write_test
