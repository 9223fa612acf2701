#include "report/html/chapters/html_project.h"

#include "report/document/luminaire_schedule.h"
#include "report/document/luminaire_totals.h"
#include "report/html/drawings/html_polar.h"
#include "report/html/page/html_markup.h"
#include "report/html/room/html_convergence.h"
#include "report/text/factor_words.h"
#include "report/text/markup.h"
#include "report/text/plane_names.h"
#include "report/text/schedule_words.h"
#include "report/text/svg.h"
#include "report/text/words.h"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

namespace report {
namespace {

// Heads of columns of numbers.
std::string number_heads(const Texts& t, std::initializer_list<Text> names) {
  std::string html;
  for (const Text name : names)
    html += fmt::format("<th scope=\"col\" class=\"num\">{}</th>", t[name]);
  return html;
}

// "0.80" and below it "LLMF 0.92 · LSF 1.00".
std::string maintenance_html(const Texts& t, const LuminaireRow& row) {
  std::string parts;
  const auto add = [&](const char* name, const std::optional<double>& value) {
    if (value)
      parts +=
          fmt::format("{}{} {}", parts.empty() ? "" : " × ", name, format_limit(t, *value, ""));
  };
  add(t[Text::llmf], row.maintenance.llmf);
  add(t[Text::lsf], row.maintenance.lsf);
  add(t[Text::lmf], row.maintenance.lmf);
  add(t[Text::rsmf], row.maintenance.rsmf);
  const std::string text = factor_words(t, row.maintenance_factor);
  if (!row.maintenance.is_stated) parts = t[Text::not_stated];
  return parts.empty() ? text : text + "<span class=\"note\">" + parts + "</span>";
}

// What the file has where the project states another flux or power, and what it states where its
// intensities give another flux; "" = nothing does.
std::string file_words(const Texts& t, const LuminaireRow& type) {
  const auto differs = [](double file, double own) { return file > 0.0 && file != own; };
  std::string words;
  if (differs(type.file_flux_lm, type.flux_lm))
    words = format_lumens(t, type.told_file_lm()) + " lm";
  if (differs(type.file_power_w, type.power_w))
    words += (words.empty() ? "" : ", ") + format_watts(t, type.file_power_w) + " W";
  if (!words.empty()) words = t.say<Text::schedule_overridden>(words);
  if (type.stated_flux_lm > 0.0 && type.told_file_lm() != type.stated_flux_lm) {
    words += (words.empty() ? "" : "; ") +
             t.say<Text::schedule_stated>(format_lumens(t, type.stated_flux_lm),
                                          format_lumens(t, type.file_flux_lm));
  }
  return words;
}

// Maker, name, article and lamp as the photometry file has them, the opening and the housing; the
// project's own id where nothing is said of them.
std::string product_html(const Texts& t, const ScheduleRow& row) {
  const LuminaireRow& type = *row.type;
  std::string words;
  const auto add = [&](const std::string& text) {
    if (!text.empty()) words += (words.empty() ? "" : ", ") + text;
  };
  if (!type.article().empty() && type.article() != type.name)
    add(t.say<Text::article>(escape_html(type.article())));
  add(escape_html(type.lamp));
  add(opening_words(t, row));
  if (!type.housing_material.empty()) {
    add(type.housing_depth_m > 0.0
            ? t.say<Text::housing_deep>(escape_html(type.housing_material),
                                        format_metres(t, type.housing_depth_m))
            : t.say<Text::housing_face>(escape_html(type.housing_material)));
  }
  add(file_words(t, type));
  std::string title = escape_html(type.maker);
  if (!type.name.empty()) title += (title.empty() ? "" : " · ") + escape_html(type.name);
  if (title.empty()) title = escape_html(type.type_id);
  const std::string note = "<span class=\"note\">";
  return title + (words.empty() ? "" : note + words + "</span>") + note +
         t.say<Text::type_and_file>(escape_html(type.type_id), escape_html(type.photometry_file)) +
         "</span>";
}

// The luminous opening from above, C0 to the right; "" where it is a point or not known.
std::string outline_svg(const Texts& t, const ScheduleRow& row) {
  constexpr double kSize = 72, kEdge = 4;
  const double longest_m = std::max(row.opening_m.x, row.opening_m.y);
  const std::string words = opening_words(t, row);
  if (words.empty() || !(longest_m > 0.0)) return {};
  const double scale = (kSize - 2 * kEdge) / longest_m;
  const glm::dvec2 size = scale * row.opening_m + 2 * kEdge;
  glm::dvec2 low_m = row.outline_m.front();
  for (const glm::dvec2& corner : row.outline_m) low_m = glm::min(low_m, corner);
  std::string path;
  for (const glm::dvec2& corner : row.outline_m) {
    const glm::dvec2 at = scale * (corner - low_m) + kEdge;
    path += fmt::format("{}{} {}", path.empty() ? "M" : "L", svg_number(at.x),
                        svg_number(size.y - at.y));
  }
  return fmt::format(
      "<svg class=\"opening\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" role=\"img\" "
      "aria-label=\"{2}\"><path d=\"{3}Z\"/></svg>",
      svg_number(size.x), svg_number(size.y), words, path);
}

std::string schedule_cell(const std::string& text) {
  return "<td class=\"num\">" + (text.empty() ? "–" : text) + "</td>";
}

// Words beside a number wrap: what is wider than paper makes a browser shrink the whole document.
std::string colour_cell(const LuminaireRow& type, const std::string& words) {
  if (words.empty() || !type.is_of_other_light()) return schedule_cell(escape_html(words));
  return "<td class=\"num wraps\">" + escape_html(words) + "</td>";
}

std::string luminaire_row(const Texts& t, const ScheduleRow& row) {
  const LuminaireRow& type = *row.type;
  const bool has_power = type.power_w > 0.0;
  return "<tr><th scope=\"row\">" + row.position + "</th><td>" + product_html(t, row) +
         html_polar(t, type) + outline_svg(t, row) + "</td>" +
         schedule_cell(format_lumens(t, type.told_lm())) +
         schedule_cell(has_power ? format_watts(t, type.power_w) : "") +
         schedule_cell(has_power ? format_fixed(type.told_lm() / type.power_w, 0) : "") +
         colour_cell(type, colour_temperature_words(t, type)) +
         colour_cell(type, colour_rendering_words(t, type)) + "<td>" + mounting_words(t, row) +
         "</td>" + schedule_cell(fmt::format("{}", type.count)) +
         schedule_cell(maintenance_html(t, type)) + "<td>" + escape_html(rooms_words(t, row)) +
         "</td></tr>\n";
}

std::string total_row(const Texts& t, const LuminaireTotals& totals) {
  return fmt::format(
      "<tr class=\"total\"><th scope=\"row\" colspan=\"2\">{}</th><td class=\"num\">{}</td>"
      "<td class=\"num\">{}</td><td></td><td></td><td></td><td></td><td class=\"num\">{}</td>"
      "<td></td><td></td></tr>\n",
      t[Text::all_luminaires], format_lumens(t, totals.flux_lm),
      totals.is_power_known ? format_watts(t, totals.power_w) : t[Text::not_stated], totals.count);
}

std::string balance_row(const Texts& t, const SpacePart& space) {
  const calc::FluxBalance& balance = space.balance;
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td class=\"num\">{} lm</td><td class=\"num\">{}</td><td "
      "class=\"num\">{}</td>"
      "<td class=\"num\">{}</td><td class=\"num\">{}</td></tr>\n",
      escape_html(title_of(space.name, space.id)), format_lumens(t, balance.emitted_lm),
      format_measured(t, balance.absorbed_lm, "lm"), format_measured(t, balance.escaped_lm, "lm"),
      format_count(space.triangles), format_count(space.degenerate_triangles));
}

std::string ray_row(const Texts& t, const SpacePart& space, const PlanePart& plane) {
  if (!plane.is_computed) return {};
  const calc::SolveCounters& counters = plane.counters;
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td class=\"num\">{}</td><td class=\"num\">{}</td><td "
      "class=\"num\">{}</td>"
      "<td class=\"num\">{}</td><td>{}</td></tr>\n",
      escape_html(plane_name(t, space, plane)), format_count(counters.paths),
      format_count(counters.direct_rays), format_count(counters.connection_rays),
      format_count(counters.near_rays), stop_words(t, plane.stop));
}

std::string times_table(const Texts& t, const PhaseTimes& times) {
  if (!(times.total_s > 0.0)) return {};
  const std::array<std::pair<Text, double>, 8> phases{{{Text::time_load, times.load_s},
                                                       {Text::time_prepare, times.prepare_s},
                                                       {Text::time_direct, times.direct_s},
                                                       {Text::time_vertices, times.pool_s},
                                                       {Text::connections, times.connect_s},
                                                       {Text::time_near, times.near_s},
                                                       {Text::time_verdicts, times.judge_s},
                                                       {Text::time_total, times.total_s}}};
  std::string rows;
  if (times.maps_s > 0.0) rows += fact(t[Text::time_maps], format_seconds(t, times.maps_s) + " s");
  for (const auto& [name, seconds] : phases)
    rows += fact(t[name], format_seconds(t, seconds) + " s");
  return std::string("<table class=\"facts narrow\"><caption>") + t[Text::time] +
         "</caption><tbody>" + rows + "</tbody></table>\n";
}

const char* repeatability(const Texts& t, SameBits same_bits) {
  switch (same_bits) {
    case SameBits::any_processor:
      return t[Text::repeatable];
    case SameBits::same_device:
      return t[Text::repeatable_on_device];
    case SameBits::nowhere:
      return t[Text::not_repeatable];
  }
  return "";
}

}  // namespace

std::string html_messages(const Texts& t, const ProjectPart& project, bool with_places) {
  if (project.diagnostics.empty()) return {};
  std::string items;
  for (const calc::Diagnostic& diagnostic : project.diagnostics) {
    const bool is_error = !is_warning(diagnostic);
    const Text kind = is_error                                 ? Text::error
                      : is_strict_warning(project, diagnostic) ? Text::warning_counts
                                                               : Text::warning;
    const calc::SourceLocation& where = diagnostic.where;
    std::string place = escape_html(where.file);
    if (where.line > 0) place += fmt::format(":{}", where.line);
    if (where.column > 0) place += fmt::format(":{}", where.column);
    if (with_places) place = "<code>" + place + "</code> ";
    items += fmt::format("<li class=\"{}\"><b>{}</b> {} <span class=\"note\">{}{}</span></li>\n",
                         kind == Text::warning ? "warning" : "error", t[kind],
                         t.english_html(escape_html(diagnostic.message)), with_places ? place : "",
                         calc::diagnostic_name(diagnostic.id));
  }
  // Clients see the words without the places in files.
  const std::string whose =
      with_places ? ""
                  : std::string("<p class=\"quiet\">") + t[Text::messages_for_author] + "</p>\n";
  return std::string("<h3>") + t[Text::messages] + "</h3>\n" + whose + "<ul class=\"messages\">\n" +
         items + "</ul>\n";
}

std::string html_luminaires(const Texts& t, const ProjectPart& project, std::size_t index) {
  if (project.luminaires.empty()) return {};
  const LuminaireSchedule schedule = schedule_of(project);
  std::string rows, remarks;
  for (const ScheduleRow& row : schedule.used) rows += luminaire_row(t, row);
  for (const std::string& remark : schedule_remarks(t, schedule))
    remarks += "<p class=\"quiet\">" + escape_html(remark) + "</p>\n";
  const auto head = [](const std::string& words, const char* kind) {
    return "<th scope=\"col\"" + std::string(kind) + ">" + words + "</th>";
  };
  constexpr const char* kNumber = " class=\"num\"";
  const std::string heads =
      head(t[Text::schedule_position], "") + head(t[Text::sheet_product], "") +
      head(std::string(t[Text::flux]) + " lm", kNumber) +
      head(std::string(t[Text::power]) + " W", kNumber) + head("lm/W", kNumber) +
      head("K", kNumber) + head("Ra", kNumber) + head(t[Text::mounting], "") +
      number_heads(t, {Text::count, Text::maintenance_factor}) + head(t[Text::rooms], "");
  return fmt::format("<h3 id=\"luminaires{}\">{}</h3>\n", index + 1, t[Text::luminaires]) +
         (rows.empty()
              ? ""
              : scroll_box(t[Text::luminaire_schedule],
                           std::string("<table class=\"schedule\"><caption>") +
                               t[Text::schedule_caption] + "</caption><thead><tr>" + heads +
                               "</tr></thead><tbody>\n" + rows + "</tbody><tfoot>" +
                               total_row(t, schedule.totals) + "</tfoot></table>")) +
         remarks;
}

namespace {

// Folded, because a floor of offices has 80 planes. rows: "" = nothing was calculated.
std::string work_table(const Texts& t, const std::string& rows) {
  if (rows.empty()) return {};
  const char* title = t[Text::work_per_plane];
  return fmt::format("<details class=\"list\"><summary>{}</summary>\n", title) +
         scroll_box(title, fmt::format("<table><caption class=\"unseen\">{}</caption><thead><tr>"
                                       "<th scope=\"col\">{}</th>",
                                       title, t[Text::plane]) +
                               number_heads(t, {Text::light_paths, Text::direct_rays,
                                                Text::connections, Text::near_rays}) +
                               fmt::format("<th scope=\"col\">{}</th></tr></thead><tbody>\n",
                                           t[Text::sampling]) +
                               rows + "</tbody></table>") +
         "</details>\n";
}

}  // namespace

std::string html_calculation(const Texts& t, const Provenance& provenance,
                             const ProjectPart& project, std::size_t index) {
  if (project.spaces.empty()) return {};
  std::string balance, rays;
  for (const SpacePart& space : project.spaces) {
    balance += balance_row(t, space);
    for (const PlanePart& plane : space.planes) rays += ray_row(t, space, plane);
  }
  const std::string share = format_percent(t, provenance.confidence);
  return fmt::format("<h3 id=\"calculation{}\">{}</h3>\n", index + 1, t[Text::calculation]) +
         scroll_box(t[Text::light_balance],
                    fmt::format("<table><caption>{}</caption><thead><tr><th scope=\"col\">{}</th>",
                                t.say<Text::light_balance_caption>(share), t[Text::space]) +
                        number_heads(t, {Text::emitted, Text::absorbed, Text::escaped,
                                         Text::triangles, Text::left_out_no_area}) +
                        "</tr></thead><tbody>\n" + balance + "</tbody></table>") +
         work_table(t, rays) + html_convergence(t, project) + times_table(t, project.times);
}

std::string html_inputs(const Texts& t, const ProjectPart& project) {
  if (project.inputs.empty()) return {};
  std::string rows;
  for (const calc::InputFile& input : project.inputs) {
    rows += fmt::format("<tr><th scope=\"row\">{}</th><td class=\"hash\">{}</td></tr>\n",
                        escape_html(input.path), escape_html(input.sha256));
  }
  const char* title = t[Text::files_read];
  return fmt::format("<h3>{}</h3>\n", title) +
         scroll_box(title,
                    fmt::format("<table><caption class=\"unseen\">{}</caption><thead><tr><th "
                                "scope=\"col\">{}</th><th scope=\"col\">SHA-256</th></tr></thead>"
                                "<tbody>\n{}</tbody></table>",
                                title, t[Text::file], rows));
}

std::string html_provenance(const Texts& t, const Provenance& provenance) {
  std::string rows = fact(t[Text::program], "luxgate " + escape_html(provenance.program_version));
  if (!provenance.timestamp.empty()) rows += fact(t[Text::made], escape_html(provenance.timestamp));
  rows += fact(t[Text::backend], t.english_html(escape_html(provenance.backend)));
  rows += fact(t[Text::numbers_version], fmt::format("{}", provenance.numbers_version));
  rows += fact(t[Text::seed], fmt::format("{}", provenance.seed));
  rows += fact(t[Text::confidence],
               t.say<Text::over_all_looks>(format_percent(t, provenance.confidence)));
  rows +=
      fact(t[Text::goal],
           t[provenance.goal == rules::Goal::verdict ? Text::goal_verdict : Text::goal_accuracy]);
  rows += fact(t[Text::aimed_half_width],
               t.say<Text::of_the_value>(format_percent(t, provenance.tolerance)));
  rows += fact(t[Text::comparison], t.say<Text::unless_otherwise>(t[Text::default_policy]));
  rows += fact(t[Text::most_paths],
               t.say<Text::per_plane_and_replicate>(format_count(provenance.max_paths)));
  rows += fact(t[Text::replicates], fmt::format("{}", provenance.replicates));
  if (!provenance.policy.empty()) {
    rows +=
        fact(t[Text::policy], fmt::format("{}<br><code>{}</code>", escape_html(provenance.policy),
                                          escape_html(provenance.policy_sha256)));
  }
  const std::string redacted = redaction_words(provenance, t),
                    selected = selection_words(provenance, t);
  return fmt::format(
      "<section aria-labelledby=\"provenance\"><h2 id=\"provenance\">{}</h2>\n"
      "<p>{}{}{}</p>\n<pre tabindex=\"0\"><code>{}</code></pre>\n<table class=\"facts "
      "wide\"><caption "
      "class=\"unseen\">{}</caption><tbody>\n{}</tbody></table>\n</section>\n",
      t[Text::provenance], repeatability(t, provenance.same_bits),
      redacted.empty() ? "" : " " + redacted, selected.empty() ? "" : " " + escape_html(selected),
      escape_html(provenance.command_line), t[Text::settings], rows);
}

}  // namespace report
