#include "report/stream/spill.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

namespace report::spill_test {
namespace {

namespace fs = std::filesystem;

// A folder of its own for every test.
class Spills : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = testing::TempDir() + "luxgate_spill_XXXXXX";
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }

  // Three lines do not fit into the memory.
  SpillPlace place() const { return {folder_, 16}; }

  std::string folder_;
};

std::string copied(const Spill& spill) {
  TextSink sink;
  spill.copy_to(sink);
  return sink.text;
}

TEST_F(Spills, KeepWhatWasWrittenWhereverItLies) {
  for (const SpillPlace& where : {place(), SpillPlace{folder_, 0}, SpillPlace::memory()}) {
    Spill spill(where);
    EXPECT_TRUE(spill.is_empty());
    std::string expected;
    for (int line = 0; line < 100; ++line) {
      const std::string text = "line " + std::to_string(line) + "\n";
      spill.write(text);
      expected += text;
      EXPECT_EQ(copied(spill), expected);  // also while more is to come
    }
    EXPECT_EQ(spill.size(), expected.size());
    for (std::size_t begin = 0; begin < expected.size(); begin += 7) {
      for (const std::size_t count : {std::size_t{0}, std::size_t{1}, expected.size() - begin}) {
        EXPECT_EQ(spill.read(begin, count), expected.substr(begin, count));
      }
    }
    spill.clear();
    EXPECT_TRUE(spill.is_empty());
    spill.write("again, and more than fits into the memory");
    EXPECT_EQ(copied(spill), "again, and more than fits into the memory");
  }
}

TEST_F(Spills, TakeFilesThatWereOpenedBeforehand) {
  SpillPlace where = place();
  where.folder = folder_ + "/nowhere";
  where.files = std::make_shared<SpillFiles>(folder_, 1);
  const std::string text(100, 'x');
  for (int round = 0; round < 3; ++round) {  // the one file goes from hand to hand
    Spill spill(where);
    spill.write(text);
    spill.write("end");
    EXPECT_EQ(copied(spill), text + "end");
    EXPECT_EQ(where.files->take(), -1);
    Spill other(where);  // in memory
    other.write(text);
    other.write("other end");
    EXPECT_EQ(copied(other), text + "other end");
  }
  const int file = where.files->take();
  ASSERT_GE(file, 0);
  EXPECT_EQ(lseek(file, 0, SEEK_END), 0);
  where.files->give_back(file);
}

TEST_F(Spills, AreInMemoryWhereNoFileCouldBeOpened) {
  SpillPlace where = place();
  where.files = std::make_shared<SpillFiles>(folder_ + "/nowhere", 3);
  Spill spill(where);
  spill.write(std::string(100, 'x'));
  EXPECT_EQ(copied(spill), std::string(100, 'x'));
}

// As long as it is there, too: a process that is killed has no time to tidy up.
TEST_F(Spills, HaveNoNames) {
  Spill spill(place());
  spill.write(std::string(1000, 'x'));
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(Spills, MoreThanOnePieceIsCopiedWhole) {
  Spill spill(place());
  std::string expected;
  for (int i = 0; i < 100000; ++i) expected += std::to_string(i) + ",";
  spill.write(expected);
  spill.write("end");
  EXPECT_EQ(copied(spill), expected + "end");
}

TEST_F(Spills, WithoutRoomSayWhy) {
  Spill spill({folder_ + "/none", 16});
  spill.write("fits");
  try {
    spill.write(std::string(1000, 'x'));
    FAIL() << "it was written somewhere";
  } catch (const WriteFailure& failure) {
    EXPECT_STREQ(failure.what(), "No such file or directory");
  }
}

}  // namespace
}  // namespace report::spill_test
