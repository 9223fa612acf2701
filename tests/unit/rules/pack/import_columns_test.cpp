#include "rules/pack/import_columns.h"

#include "calc/base/csv.h"
#include "rules/pack/builtin_packs.h"
#include "rules/pack/import_rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace rules::import_columns_test {
namespace {

TEST(ImportColumns, KnowUsualHeads) {
  const std::map<std::string, std::vector<std::string>> heads{
      {"ref", {"ref", "Ref. no.", "REF", "final_ref", "No.", "reference"}},
      {"name", {"name", "Activity", "task", "Use", "Type of task/activity area"}},
      {"Em_lx",
       {"Em", "Em required", "em_required_lx", "Em, required (lx)", "E m [lx]", "\u0112m lx"}},
      {"Em_modified_lx", {"Em modified", "Em_modified_lx", "modified"}},
      {"Uo", {"Uo", "U0", "U\u2080", "Uo_min", "uniformity"}},
      {"Ra", {"Ra", "RA min", "CRI"}},
      {"RUGL", {"RUGL", "UGRL", "UGR", "R_UGL", "RUGL_max", "UGR limit"}},
      {"Ez_lx", {"Ez", "Em,z lx", "Ez_m_lx"}},
      {"Ewall_lx", {"Em,wall", "wall", "Em_wall_lx"}},
      {"Eceiling_lx", {"Em,ceiling", "ceiling", "Em_ceiling_lx"}},
      {"plane", {"plane", "Reference plane"}},
      {"confirmed", {"confirmed_fields"}},
      {"status", {"final_ref_confidence"}},
      {"notes", {"Notes", "remarks", "Specific requirements"}},
      {"sources", {"source"}},
  };
  for (const auto& [name, written] : heads) {
    for (const std::string& head : written) EXPECT_EQ(import_column_name(head), name) << head;
  }
  EXPECT_EQ(import_column_name("cct_K"), "cct_K");
}

TEST(ImportColumns, EveryNameStandsForOneColumn) {
  std::map<std::string, std::string> column_of;
  for (const ImportColumn& column : import_columns()) {
    EXPECT_EQ(import_column_name(column.name), column.name);
    EXPECT_FALSE(column.meaning.empty());
    const auto [at, is_new] =
        column_of.emplace(plain_column_name(column.name), std::string(column.name));
    EXPECT_TRUE(is_new) << at->second;
  }
}

TEST(ImportColumns, SuggestTheNearestOne) {
  EXPECT_EQ(import_column_suggestion("Rugll"), "; did you mean 'RUGL'?");
  EXPECT_EQ(import_column_suggestion("activty"), "; did you mean 'name'?");
  EXPECT_EQ(import_column_suggestion("colour"), "");
}

TEST(ImportColumns, MakeATemplateThatIsImportedWithoutAWord) {
  calc::Diagnostics diagnostics;
  for (const std::string_view like : builtin_pack_texts()) {
    if (like.find("id=\"en12464-1\" edition=\"2021\"") == std::string_view::npos) continue;
    const auto pack = import_rows(import_template(), "t.csv", like, "mine", diagnostics);
    ASSERT_TRUE(pack.has_value());
    EXPECT_EQ(pack->rows, 2);
    EXPECT_EQ(pack->floor_rows, 1);
  }
  EXPECT_TRUE(diagnostics.all().empty());
}

TEST(ImportColumns, AreAllInTheHelp) {
  const std::string help = import_columns_help();
  for (const ImportColumn& column : import_columns()) {
    EXPECT_THAT(help, testing::HasSubstr("\n  " + std::string(column.name)));
  }
}

}  // namespace
}  // namespace rules::import_columns_test
