#include "rules/pack/named_pack.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace rules::named_pack_test {
namespace {

RulePack pack_of(std::string id, std::string edition, std::string status = "published") {
  RulePack pack;
  pack.file = edition + ".xml";
  pack.id = std::move(id);
  pack.edition = std::move(edition);
  pack.status = std::move(status);
  return pack;
}

std::string meant(std::string_view name, const std::vector<RulePack>& packs) {
  const NamedPack found = named_pack(name, packs);
  EXPECT_EQ(found.is_ambiguous(), found.pack == nullptr && !found.candidates.empty());
  if (found.is_ambiguous()) return "one of " + found.candidates;
  return found.pack == nullptr ? "none" : found.pack->full_id();
}

TEST(NamedPack, ABareIdIsTheOnlyEditionOrTheOneInForce) {
  EXPECT_EQ(meant("a", {pack_of("a", "1", "withdrawn"), pack_of("b", "2")}), "a:1");
  EXPECT_EQ(meant("a", {pack_of("a", "1", "superseded"), pack_of("a", "2")}), "a:2");
  EXPECT_EQ(meant("a", {pack_of("a", "2"), pack_of("a", "3", "draft")}), "a:2");
  EXPECT_EQ(meant("c", {pack_of("a", "1")}), "none");
  EXPECT_EQ(meant("", {pack_of("a", "1")}), "none");
}

// The last one that is published was taken where a rule is explained, and none where it is used.
TEST(NamedPack, TwoEditionsInForceAreAmbiguousInAnyOrder) {
  EXPECT_EQ(meant("a", {pack_of("a", "1"), pack_of("a", "own")}),
            "one of a:1 (1.xml), a:own (own.xml)");
  EXPECT_EQ(meant("a", {pack_of("a", "own"), pack_of("a", "1")}),
            "one of a:own (own.xml), a:1 (1.xml)");
  EXPECT_EQ(meant("a", {pack_of("a", "1", "draft"), pack_of("a", "2", "draft")}),
            "one of a:1 (1.xml), a:2 (2.xml)");
}

TEST(NamedPack, TheEditionChooses) {
  const std::vector<RulePack> packs{pack_of("a", "1"), pack_of("a", "own"),
                                    pack_of("a", "0", "withdrawn")};
  for (const char* name : {"a:1", "a:own", "a:0"}) EXPECT_EQ(meant(name, packs), name);
  EXPECT_EQ(meant("a:2", packs), "none");
}

TEST(NamedPack, OneEditionThatIsLoadedTwiceIsAmbiguous) {
  EXPECT_EQ(meant("a:1", {pack_of("a", "1"), pack_of("a", "1")}),
            "one of a:1 (1.xml), a:1 (1.xml)");
}

}  // namespace
}  // namespace rules::named_pack_test
