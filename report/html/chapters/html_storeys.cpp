#include "report/html/chapters/html_storeys.h"

#include "calc/base/names.h"
#include "calc/scene/polygon.h"
#include "report/document/luminaire_totals.h"
#include "report/document/room_summary.h"
#include "report/document/storeys.h"
#include "report/html/drawings/flat_box.h"
#include "report/html/drawings/storey_plan.h"
#include "report/html/page/html_markup.h"
#include "report/text/markup.h"
#include "report/text/room_overview.h"
#include "report/text/storey_title.h"
#include "report/text/svg.h"
#include "report/text/text_numbers.h"
#include "report/text/words.h"
#include "rules/verdict/outcome.h"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace report {
namespace {

constexpr double kStoreyScale = 50, kSiteScale = 200;  // the largest ones

// What every plan of a project needs.
struct PlanProject {
  const Texts& t;
  const ProjectPart& project;
  Paper paper;
  std::string anchor;                       // of the project
  std::map<std::string, std::size_t> rows;  // of luminaire types
  std::map<const SpacePart*, RoomSummary> summaries;
};

PlanProject plan_project(const Texts& t, const ProjectPart& project, std::size_t index,
                         Paper paper) {
  PlanProject all{t, project, paper, fmt::format("storey{}", index + 1), {}, {}};
  for (std::size_t i = 0; i < project.luminaires.size(); ++i)
    all.rows.emplace(project.luminaires[i].type_id, i);
  for (RoomSummary& room : room_summaries(project))
    all.summaries.emplace(room.space, std::move(room));
  return all;
}

bool has_anything(const SpacePart& space) {
  return !space.luminaires.empty() || !space.planes.empty();
}

// Of which at least one has two rooms: else the plan of the room shows as much.
bool are_drawn(const Storeys& storeys) {
  return std::any_of(storeys.list.begin(), storeys.list.end(),
                     [](const Storey& storey) { return storey.rooms.size() > 1; });
}

std::string scale_of(const Texts& t, const PlanFit& fit) {
  return "1:" + format_shortest(t, fit.scale);
}

// A room's name as people wrote it, and its number in it: "1.03", "Office B". number: "" if none.
struct RoomName {
  std::string whole, number, rest;
};

RoomName room_name(const SpacePart& space) {
  RoomName name;
  name.whole = title_of(space.name, space.id);
  const std::string_view whole = name.whole;
  const auto has_digit = [](std::string_view word) {
    return std::any_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
  };
  const std::size_t first = whole.find(' '), last = whole.rfind(' ');
  if (first == std::string_view::npos) return name;
  if (has_digit(whole.substr(0, first))) {
    name.number = whole.substr(0, first);
    name.rest = whole.substr(first + 1);
  } else if (has_digit(whole.substr(last + 1))) {
    name.number = whole.substr(last + 1);
    name.rest = whole.substr(0, last);
  }
  return name;
}

// By which a list names rooms: their own numbers where all have one of their own, else 1, 2, 3 ...
std::vector<std::string> short_names(const std::vector<RoomName>& names) {
  constexpr std::size_t kLongest = 10;
  std::set<std::string> known;
  std::vector<std::string> list;
  bool has_all = true;
  for (const RoomName& name : names) {
    has_all = has_all && !name.number.empty() && name.number.size() <= kLongest &&
              known.insert(name.number).second;
    list.push_back(name.number);
  }
  for (std::size_t i = 0; !has_all && i < list.size(); ++i) list[i] = fmt::format("{}", i + 1);
  return list;
}

// In two lines of about the same length; as it is where it is one word.
std::vector<std::string> in_two_lines(const std::string& words) {
  std::size_t best = std::string::npos;
  const auto off_middle = [&](std::size_t at) {
    return std::abs(static_cast<double>(at) - 0.5 * static_cast<double>(words.size()));
  };
  for (std::size_t at = words.find(' '); at != std::string::npos; at = words.find(' ', at + 1)) {
    if (best == std::string::npos || off_middle(at) < off_middle(best)) best = at;
  }
  if (best == std::string::npos) return {words};
  return {words.substr(0, best), words.substr(best + 1)};
}

std::vector<std::vector<std::string>> name_labels(const RoomName& name, const std::string& number) {
  std::vector<std::vector<std::string>> labels;
  if (!name.number.empty()) labels.push_back({name.number, name.rest});
  labels.push_back({name.whole});
  if (name.number.empty()) {
    labels.push_back(in_two_lines(name.whole));
  } else {
    std::vector<std::string> lines = in_two_lines(name.rest);
    lines.insert(lines.begin(), name.number);
    labels.push_back(std::move(lines));
  }
  labels.push_back({number});
  return labels;
}

// How much is said of a value: "503 ±9 ≥ 500", "503 ±9", "503".
enum class ValueDetail { required, interval, bare };

// "Em 412 ≥ 500", "Uo 0.61 ≥ 0.60", "UGR 17 ≤ 19".
std::vector<std::string> value_lines(const Texts& t, const RoomSummary& room, ValueDetail detail) {
  std::vector<std::string> lines;
  const auto add = [&](const char* name, const rules::Finding* finding) {
    if (finding == nullptr) return;
    lines.push_back(std::string(name) + " " +
                    (detail == ValueDetail::required
                         ? overview_cell(t, finding)
                         : overview_value(t, *finding, detail == ValueDetail::interval)));
  };
  if (room.average != nullptr) add(average_symbol(*room.average), room.average);
  add("Uo", room.uniformity);
  add("UGR", room.glare);
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string words;
  for (const std::string& line : lines) words += (words.empty() ? "" : " · ") + line;
  return words;
}

// With what is required before without, since that is what a value is read against.
std::vector<std::vector<std::string>> result_labels(const Texts& t, const RoomSummary& room,
                                                    const RoomName& name,
                                                    const std::string& number) {
  const std::string sign = std::string(outcome_symbol(room.outcome)) + " ",
                    shorter = name.number.empty() ? number : name.number;
  std::vector<std::vector<std::string>> labels;
  for (const ValueDetail detail :
       {ValueDetail::required, ValueDetail::interval, ValueDetail::bare}) {
    const std::vector<std::string> lines = value_lines(t, room, detail);
    for (const std::string& head : {name.whole, shorter}) {
      labels.push_back(lines);
      labels.back().insert(labels.back().begin(), sign + head);
      if (lines.size() > 1) labels.push_back({sign + head, joined(lines)});
    }
  }
  labels.push_back({sign + number});
  return labels;
}

std::vector<glm::dvec2> outline_of(const PlanePart& plane) {
  std::vector<glm::dvec2> outline;
  for (const glm::dvec2& corner : plane.outline_m) {
    outline.emplace_back(plane.grid.origin_m + corner.x * plane.grid.u + corner.y * plane.grid.v);
  }
  return outline;
}

bool is_level(const PlanePart& plane) {
  return plane.outline_m.size() >= 3 && is_horizontal(glm::cross(plane.grid.u, plane.grid.v));
}

// What is worked at: level planes of illuminance with requirements of their own role.
bool is_task(const PlanePart& plane) {
  return is_level(plane) && is_plain_illuminance(plane) &&
         std::any_of(plane.findings.begin(), plane.findings.end(),
                     [](const auto& finding) { return finding.requirement.origin.is_of_own_role; });
}

// The plane is all of the room, whose walls say where it ends.
bool is_whole(const SpacePart& room, const PlanePart& plane) {
  constexpr double kAlmost = 0.98;
  return std::abs(calc::signed_area(plane.outline_m)) >=
         kAlmost * std::abs(calc::signed_area(room.footprint_m));
}

void add_luminaires(const PlanProject& all, const SpacePart& space, PlanContents& contents) {
  for (const LuminaireMark& mark : space.luminaires) {
    const auto row = all.rows.find(mark.type_id);
    contents.luminaires.push_back(
        {&mark, row == all.rows.end() ? "" : position_letter(row->second)});
  }
}

std::string items(const std::string& list) {
  return list.empty() ? "" : "<ul class=\"layout-key\">\n" + list + "</ul>\n";
}

std::string item(const std::string& sign, const std::string& words) {
  return fmt::format("<li><b>{}</b> {}</li>\n", escape_html(sign), escape_html(words));
}

// "A Panel 600 × 34": types on this plan.
std::string type_items(const PlanProject& all, const PlanContents& contents) {
  std::map<std::size_t, int> counts;
  for (const PlanSign& sign : contents.luminaires) {
    const auto row = all.rows.find(sign.luminaire->type_id);
    if (row != all.rows.end()) ++counts[row->second];
  }
  std::string list;
  for (const auto& [row, count] : counts) {
    const LuminaireRow& type = all.project.luminaires[row];
    list += item(position_letter(row),
                 fmt::format("{} × {}", count, title_of(type.name, type.type_id)));
  }
  return list;
}

std::string notes_of(const Texts& t, const PlanContents& contents, const PlanFit& fit,
                     const PlanDrawing& drawing) {
  std::string notes;
  const std::size_t drawn = contents.luminaires.size() - drawing.outside;
  if (!drawing.is_as_points && drawing.without_letter < drawn)
    notes += std::string(" ") + t[Text::plan_letters];
  if (!contents.dashed_m.empty()) notes += std::string(" ") + t[Text::plan_dashed_tasks];
  if (std::any_of(contents.areas.begin(), contents.areas.end(),
                  [](const PlanArea& area) { return !area.is_room && area.outcome; })) {
    notes += std::string(" ") + t[Text::plan_dashed_planes];
  }
  if (fit.is_turned) notes += std::string(" ") + t[Text::plan_turned];
  if (drawing.is_as_points) notes += std::string(" ") + t[Text::plan_as_points];
  if (drawing.outside > 0) notes += " " + t.say<Text::plan_outside>(drawing.outside);
  if (drawing.without_letter > 0 && !contents.luminaires.empty())
    notes += " " + t.say<Text::plan_without_letters>(drawing.without_letter);
  return notes;
}

std::string figure(const PlanDrawing& drawing, const std::string& title, const std::string& keys,
                   const std::string& caption) {
  return fmt::format("<figure class=\"layout-figure storey-figure\" style=\"width:{}mm\">\n",
                     svg_number(drawing.width_mm)) +
         scroll_box(escape_html(title), drawing.svg) + keys + "<figcaption>" + caption +
         "</figcaption></figure>\n";
}

// "✓ pass 5": the tints of a plan.
std::string outcome_key(const Texts& t, const std::vector<PlanArea>& areas) {
  std::map<rules::Outcome, int> counts;
  for (const PlanArea& area : areas) {
    if (area.outcome && rules::counts(*area.outcome)) ++counts[*area.outcome];
  }
  std::string list;
  for (const auto& [outcome, count] : counts) {
    list += fmt::format(
        "<li><span class=\"badge {}\"><span class=\"sign\" aria-hidden=\"true\">{}</span>{}</span> "
        "{}</li>\n",
        calc::name_of(outcome), outcome_symbol(outcome), outcome_words(t, outcome), count);
  }
  return list.empty() ? "" : "<ul class=\"key\">\n" + list + "</ul>\n";
}

// A storey, in the order of its rooms.
class StoreyFigures {
 public:
  StoreyFigures(const PlanProject& all, const Storey& storey, std::string anchor)
      : all_(all), storey_(storey), anchor_(std::move(anchor)) {
    for (const std::size_t room : storey.rooms) {
      names_.push_back(room_name(space(room)));
      for (const glm::dvec2& corner : space(room).footprint_m) extent_m_.add(corner);
    }
    numbers_ = short_names(names_);
  }

  std::string title() const { return storey_title(all_.t, storey_.floor_z_m); }
  std::optional<PlanFit> fit() const {
    return fit_plan(extent_m_.size(), all_.paper, kStoreyScale);
  }
  std::string html(const PlanFit& fit) const {
    return "<div class=\"storey\">\n" + installation(fit) + results(fit) + "</div>\n";
  }

 private:
  const SpacePart& space(std::size_t room) const { return all_.project.spaces[room]; }
  const RoomSummary* summary(std::size_t i) const {
    const auto found = all_.summaries.find(&space(storey_.rooms[i]));
    return found == all_.summaries.end() ? nullptr : &found->second;
  }
  std::string installation(const PlanFit& fit) const;
  std::string results(const PlanFit& fit) const;
  std::string installation_items(const PlanDrawing& drawing) const;
  std::string result_items(const PlanDrawing& drawing) const;

  const PlanProject& all_;
  const Storey& storey_;
  std::string anchor_;
  FlatBox extent_m_;
  std::vector<RoomName> names_;
  std::vector<std::string> numbers_;
};

std::string StoreyFigures::installation(const PlanFit& fit) const {
  PlanContents contents;
  contents.north_deg = all_.project.north_deg;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const SpacePart& room = space(storey_.rooms[i]);
    contents.areas.push_back({room.footprint_m, true, name_labels(names_[i], numbers_[i]), {}});
    add_luminaires(all_, room, contents);
    for (const PlanePart& plane : room.planes) {
      if (is_task(plane) && !is_whole(room, plane)) contents.dashed_m.push_back(outline_of(plane));
    }
  }
  const std::string scale = scale_of(all_.t, fit),
                    words = all_.t.say<Text::storey_plan_of>(title(), scale);
  const PlanDrawing drawing = draw_plan(all_.t, contents, extent_m_, fit, words, anchor_ + "-plan");
  return figure(
      drawing, words, items(type_items(all_, contents)) + items(installation_items(drawing)),
      all_.t.say<Text::storey_plan_caption>(scale) + notes_of(all_.t, contents, fit, drawing));
}

std::string StoreyFigures::results(const PlanFit& fit) const {
  PlanContents contents;
  contents.north_deg = all_.project.north_deg;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    PlanArea area{space(storey_.rooms[i]).footprint_m, true, {}, {}};
    if (const RoomSummary* room = summary(i)) {
      area.labels = result_labels(all_.t, *room, names_[i], numbers_[i]);
      area.outcome = room->outcome;
      area.sign = outcome_symbol(room->outcome);
    } else {
      area.labels = name_labels(names_[i], numbers_[i]);
    }
    contents.areas.push_back(std::move(area));
  }
  const std::string scale = scale_of(all_.t, fit),
                    words = all_.t.say<Text::storey_results_of>(title(), scale);
  const PlanDrawing drawing =
      draw_plan(all_.t, contents, extent_m_, fit, words, anchor_ + "-results");
  return figure(
      drawing, words, outcome_key(all_.t, contents.areas) + items(result_items(drawing)),
      all_.t.say<Text::storey_results_caption>(scale) + notes_of(all_.t, contents, fit, drawing));
}

std::string StoreyFigures::installation_items(const PlanDrawing& drawing) const {
  std::string list;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const RoomName& name = names_[i];
    if (drawing.is_short[i])
      list += item(numbers_[i], numbers_[i] == name.number ? name.rest : name.whole);
  }
  return list;
}

// Of very many rooms the overview of rooms is the list.
std::string StoreyFigures::result_items(const PlanDrawing& drawing) const {
  constexpr std::ptrdiff_t kMost = 40;
  std::string list;
  if (std::count(drawing.is_short.begin(), drawing.is_short.end(), true) > kMost) return list;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (!drawing.is_short[i]) continue;
    const RoomName& name = names_[i];
    std::string words = numbers_[i] == name.number ? name.rest : name.whole;
    const RoomSummary* room = summary(i);
    if (room != nullptr) {
      if (const std::string values = joined(value_lines(all_.t, *room, ValueDetail::required));
          !values.empty())
        words += " · " + values;
    }
    list += item(room == nullptr ? numbers_[i]
                                 : std::string(outcome_symbol(room->outcome)) + " " + numbers_[i],
                 words);
  }
  return list;
}

std::string with(const std::string& names, const std::string& name) {
  return names.empty() ? name : names + ", " + name;
}

// Planes of a site with the same outline from above.
struct SiteArea {
  PlanArea area;
  std::vector<std::string> titles;
};

std::optional<rules::Outcome> outcome_of_plane(const PlanePart& plane) {
  rules::Outcome outcome = rules::Outcome::nothing_asked;
  for (const rules::Finding& finding : plane.findings)
    outcome = rules::graver(outcome, rules::outcome_of(finding));
  if (outcome == rules::Outcome::nothing_asked) return std::nullopt;
  return outcome;
}

// left_out: takes the titles of planes that no plan can show.
std::vector<SiteArea> site_areas(const Texts& t, const SpacePart& space, std::string& left_out) {
  std::vector<SiteArea> areas;
  std::map<std::vector<std::pair<long long, long long>>, std::size_t> known;  // in millimetres
  for (const PlanePart& plane : space.planes) {
    if (!is_level(plane)) continue;
    const std::vector<glm::dvec2> outline = outline_of(plane);
    constexpr double kFarthest_m = 1e7;
    std::vector<std::pair<long long, long long>> key;
    for (const glm::dvec2& m : outline) {
      if (std::abs(m.x) <= kFarthest_m && std::abs(m.y) <= kFarthest_m)
        key.emplace_back(std::llround(m.x * 1000.0), std::llround(m.y * 1000.0));
    }
    if (key.size() < outline.size() || outline.size() > kMostPlanCorners) {
      left_out = with(left_out, plane_title(t, plane));
      continue;
    }
    const auto [found, is_new] = known.emplace(key, areas.size());
    if (is_new) areas.push_back({{outline, false, {}, {}}, {}});
    SiteArea& area = areas[found->second];
    area.titles.push_back(plane_title(t, plane));
    if (const std::optional<rules::Outcome> outcome = outcome_of_plane(plane)) {
      area.area.outcome =
          rules::graver(area.area.outcome.value_or(rules::Outcome::nothing_asked), *outcome);
    }
  }
  return areas;
}

std::string all_titles(const SiteArea& area) {
  std::string titles;
  for (const std::string& title : area.titles) titles += (titles.empty() ? "" : ", ") + title;
  return titles;
}

// Planes and what lights them: luminaires much farther away would make the plan small.
FlatBox site_extent(const SpacePart& space, const std::vector<SiteArea>& areas) {
  constexpr double kLeastAround_m = 30.0;
  FlatBox planes;
  for (const SiteArea& area : areas) {
    for (const glm::dvec2& corner : area.area.outline_m) planes.add(corner);
  }
  FlatBox extent = planes, reach;
  if (!planes.is_empty()) {
    const glm::dvec2 around = glm::max(planes.size(), glm::dvec2(kLeastAround_m));
    reach = {planes.low - around, planes.high + around};
  }
  for (const LuminaireMark& luminaire : space.luminaires) {
    const glm::dvec2 place(luminaire.position_m);
    if (planes.is_empty() || reach.contains(place)) extent.add(place);
  }
  return extent;
}

struct SitePlan {
  const SpacePart* space = nullptr;
  std::vector<SiteArea> areas;
  FlatBox extent_m;
  std::optional<PlanFit> fit;  // nothing: too large for a page
  std::string left_out;        // planes
};

// Nothing where the space is so small that its own plan shows as much.
std::optional<SitePlan> site_plan(const PlanProject& all, const SpacePart& space) {
  constexpr double kSmallest_m = 12.0;
  if (!has_anything(space)) return std::nullopt;
  SitePlan site;
  site.space = &space;
  site.areas = site_areas(all.t, space, site.left_out);
  site.extent_m = site_extent(space, site.areas);
  if (site.extent_m.is_empty() || site.extent_m.longest() < kSmallest_m) return std::nullopt;
  site.fit = fit_plan(site.extent_m.size(), all.paper, kSiteScale);
  return site;
}

std::string site_title(const Texts& t, const SpacePart& space) {
  return t.say<Text::site_of>(title_of(space.name, space.id));
}

std::string site_figure(const PlanProject& all, SitePlan& site, const std::string& anchor) {
  PlanContents contents;
  contents.north_deg = all.project.north_deg;
  for (std::size_t i = 0; i < site.areas.size(); ++i) {
    SiteArea& area = site.areas[i];
    const std::string sign =
        area.area.outcome ? std::string(outcome_symbol(*area.area.outcome)) + " " : "";
    area.area.labels = {{sign + all_titles(area)}, {sign + fmt::format("{}", i + 1)}};
    contents.areas.push_back(area.area);
  }
  add_luminaires(all, *site.space, contents);
  for (const BodyMark& body : site.space->bodies)
    contents.lines_m.insert(contents.lines_m.end(), body.lines_m.begin(), body.lines_m.end());
  const std::string scale = scale_of(all.t, *site.fit),
                    words = all.t.say<Text::site_plan_of>(site_title(all.t, *site.space), scale);
  const PlanDrawing drawing = draw_plan(all.t, contents, site.extent_m, *site.fit, words, anchor);
  std::string list;
  for (std::size_t i = 0; i < site.areas.size(); ++i) {
    if (drawing.is_short[i]) list += item(fmt::format("{}", i + 1), all_titles(site.areas[i]));
  }
  return "<div class=\"storey\">\n" +
         figure(drawing, words,
                items(type_items(all, contents)) + outcome_key(all.t, contents.areas) + items(list),
                all.t.say<Text::site_plan_caption>(scale) +
                    notes_of(all.t, contents, *site.fit, drawing)) +
         "</div>\n";
}

std::string heading(const std::string& title) { return "<h3>" + escape_html(title) + "</h3>\n"; }

std::string names_of(const ProjectPart& project, const std::vector<std::size_t>& rooms) {
  std::string names;
  for (const std::size_t room : rooms) {
    const SpacePart& space = project.spaces[room];
    names += (names.empty() ? "" : ", ") + std::string(title_of(space.name, space.id));
  }
  return names;
}

std::string remark(const std::string& words) {
  return "<p class=\"quiet note-of-room\">" + escape_html(words) + "</p>\n";
}

}  // namespace

std::string html_storeys(const Texts& t, const ProjectPart& project, std::size_t index,
                         Paper paper) {
  const PlanProject all = plan_project(t, project, index, paper);
  const Storeys storeys = storeys_of(project);
  std::string html, empty, too_large;
  std::size_t plans = 0;
  const auto anchor = [&] { return fmt::format("{}-{}", all.anchor, ++plans); };
  for (const Storey& storey : storeys.list) {
    if (!are_drawn(storeys)) break;
    const StoreyFigures figures(all, storey, anchor());
    const bool has_any = std::any_of(storey.rooms.begin(), storey.rooms.end(), [&](std::size_t i) {
      return has_anything(project.spaces[i]);
    });
    if (!has_any) {
      empty = with(empty, figures.title());
    } else if (const std::optional<PlanFit> fit = figures.fit()) {
      html += heading(figures.title()) + figures.html(*fit);
    } else {
      too_large = with(too_large, figures.title());
    }
  }
  if (are_drawn(storeys)) {
    if (!empty.empty()) html += remark(t.say<Text::storeys_empty>(empty));
    if (!storeys.overlapping.empty())
      html += remark(t.say<Text::storeys_overlapping>(names_of(project, storeys.overlapping)));
    if (!storeys.without_outline.empty())
      html +=
          remark(t.say<Text::storeys_without_outline>(names_of(project, storeys.without_outline)));
  }
  for (const std::size_t space : storeys.outdoors) {
    std::optional<SitePlan> site = site_plan(all, project.spaces[space]);
    if (!site) continue;
    const std::string title = site_title(t, project.spaces[space]);
    if (site->fit) {
      html += heading(title) + site_figure(all, *site, anchor());
      if (!site->left_out.empty())
        html += remark(t.say<Text::storeys_without_outline>(site->left_out));
    } else {
      too_large = with(too_large, title);
    }
  }
  if (!too_large.empty()) html += remark(t.say<Text::storeys_too_large>(too_large));
  return html;
}

std::string storeys_title(const Texts& t, const ProjectPart& project) {
  if (are_drawn(storeys_of(project))) return t[Text::storeys_title];
  return escape_html(t.say<Text::site_of>(title_of(project.name, project.path)));
}

}  // namespace report
