#include "report/tools/store/store.h"

#include <gtest/gtest.h>

namespace store_test {
namespace {

TEST(ParseBytes, TakesAWholeNumberAndAUnit) {
  EXPECT_EQ(cli::parse_bytes("0"), 0u);
  EXPECT_EQ(cli::parse_bytes("1500000"), 1500000u);
  EXPECT_EQ(cli::parse_bytes("500MB"), 500'000'000u);
  EXPECT_EQ(cli::parse_bytes("2GiB"), std::uint64_t{2} << 30);
  EXPECT_EQ(cli::parse_bytes("16TiB"), std::uint64_t{16} << 40);
}

TEST(ParseBytes, RefusesTheRest) {
  for (const char* text : {"", "GiB", "1.5GiB", "-1", "2gib", "2 GiB", "2G", "99999999999TiB",
                           "18446744073709551616"}) {
    EXPECT_EQ(cli::parse_bytes(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace store_test
