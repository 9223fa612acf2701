// Reads a rule pack file as a whole.

#include "calc/base/diagnostic_ids.h"
#include "calc/base/file_kind.h"
#include "calc/base/text.h"
#include "calc/base/xml_document.h"
#include "calc/base/xml_encoding.h"
#include "calc/base/xml_reader.h"
#include "rules/pack/pack_elements.h"
#include "rules/pack/pack_parts.h"
#include "rules/pack/rule_pack.h"
#include "rules/pack/rule_pack_check.h"

#include <algorithm>
#include <utility>

namespace rules {
namespace {

using calc::DiagnosticId;
using calc::ElementReader;

void read_header(ElementReader& reader, RulePack& pack) {
  reader.allow(kRulePackElement);
  const auto choice = [&](std::string_view name, const calc::Names& names) {
    return std::string(names[reader.choice(name, names)]);
  };
  pack.id = reader.id();
  pack.edition = reader.id("edition");
  pack.title = reader.text("title");
  pack.version = reader.id("version");
  pack.kind = choice("kind", kPackKindType.words);
  pack.status = choice("status", kPackStatusType.words);
  pack.jurisdiction = reader.text_or("jurisdiction", "");
  pack.licence = choice("licence", kPackLicenceType.words);
  pack.licence_note = reader.text_or("licence-note", "");
  pack.role = reader.id("role");
}

// Adds `item` unless its name, `key`, is already taken.
template <class Item, class Key>
void add(std::vector<Item>& items, Item item, Key key, std::string_view attribute,
         const calc::XmlElement& element, calc::Diagnostics& diagnostics) {
  const std::string& name = item.*key;
  const bool is_taken = std::any_of(items.begin(), items.end(), [&](const Item& other) {
    return !name.empty() && other.*key == name;
  });
  if (is_taken) {
    const calc::XmlAttribute* at = element.find(attribute);
    diagnostics.report(DiagnosticId::rule_name_twice, at ? at->where : element.where, element.name,
                       name);
  }
  items.push_back(std::move(item));
}

// Reads parts in the order of the table, in which a part follows all parts that it names, whatever
// the order in the file; formulas are checked last.
void read_parts(const calc::XmlElement& root, RulePack& pack, calc::Diagnostics& diagnostics) {
  bool has_policy = false;
  for (const std::string_view name : child_names(kRulePackElement)) {
    for (const calc::XmlElement& e : root.children) {
      if (e.name != name) continue;
      calc::Diagnostics& d = diagnostics;
      if (name == "source") add(pack.sources, read_source(e, d), &RuleSource::id, "id", e, d);
      if (name == "parameter") add(pack.parameters, read_name(e, d), &RuleName::id, "id", e, d);
      if (name == "fact") add(pack.facts, read_name(e, d), &RuleName::id, "id", e, d);
      if (name == "table") add(pack.tables, read_table(e, d), &RuleTable::id, "id", e, d);
      if (name == "scale") add(pack.scales, read_scale(e, d), &RuleScale::id, "id", e, d);
      if (name == "mask") add(pack.masks, read_mask(e, d), &Mask::id, "id", e, d);
      if (name == "grid") add(pack.grids, read_grid(e, d), &RuleGrid::id, "id", e, d);
      if (name == "plane") pack.planes.push_back(read_plane(e, pack, d));
      if (name == "row") add(pack.rows, read_row(e, pack, d), &RuleRow::ref, "ref", e, d);
      if (name == "check") add(pack.checks, read_check(e, pack, d), &RuleCheck::id, "id", e, d);
      if (name == "aggregate") {
        add(pack.aggregates, read_aggregate(e, d), &RuleAggregate::id, "id", e, d);
      }
      if (name == "class") add(pack.classes, read_class(e, d), &RuleClass::id, "id", e, d);
      if (name == "policy") {
        if (has_policy) d.report(DiagnosticId::rule_name_twice, e.where, "policy", "policy");
        has_policy = true;
        pack.policy = read_policy(e, d);
      }
    }
  }
}

RulePack read_pack(const calc::XmlElement& root, const std::string& file,
                   calc::Diagnostics& diagnostics) {
  ElementReader reader(root, diagnostics);
  RulePack pack;
  pack.file = file;
  read_header(reader, pack);
  read_parts(root, pack, diagnostics);
  check_zones(pack, root, diagnostics);
  if (pack.checks.empty()) {
    reader.report(DiagnosticId::missing_form, root.where, "rule-pack", "at least one <check>");
  }
  const std::vector<std::string> roles = pack.roles();
  const calc::Names names(roles.begin(), roles.end());
  if (!pack.role.empty() && !roles.empty() &&
      std::find(roles.begin(), roles.end(), pack.role) == roles.end()) {
    report_unknown_name(diagnostics, reader.where("role"), "role", "rule-pack", "check with role",
                        pack.role, names);
  }
  return pack;
}

}  // namespace

std::optional<RulePack> parse_rule_pack(std::string_view xml, const std::string& file,
                                        calc::Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  if (!calc::check_file_kind(xml, file, calc::FileUse::rule_pack, diagnostics,
                             calc::looks_like_xml(xml))) {
    return std::nullopt;
  }
  // Of a foreign file nothing is said but that.
  const calc::XmlText text =
      calc::has_first_element(xml, "rule-pack") ? calc::XmlText::refuse : calc::XmlText::keep;
  const std::optional<calc::XmlElement> root =
      calc::parse_xml(std::string(xml), file, diagnostics, text);
  if (!root) return std::nullopt;
  if (root->name != "rule-pack") {
    diagnostics.report(DiagnosticId::wrong_root_element, root->where, root->name, "rule-pack");
    return std::nullopt;
  }
  const RulePack pack = read_pack(*root, file, diagnostics);
  // Formulas that could not be read would only be found wrong a second time.
  if (diagnostics.error_count() == errors_before) check_rule_pack(pack, diagnostics);
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  return pack;
}

}  // namespace rules
