#include "calc/store/entry_folder.h"

#include "calc/base/file_hash.h"
#include "calc/store/entry_file.h"
#include "calc/store/folder_care.h"
#include "tests/support/scratch_folder.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstring>
#include <functional>
#include <map>

namespace entry_folder_test {
namespace {

namespace fs = std::filesystem;
using test_support::bytes_of;
using test_support::put_bytes;
using test_support::ScratchFolder;
using testing::HasSubstr;

constexpr std::size_t kMost = 1000;
const std::string kKey = "a key\nof two lines", kBytes = std::string("some\0bytes", 10);

class Store : public testing::Test {
 protected:
  Store() : path((scratch.path() / "deep" / "store").string()) {}

  fs::path file_of(const std::string& key) const {
    const calc::EntryPlace place = calc::place_of_key(key);
    return fs::path(path) / place.folder / place.file;
  }
  void write(const std::string& key = kKey, const std::string& bytes = kBytes) const {
    calc::EntryFolder store(path);
    store.write(key, bytes);
    ASSERT_EQ(store.troubles().not_written, "");
  }
  // Why the entry is not used after `change`; it is then written again and whole.
  std::string why_unusable_after(const std::function<void(const fs::path&)>& change) const {
    write();
    change(file_of(kKey));
    calc::EntryFolder store(path);
    EXPECT_EQ(store.read(kKey, kMost), std::nullopt);
    EXPECT_EQ(store.troubles().unusable, 1u);
    store.write(kKey, kBytes);
    EXPECT_EQ(store.troubles().not_written, "");
    EXPECT_EQ(store.read(kKey, kMost), kBytes);
    return store.troubles().unusable_why;
  }
  static void set_age(const fs::path& file, std::int64_t used_s) {
    const timespec times[2] = {{used_s, 0}, {used_s, 0}};
    ASSERT_EQ(utimensat(AT_FDCWD, file.c_str(), times, AT_SYMLINK_NOFOLLOW), 0);
  }

  ScratchFolder scratch;
  std::string path;
};

TEST_F(Store, GivesWhatWasWrittenAndNothingElse) {
  calc::EntryFolder store(path);
  EXPECT_EQ(store.read(kKey, kMost), std::nullopt);  // not even a folder
  EXPECT_FALSE(fs::exists(path));
  store.write(kKey, kBytes);
  store.write("another", "");
  EXPECT_EQ(store.read(kKey, kMost), kBytes);
  EXPECT_EQ(store.read("another", 0), "");
  EXPECT_EQ(store.read("a third", kMost), std::nullopt);
  EXPECT_EQ(store.troubles().unusable, 0u);
  EXPECT_TRUE(fs::exists(fs::path(path) / calc::kStoreMark));
  EXPECT_EQ(calc::problem_with_store(path), "");
}

TEST_F(Store, DamagedEntriesAreNotUsedAndAreReplaced) {
  const auto edit = [](const std::function<void(std::string&)>& change) {
    return [change](const fs::path& file) {
      std::string bytes = bytes_of(file);
      change(bytes);
      put_bytes(file, bytes);
    };
  };
  EXPECT_THAT(why_unusable_after(edit([](std::string& b) { b.clear(); })), HasSubstr("is empty"));
  EXPECT_THAT(why_unusable_after(edit([](std::string& b) { b.resize(20); })),
              HasSubstr("too short"));
  EXPECT_THAT(why_unusable_after(edit([](std::string& b) { b.pop_back(); })),
              HasSubstr("its length"));
  EXPECT_THAT(why_unusable_after(edit([](std::string& b) { b += '\0'; })), HasSubstr("its length"));
  EXPECT_THAT(why_unusable_after(edit([](std::string& b) { b += std::string(2 * kMost, ' '); })),
              HasSubstr("too large"));
  EXPECT_THAT(why_unusable_after(edit([](std::string& b) { b[0] = 'l'; })),
              HasSubstr("not a store entry"));
  EXPECT_THAT(why_unusable_after(edit([](std::string& b) { b[8] = 2; })),
              HasSubstr("its format is 2; this program reads 1"));
  EXPECT_THAT(why_unusable_after([](const fs::path& file) {
                fs::remove(file);
                fs::create_directory(file);
              }),
              HasSubstr("not a file"));
  EXPECT_THAT(why_unusable_after([this](const fs::path& file) {
                fs::rename(file, scratch.path() / "elsewhere");
                fs::create_symlink(scratch.path() / "elsewhere", file);
              }),
              HasSubstr("it is a link"));
  EXPECT_THAT(why_unusable_after([](const fs::path& file) {
                fs::remove(file);
                ASSERT_EQ(mkfifo(file.c_str(), 0666), 0);
              }),
              HasSubstr("not a file"));
  // Whole, but in the place of another.
  EXPECT_THAT(why_unusable_after([](const fs::path& file) {
                put_bytes(file, calc::render_entry("key of another", kBytes));
              }),
              HasSubstr("another key"));
}

TEST_F(Store, EveryFlippedBitIsSeen) {
  const std::string whole = calc::render_entry(kKey, kBytes);
  ASSERT_EQ(calc::parse_entry(whole).bytes, kBytes);
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    std::string bytes = whole;
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << (bit % 8)));
    EXPECT_NE(calc::parse_entry(bytes).problem, "") << bit;
  }
}

// Lengths that do not fit together, with a checksum that does.
TEST_F(Store, LengthsAreNotBelieved) {
  for (const std::size_t at : {12u, 16u, 20u, 23u}) {
    std::string file = calc::render_entry(kKey, kBytes);
    file.resize(file.size() - 32);
    file[at] = '\xff';
    file += calc::sha256(file);
    EXPECT_EQ(calc::parse_entry(file).problem, "its length differs from the stated length") << at;
  }
}

TEST_F(Store, ALinkInPlaceOfAPartIsNotFollowed) {
  write();
  const fs::path part = file_of(kKey).parent_path();
  fs::rename(part, scratch.path() / "elsewhere");
  fs::create_symlink(scratch.path() / "elsewhere", part);
  calc::EntryFolder store(path);
  EXPECT_EQ(store.read(kKey, kMost), std::nullopt);
  store.write(kKey, "other");
  EXPECT_NE(store.troubles().not_written, "");
  EXPECT_NE(bytes_of(scratch.path() / "elsewhere" / file_of(kKey).filename()), "");
}

TEST_F(Store, AFullFolderInPlaceOfAnEntryStaysAndIsToldOfOnce) {
  write();
  fs::remove(file_of(kKey));
  fs::create_directories(file_of(kKey) / "full");
  calc::EntryFolder store(path);
  store.write(kKey, kBytes);
  EXPECT_NE(store.troubles().not_written, "");
  EXPECT_TRUE(fs::exists(file_of(kKey) / "full"));
  // Nothing is left of what could not be put there.
  EXPECT_EQ(calc::count_entries(path).left_behind, 0u);
}

TEST_F(Store, IsAFolderOfItsOwn) {
  EXPECT_EQ(calc::problem_with_store(path), "");
  put_bytes(scratch.path() / "file", "");
  EXPECT_THAT(calc::problem_with_store((scratch.path() / "file").string()),
              HasSubstr("is not a folder"));
  EXPECT_THAT(calc::problem_with_store(scratch.path().string()), HasSubstr("is not a store"));
  // Another process is just about to mark it.
  fs::create_directory(scratch.path() / "new");
  put_bytes(scratch.path() / "new" / ".new-0123", "");
  EXPECT_EQ(calc::problem_with_store((scratch.path() / "new").string()), "");
  calc::EntryFolder below_a_file((scratch.path() / "file" / "store").string());
  below_a_file.write(kKey, kBytes);
  EXPECT_NE(below_a_file.troubles().not_written, "");
  EXPECT_EQ(below_a_file.read(kKey, kMost), std::nullopt);
}

TEST_F(Store, ReadingNotesTheUseOnceADay) {
  write();
  calc::EntryFolder store(path);
  const auto used = [&] { return fs::last_write_time(file_of(kKey)).time_since_epoch().count(); };
  set_age(file_of(kKey), std::time(nullptr) - 60 * 60);
  const auto an_hour_ago = used();
  EXPECT_TRUE(store.read(kKey, kMost));
  EXPECT_EQ(used(), an_hour_ago);
  set_age(file_of(kKey), std::time(nullptr) - 25 * 60 * 60);
  EXPECT_TRUE(store.read(kKey, kMost));
  EXPECT_GT(used(), an_hour_ago);
}

TEST_F(Store, VerifyNamesWhatIsDamaged) {
  for (int k = 0; k < 20; ++k) write("key " + std::to_string(k));
  put_bytes(file_of("key 3"), "");
  fs::rename(file_of("key 5"), file_of("key 4"));
  std::map<std::string, std::string> damaged;
  const calc::StoreCount count = calc::verify_entries(
      path, [&](const std::string& place, const std::string& why) { damaged[place] = why; });
  EXPECT_EQ(count.entries, 19u);
  ASSERT_EQ(damaged.size(), 2u);
  const auto place = [&](const std::string& key) {
    return fs::relative(file_of(key), path).string();
  };
  EXPECT_EQ(damaged[place("key 3")], "it is empty");
  EXPECT_EQ(damaged[place("key 4")], "it has another key");
}

TEST_F(Store, PruneTakesWhatWasUnusedForLongest) {
  constexpr std::int64_t kNow = 1'000'000'000;
  for (int k = 0; k < 10; ++k) {
    write("key " + std::to_string(k), std::string(k == 6 ? 900 : 100, 'x'));
    set_age(file_of("key " + std::to_string(k)), kNow - 1000 * k);
  }
  const fs::path part = file_of("key 0").parent_path();
  put_bytes(part / ".new-old", "x");
  set_age(part / ".new-old", kNow - 25 * 60 * 60);
  put_bytes(part / ".new-now", "x");
  set_age(part / ".new-now", kNow - 60);
  put_bytes(part / "notes.txt", "mine");
  const std::string foreign(62, 'a');
  put_bytes(part / foreign, "an object of another program");
  set_age(part / foreign, kNow - 1'000'000);
  const std::uint64_t all = calc::count_entries(path).bytes;
  const std::uint64_t small = fs::file_size(file_of("key 0"));

  EXPECT_EQ(calc::prune_entries(path, all, kNow).deleted_entries, 0u);
  const calc::PruneResult result = calc::prune_entries(path, 7 * small, kNow);
  // Six small ones fit, the seventh is large, and what is older than it goes, too.
  EXPECT_EQ(result.deleted_entries, 4u);
  EXPECT_THAT(result.problem, HasSubstr(foreign));
  for (int k = 0; k < 10; ++k) {
    EXPECT_EQ(fs::exists(file_of("key " + std::to_string(k))), k < 6) << k;
  }
  EXPECT_FALSE(fs::exists(part / ".new-old"));
  EXPECT_TRUE(fs::exists(part / ".new-now"));
  EXPECT_TRUE(fs::exists(part / "notes.txt"));
  EXPECT_TRUE(fs::exists(part / foreign));
  fs::remove(part / foreign);
  EXPECT_EQ(calc::prune_entries(path, 0, kNow).kept.entries, 0u);
}

}  // namespace
}  // namespace entry_folder_test
