#include "calc/project/about_xml.h"

#include "calc/base/day.h"
#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/base/utf8.h"
#include "calc/project/reading/project_elements.h"

#include <optional>
#include <string>
#include <utility>

namespace calc {
namespace {

AboutProject read_one(ProjectContext& context, const XmlElement& element) {
  ElementReader reader(element, context.diagnostics);
  reader.allow(kAboutElement);
  AboutProject about;
  for (const AboutText& one : kAboutTexts) {
    about.*one.text = std::string(trim(reader.text_or(one.name, "")));
  }
  if (reader.has("date") && !is_day(about.date)) {
    reader.report(DiagnosticId::not_a_day, reader.where("date"), "date", element.name,
                  printable(shorten_utf8(about.date, 40)));
  }
  if (!reader.has("logo")) return about;
  const std::string file = reader.text("logo");
  if (file.empty()) return about;
  if (std::optional<Logo> logo = context.files.logo(file, reader.where("logo"))) {
    about.logo = *std::move(logo);
  }
  return about;
}

}  // namespace

void read_about(ProjectContext& context, const XmlElement& root) {
  int line = 0;
  for (const XmlElement& child : root.children) {
    if (child.name != kAboutName) continue;
    AboutProject about = read_one(context, child);
    if (line == 0) {
      line = child.where.line;
      context.project.about = std::move(about);
    } else {
      context.diagnostics.report(DiagnosticId::duplicate_id, child.where, "element", kAboutName,
                                 line);
    }
  }
}

}  // namespace calc
