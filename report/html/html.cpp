#include "report/html/html.h"

#include "calc/base/file_hash.h"
#include "report/html/html_aggregates.h"
#include "report/html/html_findings.h"
#include "report/html/html_markup.h"
#include "report/html/html_pages.h"
#include "report/html/html_plane.h"
#include "report/html/html_project.h"
#include "report/html/html_revision.h"
#include "report/html/html_room.h"
#include "report/html/html_script.h"
#include "report/html/html_style.h"
#include "report/text/markup.h"
#include "report/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>

namespace report {
namespace {

std::string page_title(const Texts& t, const Document& document) {
  if (document.projects.size() != 1) return t.say<Text::project_count>(document.projects.size());
  return escape_html(title_of(document.projects[0].name, document.projects[0].path));
}

// 'sha256-...' of the only script that may run.  [CSP, hash sources]
std::string script_source(const std::string& script) {
  const std::string hex = calc::sha256_hex(script);
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  return "'sha256-" + base64(bytes) + "'";
}

// German words are longer, and broken only between syllables where the browser can. Only there, so
// that English pages stay as they are.
constexpr const char* kLongWords =
    "@media (min-width: 40.01rem) { .attention li { grid-template-columns: 10.4rem 1fr; } }\n"
    "tbody th, tbody td:not(.num, .gauge-cell) { overflow-wrap: break-word; }\n";

// The policy forbids whatever a name from a file might still manage to load or run. title: escaped.
std::string head(const Texts& t, const std::string& title, bool has_script) {
  return "<head>\n<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" content=\"width=device-width, "
         "initial-scale=1\"/>\n"
         "<meta name=\"color-scheme\" content=\"light dark\"/>\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
         "'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'" +
         (has_script ? "; script-src " + script_source(html_script(t)) : "") + "\"/>\n<title>" +
         title + " – " + t[Text::compliance] + "</title>\n<style>\n" + html_style() +
         (t.language() == Language::german ? kLongWords : "") + "</style>\n</head>\n";
}

// Regions are landmarks, which must differ in name; planes of several rooms may have one name.
// body: made by our own renderers, so that no name from a file can hold a quote.
std::string with_unique_regions(std::string_view body) {
  constexpr std::string_view kLabel = "role=\"region\" tabindex=\"0\" aria-label=\"";
  std::set<std::string> taken;
  std::string html;
  html.reserve(body.size());
  for (std::size_t at = body.find(kLabel); at != std::string_view::npos; at = body.find(kLabel)) {
    const std::size_t begin = at + kLabel.size();
    const std::string label(body.substr(begin, body.find('"', begin) - begin));
    std::string name = label;
    for (int k = 2; !taken.insert(name).second; ++k) name = fmt::format("{} ({})", label, k);
    html += body.substr(0, begin);
    html += name;
    body.remove_prefix(begin + label.size());
  }
  html += body;
  return html;
}

std::string page(const Texts& t, const std::string& title, const std::string& masthead,
                 const std::string& body, const Document& document, bool has_script) {
  return std::string("<!DOCTYPE html>\n<html lang=\"") + t.language_tag() + "\">\n" +
         head(t, title, has_script) + "<body>\n<a class=\"skip\" href=\"#main\">" +
         t[Text::skip_to_results] + "</a>\n" + masthead + "<main id=\"main\">\n" +
         with_unique_regions(body) + "</main>\n<footer><p>" +
         t.say<Text::made_by_program>(escape_html(document.provenance.program_version)) +
         "</p></footer>\n" + (has_script ? "<script>" + html_script(t) + "</script>\n" : "") +
         "</body>\n</html>\n";
}

struct Section {
  std::string address, words;  // words: escaped
};

std::string contents(const Texts& t, const std::vector<Section>& sections) {
  std::string html =
      std::string("<nav aria-label=\"") + t[Text::contents] + "\"><ul class=\"contents\">";
  for (const Section& section : sections)
    html += fmt::format("<li><a href=\"{}\">{}</a></li>", section.address, section.words);
  return html + "</ul></nav>\n";
}

std::string masthead(const Texts& t, const Document& document, bool needs_attention) {
  std::string paths;
  for (const ProjectPart& project : document.projects) {
    paths += fmt::format("{}{}", paths.empty() ? "" : " · ", escape_html(project.path));
  }
  if (!document.provenance.timestamp.empty()) {
    paths += " · " + escape_html(document.provenance.timestamp);
  }
  std::vector<Section> sections;
  if (document.revision) sections.push_back({"#revision", html_revision_title(t, document)});
  if (needs_attention) sections.push_back({"#attention", t[Text::needs_attention]});
  sections.push_back({"#summary", t[Text::summary]});
  constexpr std::size_t kMostProjects = 12;
  const std::size_t projects = document.projects.size();
  for (std::size_t p = 0; p < std::min(projects, kMostProjects); ++p) {
    const ProjectPart& project = document.projects[p];
    sections.push_back(
        {fmt::format("#project{}", p + 1),
         projects == 1 ? t[Text::planes] : escape_html(title_of(project.name, project.path))});
    if (projects > 1) continue;
    if (!project.luminaires.empty()) sections.push_back({"#luminaires1", t[Text::luminaires]});
    if (!project.spaces.empty()) sections.push_back({"#calculation1", t[Text::calculation]});
  }
  sections.push_back({"#provenance", t[Text::provenance]});
  return std::string("<header>\n<p class=\"eyebrow\">luxgate · ") + t[Text::compliance_report] +
         "</p>\n<h1>" + page_title(t, document) + "</h1>\n<p class=\"quiet paths\">" + paths +
         "</p>\n" + html_verdict_banner(t, document) + contents(t, sections) + "</header>\n";
}

std::string space_title(const SpacePart& space) {
  return fmt::format("{} <span class=\"id\">{}</span>", escape_html(title_of(space.name, space.id)),
                     space.name.empty() ? "" : escape_html(space.id));
}

// Zones that were not made, and why.
std::string notes_html(const Texts& t, const SpacePart& space) {
  std::string html;
  for (const std::string& note : space.notes)
    html += "<p class=\"quiet note-of-room\">" + t.english_html(escape_html(note)) + "</p>\n";
  for (const rules::RowCoverage& row : space.coverage) {
    html += fmt::format("<p class=\"note-of-room{}\">{}</p>\n", row.is_whole() ? " quiet" : "",
                        escape_html(coverage_words(t, row)));
  }
  return html;
}

std::string space_html(const Texts& t, const Document& document, std::size_t p, std::size_t s) {
  const SpacePart& space = document.projects[p].spaces[s];
  std::string html = "<section class=\"space\"><h3>" + space_title(space) + "</h3>\n";
  html += html_room(t, space) + notes_html(t, space);
  for (std::size_t k = 0; k < space.planes.size(); ++k)
    html += html_plane(t, {p, s, k}, space, space.planes[k], folds_passed_planes(document));
  return html + "</section>\n";
}

// Sections are landmarks, which must differ in name; projects may have one name.
std::string section_name(const Document& document, std::size_t p) {
  const auto title = [&](std::size_t k) {
    return std::string(title_of(document.projects[k].name, document.projects[k].path));
  };
  std::size_t number = 1;
  for (std::size_t k = 0; k < p; ++k) number += title(k) == title(p) ? 1 : 0;
  if (number == 1) return fmt::format("aria-labelledby=\"project{}\"", p + 1);
  return fmt::format("aria-label=\"{} ({})\"", escape_html(title(p)), number);
}

std::string project_html(const Texts& t, const Document& document, std::size_t p,
                         const std::string& folder) {
  const ProjectPart& project = document.projects[p];
  const bool is_only = document.projects.size() == 1;
  std::string html =
      fmt::format("<section class=\"project\" {2}><h2 id=\"project{0}\">{1}</h2>\n", p + 1,
                  is_only ? t[Text::planes] : escape_html(title_of(project.name, project.path)),
                  section_name(document, p));
  if (!is_only && !project.name.empty())
    html += "<p class=\"quiet\">" + escape_html(project.path) + "</p>\n";
  if (!project.is_judged) {
    html += "<p class=\"message\">" + badge(t, rules::Verdict::not_judged) + " " +
            t[Text::project_unreadable] + "</p>\n";
  }
  html += html_messages(t, project);
  if (!folder.empty() && !project.spaces.empty()) {
    html += "<ul class=\"pages\">\n";
    for (const HtmlPage& room : html_pages(document)) {
      if (room.project != p) continue;
      const SpacePart& space = project.spaces[room.space];
      const std::string part =
          room.planes == space.planes.size()
              ? ""
              : ", " + t.say<Text::planes_from_to>(room.first_plane + 1,
                                                   room.first_plane + room.planes);
      html += fmt::format("<li><a href=\"{}/{}\">{}</a><span class=\"quiet\">{}</span>{}</li>\n",
                          folder, room.name, escape_html(title_of(space.name, space.id)), part,
                          room.first_plane == 0 ? notes_html(t, space) : "");
    }
    html += "</ul>\n";
  } else {
    for (std::size_t s = 0; s < project.spaces.size(); ++s) html += space_html(t, document, p, s);
  }
  return html + html_aggregates(t, project, p) + html_luminaires(t, project, p) +
         html_calculation(t, document.provenance, project, p) + html_inputs(t, project) +
         "</section>\n";
}

std::string whole_page(const Texts& t, const Document& document, const std::string& folder) {
  const std::string attention = html_attention(t, document, folder);
  std::string body = html_revision(t, document) + attention + html_summary(t, document, folder);
  for (std::size_t p = 0; p < document.projects.size(); ++p)
    body += project_html(t, document, p, folder);
  const std::string title =
      std::string(outcome_symbol(outcome_of(document))) + " " + page_title(t, document);
  return page(t, title, masthead(t, document, !attention.empty()),
              body + html_provenance(t, document), document, true);
}

}  // namespace

std::string render_html(const Document& document, const Texts& t) {
  return whole_page(t, document, "");
}

std::string render_html_index(const Document& document, const std::string& folder, const Texts& t) {
  return whole_page(t, document, folder);
}

std::vector<HtmlPage> html_pages(const Document& document) {
  std::vector<HtmlPage> pages;
  for (std::size_t p = 0; p < document.projects.size(); ++p) {
    const ProjectPart& project = document.projects[p];
    for (std::size_t s = 0; s < project.spaces.size(); ++s) {
      const std::size_t planes = project.spaces[s].planes.size();
      std::size_t first = 0;
      do {
        const std::size_t count = std::min(kPlanesPerPage, planes - first);
        pages.push_back({page_name({p, s, first}), p, s, first, count});
        first += kPlanesPerPage;
      } while (first < planes);
    }
  }
  return pages;
}

std::string render_html_page(const Document& document, const HtmlPage& room,
                             const std::string& index, const Texts& t) {
  const ProjectPart& project = document.projects[room.project];
  const SpacePart& space = project.spaces[room.space];
  const std::string title = escape_html(title_of(space.name, space.id));
  const std::string head = "<header>\n<p class=\"eyebrow\"><a href=\"" + escape_html(index) +
                           "\">" + t[Text::all_results] + "</a> · luxgate · " +
                           t[Text::compliance_report] + "</p>\n<h1>" + title +
                           "</h1>\n<p class=\"quiet paths\">" +
                           escape_html(title_of(project.name, project.path)) + "</p>\n</header>\n";
  std::string body = std::string("<section class=\"space\"><h2 class=\"unseen\">") +
                     t[Text::planes] + "</h2>\n<h3 class=\"unseen\">" + title + "</h3>\n";
  if (room.first_plane == 0) body += html_room(t, space) + notes_html(t, space);
  for (std::size_t k = room.first_plane; k < room.first_plane + room.planes; ++k) {
    body += html_plane(t, {room.project, room.space, k}, space, space.planes[k], true);
  }
  // The script unfolds what is printed.
  return page(t, title, head, body + "</section>\n", document, true);
}

}  // namespace report
