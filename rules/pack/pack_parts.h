#pragma once
// Readers for the elements of a rule pack file; rule_pack_reader.cpp calls them. All errors are
// reported; an element with an error is returned in a harmless form.

#include "calc/base/diagnostics.h"
#include "calc/base/xml_document.h"
#include "calc/base/xml_reader.h"
#include "rules/pack/rule_pack.h"

#include <optional>
#include <string_view>
#include <utility>

namespace rules {

RuleSource read_source(const calc::XmlElement& element, calc::Diagnostics& diagnostics);
// Reads <parameter> or <fact>.
RuleName read_name(const calc::XmlElement& element, calc::Diagnostics& diagnostics);
DecisionPolicy read_policy(const calc::XmlElement& element, calc::Diagnostics& diagnostics);
// Reads a row. Values are in the units of pack.parameters, sources are from pack.sources.
RuleRow read_row(const calc::XmlElement& element, const RulePack& pack,
                 calc::Diagnostics& diagnostics);
RuleTable read_table(const calc::XmlElement& element, calc::Diagnostics& diagnostics);
RuleScale read_scale(const calc::XmlElement& element, calc::Diagnostics& diagnostics);
Mask read_mask(const calc::XmlElement& element, calc::Diagnostics& diagnostics);
RuleGrid read_grid(const calc::XmlElement& element, calc::Diagnostics& diagnostics);
RulePlane read_plane(const calc::XmlElement& element, const RulePack& pack,
                     calc::Diagnostics& diagnostics);
// Checks the zones that planes surround, once all planes are read.
void check_zones(const RulePack& pack, const calc::XmlElement& root,
                 calc::Diagnostics& diagnostics);
// Reads a check, with a mask of pack.masks. check_rule_pack() looks up the names in its formula.
RuleCheck read_check(const calc::XmlElement& element, const RulePack& pack,
                     calc::Diagnostics& diagnostics);
RuleAggregate read_aggregate(const calc::XmlElement& element, calc::Diagnostics& diagnostics);
RuleClass read_class(const calc::XmlElement& element, calc::Diagnostics& diagnostics);

// Reads the attribute "unit", or another attribute that names a unit.
Unit read_unit(calc::ElementReader& reader, std::string_view attribute);
// Reads the attribute "trust"; returns confirmed if it is optional and absent.
Trust read_trust(calc::ElementReader& reader);
// Reads two heights in ascending order, in metres; empty without the attribute. Reports errors.
std::optional<std::pair<double, double>> read_heights(calc::ElementReader& reader,
                                                      std::string_view name);
// Reads ids separated by blanks; empty after an error.
std::vector<std::string> read_ids(calc::ElementReader& reader, std::string_view attribute);

// Reports "attribute of <element>: there is no kind 'found'; allowed: ...".
void report_unknown_name(calc::Diagnostics& diagnostics, const calc::SourceLocation& where,
                         std::string_view attribute, std::string_view element,
                         std::string_view kind, std::string_view found, const calc::Names& choices);

}  // namespace rules
