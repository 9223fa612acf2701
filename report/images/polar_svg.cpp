#include "report/images/polar_diagram.h"
#include "report/text/markup.h"
#include "report/text/svg.h"

#include <fmt/format.h>

namespace report {
namespace {

constexpr const char* kPolarStyle =
    "<style>\n"
    ".paper{fill:#fff}.grid,.frame,.c0,.c90{fill:none;stroke-linejoin:round}\n"
    ".grid{stroke:#dcdfe3}.frame{stroke:#9aa1a9}.c0{stroke:#0b57a4}.c90{stroke:#b8460e}\n"
    "text{font-family:system-ui,'Segoe UI',Roboto,'Helvetica Neue',Arial,sans-serif;"
    "dominant-baseline:central;paint-order:stroke;stroke:#fff;stroke-width:3px;"
    "stroke-linejoin:round}\n"
    ".text{fill:#1b1f24;font-size:14px}.faint{fill:#59616b;font-size:12px}"
    ".title{fill:#1b1f24;font-size:16px;font-weight:600}\n"
    "@media (prefers-color-scheme:dark){.paper{fill:#16191d}.grid{stroke:#333940}"
    ".frame{stroke:#6d757f}.c0{stroke:#7db8f5}.c90{stroke:#ffa46b}text{stroke:#16191d}"
    ".text,.title{fill:#e8eaed}.faint{fill:#a9b1ba}}\n"
    "</style>\n";

const char* class_of(PolarRole role) {
  switch (role) {
    case PolarRole::grid:
      return "grid";
    case PolarRole::frame:
      return "frame";
    case PolarRole::c0_c180:
      return "c0";
    case PolarRole::c90_c270:
      return "c90";
    case PolarRole::text:
      return "text";
    case PolarRole::faint_text:
      break;
  }
  return "faint";
}

std::string line_markup(const PolarLine& line) {
  std::string points;
  for (const PolarPoint& point : line.points) {
    if (!points.empty()) points += ' ';
    points += svg_number(point.x) + "," + svg_number(point.y);
  }
  return fmt::format("<polyline class=\"{}\" stroke-width=\"{}\"{} points=\"{}\"/>\n",
                     class_of(line.role), svg_number(line.width),
                     line.dashed ? " stroke-dasharray=\"9 5\"" : "", points);
}

std::string label_markup(const PolarLabel& label) {
  const char* anchor = label.anchor == PolarLabel::Anchor::start
                           ? "start"
                           : (label.anchor == PolarLabel::Anchor::end ? "end" : "middle");
  return fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>\n",
                     label.is_title ? "title" : class_of(label.role), svg_number(label.at.x),
                     svg_number(label.at.y), anchor, escape_html(label.text));
}

}  // namespace

std::string render_polar_svg(const PolarDrawing& drawing) {
  const std::string width = svg_number(drawing.width);
  const std::string height = svg_number(drawing.height);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\" role=\"img\">\n<title>Polar diagram: {2}</title>\n",
      width, height, escape_html(drawing.title));
  svg += kPolarStyle;
  svg += fmt::format("<rect class=\"paper\" width=\"{}\" height=\"{}\"/>\n", width, height);
  for (const PolarLine& line : drawing.lines) svg += line_markup(line);
  for (const PolarLabel& label : drawing.labels) svg += label_markup(label);
  return svg + "</svg>\n";
}

}  // namespace report
