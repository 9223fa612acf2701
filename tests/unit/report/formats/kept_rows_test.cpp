#include "report/formats/kept_rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace report {
namespace {

TEST(KeptRows, ComeBackAsTheyWere) {
  const std::string nothing, long_text(70'000, 'x'), zeros("a\0b", 3);
  const TableNumber number{-1.0 / 3.0, 2, true};
  KeptRows rows;
  rows.add(
      std::vector<TableCell>{TableCell(), nothing, long_text, zeros, number, std::int64_t{-7}});
  rows.add(std::vector<TableCell>(6));
  std::vector<std::vector<TableCell>> back;
  rows.for_each([&](std::vector<TableCell> row) { back.push_back(std::move(row)); });
  ASSERT_EQ(back.size(), 2u);
  const std::vector<TableCell>& first = back[0];
  ASSERT_EQ(first.size(), 6u);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(first[0]));
  EXPECT_EQ(std::get<std::string>(first[1]), nothing);
  EXPECT_EQ(std::get<std::string>(first[2]), long_text);
  EXPECT_EQ(std::get<std::string>(first[3]), zeros);
  EXPECT_EQ(std::get<TableNumber>(first[4]).value, number.value);
  EXPECT_EQ(std::get<TableNumber>(first[4]).decimals, 2);
  EXPECT_TRUE(std::get<TableNumber>(first[4]).is_percent);
  EXPECT_EQ(std::get<std::int64_t>(first[5]), -7);
  for (const TableCell& cell : back[1]) EXPECT_TRUE(std::holds_alternative<std::monostate>(cell));
}

TEST(KeptRows, KnowTheColumnsThatAreUsed) {
  KeptRows rows;
  EXPECT_FALSE(rows.is_used(0));
  rows.add(std::vector<TableCell>{TableCell(), std::string("a"), TableCell()});
  rows.add(std::vector<TableCell>{TableCell(), TableCell(), std::int64_t{0}});
  EXPECT_FALSE(rows.is_used(0));
  EXPECT_TRUE(rows.is_used(1));
  EXPECT_TRUE(rows.is_used(2)) << "0 is a number";
  EXPECT_FALSE(rows.is_used(3));
}

}  // namespace
}  // namespace report
