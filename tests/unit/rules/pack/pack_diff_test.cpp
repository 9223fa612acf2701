#include "rules/pack/pack_diff.h"

#include "rules/pack/pack_elements.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace rules::pack_diff_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

RulePack pack_of(const std::string& xml) {
  calc::Diagnostics diagnostics;
  std::optional<RulePack> pack = parse_rule_pack(xml, "own.xml", diagnostics);
  for (const calc::Diagnostic& d : diagnostics.all()) ADD_FAILURE() << format_diagnostic(d);
  return pack.value_or(RulePack{});
}

// "check a: limit at-least 1 -> at-least 2 [stricter]", "row 1 removed".
std::vector<std::string> lines_of(const std::vector<PartDifference>& parts) {
  std::vector<std::string> lines;
  const auto word = [](Tightening tightening) {
    const std::string_view name = calc::name_of(tightening);
    return name.empty() ? "" : fmt::format(" [{}]", name);
  };
  const auto text = [](const std::optional<PackField>& field) {
    return field ? field->text : std::string("-");
  };
  for (const PartDifference& part : parts) {
    std::string name(calc::name_of(part.part));
    if (!part.id.empty()) name += " " + part.id;
    if (!part.id_after.empty()) name += "=" + part.id_after;
    if (part.change != PartChange::changed) {
      lines.push_back(
          fmt::format("{} {}{}", name, calc::name_of(part.change), word(part.tightening)));
      continue;
    }
    for (const FieldDifference& field : part.fields) {
      lines.push_back(fmt::format("{}: {} {} -> {}{}", name, field.name, text(field.before),
                                  text(field.after), word(field.tightening)));
    }
  }
  return lines;
}

std::vector<std::string> lines_of(const std::string& before, const std::string& after,
                                  const RowNames& rows = {}) {
  return lines_of(diff_of(pack_of(before), pack_of(after), rows));
}

// The first of `was`, which must be there.
std::string edited(std::string text, const std::string& was, const std::string& is) {
  const std::size_t at = text.find(was);
  if (at == std::string::npos) {
    ADD_FAILURE() << "no " << was;
    return text;
  }
  return text.replace(at, was.size(), is);
}

// Every attribute of the format, and parts that nothing names, so that they may have another id.
const std::string kHead =
    "<rule-pack id='own' edition='2024' title='Own' version='3' kind='contract' status='draft' "
    "jurisdiction='EU' licence='internal' licence-note='kept' role='desk'>\n";
const std::vector<std::string> kParts{
    "<source id='s' note='copy' address='a'/>",
    "<source id='unused' note='copy'/>",
    "<parameter id='E' unit='lx' meaning='average'/>",
    "<parameter id='R' unit='none' meaning='rating'/>",
    "<parameter id='idle' unit='none' meaning='of nothing'/>",
    "<parameter id='F' unit='lx' meaning='another'/>",
    "<fact id='f' unit='lx' meaning='of nothing'/>",
    "<policy compare='rounded' rounding='half-even' digits-illuminance='1' digits-ratio='3' "
    "digits-other='2' tolerance='0.01' tolerance-reason='r' guard='0.05'/>",
    "<table id='t' key-unit='lx' value-unit='lx' match='next-lower' trust='confirmed'>"
    "<entry key='0' value='key'/><entry key='200' value='150'/></table>",
    "<table id='idle' key-unit='lx' value-unit='lx' match='exact'><entry key='7' value='8'/>"
    "</table>",
    "<scale id='k' unit='lx' values='100 200 300' of='E' down='1' up='0' trust='unverified'/>",
    "<scale id='idle' unit='lx' values='1 2'/>",
    "<mask id='b'><border metres='0.3'/></mask>"
    "<mask id='m'><inset metres='0.5' share='0.2' up-to-width='1'/><walls metres='0.6'/>"
    "<across metres='0.7' share='0.25' up-to-width='2'/><centre-line up-to-width='3'/></mask>",
    "<mask id='idle'><inset metres='0.1'/></mask>",
    "<grid id='g' method='formula-power' count='odd-up' factor='0.3' base='4' max-spacing='8' "
    "ratio='3' trust='single-source' note='n'/>",
    "<grid id='spaced' method='fixed-spacing' count='up' spacing='3 1.5' least='10 3'/>",
    "<grid id='counted' method='fixed-count' count='given' cells='9 3'/>",
    "<grid id='idle' method='project' count='given'/>",
    "<plane role='desk' orientation='horizontal-up' heights='0.7 0.8' heights-are='usual' grid='g' "
    "mask='m' missing='0.15' note='n' area='task' height='0.75' margin='0.5' narrow-below='3' "
    "narrow-share='0.15'/>",
    "<plane role='band' orientation='horizontal-up' area='band' around='desk' width='0.4'/>",
    "<plane role='wall' orientation='surface'/>",
    "<plane role='wall' orientation='vertical'/>",
    "<row ref='1.1' name='shop' trust='confirmed' sources='s' note='n' task-heights='0 0.2' "
    "task-orientation='vertical' name-de='Laden'>"
    "<value of='E' required='300' modified='500' trust='unverified'/>"
    "<value of='R' required='19'/></row>",
    "<row ref='1.2' name='store' trust='confirmed'><value of='E' none='unknown'/>"
    "<value of='R' none='not-specified'/></row>",
    "<check id='a' role='desk' clause='4' severity='should' quantity='planar' statistic='average' "
    "mask='m' state='initial' sources='electric' light='direct' outage='any-one-unit' ways='level' "
    "at-least='row(E)' trust='unverified' note='n'/>",
    "<check id='percent' role='desk' quantity='planar' statistic='percentile' percent='5' "
    "less-than='7 lx'/>",
    "<check id='share' role='desk' quantity='planar' statistic='share' from='10 lx' to='90 lx' "
    "more-than='0.5'/>",
    "<check id='rating' role='eye' quantity='UGR' statistic='maximum' at-most='row(R)'/>",
    "<check id='table' role='room' quantity='UGR-table' statistic='value' at-most='row(R)' "
    "instead-of='rating'/>",
    "<check id='band' role='band' quantity='planar' statistic='average' "
    "at-least='table(t, row(E))'/>",
    "<check id='idle' role='wall' quantity='planar' statistic='average' at-least='1 lx'>"
    "<special place='other-wall' limit='0.5 lx' rows='1.2' trust='unverified' note='n'/></check>",
    "<aggregate id='x' rule='at-least' count='1' of='a percent' severity='should' clause='7' "
    "trust='unverified' note='n'/>",
    "<aggregate id='y' rule='share' share='0.9' over='rooms' by='area' of='share'/>",
    "<class id='c' rows='1.1 1.2' of='a'/>"};

std::string joined(const std::vector<std::string>& parts) {
  std::string text = kHead;
  for (const std::string& part : parts) text += part + "\n";
  return text + "</rule-pack>\n";
}
const std::string kEverything = joined(kParts);

// One attribute becomes another: of which part that is a difference, and of which field.
struct Edit {
  const char* attribute;  // "check.role"
  const char* was;
  const char* is;
  const char* part;
  const char* field;
};

constexpr Edit kEdits[] = {
    {"rule-pack.id", "id='own'", "id='other'", "pack", "id"},
    {"rule-pack.edition", "edition='2024'", "edition='2025'", "pack", "edition"},
    {"rule-pack.title", "title='Own'", "title='Mine'", "pack", "title"},
    {"rule-pack.version", "version='3'", "version='4'", "pack", "version"},
    {"rule-pack.kind", "kind='contract'", "kind='law'", "pack", "kind"},
    {"rule-pack.status", "status='draft'", "status='published'", "pack", "status"},
    {"rule-pack.jurisdiction", "jurisdiction='EU'", "jurisdiction='US'", "pack", "jurisdiction"},
    {"rule-pack.licence", "licence='internal'", "licence='public'", "pack", "licence"},
    {"rule-pack.licence-note", "licence-note='kept'", "licence-note='free'", "pack",
     "licence-note"},
    {"rule-pack.role", "role='desk'>", "role='wall'>", "pack", "role"},
    {"source.id", "source id='unused'", "source id='u'", "source unused", ""},
    {"source.note", "note='copy' a", "note='print' a", "source s", "note"},
    {"source.address", "address='a'", "address='b'", "source s", "address"},
    {"parameter.id", "parameter id='idle'", "parameter id='i'", "parameter idle", ""},
    {"parameter.unit", "id='idle' unit='none'", "id='idle' unit='m'", "parameter idle", "unit"},
    {"parameter.meaning", "meaning='average'", "meaning='mean'", "parameter E", "meaning"},
    {"fact.id", "fact id='f'", "fact id='g'", "fact f", ""},
    {"fact.unit", "'f' unit='lx'", "'f' unit='fc'", "fact f", "unit"},
    {"fact.meaning", "unit='lx' meaning='of nothing'", "unit='lx' meaning='x'", "fact f",
     "meaning"},
    {"policy.compare", "compare='rounded'", "compare='raw'", "policy", "compare"},
    {"policy.rounding", "rounding='half-even'", "rounding='down'", "policy", "rounding"},
    {"policy.digits-illuminance", "digits-illuminance='1'", "digits-illuminance='2'", "policy",
     "digits-illuminance"},
    {"policy.digits-ratio", "digits-ratio='3'", "digits-ratio='4'", "policy", "digits-ratio"},
    {"policy.digits-other", "digits-other='2'", "digits-other='0'", "policy", "digits-other"},
    {"policy.tolerance", "tolerance='0.01'", "tolerance='0.02'", "policy", "tolerance"},
    {"policy.tolerance-reason", "tolerance-reason='r'", "tolerance-reason='q'", "policy",
     "tolerance-reason"},
    {"policy.guard", "guard='0.05'", "guard='0.04'", "policy", "guard"},
    {"table.id", "table id='idle'", "table id='i'", "table idle", ""},
    {"table.key-unit", "'idle' key-unit='lx'", "'idle' key-unit='m'", "table idle", "key-unit"},
    {"table.value-unit", "value-unit='lx' match='exact'", "value-unit='m' match='exact'",
     "table idle", "value-unit"},
    {"table.match", "match='next-lower'", "match='linear'", "table t", "match"},
    {"table.trust", "trust='confirmed'><e", "trust='unverified'><e", "table t", "trust"},
    {"entry.key", "key='200'", "key='250'", "table t", "key 200 lx"},
    {"entry.value", "value='150'", "value='key'", "table t", "key 200 lx"},
    {"scale.id", "scale id='idle'", "scale id='i'", "scale idle", ""},
    {"scale.unit", "'idle' unit='lx' v", "'idle' unit='m' v", "scale idle", "unit"},
    {"scale.values", "200 300'", "200 400'", "scale k", "values"},
    {"scale.of", "of='E' down", "of='F' down", "scale k", "of"},
    {"scale.down", "down='1'", "down='2'", "scale k", "down"},
    {"scale.up", "up='0'", "up='2'", "scale k", "up"},
    {"scale.trust", "up='0' trust='unverified'", "up='0' trust='confirmed'", "scale k", "trust"},
    {"mask.id", "mask id='idle'", "mask id='i'", "mask idle", ""},
    {"inset.metres", "inset metres='0.5'", "inset metres='0.4'", "mask m", "points"},
    {"inset.share", "share='0.2'", "share='0.3'", "mask m", "points"},
    {"inset.up-to-width", "up-to-width='1'", "up-to-width='1.5'", "mask m", "points"},
    {"walls.metres", "walls metres='0.6'", "walls metres='0.5'", "mask m", "points"},
    {"border.metres", "border metres='0.3'", "border metres='0.4'", "mask b", "points"},
    {"across.metres", "across metres='0.7'", "across metres='0.5'", "mask m", "points"},
    {"across.share", "share='0.25'", "share='0.2'", "mask m", "points"},
    {"across.up-to-width", "up-to-width='2'", "up-to-width='3'", "mask m", "points"},
    {"centre-line.up-to-width", "<centre-line up-to-width='3'/>", "<centre-line/>", "mask m",
     "points"},
    {"grid.id", "grid id='idle'", "grid id='i'", "grid idle", ""},
    {"grid.method", "method='fixed-count' count='given' cells='9 3'",
     "method='project' count='given'", "grid counted", "points"},
    {"grid.count", "count='odd-up'", "count='nearest'", "grid g", "points"},
    {"grid.factor", "factor='0.3'", "factor='0.2'", "grid g", "points"},
    {"grid.base", "base='4'", "base='5'", "grid g", "points"},
    {"grid.max-spacing", "max-spacing='8'", "max-spacing='10'", "grid g", "points"},
    {"grid.ratio", " ratio='3'", " ratio='2'", "grid g", "points"},
    {"grid.spacing", "spacing='3 1.5'", "spacing='3 1'", "grid spaced", "points"},
    {"grid.least", "least='10 3'", "least='10 2'", "grid spaced", "points"},
    {"grid.cells", "cells='9 3'", "cells='9 4'", "grid counted", "points"},
    {"grid.trust", "trust='single-source' note='n'", "trust='confirmed' note='n'", "grid g",
     "trust"},
    {"grid.note", "trust='single-source' note='n'", "trust='single-source' note='x'", "grid g",
     "note"},
    {"plane.role", "plane role='wall' orientation='vertical'",
     "plane role='roof' orientation='vertical'", "plane wall-2", ""},
    {"plane.orientation", "orientation='vertical'", "orientation='free'", "plane wall-2",
     "orientation"},
    {"plane.heights", "heights='0.7 0.8'", "heights='0.7 0.9'", "plane desk", "heights"},
    {"plane.heights-are", "heights-are='usual'", "heights-are='required'", "plane desk",
     "heights-are"},
    {"plane.grid", " grid='g'", " grid='spaced'", "plane desk", "grid"},
    {"plane.mask", "mask='m' missing", "mask='idle' missing", "plane desk", "mask"},
    {"plane.missing", "missing='0.15'", "missing='0.1'", "plane desk", "missing"},
    {"plane.note", "note='n' area", "note='x' area", "plane desk", "note"},
    {"plane.area", "area='band' around='desk' width", "area='task-and-band' width", "plane band",
     "area"},
    {"plane.around", "orientation='surface'",
     "orientation='surface' area='band' around='desk' width='1'", "plane wall", "around"},
    {"plane.holds", "orientation='surface'", "orientation='surface' holds='desk'", "plane wall",
     "holds"},
    {"plane.width", "width='0.4'", "width='0.3'", "plane band", "width"},
    {"plane.height", "height='0.75'", "height='0.8'", "plane desk", "height"},
    {"plane.margin", "margin='0.5'", "margin='0.4'", "plane desk", "margin"},
    {"plane.narrow-below", "narrow-below='3'", "narrow-below='2'", "plane desk", "narrow-below"},
    {"plane.narrow-share", "narrow-share='0.15'", "narrow-share='0.1'", "plane desk",
     "narrow-share"},
    {"row.name-de", "name-de='Laden'", "name-de='Markt'", "row 1.1", "name-de"},
    {"row.task-orientation", "task-orientation='vertical'", "task-orientation='free'", "row 1.1",
     "task-orientation"},
    {"row.ref", "rows='1.1 1.2'", "rows='1.2 1.1'", "class c", "rows"},
    {"row.name", "name='shop'", "name='mall'", "row 1.1", "name"},
    {"row.trust", "name='shop' trust='confirmed'", "name='shop' trust='unverified'", "row 1.1",
     "trust"},
    {"row.sources", "sources='s'", "sources='s unused'", "row 1.1", "sources"},
    {"row.note", "note='n' task", "note='x' task", "row 1.1", "note"},
    {"row.task-heights", "task-heights='0 0.2'", "task-heights='0 0.3'", "row 1.1", "task-heights"},
    {"value.of", "of='R' required='19'", "of='idle' required='19'", "row 1.1", "R"},
    {"value.required", "required='300'", "required='400'", "row 1.1", "E"},
    {"value.modified", "modified='500'", "modified='750'", "row 1.1", "E modified"},
    {"value.none", "none='unknown'", "none='not-applicable'", "row 1.2", "E"},
    {"value.trust", "modified='500' trust='unverified'", "modified='500' trust='single-source'",
     "row 1.1", "E trust"},
    {"check.id", "check id='idle'", "check id='i'", "check idle", ""},
    {"check.role", "role='wall' quantity", "role='roof' quantity", "check idle", "role"},
    {"check.clause", "clause='4'", "clause='5'", "check a", "clause"},
    {"check.severity", "severity='should' quantity", "severity='shall' quantity", "check a",
     "severity"},
    {"check.quantity", "role='wall' quantity='planar'", "role='wall' quantity='scalar'",
     "check idle", "quantity"},
    {"check.statistic", "quantity='planar' statistic='average' at-least='1 lx'",
     "quantity='planar' statistic='minimum' at-least='1 lx'", "check idle", "statistic"},
    {"check.percent", "percent='5'", "percent='10'", "check percent", "percent"},
    {"check.from", "from='10 lx'", "from='20 lx'", "check share", "from"},
    {"check.to", "to='90 lx'", "to='95 lx'", "check share", "to"},
    {"check.mask", "mask='m' state", "mask='idle' state", "check a", "mask"},
    {"check.state", "state='initial'", "state='maintained'", "check a", "state"},
    {"check.sources", "sources='electric'", "sources='daylight'", "check a", "sources"},
    {"check.light", "light='direct'", "light='all'", "check a", "light"},
    {"check.outage", "outage='any-one-unit'", "outage='none'", "check a", "outage"},
    {"check.ways", "ways='level'", "ways='all'", "check a", "ways"},
    {"check.at-least", "at-least='1 lx'", "at-least='2 lx'", "check idle", "limit"},
    {"check.at-most", "statistic='maximum' at-most='row(R)'", "statistic='maximum' at-most='22'",
     "check rating", "limit"},
    {"check.more-than", "more-than='0.5'", "more-than='0.6'", "check share", "limit"},
    {"check.less-than", "less-than='7 lx'", "at-most='7 lx'", "check percent", "limit"},
    {"check.instead-of", " instead-of='rating'", "", "check table", "instead-of"},
    {"check.trust", "at-least='row(E)' trust='unverified'", "at-least='row(E)' trust='confirmed'",
     "check a", "trust"},
    {"check.note", "trust='unverified' note='n'/>\n<check", "trust='unverified' note='x'/>\n<check",
     "check a", "note"},
    {"special.place", "place='other-wall'", "place='unknown-task'", "check idle",
     "special other-wall"},
    {"special.limit", "limit='0.5 lx'", "limit='0.6 lx'", "check idle", "special other-wall"},
    {"special.rows", "rows='1.2' trust", "rows='1.1' trust", "check idle",
     "special other-wall rows"},
    {"special.trust", "rows='1.2' trust='unverified'", "rows='1.2' trust='confirmed'", "check idle",
     "special other-wall trust"},
    {"special.note", "trust='unverified' note='n'/></check>",
     "trust='unverified' note='x'/></check>", "check idle", "special other-wall note"},
    {"aggregate.id", "aggregate id='x'", "aggregate id='i'", "aggregate x", ""},
    {"aggregate.rule", "rule='at-least' count='1'", "rule='any'", "aggregate x", "rule"},
    {"aggregate.count", "count='1'", "count='2'", "aggregate x", "count"},
    {"aggregate.share", "share='0.9'", "share='0.8'", "aggregate y", "share"},
    {"aggregate.of", "of='a percent'", "of='a percent idle'", "aggregate x", "of"},
    {"aggregate.over", "over='rooms'", "over='planes'", "aggregate y", "over"},
    {"aggregate.by", "by='area'", "by='count'", "aggregate y", "by"},
    {"aggregate.severity", "severity='should' clause='7'", "severity='shall' clause='7'",
     "aggregate x", "severity"},
    {"aggregate.clause", "clause='7'", "clause='8'", "aggregate x", "clause"},
    {"aggregate.trust", "clause='7' trust='unverified'", "clause='7' trust='confirmed'",
     "aggregate x", "trust"},
    {"aggregate.note", "note='n'/>\n<aggregate", "note='x'/>\n<aggregate", "aggregate x", "note"},
    {"class.id", "class id='c'", "class id='d'", "class c", ""},
    {"class.rows", "rows='1.1 1.2'", "rows='1.1'", "class c", "rows"},
    {"class.of", "1.2' of='a'", "1.2' of='idle'", "class c", "of"}};

void add_attributes(std::string_view element, const calc::ElementRow& row,
                    std::set<std::string>& names) {
  for (const calc::AttributeRow& attribute : row.attributes) {
    names.insert(fmt::format("{}.{}", element, attribute.name));
  }
  for (const calc::ChildRow& child : row.children) add_attributes(child.name, *child.row, names);
}

// Who adds an attribute to the format has it compared, or this fails.
TEST(PackDiff, EveryAttributeOfTheFormatHasAnEditBelow) {
  std::set<std::string> all, covered;
  add_attributes("rule-pack", kRulePackElement, all);
  for (const Edit& edit : kEdits) covered.insert(edit.attribute);
  EXPECT_EQ(covered, all);
}

TEST(PackDiff, EveryEditIsADifferenceOfItsPartAndOfNoOther) {
  const RulePack before = pack_of(kEverything);
  for (const Edit& edit : kEdits) {
    SCOPED_TRACE(edit.attribute);
    const RulePack after = pack_of(edited(kEverything, edit.was, edit.is));
    ASSERT_FALSE(after.id.empty());
    const std::vector<std::string> lines = lines_of(diff_of(before, after));
    const std::string name = edit.part;
    if (*edit.field == '\0') {
      ASSERT_EQ(lines.size(), 2U);
      EXPECT_THAT(lines[0], StartsWith(name + " removed"));
      EXPECT_THAT(lines[1], HasSubstr(" added"));
      continue;
    }
    EXPECT_THAT(lines, Contains(StartsWith(fmt::format("{}: {} ", name, edit.field))));
    for (const std::string& line : lines) EXPECT_THAT(line, StartsWith(name + ": "));
    // The other way round the same, before and after exchanged.
    EXPECT_EQ(lines_of(diff_of(after, before)).size(), lines.size());
  }
}

TEST(PackDiff, APackEqualsItself) {
  for (const RulePack& pack : builtin_rule_packs()) {
    EXPECT_THAT(lines_of(diff_of(pack, pack)), IsEmpty()) << pack.full_id();
  }
  EXPECT_THAT(lines_of(kEverything, kEverything), IsEmpty());
}

TEST(PackDiff, TheOrderOfAFileIsNoDifference) {
  std::vector<std::string> parts = kParts;
  std::reverse(parts.begin(), parts.end());
  // The first plane of a role is not its second one.
  const auto is_wall = [](const std::string& part) {
    return part.starts_with("<plane role='wall'");
  };
  const auto first = std::find_if(parts.begin(), parts.end(), is_wall);
  std::iter_swap(first, std::find_if(first + 1, parts.end(), is_wall));
  std::string shuffled = joined(parts);
  shuffled = edited(shuffled, "of='a percent'", "of='percent a'");
  shuffled = edited(shuffled, "<walls metres='0.6'/>", "");
  shuffled = edited(shuffled, "<inset metres='0.5'", "<walls metres='0.6'/><inset metres='0.5'");
  EXPECT_THAT(lines_of(kEverything, shuffled), IsEmpty());
}

TEST(PackDiff, AFormulaIsTheSameHoweverItIsWritten) {
  const auto with = [](const std::string& limit) {
    return edited(kEverything, "at-least='1 lx'", "at-least='" + limit + "'");
  };
  EXPECT_THAT(lines_of(with("0.50 lx + limit(a)"), with("(0.5 lx+limit(a))")), IsEmpty());
  EXPECT_THAT(lines_of(with("2 * 1 lx"), with("1 lx * 2")),
              ElementsAre("check idle: limit at-least 2 * 1 lx -> at-least 1 lx * 2"));
}

TEST(PackDiff, AmountsAreComparedInBaseUnits) {
  const std::string feet = edited(
      edited(kEverything, "'idle' unit='lx' values='1 2'", "'idle' unit='m' values='3.048 6.096'"),
      "role='desk'>", "role='desk'>");
  const std::string metres =
      edited(feet, "unit='m' values='3.048 6.096'", "unit='ft' values='10 20'");
  EXPECT_THAT(lines_of(feet, metres), ElementsAre("scale idle: unit m -> ft"));
}

// Of parts with nothing to be held against.
TEST(PackDiff, PartsThatOnlyOnePackHas) {
  const std::vector<std::pair<std::string, std::string>> parts{
      {"<source id='n' note='n'/>", "source n"},
      {"<parameter id='n' unit='lx' meaning='m'/>", "parameter n"},
      {"<fact id='n' unit='lx' meaning='m'/>", "fact n"},
      {"<table id='n' key-unit='lx' value-unit='lx' match='exact'><entry key='1' "
       "value='2'/></table>",
       "table n"},
      {"<scale id='n' unit='lx' values='1 2'/>", "scale n"},
      {"<mask id='n'><inset metres='1'/></mask>", "mask n"},
      {"<grid id='n' method='project' count='given'/>", "grid n"},
      {"<plane role='desk' orientation='free'/>", "plane desk-2"},
      {"<row ref='n' name='n' trust='confirmed'/>", "row n"},
      {"<aggregate id='n' rule='all' of='a'/>", "aggregate n"},
      {"<class id='n' rows='1.1' of='a'/>", "class n"}};
  for (const auto& [xml, name] : parts) {
    const std::string more = edited(kEverything, "</rule-pack>", xml + "</rule-pack>");
    EXPECT_THAT(lines_of(kEverything, more), ElementsAre(name + " added"));
    EXPECT_THAT(lines_of(more, kEverything), ElementsAre(name + " removed"));
  }
}

// What is added is told with all that it has.
TEST(PackDiff, AnAddedRowHasItsValues) {
  const std::string more = edited(
      kEverything, "</rule-pack>",
      "<row ref='n' name='new' trust='confirmed'><value of='E' required='200'/></row></rule-pack>");
  const std::vector<PartDifference> parts = diff_of(pack_of(kEverything), pack_of(more));
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].title, "new");
  std::vector<std::string> fields;
  for (const FieldDifference& field : parts[0].fields) {
    EXPECT_FALSE(field.before);
    fields.push_back(field.name + "=" + field.after->text);
  }
  EXPECT_THAT(fields, ElementsAre("ref=n", "name=new", "trust=confirmed", "E=200 lx"));
}

// Rows `1.1`, with E of a lower and R of an upper limit.
std::vector<std::string> change(const std::string& was, const std::string& is) {
  return lines_of(kEverything, edited(kEverything, was, is));
}

TEST(Tightening, AHigherLowerLimitIsStricterAndAHigherUpperLimitEasier) {
  EXPECT_THAT(change("required='300'", "required='200'"),
              ElementsAre("row 1.1: E 300 lx -> 200 lx [easier]"));
  EXPECT_THAT(change("required='300'", "required='400'"),
              ElementsAre("row 1.1: E 300 lx -> 400 lx [stricter]"));
  EXPECT_THAT(change("modified='500'", "modified='400'"),
              ElementsAre("row 1.1: E modified 500 lx -> 400 lx [easier]"));
  EXPECT_THAT(change(" modified='500'", ""),
              ElementsAre("row 1.1: E modified 500 lx -> - [easier]"));
  EXPECT_THAT(change("required='19'", "required='22'"),
              ElementsAre("row 1.1: R 19 -> 22 [easier]"));
  EXPECT_THAT(change("required='19'", "required='16'"),
              ElementsAre("row 1.1: R 19 -> 16 [stricter]"));
}

TEST(Tightening, EachChangeIsJudgedByItself) {
  EXPECT_THAT(change("required='300' modified='500'", "required='400' modified='450'"),
              ElementsAre("row 1.1: E 300 lx -> 400 lx [stricter]",
                          "row 1.1: E modified 500 lx -> 450 lx [easier]"));
}

TEST(Tightening, AValueThatIsNotKnownIsNeither) {
  EXPECT_THAT(change("of='E' none='unknown'", "of='E' required='200'"),
              ElementsAre("row 1.2: E unknown -> 200 lx"));
  EXPECT_THAT(change("of='E' none='unknown'", "of='E' none='not-specified'"),
              ElementsAre("row 1.2: E unknown -> not-specified"));
}

// Two ways to meet one requirement come and go together.
TEST(Tightening, ARequirementMoreIsStricter) {
  EXPECT_THAT(change("of='R' none='not-specified'", "of='R' required='22'"),
              ElementsAre("row 1.2: R not-specified -> 22 [stricter]"));
  EXPECT_THAT(change("of='R' required='19'", "of='R' none='not-applicable'"),
              ElementsAre("row 1.1: R 19 -> not-applicable [easier]"));
  EXPECT_THAT(change("of='R' none='not-specified'", "of='R' none='not-applicable'"),
              ElementsAre("row 1.2: R not-specified -> not-applicable"));
}

TEST(Tightening, OneMoreWayToMeetARequirementIsNoRequirementMore) {
  // The table's limit has a value of its own.
  const std::string own = edited(kEverything, "statistic='value' at-most='row(R)'",
                                 "statistic='value' at-most='row(idle)'");
  EXPECT_THAT(
      lines_of(own, edited(own, "<value of='R' required='19'/>",
                           "<value of='R' required='19'/><value of='idle' required='19'/>")),
      ElementsAre("row 1.1: idle - -> 19"));
  // E is of an aggregate of which one check is enough.
  EXPECT_THAT(change("of='E' required='300' modified='500'", "of='E' none='not-specified'"),
              Contains("row 1.1: E 300 lx -> not-specified"));
}

TEST(Tightening, AValueInTheLimitsOfBothKindsIsNeither) {
  const std::string both = edited(kEverything, "less-than='7 lx'", "less-than='2 * row(E)'");
  EXPECT_THAT(lines_of(both, edited(both, "required='300'", "required='200'")),
              ElementsAre("row 1.1: E 300 lx -> 200 lx"));
}

TEST(Tightening, AValueThatOnlyOnePackUsesIsNeither) {
  const std::string unused = edited(kEverything, "at-least='row(E)'", "at-least='5 lx'");
  const std::string none = edited(unused, "at-least='table(t, row(E))'", "at-least='6 lx'");
  EXPECT_THAT(lines_of(none, edited(kEverything, "required='300'", "required='400'")),
              Contains("row 1.1: E 300 lx -> 400 lx"));
  EXPECT_THAT(lines_of(kEverything, edited(none, "required='300'", "required='400'")),
              Contains("row 1.1: E 300 lx -> 400 lx"));
}

// In a divisor a higher value makes the limit lower.
TEST(Tightening, ADivisorTurnsItRound) {
  const std::string divided =
      edited(edited(kEverything, "at-least='row(E)'", "at-least='100 lx / row(E) * 9 lx'"),
             "at-least='table(t, row(E))'", "at-least='6 lx'");
  EXPECT_THAT(lines_of(divided, edited(divided, "required='300'", "required='200'")),
              ElementsAre("row 1.1: E 300 lx -> 200 lx [stricter]"));
}

TEST(Tightening, OfTablesByWhatTheirRowsMakeOfThem) {
  EXPECT_THAT(change("value='150'", "value='180'"),
              ElementsAre("table t: key 200 lx 150 lx -> 180 lx [stricter]"));
  EXPECT_THAT(change("value='150'", "value='100'"),
              ElementsAre("table t: key 200 lx 150 lx -> 100 lx [easier]"));
  EXPECT_THAT(change("<entry key='200' value='150'/>", ""),
              ElementsAre("table t: key 200 lx 150 lx -> - [stricter]"));
  EXPECT_THAT(change("value='8'", "value='9'"),  // nothing uses it
              ElementsAre("table idle: key 7 lx 8 lx -> 9 lx"));
}

TEST(Tightening, OfLimits) {
  const std::string line = "check idle: limit at-least 1 lx -> ";
  EXPECT_THAT(change("at-least='1 lx'", "at-least='2 lx'"),
              ElementsAre(line + "at-least 2 lx [stricter]"));
  EXPECT_THAT(change("at-least='1 lx'", "at-least='0.5 lx'"),
              ElementsAre(line + "at-least 0.5 lx [easier]"));
  EXPECT_THAT(change("at-least='1 lx'", "more-than='1 lx'"),
              ElementsAre(line + "more-than 1 lx [stricter]"));
  EXPECT_THAT(change("at-least='1 lx'", "at-most='2 lx'"), ElementsAre(line + "at-most 2 lx"));
  EXPECT_THAT(change("less-than='7 lx'", "less-than='8 lx'"),
              ElementsAre("check percent: limit less-than 7 lx -> less-than 8 lx [easier]"));
  EXPECT_THAT(change("less-than='7 lx'", "at-most='7 lx'"),
              ElementsAre("check percent: limit less-than 7 lx -> at-most 7 lx [easier]"));
}

// Higher is stricter for `idle`, and easier for what may be twice as much.
TEST(Tightening, OfLimitsInTheLimitsOfOthers) {
  const auto with = [](const std::string& limit) {
    return edited(kEverything, "less-than='7 lx'", limit);
  };
  const std::string lower = with("at-least='2 * limit(idle)'");
  const std::string upper = with("at-most='2 * limit(idle)'");
  const std::string line = "check idle: limit at-least 1 lx -> at-least 2 lx";
  const auto raised = [](const std::string& pack) {
    return edited(pack, "at-least='1 lx'", "at-least='2 lx'");
  };
  EXPECT_THAT(lines_of(lower, raised(lower)), ElementsAre(line + " [stricter]"));
  EXPECT_THAT(lines_of(upper, raised(upper)), ElementsAre(line));
}

// Of 1.2 nobody knows a limit, before or after.
TEST(Tightening, OfLimitsThatHangOnRows) {
  EXPECT_THAT(change("at-least='row(E)'", "at-least='2 * row(E)'"),
              ElementsAre("check a: limit at-least row(E) -> at-least 2 * row(E) [stricter]"));
  const std::string known = edited(kEverything, "of='E' none='unknown'", "of='E' required='100'");
  EXPECT_THAT(lines_of(known, edited(known, "at-least='row(E)'", "at-least='2 * row(E)'")),
              ElementsAre("check a: limit at-least row(E) -> at-least 2 * row(E) [stricter]"));
  // Higher for one row and lower for the other.
  EXPECT_THAT(lines_of(known, edited(known, "at-least='row(E)'", "at-least='200 lx'")),
              ElementsAre("check a: limit at-least row(E) -> at-least 200 lx"));
}

// The table has nothing for 300 lx.
TEST(Tightening, ALimitThatIsKnownNoMoreIsNeither) {
  const std::string known =
      edited(edited(kEverything, "of='E' none='unknown'", "of='E' required='200'"),
             "<entry key='7' value='8'/>", "<entry key='200' value='250'/>");
  EXPECT_THAT(lines_of(known, edited(known, "at-least='row(E)'", "at-least='table(idle, row(E))'")),
              ElementsAre("check a: limit at-least row(E) -> at-least table(idle, row(E))"));
}

TEST(Tightening, WhatHangsOnFactsOrResultsIsNeither) {
  for (const std::string with : {"fact(f)", "result(percent)"}) {
    EXPECT_THAT(change("at-least='row(E)'", "at-least='2 * " + with + "'"),
                ElementsAre("check a: limit at-least row(E) -> at-least 2 * " + with));
    const std::string hangs =
        edited(kEverything, "at-least='row(E)'", "at-least='min(row(E), " + with + ")'");
    EXPECT_THAT(lines_of(hangs, edited(hangs, "required='300'", "required='400'")),
                ElementsAre("row 1.1: E 300 lx -> 400 lx"));
    // But what else is in the pack may.
    EXPECT_THAT(lines_of(hangs, edited(hangs, "required='19'", "required='16'")),
                ElementsAre("row 1.1: R 19 -> 16 [stricter]"));
  }
}

TEST(Tightening, ALimitOfSomethingElseIsNeither) {
  EXPECT_THAT(
      change("statistic='average' at-least='1 lx'", "statistic='minimum' at-least='0.5 lx'"),
      ElementsAre("check idle: statistic average -> minimum",
                  "check idle: limit at-least 1 lx -> at-least 0.5 lx"));
}

// Neither pack alone can tell what the other's formula is worth.
TEST(Tightening, OfFormulasThatTheOtherPackCannotHave) {
  const std::string more =
      edited(kEverything, "</rule-pack>",
             "<check id='b' role='desk' quantity='planar' statistic='average' at-least='3 lx'/>"
             "</rule-pack>");
  EXPECT_THAT(lines_of(kEverything, edited(more, "at-least='1 lx'", "at-least='limit(b)'")),
              Contains("check idle: limit at-least 1 lx -> at-least limit(b)"));
}

TEST(Tightening, OfChecksThatAreThereOrNot) {
  const auto with = [](const std::string& attributes) {
    return edited(kEverything, "</rule-pack>",
                  "<check id='b' role='desk' quantity='planar' statistic='average' " + attributes +
                      "/></rule-pack>");
  };
  EXPECT_THAT(lines_of(kEverything, with("at-least='3 lx'")),
              ElementsAre("check b added [stricter]"));
  EXPECT_THAT(lines_of(with("at-least='3 lx'"), kEverything),
              ElementsAre("check b removed [easier]"));
  EXPECT_THAT(lines_of(kEverything, with("severity='info' at-least='3 lx'")),
              ElementsAre("check b added"));
  EXPECT_THAT(lines_of(kEverything, with("instead-of='idle' at-least='3 lx'")),
              ElementsAre("check b added"));
}

TEST(Tightening, OfSeverityToleranceCountAndShare) {
  EXPECT_THAT(change("severity='should' quantity", "severity='shall' quantity"),
              ElementsAre("check a: severity advice -> shall [stricter]"));
  const std::string counts = edited(kEverything, "severity='should' clause='7'", "clause='7'");
  EXPECT_THAT(lines_of(counts, edited(counts, "severity='should' quantity",
                                      "severity='in-aggregate' quantity")),
              ElementsAre("check a: severity advice -> in-aggregate"));
  EXPECT_THAT(change("tolerance='0.01'", "tolerance='0.02'"),
              ElementsAre("policy: tolerance 0.01 -> 0.02 [easier]"));
  EXPECT_THAT(change("count='1'", "count='2'"),
              ElementsAre("aggregate x: count 1 -> 2 [stricter]"));
  EXPECT_THAT(change("share='0.9'", "share='0.8'"),
              ElementsAre("aggregate y: share 0.9 -> 0.8 [easier]"));
}

// A pack of one's own may be any: `a` asks for what `b` of the other pack asks for.
TEST(Tightening, CirclesThatOnlyBothPacksTogetherHaveAreNeither) {
  const auto with = [](const std::string& a, const std::string& b) {
    return edited(kEverything, "</rule-pack>",
                  "<check id='p' role='desk' quantity='planar' statistic='average' at-least='" + a +
                      "'/><check id='q' role='desk' quantity='planar' statistic='average' "
                      "at-least='" +
                      b + "'/></rule-pack>");
  };
  EXPECT_THAT(lines_of(with("limit(q)", "3 lx"), with("3 lx", "limit(p)")),
              ElementsAre("check p: limit at-least limit(q) -> at-least 3 lx",
                          "check q: limit at-least 3 lx -> at-least limit(p)"));
}

TEST(RowNames, ARenumberedRowIsOneRow) {
  const std::string after = edited(
      edited(edited(kEverything, "ref='1.1'", "ref='34.2'"), "rows='1.1 1.2'", "rows='34.2 1.2'"),
      "required='300'", "required='400'");
  EXPECT_THAT(
      lines_of(kEverything, after, {{"1.1", "34.2"}}),
      ElementsAre("row 1.1=34.2: ref 1.1 -> 34.2", "row 1.1=34.2: E 300 lx -> 400 lx [stricter]"));
  EXPECT_THAT(lines_of(kEverything, after), ElementsAre("row 1.1 removed", "row 34.2 added",
                                                        "class c: rows 1.1, 1.2 -> 34.2, 1.2"));
}

// 1.1 of the first pack is 1.2 of the second; what is 1.2 in the first one is gone.
TEST(RowNames, ANumberMayMeanAnotherRow) {
  const std::string after =
      edited(edited(edited(kEverything, "ref='1.2'", "ref='1.3'"), "ref='1.1'", "ref='1.2'"),
             "rows='1.1 1.2'", "rows='1.2'");
  EXPECT_THAT(lines_of(kEverything, after, {{"1.1", "1.2"}}),
              ElementsAre("row 1.1=1.2: ref 1.1 -> 1.2", "row 1.2 removed", "row 1.3 added",
                          "class c: rows 1.1, 1.2 -> 1.2"));
}

TEST(RowNames, LikelyOnesHaveOneNameThatNoOtherHas) {
  const std::string after =
      edited(edited(kEverything, "ref='1.1'", "ref='2.1'"), "rows='1.1 1.2'", "rows='2.1 1.2'");
  EXPECT_EQ(likely_row_names(diff_of(pack_of(kEverything), pack_of(after))),
            (RowNames{{"1.1", "2.1"}}));
  const std::string twice =
      edited(after, "</rule-pack>", "<row ref='2.2' name='shop' trust='confirmed'/></rule-pack>");
  EXPECT_THAT(likely_row_names(diff_of(pack_of(kEverything), pack_of(twice))), IsEmpty());
}

TEST(RowNames, AreOfRowsThatAreThereAndEachOnce) {
  const RulePack pack = pack_of(kEverything);
  const auto problem = [&](const std::vector<std::string>& texts) {
    return read_row_names(texts, pack, pack).problem;
  };
  EXPECT_EQ(read_row_names({"1.1=1.2", "1.2=1.1"}, pack, pack).names,
            (RowNames{{"1.1", "1.2"}, {"1.2", "1.1"}}));
  EXPECT_EQ(problem({"1.1"}), "'1.1' is not FROM=TO");
  EXPECT_EQ(problem({"9=1.1"}), "own:2024 has no row '9'");
  EXPECT_EQ(problem({"1.1=9"}), "own:2024 has no row '9'");
  EXPECT_EQ(problem({"1.1=1.1", "1.1=1.2"}), "row '1.1' is matched twice");
  EXPECT_EQ(problem({"1.1=1.1", "1.2=1.1"}), "row '1.1' is matched twice");
}

}  // namespace
}  // namespace rules::pack_diff_test
