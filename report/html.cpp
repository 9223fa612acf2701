#include "report/html.h"

#include "calc/file_hash.h"
#include "report/html_findings.h"
#include "report/html_markup.h"
#include "report/html_pages.h"
#include "report/html_plane.h"
#include "report/html_project.h"
#include "report/html_room.h"
#include "report/html_script.h"
#include "report/html_style.h"
#include "report/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>

namespace report {
namespace {

std::string page_title(const Document& document) {
  if (document.projects.size() != 1) return fmt::format("{} projects", document.projects.size());
  return escape_html(title_of(document.projects[0].name, document.projects[0].path));
}

// 'sha256-...' of the only script that may run.  [CSP level 3, hash sources]
std::string script_source(const std::string& script) {
  const std::string hex = calc::sha256_hex(script);
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  return "'sha256-" + base64(bytes) + "'";
}

// The policy forbids whatever a name from a file might still manage to load or run. title: escaped.
std::string head(const std::string& title, bool has_script) {
  return "<head>\n<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" content=\"width=device-width, "
         "initial-scale=1\"/>\n"
         "<meta name=\"color-scheme\" content=\"light dark\"/>\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
         "'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'" +
         (has_script ? "; script-src " + script_source(html_script()) : "") + "\"/>\n<title>" +
         title + " – lighting compliance</title>\n<style>\n" + html_style() + "</style>\n</head>\n";
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

std::string page(const std::string& title, const std::string& masthead, const std::string& body,
                 const Document& document, bool has_script) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n" + head(title, has_script) +
         "<body>\n<a class=\"skip\" href=\"#main\">Skip to the results</a>\n" + masthead +
         "<main id=\"main\">\n" + with_unique_regions(body) +
         "</main>\n<footer><p>Made by luxgate " + escape_html(document.provenance.program_version) +
         ".</p></footer>\n" + (has_script ? "<script>" + html_script() + "</script>\n" : "") +
         "</body>\n</html>\n";
}

struct Section {
  std::string address, words;  // words: escaped
};

std::string contents(const std::vector<Section>& sections) {
  std::string html = "<nav aria-label=\"Contents\"><ul class=\"contents\">";
  for (const Section& section : sections)
    html += fmt::format("<li><a href=\"{}\">{}</a></li>", section.address, section.words);
  return html + "</ul></nav>\n";
}

std::string masthead(const Document& document, bool needs_attention) {
  std::string paths;
  for (const ProjectPart& project : document.projects) {
    paths += fmt::format("{}{}", paths.empty() ? "" : " · ", escape_html(project.path));
  }
  if (!document.provenance.timestamp.empty()) {
    paths += " · " + escape_html(document.provenance.timestamp);
  }
  std::vector<Section> sections;
  if (needs_attention) sections.push_back({"#attention", "Needs attention"});
  sections.push_back({"#summary", "Summary"});
  constexpr std::size_t kMostProjects = 12;
  const std::size_t projects = document.projects.size();
  for (std::size_t p = 0; p < std::min(projects, kMostProjects); ++p) {
    const ProjectPart& project = document.projects[p];
    sections.push_back(
        {fmt::format("#project{}", p + 1),
         projects == 1 ? "Planes" : escape_html(title_of(project.name, project.path))});
    if (projects > 1) continue;
    if (!project.luminaires.empty()) sections.push_back({"#luminaires1", "Luminaires"});
    if (!project.spaces.empty()) sections.push_back({"#calculation1", "Calculation"});
  }
  sections.push_back({"#provenance", "Provenance"});
  return "<header>\n<p class=\"eyebrow\">luxgate · lighting compliance report</p>\n<h1>" +
         page_title(document) + "</h1>\n<p class=\"quiet paths\">" + paths + "</p>\n" +
         html_verdict_banner(document) + contents(sections) + "</header>\n";
}

std::string space_title(const SpacePart& space) {
  return fmt::format("{} <span class=\"id\">{}</span>", escape_html(title_of(space.name, space.id)),
                     space.name.empty() ? "" : escape_html(space.id));
}

// Zones that were not made, and why.
std::string notes_html(const SpacePart& space) {
  std::string html;
  for (const std::string& note : space.notes)
    html += "<p class=\"quiet note-of-room\">" + escape_html(note) + "</p>\n";
  return html;
}

std::string space_html(const Document& document, std::size_t p, std::size_t s) {
  const SpacePart& space = document.projects[p].spaces[s];
  std::string html = "<section class=\"space\"><h3>" + space_title(space) + "</h3>\n";
  html += html_room(space) + notes_html(space);
  for (std::size_t k = 0; k < space.planes.size(); ++k)
    html += html_plane({p, s, k}, space, space.planes[k], folds_passed_planes(document));
  return html + "</section>\n";
}

std::string project_html(const Document& document, std::size_t p, const std::string& folder) {
  const ProjectPart& project = document.projects[p];
  const bool is_only = document.projects.size() == 1;
  std::string html = fmt::format(
      "<section class=\"project\" aria-labelledby=\"project{0}\"><h2 id=\"project{0}\">{1}</h2>\n",
      p + 1, is_only ? "Planes" : escape_html(title_of(project.name, project.path)));
  if (!is_only && !project.name.empty())
    html += "<p class=\"quiet\">" + escape_html(project.path) + "</p>\n";
  if (!project.is_judged) {
    html += "<p class=\"message\">" + badge(rules::Verdict::not_judged) +
            " This project could not be read or calculated.</p>\n";
  }
  html += html_messages(project);
  if (!folder.empty() && !project.spaces.empty()) {
    html += "<ul class=\"pages\">\n";
    for (const HtmlPage& room : html_pages(document)) {
      if (room.project != p) continue;
      const SpacePart& space = project.spaces[room.space];
      const std::string part = room.planes == space.planes.size()
                                   ? ""
                                   : fmt::format(", planes {} to {}", room.first_plane + 1,
                                                 room.first_plane + room.planes);
      html += fmt::format("<li><a href=\"{}/{}\">{}</a><span class=\"quiet\">{}</span>{}</li>\n",
                          folder, room.name, escape_html(title_of(space.name, space.id)), part,
                          room.first_plane == 0 ? notes_html(space) : "");
    }
    html += "</ul>\n";
  } else {
    for (std::size_t s = 0; s < project.spaces.size(); ++s) html += space_html(document, p, s);
  }
  return html + html_luminaires(project, p) + html_calculation(document.provenance, project, p) +
         html_inputs(project) + "</section>\n";
}

std::string whole_page(const Document& document, const std::string& folder) {
  const std::string attention = html_attention(document, folder);
  std::string body = attention + html_summary(document, folder);
  for (std::size_t p = 0; p < document.projects.size(); ++p)
    body += project_html(document, p, folder);
  const std::string title =
      std::string(verdict_symbol(overall_verdict(document))) + " " + page_title(document);
  return page(title, masthead(document, !attention.empty()), body + html_provenance(document),
              document, true);
}

}  // namespace

std::string render_html(const Document& document) { return whole_page(document, ""); }

std::string render_html_index(const Document& document, const std::string& folder) {
  return whole_page(document, folder);
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
                             const std::string& index) {
  const ProjectPart& project = document.projects[room.project];
  const SpacePart& space = project.spaces[room.space];
  const std::string title = escape_html(title_of(space.name, space.id));
  const std::string head = "<header>\n<p class=\"eyebrow\"><a href=\"" + escape_html(index) +
                           "\">All results</a> · luxgate · lighting compliance report</p>\n<h1>" +
                           title + "</h1>\n<p class=\"quiet paths\">" +
                           escape_html(title_of(project.name, project.path)) + "</p>\n</header>\n";
  std::string body =
      "<section class=\"space\"><h2 class=\"unseen\">Planes</h2>\n<h3 "
      "class=\"unseen\">" +
      title + "</h3>\n";
  if (room.first_plane == 0) body += html_room(space) + notes_html(space);
  for (std::size_t k = room.first_plane; k < room.first_plane + room.planes; ++k) {
    body += html_plane({room.project, room.space, k}, space, space.planes[k], true);
  }
  // The script unfolds what is printed.
  return page(title, head, body + "</section>\n", document, true);
}

}  // namespace report
