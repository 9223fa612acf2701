#include "report/tools/export/ifc_results.h"

#include "calc/base/file_hash.h"
#include "calc/base/text.h"
#include "calc/base/utf8.h"
#include "calc/scene/polygon.h"
#include "report/formats/ci_finding.h"
#include "report/text/aggregate_words.h"
#include "report/text/ifc_guid.h"
#include "report/text/number_format.h"
#include "report/text/one_source_note.h"
#include "report/text/plain_text.h"
#include "report/text/words.h"
#include "report/tools/import/ifc_design.h"
#include "report/tools/import/step_text.h"
#include "rules/verdict/outcome.h"
#include "rules/verdict/waiver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace cli {
namespace {

using report::printable;
using rules::Outcome;

// What an export adds stands between these. The hash is of what is between: who has changed a byte
// of it keeps it.
constexpr std::string_view kBlockBegin = "/* luxgate results: begin */\n";
constexpr std::string_view kBlockEnd = "/* luxgate results: end, ";
constexpr std::size_t kHashDigits = 64;
constexpr std::string_view kBlockTail = " */\n";

constexpr std::size_t kLongestPropertyName = 200;  // characters; IfcIdentifier has 255
constexpr std::size_t kLongestLabel = 255;         // of IfcLabel
constexpr std::size_t kMostWarnings = 100;         // that are written in full
constexpr std::size_t kMostNamed = 10;             // things of a kind that a note names
// Of areas and heights of the model against those of the result: coordinates of projects are
// rounded to 0.1 mm, and arcs are chords.
constexpr double kSameSize = 0.005;
// Of an outline: places along it fall on one side or the other.
constexpr double kSameShape = 0.02;

// Offset at which the block of an earlier export begins, up to `end`; empty: there is none, or
// somebody has changed it.
std::optional<std::size_t> earlier_block(std::string_view model, std::size_t end) {
  const std::string_view before = model.substr(0, end);
  const std::size_t tail = kBlockEnd.size() + kHashDigits + kBlockTail.size();
  if (before.size() < tail) return std::nullopt;
  const std::size_t end_mark = before.size() - tail;
  if (before.substr(end_mark, kBlockEnd.size()) != kBlockEnd) return std::nullopt;
  const std::size_t begin = before.substr(0, end_mark).rfind(kBlockBegin);
  if (begin == std::string_view::npos) return std::nullopt;
  const std::size_t content = begin + kBlockBegin.size();
  const std::string hash = calc::sha256_hex(before.substr(content, end_mark - content));
  if (before.substr(end_mark + kBlockEnd.size(), kHashDigits) != hash) return std::nullopt;
  return begin;
}

// Calls with the number of every instance that a value refers to.
template <class Call>
void each_reference(const StepValue& value, const Call& call) {
  if (const auto number = value.reference()) call(*number);
  for (const StepValue& item : value.items()) each_reference(item, call);
}

// "what 'a', 'b' and 3 more"
std::string named(const std::vector<std::string>& names) {
  return printable(calc::list_names(names, kMostNamed));
}

struct Extent2 {
  glm::dvec2 low_m{std::numeric_limits<double>::infinity()};
  glm::dvec2 high_m{-std::numeric_limits<double>::infinity()};
};

Extent2 extent_of(const std::vector<glm::dvec2>& outline_m) {
  Extent2 extent;
  for (const glm::dvec2& corner : outline_m) {
    extent.low_m = glm::min(extent.low_m, corner);
    extent.high_m = glm::max(extent.high_m, corner);
  }
  return extent;
}

// What is in one of the outlines alone, as a share of what is in either. The origin of an import is
// its own: the outlines are laid with their lower left ends on each other. By a grid of places.
double share_apart(const std::vector<glm::dvec2>& a_m, const std::vector<glm::dvec2>& b_m) {
  constexpr int kPlaces = 200;  // along each axis
  const Extent2 a = extent_of(a_m), b = extent_of(b_m);
  const glm::dvec2 size_m = glm::max(a.high_m - a.low_m, b.high_m - b.low_m);
  int either = 0, apart = 0;
  for (int i = 0; i < kPlaces; ++i) {
    for (int k = 0; k < kPlaces; ++k) {
      const glm::dvec2 place_m = size_m * glm::dvec2(i + 0.5, k + 0.5) / double{kPlaces};
      const bool in_a = calc::contains_point(a_m, a.low_m + place_m);
      const bool in_b = calc::contains_point(b_m, b.low_m + place_m);
      either += in_a || in_b ? 1 : 0;
      apart += in_a != in_b ? 1 : 0;
    }
  }
  return either == 0 ? 1.0 : static_cast<double>(apart) / either;
}

// One property of a set.
struct Property {
  std::string name, value;  // value: from the second argument on, as STEP text
  bool is_bounded = false;
};

// A result of a room with the room's place in the model.
struct PlacedRoom {
  const report::ProjectPart* project;
  const report::SpacePart* space;
  std::uint32_t instance;
  std::vector<report::CiFinding> entries;  // of this room
  std::string doubt = {};                  // that the model's room is not that of the result
};

// The properties of one set, in the order of the calls; names are unique, as IFC wants them.
class PropertyList {
 public:
  // unit: "#12" of the unit lux.
  PropertyList(bool is_ifc4, std::string lux) : is_ifc4_(is_ifc4), lux_(std::move(lux)) {}

  // Of words that are not longer than a label may be IFCLABEL, else IFCTEXT. "" is left out.
  void words(const std::string& name, const std::string& words) {
    if (words.empty()) return;
    const std::string safe = printable(words);
    const char* type = safe.size() <= kLongestLabel ? "IFCLABEL" : "IFCTEXT";
    single(name, fmt::format("{}({})", type, step_literal(safe)), "$");
  }
  void each_words(const std::string& name, const std::vector<std::string>& all) {
    for (std::size_t i = 0; i < all.size(); ++i) words(fmt::format("{} {}", name, i + 1), all[i]);
  }

  void number(const std::string& name, double value, const std::string& unit) {
    if (!std::isfinite(value)) return;
    single(name + in_unit(unit), measure(value, unit), unit_of(unit));
  }

  // A value with its interval. What has no end on one side has none there; what has none at all is
  // words. Of IFC 2x3 a property of its own has the value.
  void estimate(const std::string& name, const calc::Estimate& value, const std::string& unit) {
    if (std::isnan(value.value)) return;
    if (!std::isfinite(value.value)) {
      words(name, report::format_measured(value, unit));
      return;
    }
    const auto end = [&](double at) { return std::isfinite(at) ? measure(at, unit) : "$"; };
    std::string bounds = fmt::format("{},{},{}", end(value.high), end(value.low), unit_of(unit));
    if (is_ifc4_) {
      bounds += "," + measure(value.value, unit);
    } else {
      number(name, value.value, unit);
      if (!std::isfinite(value.low) && !std::isfinite(value.high)) {
        words(name + " interval", "not known");
        return;
      }
    }
    add({name + (is_ifc4_ ? "" : " interval") + in_unit(unit), bounds, true});
  }

  const std::vector<Property>& list() const { return list_; }

 private:
  static bool is_lux(const std::string& unit) { return unit == "lx"; }
  // IFC has no unit here for other ones: their name says it.
  static std::string in_unit(const std::string& unit) {
    return unit.empty() || is_lux(unit) ? "" : " (" + unit + ")";
  }
  static std::string measure(double value, const std::string& unit) {
    return fmt::format("{}({})", is_lux(unit) ? "IFCILLUMINANCEMEASURE" : "IFCREAL",
                       step_real(value));
  }
  std::string unit_of(const std::string& unit) const { return is_lux(unit) ? lux_ : "$"; }

  void single(const std::string& name, const std::string& value, const std::string& unit) {
    add({name, value + "," + unit, false});
  }

  void add(Property property) {
    const std::string wanted = calc::shorten_utf8(printable(property.name), kLongestPropertyName);
    property.name = wanted;
    for (int k = 2; !names_.insert(property.name).second; ++k) {
      property.name = fmt::format("{} ({})", wanted, k);
    }
    list_.push_back(std::move(property));
  }

  bool is_ifc4_;
  std::string lux_;
  std::vector<Property> list_;
  std::set<std::string> names_;
};

// "fail", "pass (advice, does not count)", "fail, waived".
std::string finding_verdict(const report::CiFinding& entry) {
  std::string words = report::verdict_words({}, entry.verdict);
  if (report::is_waived(entry)) return words + ", waived: it does not count";
  const rules::Severity severity =
      entry.aggregate != nullptr ? entry.aggregate->severity : entry.finding->requirement.severity;
  if (severity == rules::Severity::advice) words += " (advice, does not count)";
  if (severity == rules::Severity::in_aggregate) words += " (counts in aggregates)";
  return words;
}

Outcome outcome_of_entry(const report::CiFinding& entry) {
  if (entry.aggregate != nullptr) return rules::outcome_of(*entry.aggregate);
  if (entry.finding != nullptr) return rules::outcome_of(*entry.finding);
  return Outcome::not_judged;  // a plane without result
}

std::string project_title(const report::ProjectPart& project) {
  if (!project.name.empty()) return project.name;
  return std::filesystem::path(project.path).filename().string();
}

class ResultsWriter {
 public:
  ResultsWriter(std::string_view model, const StepText& text, const report::Document& result,
                std::string& problem)
      : model_(model), text_(text), result_(result), problem_(problem) {}

  std::optional<IfcWithResults> write() {
    if (!check_model() || !place_rooms()) return std::nullopt;
    compare_rooms();
    lux_ = fmt::format("#{}", add_instance("IFCSIUNIT(*,.ILLUMINANCEUNIT.,$,.LUX.)"));
    for (PlacedRoom& room : rooms_) add_room(room);
    if (with_.rooms == 0) {
      return fail("no room of the result could be written: " + with_.notes.back());
    }
    add_run();
    if (next_ - 1 > kLargestStepNumber) {
      return fail("its instance numbers are so large that no number is left for results");
    }
    notes_of_units();
    const std::size_t end = text_.data_end();
    with_.text.reserve(model_.size() + block_.size() + 256);
    with_.text = model_.substr(0, end);
    with_.text += kBlockBegin;
    with_.text += block_;
    with_.text += fmt::format("{}{}{}", kBlockEnd, calc::sha256_hex(block_), kBlockTail);
    with_.text += model_.substr(end);
    if (with_.text.size() >= std::numeric_limits<std::uint32_t>::max()) {
      return fail("with the results the model would have more than 4 GiB");
    }
    return std::move(with_);
  }

 private:
  std::nullopt_t fail(std::string what) {
    problem_ = std::move(what);
    return std::nullopt;
  }

  // A note of something that has no place in the model.
  void missing(std::string what) {
    with_.notes.push_back(what);
    missing_.push_back(std::move(what));
    with_.is_all = false;
  }

  bool check_model() {
    const std::string schema = text_.schema().empty() ? "" : text_.schema().front();
    is_ifc4_ = schema.starts_with("IFC4");
    if (!is_ifc4_ && !schema.starts_with("IFC2X3")) {
      fail(fmt::format("the schema is '{}'; results go into IFC2X3 and IFC4",
                       calc::shorten_utf8(printable(schema), 40)));
      return false;
    }
    if (text_.of_name("IFCPROJECT").size() != 1) {
      fail(fmt::format("it has {} IFCPROJECT; exactly one is needed",
                       text_.of_name("IFCPROJECT").size()));
      return false;
    }
    if (text_.of_name("IFCSPACE").empty()) {
      fail("it has no IfcSpace to write results of rooms into");
      return false;
    }
    for (const std::uint32_t set : text_.of_name("IFCPROPERTYSET")) {
      if (!text_at(set, 2).starts_with(kIfcSetPrefix)) continue;
      fail(fmt::format(
          "#{}, line {}: the property set '{}' is of an earlier export, and another program has "
          "written it since, so that it cannot be removed safely; give the model without sets "
          "whose names begin with {}",
          text_.number(set), text_.line(set), calc::shorten_utf8(printable(text_at(set, 2)), 60),
          kIfcSetPrefix));
      return false;
    }
    next_ = text_.number(static_cast<std::uint32_t>(text_.size() - 1)) + 1;
    return true;
  }

  std::string text_at(std::uint32_t instance, std::size_t argument) const {
    const std::vector<StepValue> a = text_.arguments(instance);
    return argument < a.size() ? a[argument].untyped().text().value_or("") : "";
  }

  bool place_rooms() {
    std::map<std::string, std::vector<std::uint32_t>> space_of;
    for (const std::uint32_t space : text_.of_name("IFCSPACE")) {
      space_of[text_at(space, 0)].push_back(space);
    }
    std::map<std::uint32_t, const report::ProjectPart*> taken;
    std::vector<std::string> foreign, absent, twice;
    std::size_t asked = 0;
    for (const report::ProjectPart& project : result_.projects) {
      if (!project.is_judged) {
        missing(
            fmt::format("project '{}' could not be judged: the model gets none of its rooms "
                        "model",
                        printable(project_title(project))));
      }
      std::map<const report::SpacePart*, std::vector<report::CiFinding>> entries;
      for (report::CiFinding& entry : report::CiFindings({}, nullptr).of(project)) {
        if (entry.space != nullptr) entries[entry.space].push_back(std::move(entry));
      }
      for (const report::SpacePart& space : project.spaces) {
        ++asked;
        const std::string key = key_of(space);
        const auto found = space_of.find(key);
        if (key.empty()) {
          foreign.push_back("'" + space.id + "'");
        } else if (found == space_of.end()) {
          absent.push_back("'" + space.id + "'");
        } else if (found->second.size() > 1) {
          twice.push_back("'" + space.id + "'");
        } else if (const auto [at, is_new] = taken.try_emplace(found->second[0], &project);
                   !is_new) {
          fail(fmt::format("room '{}' has two results, in the projects '{}' and '{}'",
                           printable(space.id), printable(at->second->path),
                           printable(project.path)));
          return false;
        } else {
          rooms_.push_back({&project, &space, found->second[0], std::move(entries[&space])});
        }
      }
    }
    if (!foreign.empty()) {
      missing("without a place in the model: their ids are not from an import: " + named(foreign));
    }
    if (!absent.empty()) missing("not in this model: " + named(absent));
    if (!twice.empty()) {
      missing("omitted, because the model has two spaces with this GlobalId:  " + named(twice));
    }
    if (rooms_.empty()) {
      fail(asked == 0 ? "the result has no room"
                      : fmt::format("none of the {} rooms of the result can be placed in this "
                                    "model: {}",
                                    asked, missing_.back()));
      return false;
    }
    std::vector<std::string> without;
    for (const std::uint32_t space : text_.of_name("IFCSPACE")) {
      if (!taken.contains(space)) without.push_back("'" + space_words(space) + "'");
    }
    if (!without.empty()) {
      without_ = fmt::format("{} of {} spaces of the model: {}", without.size(),
                             text_.of_name("IFCSPACE").size(), named(without));
      with_.notes.push_back("without results: " + without_);
    }
    return true;
  }

  // Also by the id that it had before somebody gave it a better one.
  static std::string key_of(const report::SpacePart& space) {
    const std::string key = report::key_of_id(space.id, report::kRoomIdPrefix);
    return key.empty() ? report::key_of_id(space.was, report::kRoomIdPrefix) : key;
  }

  // Number and name as people know them, else the GlobalId.
  std::string space_words(std::uint32_t space) const {
    const std::string number = text_at(space, 2), name = text_at(space, 7);
    const std::string words = number + (number.empty() || name.empty() ? "" : " ") + name;
    return words.empty() ? text_at(space, 0) : words;
  }

  // Whether rooms are still as large as when they were calculated.
  void compare_rooms() {
    StepProblem unread;
    const std::optional<Design> design = read_ifc(model_, "", {}, unread);
    std::map<std::string, const DesignRoom*> room_of;
    if (design) {
      for (const DesignRoom& room : design->room) room_of.emplace(room.source.key, &room);
    }
    std::vector<std::string> other, unknown;
    for (PlacedRoom& placed : rooms_) {
      const auto found = room_of.find(text_at(placed.instance, 0));
      const std::string name = "'" + space_words(placed.instance) + "'";
      if (found == room_of.end() || placed.space->footprint_m.empty()) {
        placed.doubt = "the room of the model may not be that of the result";
        unknown.push_back(name);
        continue;
      }
      const double area_m2 = std::fabs(calc::signed_area(found->second->outline_m));
      const double was_m2 = std::fabs(calc::signed_area(placed.space->footprint_m));
      const double height_m = found->second->height_m.value_or(placed.space->height_m);
      const auto is_same = [](double a, double b) { return std::fabs(a - b) <= kSameSize * b; };
      if (!is_same(area_m2, was_m2) || !is_same(height_m, placed.space->height_m)) {
        placed.doubt = fmt::format(
            "the room of the model has {} m² and is {} m high, that of the result {} m² and {} m",
            report::format_fixed(area_m2, 2), report::format_metres(height_m),
            report::format_fixed(was_m2, 2), report::format_metres(placed.space->height_m));
        other.push_back(name);
      } else if (share_apart(found->second->outline_m, placed.space->footprint_m) > kSameShape) {
        placed.doubt = "the rooms of model and result have the same area and different outlines";
        other.push_back(name);
      } else if (!found->second->hole_m.empty()) {
        // A result has what stands in them as solids, and nobody says which these were.
        placed.doubt = fmt::format(
            "the room of the model has holes in its floor ({}), which may not be those of the "
            "result",
            found->second->hole_m.size());
        unknown.push_back(name);
      } else if (!found->second->doubt.empty()) {
        placed.doubt = fmt::format("the shape of the model's room is uncertain: {}",
                                   fmt::join(found->second->doubt, "; "));
        unknown.push_back(name);
      }
    }
    doubtful_ = other;
    doubtful_.insert(doubtful_.end(), unknown.begin(), unknown.end());
    if (!other.empty()) {
      with_.notes.push_back("the model's rooms are not those that were calculated: " +
                            named(other) + "; their verdicts say so");
      with_.is_all = false;
    }
    if (!unknown.empty()) {
      with_.notes.push_back("the rooms may not be those that were calculated:  " + named(unknown) +
                            "; their verdicts say so");
      with_.is_all = false;
    }
  }

  // --- instances -------------------------------------------------------------------------------
  std::uint64_t add_instance(const std::string& body) {
    block_ += fmt::format("#{}={};\n", next_, body);
    return next_++;
  }

  // "#12" or "$"; empty: IFC 2x3 wants one, and the model has none.
  std::optional<std::string> owner_of(std::uint32_t thing) const {
    const auto history = [&](std::uint32_t of) -> std::optional<std::uint32_t> {
      const std::vector<StepValue> a = text_.arguments(of);
      if (a.size() < 2) return std::nullopt;
      const auto found = text_.find(a[1]);
      return found && text_.name(*found) == "IFCOWNERHISTORY" ? found : std::nullopt;
    };
    std::optional<std::uint32_t> found = history(thing);
    if (!found && is_ifc4_) return "$";
    if (!found) found = history(text_.of_name("IFCPROJECT")[0]);
    if (!found && !text_.of_name("IFCOWNERHISTORY").empty()) {
      found = text_.of_name("IFCOWNERHISTORY")[0];
    }
    if (!found) return std::nullopt;
    return fmt::format("#{}", text_.number(*found));
  }

  // guid_names: what the set is, besides whose.
  void add_set(std::uint32_t thing, const std::string& owner, const std::string& name,
               const std::string& about, std::vector<std::string> guid_names,
               const PropertyList& properties) {
    std::string list;
    for (const Property& property : properties.list()) {
      const char* kind = property.is_bounded ? "IFCPROPERTYBOUNDEDVALUE" : "IFCPROPERTYSINGLEVALUE";
      const std::uint64_t number = add_instance(
          fmt::format("{}({},$,{})", kind, step_literal(property.name), property.value));
      list += fmt::format("{}#{}", list.empty() ? "" : ",", number);
    }
    guid_names.insert(guid_names.begin(), {"luxgate results", text_at(thing, 0)});
    const auto guid = [&](const char* of) {
      std::vector<std::string> names = guid_names;
      names.emplace_back(of);
      return report::ifc_letters(report::guid_of_names(names));
    };
    const std::uint64_t set =
        add_instance(fmt::format("IFCPROPERTYSET('{}',{},{},{},({}))", guid("set"), owner,
                                 step_literal(name), step_literal(about), list));
    add_instance(fmt::format("IFCRELDEFINESBYPROPERTIES('{}',{},$,$,(#{}),#{})", guid("relation"),
                             owner, text_.number(thing), set));
  }

  PropertyList properties() const { return {is_ifc4_, lux_}; }

  // --- rooms -----------------------------------------------------------------------------------
  // Says, too, that only a part was judged: who reads nothing else reads that.
  std::string verdict_of(Outcome outcome, const std::string& doubt, bool is_part = false) const {
    std::string words = report::outcome_words(outcome);
    if (is_part || !result_.provenance.selection.empty()) words += ", of a part only";
    return doubt.empty() ? words : words + ", but see Doubt";
  }

  void add_room(PlacedRoom& room) {
    const std::optional<std::string> owner = owner_of(room.instance);
    if (!owner) {
      missing(
          fmt::format("omitted: '{}', because IFC 2x3 needs an owner history and the model has "
                      "none",
                      printable(space_words(room.instance))));
      return;
    }
    ++with_.rooms;
    const report::SpacePart& space = *room.space;
    report::Totals totals;
    totals.verdicts = report::count_verdicts(space);
    totals.outcome = Outcome::nothing_asked;
    for (const report::CiFinding& entry : room.entries) {
      totals.outcome = rules::graver(totals.outcome, outcome_of_entry(entry));
    }
    const report::WarningCounts warnings = report::count_warnings(*room.project);
    Outcome verdict = totals.outcome;
    if (warnings.strict > 0) verdict = rules::graver(verdict, Outcome::warned);
    PropertyList all = properties();
    all.words("Verdict", verdict_of(verdict, room.doubt));
    all.words("Requirements", report::summary_words(totals));
    all.words("Part", report::selection_words(result_.provenance));
    all.words("Doubt", room.doubt);
    std::vector<std::string> in_part, left_out;
    for (const rules::RowCoverage& row : space.coverage) {
      if (!row.asks_all()) in_part.push_back(report::coverage_words({}, row));
      for (const rules::RoleCoverage& role : row.roles) {
        for (const rules::LeftOutZone& zone : role.left_out) {
          if (zone.has_ended) continue;  // told by its plane, which is not judged
          left_out.push_back(fmt::format("{}.{} ({})", row.workplace, zone.zone,
                                         rules::waiver_words(zone.by).english()));
        }
      }
    }
    all.each_words("Asked in part", in_part);
    all.each_words("Left out", left_out);
    std::vector<std::string> notes;
    for (const calc::Message& note : space.notes) notes.push_back(note.english());
    all.each_words("Note", notes);
    if (warnings.all > 0) {
      all.words("Warnings",
                fmt::format("{} of the project, see Luxgate_Run of the IfcProject", warnings.all));
    }
    for (const report::CiFinding& entry : room.entries) {
      if (entry.aggregate == nullptr) continue;
      const std::string title = report::aggregate_title({}, *entry.aggregate);
      all.words(title + ": verdict", finding_verdict(entry));
      all.words(title + ": result", entry.message);
    }
    all.words("Project", project_title(*room.project));
    all.words("Written by", program());
    add_set(room.instance, *owner, std::string(kIfcSetPrefix) + "Results",
            "Lighting of this room against its requirements", {"room"}, all);
    for (const report::PlanePart& plane : space.planes) add_plane(room, plane, *owner);
  }

  void add_plane(const PlacedRoom& room, const report::PlanePart& plane, const std::string& owner) {
    PropertyList all = properties();
    Outcome verdict = plane.is_computed ? Outcome::nothing_asked : Outcome::not_judged;
    for (const report::CiFinding& entry : room.entries) {
      if (entry.plane == &plane) verdict = rules::graver(verdict, outcome_of_entry(entry));
    }
    all.words("Verdict", verdict_of(verdict, room.doubt));
    all.words("Doubt", room.doubt);
    all.words("Plane", std::string(report::title_of(plane.name, plane.id)));
    all.words("Measured", report::values_words({}, plane));
    if (!plane.is_computed) all.words("Not computed", plane.reason.english());
    all.words("Doubt of sampling", report::doubt_words(plane));
    if (!plane.changed.empty()) all.words("Changed", plane.changed.english());
    std::vector<std::string> notes;
    for (const calc::Message& remark : plane.remarks) notes.push_back(remark.english());
    all.each_words("Note", notes);
    for (const report::CiFinding& entry : room.entries) {
      if (entry.plane != &plane || entry.finding == nullptr) continue;
      const rules::Finding& finding = *entry.finding;
      const rules::Requirement& requirement = finding.requirement;
      const std::string unit = rules::unit_of(requirement);
      all.words(requirement.id + ": verdict", finding_verdict(entry));
      all.words(requirement.id + ": result", entry.message);
      if (finding.verdict != rules::Verdict::not_judged) {
        all.estimate(requirement.id + ": value", finding.measured, unit);
      }
      all.number(fmt::format("{}: limit {}", requirement.id,
                             report::comparison_sign(requirement.comparison)),
                 requirement.limit, unit);
      if (requirement.waiver) {
        all.words(requirement.id + ": waiver", rules::waiver_words(*requirement.waiver).english() +
                                                   (finding.is_waived ? "" : " (does not apply)"));
      }
    }
    if (plane.is_computed) {
      const std::string unit = report::plane_unit(plane);
      const std::string of = ", all at full output";
      all.estimate("Average" + of, plane.average, unit);
      all.estimate("Minimum" + of, plane.minimum, unit);
      all.estimate("Maximum" + of, plane.maximum, unit);
    }
    add_set(room.instance, owner, fmt::format("{}Plane_{}", kIfcSetPrefix, printable(plane.id)),
            "Lighting of a plane of this room against its requirements", {"plane", plane.id}, all);
  }

  // --- what holds for all ----------------------------------------------------------------------
  std::string program() const { return "luxgate " + result_.provenance.program_version; }

  void add_run() {
    const std::uint32_t project = text_.of_name("IFCPROJECT")[0];
    const std::optional<std::string> owner = owner_of(project);
    if (!owner) return;  // then no room was written, either
    const report::Totals totals = report::totals_of(result_);
    PropertyList all = properties();
    // Who reads this alone must not take it for more than it is.
    std::string doubt;
    if (!doubtful_.empty()) {
      doubt = "rooms of the model may not be those that were calculated: " + named(doubtful_);
    }
    if (!missing_.empty()) {
      doubt +=
          (doubt.empty() ? "" : "; ") + std::string("not all results have a place in the model");
    }
    const bool is_part = !without_.empty();
    all.words("Verdict", verdict_of(totals.outcome, doubt, is_part));
    all.words("Doubt", doubt);
    all.words("Spaces without results", without_);
    all.words("Requirements", report::summary_words(totals));
    all.words("Remarks", report::provenance_remarks(result_.provenance));
    all.words("One public source", report::one_source_note({}, totals.one_source_rows));
    all.words("Confidence of intervals", report::format_percent(result_.provenance.confidence));
    all.each_words("Without a place in the model", missing_);
    std::vector<std::string> warnings;
    std::size_t more = 0;
    for (const report::ProjectPart& one : result_.projects) {
      all.words("Project " + project_title(one),
                verdict_of(report::outcome_of(one), doubt, is_part));
      for (const report::CiFinding& entry : report::CiFindings({}, nullptr).of(one)) {
        if (entry.space != nullptr || entry.aggregate == nullptr) continue;
        const std::string title =
            entry.place + ", " + report::aggregate_title({}, *entry.aggregate);
        all.words(title + ": verdict", finding_verdict(entry));
        all.words(title + ": result", entry.message);
      }
      for (const calc::Diagnostic& diagnostic : one.diagnostics) {
        if (warnings.size() == kMostWarnings) {
          ++more;
          continue;
        }
        warnings.push_back(calc::format_diagnostic(diagnostic));
      }
    }
    all.each_words("Message", warnings);
    if (more > 0) all.words("Messages", calc::and_more(more, "in the result file"));
    all.words("Written by", program());
    add_set(project, *owner, std::string(kIfcSetPrefix) + "Run",
            "The calculation of lighting that all sets Luxgate_... are from", {"run"}, all);
  }

  // Our properties name lux themselves; other numbers of the file may be in something else.
  void notes_of_units() {
    for (const std::uint32_t assignment : text_.of_name("IFCUNITASSIGNMENT")) {
      const std::vector<StepValue> a = text_.arguments(assignment);
      if (a.empty()) continue;
      for (const StepValue& value : a[0].items()) {
        const auto unit = text_.find(value);
        if (!unit) continue;
        const std::vector<StepValue> b = text_.arguments(*unit);
        if (b.size() < 2 || b[1].enumeration() != "ILLUMINANCEUNIT") continue;
        const bool is_lux = text_.name(*unit) == "IFCSIUNIT" && b.size() > 3 && b[2].is_null() &&
                            b[3].enumeration() == "LUX";
        if (!is_lux) {
          with_.notes.push_back(fmt::format(
              "#{}: the unit of illuminance of the model is not lux; the results state lux",
              text_.number(*unit)));
        }
      }
    }
  }

  std::string_view model_;
  const StepText& text_;
  const report::Document& result_;
  std::string& problem_;
  bool is_ifc4_ = false;
  std::uint64_t next_ = 1;
  std::string lux_, block_;
  std::vector<PlacedRoom> rooms_;
  std::vector<std::string> missing_;
  std::vector<std::string> doubtful_;  // rooms that may not be those of the result
  std::string without_;                // spaces without results; "" = none
  IfcWithResults with_;
};

// The model without what an earlier export has added. Empty with a problem.
std::optional<std::string> without_block(std::string_view model, const StepText& text,
                                         std::size_t begin, std::string& problem) {
  std::string rest(model.substr(0, begin));
  rest += model.substr(text.data_end());
  StepProblem unread;
  const std::optional<StepText> left = StepText::open(rest, unread);
  if (!left) {
    problem = "it cannot be read without the results of an earlier export:  " + unread.what;
    return std::nullopt;
  }
  for (std::uint32_t i = 0; i < left->size(); ++i) {
    bool is_hanging = false;
    for (const StepValue& value : left->arguments(i)) {
      each_reference(value, [&](std::uint64_t number) {
        is_hanging = is_hanging || (text.find(number) && !left->find(number));
      });
    }
    if (!is_hanging) continue;
    problem = fmt::format("#{} refers to results of an earlier export, which so cannot be replaced",
                          left->number(i));
    return std::nullopt;
  }
  return rest;
}

}  // namespace

std::optional<IfcWithResults> ifc_with_results(std::string_view model,
                                               const report::Document& result,
                                               std::string& problem) {
  StepProblem unread;
  std::optional<StepText> text = StepText::open(model, unread);
  if (!text || text->size() == 0) {
    problem = !text ? unread.what : "it has no instances";
    if (unread.line != 0) problem = fmt::format("line {}: {}", unread.line, problem);
    return std::nullopt;
  }
  std::string rest;
  const std::optional<std::size_t> block = earlier_block(model, text->data_end());
  if (block) {
    std::optional<std::string> without = without_block(model, *text, *block, problem);
    if (!without) return std::nullopt;
    rest = std::move(*without);
    model = rest;
    text = StepText::open(model, unread);
  }
  std::optional<IfcWithResults> with = ResultsWriter(model, *text, result, problem).write();
  if (with && block) {
    with->notes.insert(with->notes.begin(), "the results of an earlier export were replaced");
  }
  return with;
}

}  // namespace cli
