#include "report/html/client/client_page.h"

#include "report/document/room_summary.h"
#include "report/document/storeys.h"
#include "report/html/chapters/data_sheets.h"
#include "report/html/chapters/html_about.h"
#include "report/html/chapters/html_aggregates.h"
#include "report/html/chapters/html_deviations.h"
#include "report/html/chapters/html_emergency.h"
#include "report/html/chapters/html_energy.h"
#include "report/html/chapters/html_findings.h"
#include "report/html/chapters/html_maintenance.h"
#include "report/html/chapters/html_method.h"
#include "report/html/chapters/html_project.h"
#include "report/html/chapters/html_revision.h"
#include "report/html/chapters/html_roads.h"
#include "report/html/chapters/html_storeys.h"
#include "report/html/client/client_positions.h"
#include "report/html/client/client_room.h"
#include "report/html/client/client_style.h"
#include "report/html/page/html_footnotes.h"
#include "report/html/page/html_markup.h"
#include "report/html/page/html_tool_page.h"
#include "report/html/page/page_parts.h"
#include "report/html/page/print_pages.h"
#include "report/html/room/html_room.h"
#include "report/html/room/html_uses.h"
#include "report/text/markup.h"
#include "report/text/notices.h"
#include "report/text/room_titles.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace report {
namespace {

struct ClientChapter {
  std::string html;     // "" = the project has none
  std::string address;  // of its heading; "" = the contents have no line for it
  std::string title;    // escaped
};

std::string causes_html(const Texts& t, const ProjectPart& project,
                        const std::vector<RoomSummary>& rooms) {
  const std::vector<std::string> titles = room_titles(project);
  std::string html;
  for (const RoomSummary& room : rooms) {
    const std::string causes = client_causes(t, room);
    if (causes.empty()) continue;
    const auto s = static_cast<std::size_t>(room.space - project.spaces.data());
    html += fmt::format("<h3>{}</h3>\n", escape_html(titles[s])) + causes;
  }
  return html.empty() ? html : "<div class=\"causes\">\n" + html + "</div>\n";
}

// words: not escaped; "" = none.
std::string paragraph(const std::string& words) {
  return words.empty() ? words : "<p>" + escape_html(words) + "</p>\n";
}

class ClientWriter : public FormatWriter {
 public:
  ClientWriter(const DocumentFrame& frame, const SpillPlace& place, const Texts& t,
               const PageStyle& style, const PageNumbers* numbers)
      : frame_(frame), t_(t), style_(style), numbers_(numbers), footnotes_(t), body_(place) {}

  void add(const ProjectPart& project) override;
  void finish(const DocumentEnd& end, Sink& sink) override;

 private:
  bool is_only() const { return frame_.paths.size() == 1; }
  std::vector<ClientChapter> chapters_of(const ProjectPart& project);
  ClientChapter overview(const ProjectPart& project, const std::vector<RoomSummary>& rooms) const;
  void add_rooms(const ProjectPart& project, const std::vector<RoomSummary>& rooms,
                 std::vector<ClientChapter>& chapters) const;
  // The schedule, and the positions.
  std::string luminaires(const ProjectPart& project);
  bool has_cover() const { return style_.cover != Cover::never; }

  const DocumentFrame& frame_;
  Texts t_;
  PageStyle style_;
  const PageNumbers* numbers_;
  RegionNames regions_;
  Footnotes footnotes_;
  std::size_t project_ = 0;    // the next one
  std::size_t sheets_ = 0;     // data sheets so far
  std::size_t positions_ = 0;  // luminaires whose positions are listed so far
  ClientMethod method_;
  std::string only_title_, about_, on_cover_, head_, foot_, notes_, messages_;
  std::vector<ContentsEntry> contents_;
  Spill body_;
};

ClientChapter ClientWriter::overview(const ProjectPart& project,
                                     const std::vector<RoomSummary>& rooms) const {
  ClientChapter chapter;
  chapter.address = fmt::format("overview{}", project_ + 1);
  chapter.title =
      is_only() ? t_[Text::overview_title] : escape_html(title_of(project.name, project.path));
  std::string body;
  if (!is_only()) body += html_about(t_, project.about);
  if (!project.is_judged) {
    body += "<p class=\"message\">" + badge(t_, rules::Verdict::not_judged) + " " +
            t_[Text::project_unreadable] + "</p>\n" + html_messages(t_, project);
  }
  body += html_rooms(t_, project, project_, "") + causes_html(t_, project, rooms);
  if (!body.empty())
    chapter.html =
        fmt::format("<h2 id=\"{}\" class=\"overview\">{}</h2>\n", chapter.address, chapter.title) +
        body;
  return chapter;
}

void ClientWriter::add_rooms(const ProjectPart& project, const std::vector<RoomSummary>& rooms,
                             std::vector<ClientChapter>& chapters) const {
  const ColourScales scales(project, style_.scale, style_.palette);
  const std::vector<std::string> titles = room_titles(project);
  for (const std::size_t s : spaces_in_order(project)) {
    const SpacePart& space = project.spaces[s];
    const auto summary = std::find_if(rooms.begin(), rooms.end(),
                                      [&](const auto& room) { return room.space == &space; });
    // A room without planes may still have something that was asked and could not be made.
    if (space.planes.empty() && summary == rooms.end() && notices_of(space).empty()) continue;
    chapters.push_back({client_room(t_, project, {project_, s, 0}, titles[s],
                                    summary == rooms.end() ? nullptr : &*summary, scales,
                                    style_.paper, footnotes_),
                        space_anchor(project_, s), escape_html(titles[s])});
  }
}

std::string ClientWriter::luminaires(const ProjectPart& project) {
  const std::string schedule = html_luminaires(t_, project, project_);
  if (schedule.empty()) return schedule;
  const ClientPositions positions = client_positions(
      t_, project, !frame_.provenance.selection.empty(), kMostClientPositions - positions_);
  positions_ += positions.listed;
  return schedule + positions.html;
}

std::vector<ClientChapter> ClientWriter::chapters_of(const ProjectPart& project) {
  const std::vector<RoomSummary> rooms = room_summaries(project);
  std::vector<ClientChapter> chapters{overview(project, rooms)};
  if (const std::string plans = html_storeys(t_, project, project_, style_.paper); !plans.empty()) {
    const std::string address = fmt::format("storeys{}", project_ + 1);
    const std::string title = storeys_title(t_, project);
    chapters.push_back(
        {fmt::format("<h2 id=\"{}\">{}</h2>\n", address, title) + plans, address, title});
  }
  add_rooms(project, rooms, chapters);
  const auto add = [&](std::string html, const char* address, Text title) {
    chapters.push_back({std::move(html),
                        *address == '\0' ? "" : fmt::format("{}{}", address, project_ + 1),
                        t_[title]});
  };
  add(html_roads(t_, project, project_), "roads", Text::roads);
  add(html_emergency(t_, project, project_, "", footnotes_), "emergency", Text::emergency);
  add(luminaires(project), "luminaires", Text::luminaires);
  add(html_energy(t_, project, project_), "energy", Text::energy);
  add(html_aggregates(t_, project, project_, AggregatesFor::client), "", {});
  add(html_maintenance(t_, project, project_), "maintenance", Text::maintenance_plan);
  add(html_deviations(t_, project, project_, ""), "deviations", Text::deviations);
  if (style_.sheets) {
    DataSheets sheets = data_sheets(t_, project, project_, *style_.sheets, sheets_);
    sheets_ += sheets.entries.size();
    add(std::move(sheets.html), "datasheets", Text::sheets_title);
  }
  return chapters;
}

void ClientWriter::add(const ProjectPart& project) {
  footnotes_.add(planes_of(project));
  for (const SpacePart& space : project.spaces) {
    for (const RoomPicture& picture : space.pictures.list) {
      method_.has_pictures = true;
      method_.has_rendered = method_.has_rendered || picture.is_rendered;
    }
  }
  if (is_only()) {
    only_title_ = escape_html(title_of(project.name, project.path));
    about_ = html_about(t_, project.about);
    on_cover_ = html_cover_picture(t_, project);
    foot_ = foot_words(t_, project);
    head_ = head_words(t_, project.about);
  }
  // Few rooms have pages of their own; many follow each other, so that no page is left half empty.
  constexpr std::size_t kOwnPages = 12;
  const bool has_own_pages = project.spaces.size() <= kOwnPages;
  body_.write(has_own_pages ? "<section class=\"client\">\n" : "<section class=\"client many\">\n");
  for (const ClientChapter& chapter : chapters_of(project)) {
    if (chapter.html.empty()) continue;
    body_.write(regions_.with_unique_regions(chapter.html));
    if (!chapter.address.empty()) contents_.push_back({"#" + chapter.address, chapter.title});
  }
  body_.write("</section>\n");
  notes_ += client_notes(t_, project, footnotes_);
  if (project.is_judged)
    messages_ += regions_.with_unique_regions(html_messages(t_, project, false));
  ++project_;
}

void ClientWriter::finish(const DocumentEnd& end, Sink& sink) {
  const std::string title = is_only() ? only_title_ : t_.say<Text::project_count>(project_);
  const std::string page_style = client_style() + (style_.sheets ? sheet_style() : "");
  std::vector<ContentsEntry> entries = contents_;
  std::string revision;
  if (frame_.revised != nullptr) {
    revision = regions_.with_unique_regions(html_revision(t_, *frame_.revised));
    entries.insert(entries.begin(), {"#revision", html_revision_title(t_, *frame_.revised)});
  }
  entries.push_back({"#method", t_[Text::method_title]});
  std::string to_messages;
  if (!messages_.empty()) {
    entries.push_back({"#messages", t_[Text::messages]});
    to_messages = fmt::format(" (<a href=\"#messages\">{}</a>)", t_[Text::see_messages]);
  }
  sink.write(tool_page_start(
      t_, {title, t_[Text::compliance_report], page_style, is_only() ? foot_ : title, style_.paper,
           is_only() ? head_ : head_words(t_, {}), has_cover()}));
  sink.write(on_cover_ + about_ + html_verdict_banner(t_, frame_, end, to_messages) +
             (has_cover() ? "</div>\n" : "") + html_contents(t_, entries, numbers_) +
             "</header>\n<main id=\"main\">\n" + revision);
  body_.copy_to(sink);
  sink.write(html_method(t_, end, footnotes_, &method_) + "<section>\n" +
             paragraph(provenance_remarks(end.provenance, t_)) + paragraph(t_[Text::client_more]) +
             notes_ +
             (messages_.empty() ? "" : "<div id=\"messages\">\n" + messages_ + "</div>\n") +
             "</section>\n");
  sink.write(
      tool_page_end(t_.say<Text::made_by_program>(escape_html(end.provenance.program_version))));
}

}  // namespace

std::unique_ptr<FormatWriter> client_writer(const DocumentFrame& frame, const SpillPlace& place,
                                            const Texts& t, const PageStyle& style,
                                            const PageNumbers* numbers) {
  return std::make_unique<ClientWriter>(frame, place, t, style, numbers);
}

}  // namespace report
