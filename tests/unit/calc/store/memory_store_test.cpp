#include "calc/store/memory_store.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <optional>
#include <string>

namespace memory_store_test {
namespace {

constexpr std::size_t kMost = 1000;

TEST(MemoryStore, GivesBackWhatItGot) {
  calc::MemoryStore store(kMost);
  EXPECT_EQ(store.read("key", kMost), std::nullopt);
  store.write("key", "bytes");
  store.write("other", "");
  EXPECT_EQ(store.read("key", kMost), "bytes");
  EXPECT_EQ(store.read("other", kMost), "");
  EXPECT_EQ(store.read("key", 4), std::nullopt);  // more than the reader takes
}

TEST(MemoryStore, KeepsTheFirstOfAKey) {
  calc::MemoryStore store(kMost);
  store.write("key", "first");
  store.write("key", "second");
  EXPECT_EQ(store.read("key", kMost), "first");
}

TEST(MemoryStore, ForgetsWhatIsRefused) {
  calc::MemoryStore store(10);
  store.write("key", std::string(10, 'a'));
  store.refuse("key", "why");
  store.refuse("unknown", "why");
  EXPECT_EQ(store.read("key", kMost), std::nullopt);
  store.write("key", std::string(10, 'b'));
  EXPECT_EQ(store.read("key", kMost), std::string(10, 'b'));
}

TEST(MemoryStore, KeepsNoMoreThanItMay) {
  calc::MemoryStore store(10);
  store.write("a", "123456");
  store.write("b", "12345");
  store.write("c", "1234");
  EXPECT_TRUE(store.read("a", kMost));
  EXPECT_FALSE(store.read("b", kMost));
  EXPECT_TRUE(store.read("c", kMost));
}

TEST(MemoryStore, ForgetsAllAboveALimit) {
  calc::MemoryStore store(100);
  store.write("a", std::string(60, 'x'));
  store.clear_above(60);
  EXPECT_TRUE(store.read("a", 100).has_value());
  store.clear_above(59);
  EXPECT_FALSE(store.read("a", 100).has_value());
  store.write("b", std::string(100, 'y'));
  EXPECT_TRUE(store.read("b", 100).has_value()) << "there is room for all again";
}

}  // namespace
}  // namespace memory_store_test
