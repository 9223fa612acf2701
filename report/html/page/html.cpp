#include "report/html/page/html.h"

#include "calc/base/file_hash.h"
#include "report/document/room_summary.h"
#include "report/html/chapters/data_sheets.h"
#include "report/html/chapters/html_about.h"
#include "report/html/chapters/html_advice.h"
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
#include "report/html/drawings/html_layout.h"
#include "report/html/page/html_footnotes.h"
#include "report/html/page/html_markup.h"
#include "report/html/page/html_pages.h"
#include "report/html/page/html_script.h"
#include "report/html/page/html_style.h"
#include "report/html/page/page_parts.h"
#include "report/html/page/print_pages.h"
#include "report/html/room/html_levels.h"
#include "report/html/room/html_plane.h"
#include "report/html/room/html_room.h"
#include "report/html/room/html_room_data.h"
#include "report/html/room/html_uses.h"
#include "report/html/room/html_values.h"
#include "report/text/base64.h"
#include "report/text/markup.h"
#include "report/text/room_overview.h"
#include "report/text/sentences.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace report {
namespace {

// 'sha256-...' of the only script that may run.  [CSP, hash sources]
std::string script_source(const std::string& script) {
  const std::string hex = calc::sha256_hex(script);
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  return "'sha256-" + base64(bytes) + "'";
}

// Long words are broken only between syllables where the browser can. Only in languages that have
// them, so that the other pages stay as they are.
constexpr const char* kLongWords =
    "@media (min-width: 40.01rem) { .attention li { grid-template-columns: 10.4rem 1fr; } }\n"
    "tbody th, tbody td:not(.num, .gauge-cell) { overflow-wrap: break-word; }\n";

// Up to the end of the style sheet. The policy forbids whatever a name from a file might still
// manage to load or run. title: escaped. pages: see print_pages.h.
std::string head_start(const Texts& t, const std::string& title, const std::string& pages) {
  return "<head>\n<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" content=\"width=device-width, "
         "initial-scale=1\"/>\n"
         "<meta name=\"color-scheme\" content=\"light dark\"/>\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
         "'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'; "
         "script-src " +
         script_source(html_script(t)) + "\"/>\n<title>" + title + " – " + t[Text::compliance] +
         "</title>\n<style>\n" + html_style() +
         (language_row(t.language()).has_long_words ? kLongWords : "") + pages;
}

// What comes before and after the main part of a page; the style sheet may go on in between.
std::string page_start(const Texts& t, const std::string& title, const std::string& pages) {
  return fmt::format("<!DOCTYPE html>\n<html lang=\"{}\">\n", t.language_tag()) +
         head_start(t, title, pages);
}

std::string body_start(const Texts& t) {
  return std::string("</style>\n</head>\n<body>\n<a class=\"skip\" href=\"#main\">") +
         t[Text::skip_to_results] + "</a>\n";
}

constexpr const char* kMainStart = "<main id=\"main\">\n";

std::string page_end(const Texts& t, const Provenance& provenance) {
  return "</main>\n<footer><p>" +
         t.say<Text::made_by_program>(escape_html(provenance.program_version)) +
         "</p></footer>\n<script>" + html_script(t) + "</script>\n</body>\n</html>\n";
}

std::string space_title(const SpacePart& space) {
  return fmt::format("{} <span class=\"id\">{}</span>", escape_html(title_of(space.name, space.id)),
                     space.name.empty() ? "" : escape_html(space.id));
}

// Zones that were not made, and why.
std::string notes_html(const Texts& t, const SpacePart& space) {
  std::string html;
  for (const calc::Message& note : space.notes)
    html += "<p class=\"quiet note-of-room\">" + sentence_html(t, note) + "</p>\n";
  for (const rules::RowCoverage& row : space.coverage) {
    html += fmt::format("<p class=\"note-of-room{}\">{}</p>\n", row.asks_all() ? " quiet" : "",
                        escape_html(coverage_words(t, row)));
  }
  return html;
}

std::string space_html(const Texts& t, const ProjectPart& project, std::size_t p, std::size_t s,
                       const ColourScales& scales, bool folds_passed, Paper paper,
                       const Footnotes& footnotes, const RoomSummary* summary) {
  const SpacePart& space = project.spaces[s];
  const std::vector<std::string> groups = level_groups(space);
  // Rooms that the overview names are folded; a browser that goes to a place inside opens them.
  const bool is_folded = folds_passed && summary != nullptr;
  std::string html =
      is_folded ? fmt::format(
                      "<section class=\"space\"><details class=\"room-fold\"><summary><h3>{}</h3>"
                      " {}</summary>\n<div id=\"{}\">\n",
                      space_title(space), outcome_badge(t, summary->outcome), space_anchor(p, s))
                : fmt::format("<section class=\"space\"><h3 id=\"{}\">{}</h3>\n",
                              space_anchor(p, s), space_title(space));
  html += html_room(t, space) + html_room_data(t, project, space) + html_layout(t, project, space) +
          notes_html(t, space) + html_levels(t, project, groups);
  for (std::size_t k = 0; k < space.planes.size(); ++k)
    html += html_plane(t, {p, s, k}, space, space.planes[k], scales, folds_passed, groups, paper,
                       footnotes);
  return html + (is_folded ? "</div></details></section>\n" : "</section>\n");
}

std::string page_links(const Texts& t, const ProjectPart& project, std::size_t p,
                       const std::string& folder) {
  std::string html = "<ul class=\"pages\">\n";
  for (const HtmlPage& room : html_pages(project, p)) {
    const SpacePart& space = project.spaces[room.space];
    const std::string part = room.planes == space.planes.size()
                                 ? ""
                                 : ", " + t.say<Text::planes_from_to>(
                                              room.first_plane + 1, room.first_plane + room.planes);
    html += fmt::format("<li><a href=\"{}/{}\">{}</a><span class=\"quiet\">{}</span>{}</li>\n",
                        folder, room.name, escape_html(title_of(space.name, space.id)), part,
                        room.first_plane == 0 ? notes_html(t, space) : "");
  }
  return html + "</ul>\n";
}

std::string run_start(const RoomRun& run) {
  if (run.page.empty()) return "<div class=\"run\">\n";
  return fmt::format("<div class=\"run\" style=\"page: {}\">\n", run.page);
}

// A revision or a date alone, which CI fills in, makes no document for a client.
bool says_whose(const calc::AboutProject& about) {
  return !about.client.empty() || !about.author.empty() || !about.company.empty() ||
         !about.logo.bytes.empty();
}

// The page that holds everything, or the index of pages in `folder`. What comes first in it is
// known last: all else waits in spills.
class HtmlWriter : public FormatWriter {
 public:
  HtmlWriter(const DocumentFrame& frame, const SpillPlace& place, const Texts& t,
             const PageStyle& style, std::string folder, const PageNumbers* numbers);

  void add(const ProjectPart& project) override;
  void finish(const DocumentEnd& end, Sink& sink) override;

 private:
  bool is_only() const { return frame_.paths.size() == 1; }
  std::string section_name(const ProjectPart& project);
  struct Chapter {
    std::string html;     // "" = the project has none
    const char* address;  // of its heading, without the number of the project; "" = none
    Text title;
    bool is_on_paper = false;               // alone
    std::vector<ContentsEntry> parts = {};  // of it, in the contents
  };
  void add_data_sheets(const ProjectPart& project, std::vector<Chapter>& chapters);
  std::vector<Chapter> chapters_of(const ProjectPart& project) const;
  std::string project_html(const ProjectPart& project, const std::vector<Chapter>& chapters,
                           const std::string& section, bool folds_passed) const;
  std::string annex_of(const ProjectPart& project) const;
  void add_project(const ProjectPart& project, const std::vector<Chapter>& chapters);
  void add_to_masthead(const ProjectPart& project, const std::vector<Chapter>& chapters);
  void write_masthead(const DocumentEnd& end, Sink& sink) const;
  bool has_cover() const;
  std::string page_title() const;

  const DocumentFrame& frame_;
  Texts t_;
  PageStyle style_;
  std::string folder_;
  const PageNumbers* numbers_;
  RegionNames regions_;
  Footnotes footnotes_;
  std::size_t project_ = 0;               // the next one
  std::size_t sheets_ = 0;                // data sheets so far
  std::map<std::string, int> titles_;     // how many projects have each
  std::string only_title_;                // of the first one
  std::string about_, on_cover_, rooms_;  // of the only one
  std::string storeys_, storeys_title_;   // likewise
  bool says_whose_ = false;               // the only one
  std::vector<ContentsEntry> sections_;   // of the first ones
  Spill paths_;
  std::string head_, foot_;  // of pages; of the only project
  Spill room_rules_;
  std::string revision_, summary_start_;
  HtmlAttention attention_;
  Spill summary_rows_;
  // Whether planes that pass are folded hangs on how many there are: while there are few, projects
  // are rendered both ways.
  std::size_t planes_ = 0;
  Spill projects_, projects_unfolded_;
};

HtmlWriter::HtmlWriter(const DocumentFrame& frame, const SpillPlace& place, const Texts& t,
                       const PageStyle& style, std::string folder, const PageNumbers* numbers)
    : frame_(frame),
      t_(t),
      style_(style),
      folder_(std::move(folder)),
      numbers_(numbers),
      footnotes_(t),
      paths_(place),
      room_rules_(place),
      attention_(t, folder_, place),
      summary_rows_(place),
      projects_(place),
      projects_unfolded_(place) {
  if (frame.revised != nullptr) {
    revision_ = regions_.with_unique_regions(html_revision(t, *frame.revised));
  }
  summary_start_ = regions_.with_unique_regions(
      html_summary_start(t, t[Text::summary_of_planes], frame.provenance.confidence));
}

void HtmlWriter::add(const ProjectPart& project) {
  footnotes_.add(planes_of(project));
  std::vector<Chapter> chapters = chapters_of(project);
  if (style_.sheets) add_data_sheets(project, chapters);
  add_to_masthead(project, chapters);
  attention_.add(project, project_, footnotes_);
  summary_rows_.write(html_summary_rows(t_, project, project_, is_only(), folder_, footnotes_));
  add_project(project, chapters);
  ++project_;
}

void HtmlWriter::add_project(const ProjectPart& project, const std::vector<Chapter>& chapters) {
  const bool was_few = planes_ <= kFewPlanes;
  for (const SpacePart& space : project.spaces) planes_ += space.planes.size();
  const std::string section = section_name(project);
  if (folder_.empty()) {
    for (const RoomRun& run : room_runs(project, project_)) room_rules_.write(run_rule(run));
  }
  if (planes_ <= kFewPlanes) {
    RegionNames regions = regions_;
    projects_unfolded_.write(
        regions.with_unique_regions(project_html(project, chapters, section, false)));
    if (project_ + 1 == frame_.paths.size()) {  // there will be no more planes
      regions_ = std::move(regions);
      return;
    }
  } else if (was_few) {
    projects_unfolded_.clear();
  }
  projects_.write(regions_.with_unique_regions(project_html(project, chapters, section, true)));
}

// Sections are landmarks, which must differ in name; projects may have one name.
std::string HtmlWriter::section_name(const ProjectPart& project) {
  const std::string title(title_of(project.name, project.path));
  const int number = ++titles_[title];
  if (number == 1) return fmt::format("aria-labelledby=\"project{}\"", project_ + 1);
  return fmt::format("aria-label=\"{} ({})\"", escape_html(title), number);
}

std::string HtmlWriter::project_html(const ProjectPart& project,
                                     const std::vector<Chapter>& chapters,
                                     const std::string& section, bool folds_passed) const {
  const bool has_rooms = folder_.empty() && !project.spaces.empty();
  const std::vector<RoomRun> runs =
      has_rooms ? room_runs(project, project_) : std::vector<RoomRun>();
  const std::string messages = html_messages(t_, project);
  const ColourScales scales(project, style_.scale, style_.palette);
  std::string html = fmt::format("<section class=\"project\" {}>\n", section);
  // A heading alone stands on the page of the first room, and messages above several.
  const bool is_first_run_open = has_rooms && (messages.empty() || runs.front().page.empty());
  if (is_first_run_open) html += run_start(runs.front());
  html +=
      fmt::format("<h2 id=\"project{}\">{}</h2>\n", project_ + 1,
                  is_only() ? t_[Text::planes] : escape_html(title_of(project.name, project.path)));
  if (!is_only() && !project.name.empty())
    html += "<p class=\"quiet\">" + escape_html(project.path) + "</p>\n";
  if (!project.is_judged) {
    html += "<p class=\"message\">" + badge(t_, rules::Verdict::not_judged) + " " +
            t_[Text::project_unreadable] + "</p>\n";
  }
  if (!is_only()) {
    html += html_about(t_, project.about) + html_rooms(t_, project, project_, folder_) +
            html_storeys(t_, project, project_, style_.paper);
  }
  html += messages;
  const std::vector<RoomSummary> rooms =
      has_overview(project) ? room_summaries(project) : std::vector<RoomSummary>();
  const auto summary_of = [&](std::size_t s) {
    const auto found = std::find_if(rooms.begin(), rooms.end(), [&](const RoomSummary& room) {
      return room.space == &project.spaces[s];
    });
    return found == rooms.end() ? nullptr : &*found;
  };
  for (const RoomRun& run : runs) {
    if (run.first > 0 || !is_first_run_open) html += run_start(run);
    for (std::size_t s = run.first; s < run.first + run.rooms; ++s)
      html += space_html(t_, project, project_, s, scales, folds_passed, style_.paper, footnotes_,
                         summary_of(s));
    if (!run.is_all) html += "</div>\n";
  }
  if (!folder_.empty() && !project.spaces.empty()) {
    html += page_links(t_, project, project_, folder_);
  }
  for (const Chapter& chapter : chapters) html += chapter.html;
  return html + (!runs.empty() && runs.front().is_all ? "</div>\n" : "") + "</section>\n";
}

void HtmlWriter::add_to_masthead(const ProjectPart& project, const std::vector<Chapter>& chapters) {
  constexpr std::size_t kMostProjects = 12, kMostRooms = 90;
  paths_.write((project_ == 0 ? "" : " · ") + escape_html(project.path));
  const std::string title = escape_html(title_of(project.name, project.path));
  if (project_ == 0) only_title_ = title;
  if (project_ >= kMostProjects) return;
  sections_.push_back(
      {fmt::format("#project{}", project_ + 1), is_only() ? t_[Text::planes] : title});
  if (!is_only()) return;
  about_ = html_about(t_, project.about);
  if (const std::string rooms = html_rooms(t_, project, project_, folder_); !rooms.empty()) {
    rooms_ =
        fmt::format("<section aria-labelledby=\"rooms\"><h2 id=\"rooms\">{}</h2>\n{}</section>\n",
                    t_[Text::overview_title], rooms);
  }
  if (const std::string plans = html_storeys(t_, project, project_, style_.paper); !plans.empty()) {
    storeys_title_ = storeys_title(t_, project);
    storeys_ = regions_.with_unique_regions(fmt::format(
        "<section aria-labelledby=\"storeys\"><h2 id=\"storeys\">{}</h2>\n{}</section>\n",
        storeys_title_, plans));
  }
  says_whose_ = says_whose(project.about);
  if (has_cover()) on_cover_ = html_cover_picture(t_, project);
  foot_ = foot_words(t_, project);
  head_ = head_words(t_, project.about);
  for (std::size_t s = 0; folder_.empty() && s < project.spaces.size() && s < kMostRooms; ++s) {
    const SpacePart& space = project.spaces[s];
    sections_.push_back(
        {"#" + space_anchor(project_, s), escape_html(title_of(space.name, space.id)), true});
  }
  for (const Chapter& chapter : chapters) {
    if (chapter.html.empty() || *chapter.address == '\0') continue;
    sections_.push_back({fmt::format("#{}{}", chapter.address, project_ + 1), t_[chapter.title],
                         chapter.is_on_paper});
    sections_.insert(sections_.end(), chapter.parts.begin(), chapter.parts.end());
  }
}

// Behind all else.
void HtmlWriter::add_data_sheets(const ProjectPart& project, std::vector<Chapter>& chapters) {
  DataSheets sheets = data_sheets(t_, project, project_, *style_.sheets, sheets_);
  sheets_ += sheets.entries.size();
  Chapter chapter{std::move(sheets.html), "datasheets", Text::sheets_title};
  for (const DataSheets::Entry& entry : sheets.entries)
    chapter.parts.push_back({"#" + entry.anchor, escape_html(entry.name), true});
  chapters.push_back(std::move(chapter));
}

// What stands behind the rooms, with the addresses of those that the contents name.
std::vector<HtmlWriter::Chapter> HtmlWriter::chapters_of(const ProjectPart& project) const {
  std::vector<Chapter> chapters{
      {html_uses(t_, project, project_), "uses", Text::uses},
      {html_aggregates(t_, project, project_), "", {}},
      {html_advice(t_, project, project_), "advice", Text::advice_title},
      {html_emergency(t_, project, project_, folder_, footnotes_), "emergency", Text::emergency},
      {html_roads(t_, project, project_), "roads", Text::roads},
      {html_luminaires(t_, project, project_), "luminaires", Text::luminaires},
      {html_maintenance(t_, project, project_), "maintenance", Text::maintenance_plan},
      {html_energy(t_, project, project_), "energy", Text::energy},
      {html_deviations(t_, project, project_, folder_), "deviations", Text::deviations},
      {html_calculation(t_, frame_.provenance, project, project_), "calculation",
       Text::calculation},
      {html_inputs(t_, project), "", {}}};
  if (folder_.empty()) chapters.push_back({annex_of(project), "annex", Text::annex, true});
  return chapters;
}

std::string HtmlWriter::annex_of(const ProjectPart& project) const {
  std::vector<AnnexPlane> planes;
  for (const SpacePart& space : project.spaces) {
    for (const PlanePart& plane : space.planes) planes.push_back({&space, &plane});
  }
  return html_annex(t_, planes, style_.annex, fmt::format("annex{}", project_ + 1));
}

std::string HtmlWriter::page_title() const {
  return is_only() ? only_title_ : t_.say<Text::project_count>(frame_.paths.size());
}

bool HtmlWriter::has_cover() const {
  if (style_.cover != Cover::automatic) return style_.cover == Cover::always;
  return says_whose_;
}

void HtmlWriter::write_masthead(const DocumentEnd& end, Sink& sink) const {
  sink.write(std::string("<header>\n") + (has_cover() ? "<div class=\"cover\">\n" : "") +
             "<p class=\"eyebrow\">luxgate · " + t_[Text::compliance_report] + "</p>\n<h1>" +
             page_title() + "</h1>\n<p class=\"quiet paths\">");
  paths_.copy_to(sink);
  if (!end.provenance.timestamp.empty()) {
    sink.write(" · " + escape_html(end.provenance.timestamp));
  }
  std::vector<ContentsEntry> sections;
  if (frame_.revised != nullptr)
    sections.push_back({"#revision", html_revision_title(t_, *frame_.revised)});
  if (!rooms_.empty()) sections.push_back({"#rooms", t_[Text::overview_title]});
  if (!storeys_.empty()) sections.push_back({"#storeys", storeys_title_});
  if (!attention_.is_empty()) sections.push_back({"#attention", t_[Text::needs_attention]});
  sections.push_back({"#summary", t_[Text::summary]});
  sections.insert(sections.end(), sections_.begin(), sections_.end());
  sections.push_back({"#method", t_[Text::method_title]});
  sections.push_back({"#provenance", t_[Text::provenance]});
  sink.write("</p>\n" + on_cover_ + about_ + html_verdict_banner(t_, frame_, end) +
             (has_cover() ? "</div>\n" : "") + html_contents(t_, sections, numbers_) +
             "</header>\n");
}

void HtmlWriter::finish(const DocumentEnd& end, Sink& sink) {
  const std::string symbol = outcome_symbol(end.totals.outcome);
  const std::string foot = is_only() ? foot_ : page_title();
  const std::string head = is_only() ? head_ : head_words(t_, {});
  sink.write(page_start(t_, symbol + " " + page_title(),
                        (style_.sheets ? sheet_style() : "") +
                            page_rules(t_, style_.paper, {head, "", foot}, has_cover())));
  room_rules_.copy_to(sink);
  sink.write(body_start(t_));
  write_masthead(end, sink);
  sink.write(kMainStart + revision_ + rooms_ + storeys_);
  attention_.copy_to(sink);
  const bool is_folded = planes_ > kFewPlanes && !rooms_.empty();
  sink.write(html_summary_title(t_, is_folded) + summary_start_);
  summary_rows_.copy_to(sink);
  sink.write(html_summary_end(is_folded));
  (planes_ > kFewPlanes ? projects_ : projects_unfolded_).copy_to(sink);
  RegionNames regions = regions_;
  sink.write(html_method(t_, end, footnotes_) +
             regions.with_unique_regions(html_provenance(t_, end.provenance)) +
             page_end(t_, end.provenance));
}

}  // namespace

std::unique_ptr<FormatWriter> html_writer(const DocumentFrame& frame, const SpillPlace& place,
                                          const Texts& t, const std::string& folder,
                                          const PageStyle& style, const PageNumbers* numbers) {
  return std::make_unique<HtmlWriter>(frame, place, t, style, folder, numbers);
}

std::string render_html(const Document& document, const Texts& t) {
  return render_whole(document, [&](const DocumentFrame& frame, const SpillPlace& place) {
    return html_writer(frame, place, t);
  });
}

std::vector<HtmlPage> html_pages(const ProjectPart& project, std::size_t index) {
  std::vector<HtmlPage> pages;
  for (std::size_t s = 0; s < project.spaces.size(); ++s) {
    const std::size_t planes = project.spaces[s].planes.size();
    std::size_t first = 0;
    do {
      const std::size_t count = std::min(kPlanesPerPage, planes - first);
      pages.push_back({page_name({index, s, first}), index, s, first, count});
      first += kPlanesPerPage;
    } while (first < planes);
  }
  return pages;
}

std::string render_html_page(const Provenance& provenance, const ProjectPart& project,
                             const HtmlPage& room, const std::string& index, const Texts& t,
                             const PageStyle& style) {
  const SpacePart& space = project.spaces[room.space];
  const std::vector<std::string> groups = level_groups(space);
  const std::string title = escape_html(title_of(space.name, space.id));
  const std::string head = "<header>\n<p class=\"eyebrow\"><a href=\"" + escape_html(index) +
                           "\">" + t[Text::all_results] + "</a> · luxgate · " +
                           t[Text::compliance_report] + "</p>\n<h1>" + title +
                           "</h1>\n<p class=\"quiet paths\">" +
                           escape_html(title_of(project.name, project.path)) + "</p>\n" +
                           html_about(t, project.about) + "</header>\n";
  std::string body = std::string("<section class=\"space\"><h2 class=\"unseen\">") +
                     t[Text::planes] + "</h2>\n<h3 class=\"unseen\">" + title + "</h3>\n";
  if (room.first_plane == 0) {
    body += html_room(t, space) + html_room_data(t, project, space) +
            html_layout(t, project, space) + notes_html(t, space);
  }
  body += html_levels(t, project, groups);
  std::vector<AnnexPlane> annex;
  std::vector<RoomPlane> planes;
  for (std::size_t k = room.first_plane; k < room.first_plane + room.planes; ++k)
    planes.push_back({&space, &space.planes[k]});
  Footnotes footnotes(t);
  footnotes.add(planes);
  const ColourScales scales(project, style.scale, style.palette);
  for (std::size_t k = room.first_plane; k < room.first_plane + room.planes; ++k) {
    body += html_plane(t, {room.project, room.space, k}, space, space.planes[k], scales, true,
                       groups, style.paper, footnotes);
    annex.push_back({&space, &space.planes[k]});
  }
  RegionNames regions;
  const PageWords words{head_words(t, project.about), std::string(title_of(space.name, space.id)),
                        foot_words(t, project)};
  return page_start(t, title, page_rules(t, style.paper, words)) + body_start(t) + head +
         kMainStart + regions.with_unique_regions(body + footnotes.list() + "</section>\n") +
         html_annex(t, annex, style.annex, "annex") + page_end(t, provenance);
}

}  // namespace report
