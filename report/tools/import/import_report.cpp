#include "report/tools/import/import_report.h"

#include "calc/base/text.h"
#include "calc/base/utf8.h"
#include "calc/scene/polygon.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <utility>

namespace cli {
namespace {

using NoteKind = DesignNote::Kind;
constexpr std::size_t kMostLines = 30;  // of a part of the text

constexpr std::pair<NoteKind, const char*> kParts[] = {
    {NoteKind::left_out, "Omitted, although the map names it"},
    {NoteKind::doubt, "Please check"},
    {NoteKind::taken, "Changed from the drawing"},
    {NoteKind::not_asked, "Not named by the map"}};

const char* json_name(NoteKind kind) {
  switch (kind) {
    case NoteKind::left_out:
      return "left-out";
    case NoteKind::doubt:
      return "doubt";
    case NoteKind::taken:
      return "taken";
    case NoteKind::not_asked:
      return "not-asked";
  }
  return "";
}

std::string counted(std::size_t count, const char* one, const char* several) {
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

void add_list(const std::string& head, const std::vector<std::string>& lines, std::string& text) {
  if (lines.empty()) return;
  text += head + ":\n";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i == kMostLines) {
      text += "  " + calc::and_more(lines.size() - i) + "; --json has all\n";
      break;
    }
    text += "  " + calc::printable(lines[i]) + "\n";
  }
}

}  // namespace

std::string import_as_text(const ImportReport& report) {
  const Design& design = *report.design;
  const ProjectText& project = *report.project;
  double area = 0.0;
  for (const DesignRoom& room : design.room) area += calc::signed_area(room.outline_m);
  std::string text = fmt::format("{}: unit {} ({})\n", calc::printable_path(design.file),
                                 design.unit, design.unit_reason);
  text +=
      fmt::format("{} of {} ({:.2f} m2), {} of {}, {} of {}, {} of {}, {} of {}\n", project.rooms,
                  counted(design.room.size(), "room", "rooms"), area, project.luminaires,
                  counted(design.luminaire.size(), "luminaire", "luminaires"), project.boxes,
                  counted(design.box.size(), "piece of furniture", "pieces of furniture"),
                  project.planes, counted(design.plane.size(), "plane", "planes"), project.routes,
                  counted(design.route.size(), "route", "routes"));
  for (const auto& [kind, head] : kParts) {
    std::vector<std::string> lines;
    for (const DesignNote& note : design.note) {
      if (note.kind != kind) continue;
      lines.push_back(fmt::format(
          "{}{}: {}{}", note.count > 1 ? fmt::format("{} x ", note.count) : "", note.what, note.why,
          note.place.empty()
              ? ""
              : fmt::format(" ({}{})", note.count > 1 ? "the first: " : "", note.place)));
    }
    add_list(head, lines, text);
  }
  add_list("Changed since the last import", report.changes, text);
  add_list("Also changed by hand, and kept as it is in the project", report.conflicts, text);
  return text;
}

std::string import_as_json(const ImportReport& report) {
  const Design& design = *report.design;
  const ProjectText& project = *report.project;
  nlohmann::ordered_json all;
  all["file"] = design.file;
  all["unit"] = design.unit;
  all["unit_reason"] = design.unit_reason;
  all["origin_m"] = {design.origin_m.x, design.origin_m.y, design.origin_m.z};
  const auto counts = [&](const char* name, std::size_t found, std::size_t written) {
    all[name] = {{"found", found}, {"written", written}};
  };
  counts("rooms", design.room.size(), project.rooms);
  counts("luminaires", design.luminaire.size(), project.luminaires);
  counts("furniture", design.box.size(), project.boxes);
  counts("planes", design.plane.size(), project.planes);
  counts("routes", design.route.size(), project.routes);
  nlohmann::ordered_json rooms = nlohmann::ordered_json::array();
  for (const DesignRoom& room : design.room) {
    nlohmann::ordered_json row;
    row["key"] = room.source.key;
    row["name"] = room.number + (room.number.empty() || room.name.empty() ? "" : " ") + room.name;
    row["area_m2"] = calc::signed_area(room.outline_m);
    row["place"] = room.source.place;
    rooms.push_back(std::move(row));
  }
  all["room_list"] = std::move(rooms);
  nlohmann::ordered_json notes = nlohmann::ordered_json::array();
  for (const DesignNote& note : design.note) {
    nlohmann::ordered_json row;
    row["kind"] = json_name(note.kind);
    row["what"] = note.what;
    row["why"] = note.why;
    row["place"] = note.place;
    row["count"] = note.count;
    notes.push_back(std::move(row));
  }
  all["notes"] = std::move(notes);
  all["changes"] = report.changes;
  all["conflicts"] = report.conflicts;
  all["written"] = report.written;
  return all.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace cli
