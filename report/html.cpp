#include "report/html.h"

#include "report/html_findings.h"
#include "report/html_markup.h"
#include "report/html_plane.h"
#include "report/html_project.h"
#include "report/html_room.h"
#include "report/html_style.h"
#include "report/words.h"

#include <fmt/format.h>

#include <cstddef>

namespace report {
namespace {

std::string page_title(const Document& document) {
  if (document.projects.size() != 1) return fmt::format("{} projects", document.projects.size());
  return escape_html(title_of(document.projects[0].name, document.projects[0].path));
}

std::string head(const Document& document) {
  // The policy forbids whatever a name from a file might still manage to load.
  return "<head>\n<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" content=\"width=device-width, "
         "initial-scale=1\"/>\n"
         "<meta name=\"color-scheme\" content=\"light dark\"/>\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
         "'unsafe-inline'; "
         "img-src data:\"/>\n<title>" +
         std::string(verdict_symbol(overall_verdict(document))) + " " + page_title(document) +
         " – lighting compliance</title>\n<style>\n" + html_style() + "</style>\n</head>\n";
}

std::string masthead(const Document& document) {
  std::string paths;
  for (const ProjectPart& project : document.projects) {
    paths += fmt::format("{}{}", paths.empty() ? "" : " · ", escape_html(project.path));
  }
  if (!document.provenance.timestamp.empty()) {
    paths += " · " + escape_html(document.provenance.timestamp);
  }
  return "<header>\n<p class=\"eyebrow\">luxgate · lighting compliance report</p>\n<h1>" +
         page_title(document) + "</h1>\n<p class=\"quiet\">" + paths + "</p>\n" +
         html_verdict_banner(document) + "</header>\n";
}

std::string space_html(const ProjectPart& project, std::size_t p, std::size_t s) {
  const SpacePart& space = project.spaces[s];
  std::string html = fmt::format(
      "<section class=\"space\"><h3>{} <span class=\"id\">{}</span></h3>\n",
      escape_html(title_of(space.name, space.id)), space.name.empty() ? "" : escape_html(space.id));
  html += html_room(space);
  for (const std::string& note : space.notes) {
    html += "<p class=\"quiet\">" + escape_html(note) + "</p>\n";
  }
  for (std::size_t k = 0; k < space.planes.size(); ++k)
    html += html_plane({p, s, k}, space, space.planes[k]);
  return html + "</section>\n";
}

std::string project_html(const Document& document, std::size_t p) {
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
  for (std::size_t s = 0; s < project.spaces.size(); ++s) html += space_html(project, p, s);
  return html + html_luminaires(project) + html_calculation(document.provenance, project) +
         html_inputs(project) + "</section>\n";
}

}  // namespace

std::string render_html(const Document& document) {
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n" + head(document) + "<body>\n" +
                     masthead(document) + "<main>\n" + html_attention(document) +
                     html_summary(document);
  for (std::size_t p = 0; p < document.projects.size(); ++p) html += project_html(document, p);
  return html + html_provenance(document) + "</main>\n</body>\n</html>\n";
}

}  // namespace report
