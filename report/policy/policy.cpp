#include "report/policy/policy.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/element_table.h"
#include "calc/base/file_hash.h"
#include "calc/base/file_kind.h"
#include "calc/base/text.h"
#include "calc/base/xml_document.h"
#include "calc/base/xml_encoding.h"
#include "calc/base/xml_reader.h"
#include "calc/base/xml_schema.h"
#include "calc/project/reading/project_elements.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>
#include <utility>

namespace report {
namespace {

using enum calc::Presence;
using calc::AttributeRow;
using calc::DiagnosticId;
using calc::ElementReader;
using calc::ElementRow;
using calc::kAnyText;
using calc::kIdType;
using calc::kTextType;
using calc::NumberRange;
using calc::ValueType;
using calc::XmlElement;

constexpr std::string_view kRoot = "luxgate-policy";
constexpr NumberRange kLevel{0.5, 1.0, true, "a number between 0.5 and 1"};
constexpr NumberRange kFactValue{-1.0e12, 1.0e12, false, "a number from -1e12 to 1e12"};
constexpr NumberRange kFactor{0.0, 100.0, false, "a number from 0 to 100"};

const ValueType kIdsType{.name = "ids", .item = &kIdType, .least = 1};
const ValueType kYesNoType{.name = "yesNo", .base = &kAnyText, .words = {"yes", "no"}};
const ValueType kVersionType{.name = "version", .base = &kAnyText, .words = {"1"}};
const ValueType kCountType{"xs:positiveInteger"};
const ValueType kLevelType{.name = "level", .base = &calc::kAnyDouble, .range = kLevel};
const ValueType kShareType{
    .name = "share", .base = &calc::kAnyDouble, .range = calc::kPositiveFraction};
const ValueType kFactorType{.name = "factor", .base = &calc::kAnyDouble, .range = kFactor};
const ValueType kZonesType{
    .name = "zones", .base = &kAnyText, .words = calc::names_of<PolicyZones>()};
const ValueType kEverySpaceType{
    .name = "everySpace", .base = &kAnyText, .words = calc::names_of<PolicyEverySpace>()};
const ValueType kHashType{.name = "sha256", .base = &kAnyText, .pattern = "[0-9a-f]{64}"};
const ValueType kBoundOfType{
    .name = "boundOf", .base = &kAnyText, .words = calc::names_of<PolicyBoundOf>()};

const ElementRow kPermitElement{
    .type = "permit",
    .meaning = "Who may agree to this. Without the element nobody may.",
    .attributes = {{"by", &kAnyText, optional,
                    "Names, separated by ';', as the project writes them.", "anybody"},
                   {"most-days", &kCountType, optional,
                    "From the day of judging to the last day that is stated.", "any number"}}};

const ElementRow kRowElement{
    .type = "asked",
    .meaning = "A row of a rule pack that these spaces must require as a whole.",
    .attributes = {
        {"pack", &kIdType, required, "With its edition: en12464-1:2021."},
        {"row", &kTextType, required},
        {"projects", &kTextType, optional,
         "A pattern for paths of projects, as of a shell: */office-*.xml.", "*"},
        {"spaces", &kTextType, optional,
         "A pattern for ids or names of spaces, as of a shell: office-*.", "*"},
        {"at-least", &kCountType, optional,
         "The least number of matching spaces in each of these projects.", "1"},
        {"zones", &kZonesType, optional,
         "workplace: it must be required by <workplace> elements, which make the zones as the pack "
         "requires. unchanged: also, no zone may be changed.",
         "any"},
        {"floor-share", &kShareType, optional,
         "Planes of the role must cover this share of the room's floor, seen from above.", "any"},
        {"role", &kIdType, optional, "The role of floor-share.", "task"}}};

const ElementRow kFactElement{
    .type = "fact",
    .meaning = "A fact that projects may state, in this range. Others may not be stated.",
    .attributes = {{"pack", &kIdType, required, "With its edition: en1838:2024."},
                   {"id", &kIdType, required, "As of the pack: task-illuminance."},
                   {"at-least", &calc::kAnyDouble, optional, "In lx, m, cd, or plain."},
                   {"at-most", &calc::kAnyDouble}}};

const ElementRow kPhotometryElement{
    .type = "photometry",
    .meaning = "A photometry file that may be used. Without such elements any may.",
    .attributes = {{"sha256", &kHashType, required, "As the report has it, and sha256sum."},
                   {"name", &kTextType, optional, "For people.", ""}}};

const ElementRow kBoundElement{
    .type = "bound",
    .meaning = "A range that each luminaire type or material in use must have.",
    .attributes = {{"of", &kBoundOfType, required,
                    "flux-ratio, power-ratio: the project's lumens and watts to those of the "
                    "photometry file."},
                   {"at-least", &kFactorType},
                   {"at-most", &kFactorType}}};

const ElementRow kAccuracyElement{
    .type = "accuracy",
    .meaning = "The least accuracy of the calculation.",
    .attributes = {{"confidence", &kLevelType, optional, "At least, see --confidence."},
                   {"tolerance", &kShareType, optional, "At most, see --tolerance."},
                   {"replicates", &kCountType, optional, "At least, see --replicates."},
                   {"max-paths", &kCountType, optional, "At least, see --max-paths."}}};

const ElementRow kProjectElement{
    .type = "project",
    .meaning = "A project that must be in the batch.",
    .attributes = {{"path", &kTextType, required, "Or its end: designs/office.xml."}}};

const ElementRow kFatalElement{.type = "fatalWarnings",
                               .meaning = "Warnings that count like errors, as with --strict.",
                               .attributes = {{"ids", &kIdsType, required, "Or: all."}}};

const ElementRow kFormatElement{.type = "format",
                                .meaning = "A format that must be written, see --format.",
                                .attributes = {{"kind", &kIdType, required}}};

const ElementRow kPolicyElement{
    .type = "policy",
    .attributes = {{"version", &kVersionType, required},
                   {"name", &kTextType, required, "As reports call it."},
                   {"every-space", &kEverySpaceType, optional,
                    "What each space must require. row: a row of an <asked> whose patterns match "
                    "it (anything if there is no <asked>). anything: a requirement that counts.",
                    "row"},
                   {"lowered-levels", &kYesNoType, optional,
                    "Rows may be required below their values (level=\"-1\").", "no"}},
    .children = {{"waivers", &kPermitElement},
                 {"deviations", &kPermitElement},
                 {"left-out", &kPermitElement},
                 {"asked", &kRowElement},
                 {"bound", &kBoundElement},
                 {"fact", &kFactElement},
                 {"photometry", &kPhotometryElement},
                 {"accuracy", &kAccuracyElement},
                 {"project", &kProjectElement},
                 {"fatal-warnings", &kFatalElement},
                 {"format", &kFormatElement}}};

const calc::ChildRow kRootRow{.name = kRoot, .row = &kPolicyElement};

// Elements that there may be one of.
constexpr std::array kSingle{std::pair{std::string_view("waivers"), &Policy::waivers},
                             std::pair{std::string_view("deviations"), &Policy::deviations},
                             std::pair{std::string_view("left-out"), &Policy::left_out}};

std::vector<std::string> names_in(std::string_view text) {
  std::vector<std::string> names;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(';'), text.size());
    if (const std::string_view name = calc::trim(text.substr(0, end)); !name.empty()) {
      names.emplace_back(name);
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return names;
}

PolicyPermit read_permit(ElementReader& reader) {
  reader.allow(kPermitElement);
  PolicyPermit permit;
  if (reader.has("by")) {
    permit.by = names_in(reader.text("by"));
    if (permit.by.empty()) {
      reader.report(DiagnosticId::empty_attribute, reader.where("by"), "by", reader.element().name);
    }
  }
  if (reader.has("most-days")) permit.most_days = reader.integer("most-days", 1);
  return permit;
}

void check_edition(ElementReader& reader, const std::string& pack) {
  if (pack.find(':') != std::string::npos || !reader.has("pack")) return;
  reader.report(DiagnosticId::policy_not_usable, reader.where("pack"),
                fmt::format("'{}' has no edition; write id:edition, such as en12464-1:2021", pack));
}

PolicyRow read_row(ElementReader& reader) {
  reader.allow(kRowElement);
  PolicyRow row;
  row.pack = reader.id("pack");
  row.row = reader.text("row");
  row.projects = reader.text_or("projects", "*");
  row.spaces.pattern = reader.text_or("spaces", "*");
  if (reader.has("at-least")) row.at_least = reader.integer("at-least", 1);
  if (reader.has("zones")) row.zones = reader.value<PolicyZones>("zones");
  row.floor_share = reader.optional_number("floor-share", calc::kPositiveFraction);
  if (reader.has("role")) {
    row.role = reader.id("role");
    reader.require_together("role", "floor-share");
  }
  check_edition(reader, row.pack);
  return row;
}

PolicyFact read_fact(ElementReader& reader) {
  reader.allow(kFactElement);
  PolicyFact fact;
  fact.pack = reader.id("pack");
  fact.id = reader.id("id");
  fact.at_least = reader.optional_number("at-least", kFactValue);
  fact.at_most = reader.optional_number("at-most", kFactValue);
  check_edition(reader, fact.pack);
  return fact;
}

std::string read_photometry(ElementReader& reader) {
  reader.allow(kPhotometryElement);
  reader.text_or("name", "");
  std::string sha256 = reader.text("sha256");
  constexpr std::size_t kDigits = 64;
  if (reader.has("sha256") && (sha256.size() != kDigits ||
                               sha256.find_first_not_of("0123456789abcdef") != std::string::npos)) {
    reader.report(DiagnosticId::policy_not_usable, reader.where("sha256"),
                  fmt::format("'{}' is not a SHA-256; expected 64 digits of 0-9 and a-f", sha256));
  }
  return sha256;
}

PolicyBound read_bound(ElementReader& reader) {
  reader.allow(kBoundElement);
  PolicyBound bound;
  bound.of = reader.value<PolicyBoundOf>("of");
  bound.at_least = reader.optional_number("at-least", kFactor);
  bound.at_most = reader.optional_number("at-most", kFactor);
  if (!reader.has("at-least") && !reader.has("at-most")) {
    reader.report(DiagnosticId::missing_form, reader.where(), "bound", "'at-least' or 'at-most'");
  }
  return bound;
}

void read_accuracy(ElementReader& reader, Policy& policy) {
  reader.allow(kAccuracyElement);
  policy.confidence = reader.optional_number("confidence", kLevel);
  policy.tolerance = reader.optional_number("tolerance", calc::kPositiveFraction);
  if (reader.has("replicates")) policy.replicates = reader.integer("replicates", 1);
  if (reader.has("max-paths")) {
    policy.max_paths = static_cast<std::uint64_t>(reader.integer("max-paths", 1));
  }
}

void read_fatal(ElementReader& reader, Policy& policy) {
  reader.allow(kFatalElement);
  const std::string ids = reader.text("ids");
  for (const std::string_view name : calc::split_words(ids)) {
    if (name == "all") {
      policy.are_all_warnings_fatal = true;
      continue;
    }
    const auto id = calc::diagnostic_from_name(name);
    if (id && calc::diagnostic_severity(*id) == calc::Severity::warning) {
      policy.fatal_warnings.push_back(*id);
    } else {
      reader.report(DiagnosticId::policy_not_usable, reader.where("ids"),
                    fmt::format("'{}' is not the id of a warning", name));
    }
  }
}

void read_format(ElementReader& reader, const std::vector<std::string_view>& formats,
                 Policy& policy) {
  reader.allow(kFormatElement);
  const std::string kind = reader.id("kind");
  if (!reader.has("kind")) return;
  if (std::find(formats.begin(), formats.end(), kind) == formats.end()) {
    reader.report(
        DiagnosticId::policy_not_usable, reader.where("kind"),
        fmt::format("unknown format '{}'; allowed: {}", kind, calc::join_choices(formats)));
  }
  policy.formats.push_back(kind);
}

void read_child(const XmlElement& child, const std::vector<std::string_view>& formats,
                calc::Diagnostics& diagnostics, std::vector<std::string_view>& once,
                Policy& policy) {
  ElementReader reader(child, diagnostics);
  const std::string_view name = child.name;
  const bool is_first = std::find(once.begin(), once.end(), name) == once.end();
  bool is_single = name == "accuracy";
  for (const auto& [permit, member] : kSingle) {
    if (name != permit) continue;
    is_single = true;
    policy.*member = read_permit(reader);
  }
  if (name == "asked") policy.rows.push_back(read_row(reader));
  if (name == "bound") policy.bounds.push_back(read_bound(reader));
  if (name == "fact") policy.facts.push_back(read_fact(reader));
  if (name == "photometry") policy.photometry.push_back(read_photometry(reader));
  if (name == "accuracy") read_accuracy(reader, policy);
  if (name == "fatal-warnings") read_fatal(reader, policy);
  if (name == "format") read_format(reader, formats, policy);
  if (name == "project") {
    reader.allow(kProjectElement);
    policy.projects.push_back(reader.text("path"));
  }
  if (is_single && !is_first) {
    reader.report(DiagnosticId::policy_not_usable, child.where,
                  fmt::format("<{}> is given twice", name));
  }
  once.push_back(name);
}

std::string permit_text(std::string_view what, const std::optional<PolicyPermit>& permit) {
  if (!permit) return fmt::format("{}: nobody\n", what);
  std::string text =
      fmt::format("{}: {}", what,
                  permit->by.empty() ? "anybody" : fmt::format("{}", fmt::join(permit->by, ", ")));
  if (permit->most_days) text += fmt::format(", for at most {} days", *permit->most_days);
  return text + "\n";
}

std::string range_text(std::string_view of, const std::optional<double>& at_least,
                       const std::optional<double>& at_most) {
  std::string text = fmt::format("{}:", of);
  if (at_least) text += fmt::format(" at least {}", *at_least);
  if (at_least && at_most) text += " and";
  if (at_most) text += fmt::format(" at most {}", *at_most);
  if (!at_least && !at_most) text += " any value";
  return text + "\n";
}

std::string every_space_text(PolicyEverySpace asked) {
  switch (asked) {
    case PolicyEverySpace::row:
      return "each space must have a requirement of these rows, or any requirement if there are "
             "none\n";
    case PolicyEverySpace::anything:
      return "each space must have a requirement\n";
    case PolicyEverySpace::nothing:
      break;
  }
  return "spaces need no requirement\n";
}

// Of a row, behind its own line.
std::string zones_text(const PolicyRow& row) {
  std::string text;
  if (row.zones != PolicyZones::any) {
    text += fmt::format("  on zones of workplaces{}\n",
                        row.zones == PolicyZones::unchanged ? ", unchanged" : "");
  }
  if (row.floor_share) {
    text += fmt::format("  role '{}' on at least {} of the floor\n", row.role, *row.floor_share);
  }
  return text;
}

}  // namespace

bool PolicyRow::is_for(const std::string& project_path) const {
  const std::filesystem::path path = std::filesystem::path(project_path).lexically_normal();
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::absolute(path, error);
  // As it is named, or as it would be from any folder above it.
  return fnmatch(projects.c_str(), path.c_str(), 0) == 0 ||
         fnmatch(projects.c_str(), whole.c_str(), 0) == 0 ||
         fnmatch(("*/" + projects).c_str(), whole.c_str(), 0) == 0;
}

bool PolicySpaces::has(const std::string& id, const std::string& name) const {
  return fnmatch(pattern.c_str(), id.c_str(), 0) == 0 ||
         fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

std::optional<Policy> parse_policy(const std::string& bytes, const std::string& file,
                                   const std::vector<std::string_view>& formats,
                                   calc::Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  if (!calc::check_file_kind(bytes, file, calc::FileUse::policy, diagnostics,
                             calc::looks_like_xml(bytes))) {
    return std::nullopt;
  }
  const std::optional<XmlElement> root = calc::parse_xml(bytes, file, diagnostics);
  if (!root) return std::nullopt;
  if (root->name != kRoot) {
    diagnostics.report(DiagnosticId::wrong_root_element, root->where, root->name, kRoot);
    return std::nullopt;
  }
  Policy policy;
  policy.file = file;
  policy.sha256 = calc::sha256_hex(bytes);
  ElementReader reader(*root, diagnostics);
  reader.allow(kPolicyElement);
  reader.choice("version", kVersionType.words);
  policy.name = reader.text("name");
  policy.every_space = reader.value_or("every-space", PolicyEverySpace::row);
  policy.allows_lowered_levels = reader.choice_or("lowered-levels", kYesNoType.words, 1) == 0;
  std::vector<std::string_view> once;
  for (const XmlElement& child : root->children) {
    read_child(child, formats, diagnostics, once, policy);
  }
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  return policy;
}

std::string explain_policy(const Policy& policy) {
  std::string text = fmt::format("{}\nsha256 {}\n\n", policy.name, policy.sha256);
  text += permit_text("may waive what fails", policy.waivers);
  text += permit_text("may state a deviation from a standard", policy.deviations);
  text += permit_text("may leave out a zone of a row", policy.left_out);
  text += fmt::format("rows {} required at a level below their own\n",
                      policy.allows_lowered_levels ? "may be" : "may not be");
  text += every_space_text(policy.every_space);
  for (const std::string& project : policy.projects) {
    text += fmt::format("must be in the batch: {}\n", project);
  }
  for (const PolicyRow& row : policy.rows) {
    text += fmt::format(
        "must be required as a whole: {} {}, in spaces like '{}' of projects like '{}', at least "
        "{}\n",
        row.pack, row.row, row.spaces.pattern, row.projects, row.at_least);
    text += zones_text(row);
  }
  for (const PolicyFact& fact : policy.facts) {
    text +=
        range_text(fmt::format("fact '{}' of {}", fact.id, fact.pack), fact.at_least, fact.at_most);
  }
  if (policy.facts.empty()) text += "facts may not be stated\n";
  for (const std::string& sha256 : policy.photometry) {
    text += fmt::format("photometry that may be used: {}\n", sha256);
  }
  for (const PolicyBound& bound : policy.bounds) {
    text += range_text(calc::name_of(bound.of), bound.at_least, bound.at_most);
  }
  if (policy.confidence) text += fmt::format("confidence: at least {}\n", *policy.confidence);
  if (policy.tolerance) text += fmt::format("tolerance: at most {}\n", *policy.tolerance);
  if (policy.replicates) text += fmt::format("replicates: at least {}\n", *policy.replicates);
  if (policy.max_paths) text += fmt::format("max-paths: at least {}\n", *policy.max_paths);
  if (policy.are_all_warnings_fatal) text += "every warning counts like an error\n";
  for (const calc::DiagnosticId id : policy.fatal_warnings) {
    text += fmt::format("a warning that counts like an error: {}\n", calc::diagnostic_name(id));
  }
  for (const std::string& format : policy.formats) {
    text += fmt::format("must be written: {}\n", format);
  }
  return text;
}

std::string policy_schema() {
  return calc::xml_schema({"'luxgate policy schema'",
                           "What the owner of a gate wants of every project, whatever the project "
                           "says itself: a file that luxgate check --policy reads.",
                           kRootRow});
}

}  // namespace report
