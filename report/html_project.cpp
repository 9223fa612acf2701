#include "report/html_project.h"

#include "report/html_convergence.h"
#include "report/html_markup.h"
#include "report/html_polar.h"
#include "report/redact.h"
#include "report/words.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace report {
namespace {

// "0.80" and below it "LLMF 0.92 · LSF 1.00".
std::string maintenance_html(const LuminaireRow& row) {
  std::string parts;
  const auto add = [&parts](const char* name, const std::optional<double>& value) {
    if (value)
      parts += fmt::format("{}{} {}", parts.empty() ? "" : " × ", name, format_limit(*value, ""));
  };
  add("LLMF", row.maintenance.llmf);
  add("LSF", row.maintenance.lsf);
  add("LMF", row.maintenance.lmf);
  add("RSMF", row.maintenance.rsmf);
  // A product of four factors has more digits than anybody states.
  const std::string factor = format_fixed(row.maintenance_factor, 3);
  const std::string text = factor.ends_with('0') ? factor.substr(0, factor.size() - 1) : factor;
  return parts.empty() ? text : text + "<span class=\"note\">" + parts + "</span>";
}

std::string luminaire_row(const LuminaireRow& row) {
  const bool has_power = row.power_w > 0.0;
  return fmt::format(
      "<tr><th scope=\"row\">{}<span class=\"note\">{}</span>{}</th>"
      "<td>{}<span class=\"note\">{}</span><span class=\"hash\">{}</span></td>"
      "<td class=\"num\">{}</td><td class=\"num\">{} lm</td><td class=\"num\">{}</td><td "
      "class=\"num\">{}</td>"
      "<td class=\"num\">{} cd</td><td class=\"num\">{}</td></tr>\n",
      escape_html(row.type_id), escape_html(row.name), html_polar(row),
      escape_html(row.photometry_file), escape_html(row.format), escape_html(row.sha256), row.count,
      format_lumens(row.flux_lm), has_power ? format_watts(row.power_w) + " W" : "not stated",
      has_power ? format_fixed(row.flux_lm / row.power_w, 0) + " lm/W" : "",
      format_lumens(row.max_intensity_cd), maintenance_html(row));
}

std::string total_row(const ProjectPart& project) {
  int count = 0;
  double flux_lm = 0.0, power_w = 0.0;
  bool is_power_known = true;
  for (const LuminaireRow& row : project.luminaires) {
    count += row.count;
    flux_lm += row.count * row.flux_lm;
    power_w += row.count * row.power_w;
    if (row.count > 0 && !(row.power_w > 0.0)) is_power_known = false;
  }
  return fmt::format(
      "<tr class=\"total\"><th scope=\"row\">All luminaires</th><td></td><td class=\"num\">{}</td>"
      "<td class=\"num\">{} lm</td><td class=\"num\">{}</td><td></td><td></td><td></td></tr>\n",
      count, format_lumens(flux_lm), is_power_known ? format_watts(power_w) + " W" : "");
}

std::string balance_row(const SpacePart& space) {
  const calc::FluxBalance& balance = space.balance;
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td class=\"num\">{} lm</td><td class=\"num\">{}</td><td "
      "class=\"num\">{}</td>"
      "<td class=\"num\">{}</td><td class=\"num\">{}</td></tr>\n",
      escape_html(title_of(space.name, space.id)), format_lumens(balance.emitted_lm),
      format_measured(balance.absorbed_lm, "lm"), format_measured(balance.escaped_lm, "lm"),
      format_count(space.triangles), format_count(space.degenerate_triangles));
}

std::string ray_row(const PlanePart& plane) {
  if (!plane.is_computed) return {};
  const calc::SolveCounters& counters = plane.counters;
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td class=\"num\">{}</td><td class=\"num\">{}</td><td "
      "class=\"num\">{}</td>"
      "<td class=\"num\">{}</td><td>{}</td></tr>\n",
      escape_html(title_of(plane.name, plane.id)), format_count(counters.paths),
      format_count(counters.direct_rays), format_count(counters.connection_rays),
      format_count(counters.near_rays), stop_words(plane.stop));
}

std::string times_table(const PhaseTimes& times) {
  if (!(times.total_s > 0.0)) return {};
  const std::array<std::pair<const char*, double>, 8> phases{{{"Load", times.load_s},
                                                              {"Prepare", times.prepare_s},
                                                              {"Direct light", times.direct_s},
                                                              {"Light vertices", times.pool_s},
                                                              {"Connections", times.connect_s},
                                                              {"Near field", times.near_s},
                                                              {"Verdicts", times.judge_s},
                                                              {"Total", times.total_s}}};
  std::string rows;
  if (times.maps_s > 0.0) rows += fact("Shadow maps", format_seconds(times.maps_s) + " s");
  for (const auto& [name, seconds] : phases) rows += fact(name, format_seconds(seconds) + " s");
  return "<table class=\"facts narrow\"><caption>Time</caption><tbody>" + rows +
         "</tbody></table>\n";
}

// A run that was cut short depends on how fast the machine was.
const char* repeatability(const Document& document) {
  for (const ProjectPart& project : document.projects) {
    for (const SpacePart& space : project.spaces) {
      for (const PlanePart& plane : space.planes) {
        if (plane.stop == calc::StopReason::time_limit ||
            plane.stop == calc::StopReason::interrupted) {
          return "Sampling was cut short by time or interruption: the same command may give "
                 "slightly different numbers, and intervals that agree.";
        }
      }
    }
  }
  return "The same command with the same files gives the same report.";
}

}  // namespace

std::string html_messages(const ProjectPart& project) {
  if (project.diagnostics.empty()) return {};
  std::string items;
  for (const calc::Diagnostic& diagnostic : project.diagnostics) {
    const bool is_error = diagnostic.severity() == calc::Severity::error;
    const calc::SourceLocation& where = diagnostic.where;
    std::string place = escape_html(where.file);
    if (where.line > 0) place += fmt::format(":{}", where.line);
    if (where.column > 0) place += fmt::format(":{}", where.column);
    items += fmt::format(
        "<li class=\"{0}\"><b>{0}</b> {1} <span class=\"note\"><code>{2}</code> {3}</span></li>\n",
        is_error ? "error" : "warning", escape_html(diagnostic.message), place,
        calc::diagnostic_name(diagnostic.id));
  }
  return "<h3>Messages</h3>\n<ul class=\"messages\">\n" + items + "</ul>\n";
}

std::string html_luminaires(const ProjectPart& project, std::size_t index) {
  if (project.luminaires.empty()) return {};
  std::string rows;
  for (const LuminaireRow& row : project.luminaires) rows += luminaire_row(row);
  return fmt::format("<h3 id=\"luminaires{}\">Luminaires</h3>\n", index + 1) +
         scroll_box(
             "Luminaire schedule",
             "<table class=\"schedule\"><caption>Flux, power and intensity of one luminaire, new; "
             "MF: maintenance factor. Diagrams: C0–C180 solid, C90–C270 dashed, to the outer ring"
             "</caption><thead><tr><th scope=\"col\">Type</th><th scope=\"col\">Photometry "
             "and its SHA-256</th>"
             "<th scope=\"col\" class=\"num\">Count</th><th scope=\"col\" class=\"num\">Flux</th>"
             "<th scope=\"col\" class=\"num\">Power</th><th scope=\"col\" "
             "class=\"num\">Efficacy</th>"
             "<th scope=\"col\" class=\"num\">Peak</th><th scope=\"col\" "
             "class=\"num\">MF</th></tr></thead><tbody>\n" +
                 rows + "</tbody><tfoot>" + total_row(project) + "</tfoot></table>");
}

std::string html_calculation(const Provenance& provenance, const ProjectPart& project,
                             std::size_t index) {
  if (project.spaces.empty()) return {};
  std::string balance, rays;
  for (const SpacePart& space : project.spaces) {
    balance += balance_row(space);
    for (const PlanePart& plane : space.planes) rays += ray_row(plane);
  }
  const std::string share = format_percent(provenance.confidence);
  return fmt::format("<h3 id=\"calculation{}\">Calculation</h3>\n", index + 1) +
         scroll_box(
             "Light balance",
             "<table><caption>Light balance, new luminaires at full output: emitted = absorbed + "
             "escaped within "
             "the " +
                 share +
                 " intervals</caption><thead><tr><th scope=\"col\">Space</th>"
                 "<th scope=\"col\" class=\"num\">Emitted</th><th scope=\"col\" "
                 "class=\"num\">Absorbed</th>"
                 "<th scope=\"col\" class=\"num\">Escaped</th><th scope=\"col\" "
                 "class=\"num\">Triangles</th>"
                 "<th scope=\"col\" class=\"num\">Left out, no area</th></tr></thead><tbody>\n" +
                 balance + "</tbody></table>") +
         (rays.empty() ? ""
                       : scroll_box("Work per plane",
                                    "<table><caption>Work per plane</caption><thead><tr><th "
                                    "scope=\"col\">Plane</th>"
                                    "<th scope=\"col\" class=\"num\">Light paths</th><th "
                                    "scope=\"col\" class=\"num\">Direct rays</th>"
                                    "<th scope=\"col\" class=\"num\">Connections</th><th "
                                    "scope=\"col\" class=\"num\">Near rays</th>"
                                    "<th scope=\"col\">Sampling</th></tr></thead><tbody>\n" +
                                        rays + "</tbody></table>")) +
         html_convergence(project) + times_table(project.times);
}

std::string html_inputs(const ProjectPart& project) {
  if (project.inputs.empty()) return {};
  std::string rows;
  for (const calc::InputFile& input : project.inputs) {
    rows += fmt::format("<tr><th scope=\"row\">{}</th><td class=\"hash\">{}</td></tr>\n",
                        escape_html(input.path), escape_html(input.sha256));
  }
  return "<h3>Files read</h3>\n" +
         scroll_box("Files read",
                    "<table><caption class=\"unseen\">Files read</caption><thead><tr><th "
                    "scope=\"col\">File</th>"
                    "<th scope=\"col\">SHA-256</th></tr></thead><tbody>\n" +
                        rows + "</tbody></table>");
}

std::string html_provenance(const Document& document) {
  const Provenance& provenance = document.provenance;
  std::string rows = fact("Program", "luxgate " + escape_html(provenance.program_version));
  if (!provenance.timestamp.empty()) rows += fact("Made", escape_html(provenance.timestamp));
  rows += fact("Backend", escape_html(provenance.backend));
  rows += fact("Seed", fmt::format("{}", provenance.seed));
  rows += fact("Confidence of intervals",
               format_percent(provenance.confidence) + ", over all planned looks of a plane");
  rows += fact("Goal", provenance.goal == rules::Goal::verdict
                           ? "verdict; without requirements, accuracy"
                           : "accuracy");
  rows += fact("Aimed half width",
               format_percent(provenance.tolerance) + " of the value, where accuracy is the goal");
  rows += fact("Comparison with limits",
               policy_text(rules::DecisionPolicy{}) + ", unless a requirement says otherwise");
  rows += fact("Most light paths", format_count(provenance.max_paths) + " per plane and replicate");
  rows += fact("Replicates", fmt::format("{}", provenance.replicates));
  const std::string redacted = redaction_words(document);
  return "<section aria-labelledby=\"provenance\"><h2 id=\"provenance\">Provenance</h2>\n"
         "<p>" +
         std::string(repeatability(document)) + (redacted.empty() ? "" : " " + redacted) +
         "</p>\n<pre tabindex=\"0\"><code>" + escape_html(provenance.command_line) +
         "</code></pre>\n<table class=\"facts wide\"><caption class=\"unseen\">Settings"
         "</caption><tbody>\n" +
         rows + "</tbody></table>\n</section>\n";
}

}  // namespace report
