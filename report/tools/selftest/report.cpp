#include "report/tools/selftest/report.h"

#include "report/html/page/html_markup.h"
#include "report/html/page/html_style.h"
#include "report/text/markup.h"
#include "report/text/plain_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace cli::selftest {
namespace {

std::string case_row(const JudgedCase& item, bool has_timing) {
  const JudgedNumber* worst = item.worst();
  std::string row = fmt::format("| {} | {} | {} ", item.test.name, markdown_cell(item.test.title),
                                item.numbers.size() + item.result.refused.size());
  row += worst == nullptr ? "| | | | "
                          : fmt::format("| {} | {} | {} | {} ", exact_words(*worst),
                                        value_words(worst->stated.value), interval_words(*worst),
                                        deviation_words(*worst));
  if (has_timing) row += fmt::format("| {:.2f} s ", item.seconds);
  return row + "| " + verdict_name(item.verdict) + " |\n";
}

std::string numbers_html(const JudgedCase& item, const std::vector<std::string>& printed) {
  std::string html =
      "<table><thead><tr><th>Number</th><th class=\"num\">exact</th><th class=\"num\">ours</th><th "
      "class=\"num\">95 % interval</th><th class=\"num\">deviation</th>" +
      std::string(printed.empty() ? "" : "<th class=\"num\">printed</th>") +
      "<th>verdict</th></tr></thead><tbody>\n";
  for (std::size_t k = 0; k < item.numbers.size(); ++k) {
    const JudgedNumber& n = item.numbers[k];
    html += fmt::format(
        "<tr><td>{}</td><td class=\"num\">{}</td><td class=\"num\">{}</td><td class=\"num\">{}</td>"
        "<td class=\"num\">{}</td>{}<td>{}</td></tr>\n",
        report::escape_html(n.measured.what), exact_words(n), value_words(n.stated.value),
        interval_words(n), report::with_minus(deviation_words(n)),
        printed.empty() ? ""
                        : "<td class=\"num\">" +
                              report::escape_html(k < printed.size() ? printed[k] : "") + "</td>",
        verdict_name(n.verdict));
  }
  for (const Refused& refused : item.result.refused) {
    html += fmt::format("<tr><td>{}</td><td colspan=\"4\">{}</td><td>{}</td></tr>\n",
                        report::escape_html(refused.what), report::escape_html(refused.said),
                        refused.said.empty() ? "NOT refused" : "refused");
  }
  return html + "</tbody></table>\n";
}

}  // namespace

const std::vector<std::string>& not_covered() {
  static const std::vector<std::string> list = {
      "Daylight (CIE 171:2006, 5.9 to 5.14): luxgate has no sky and no sun",
      "Transmission through glass (5.5): luxgate has no transparent surfaces",
      "Measured rooms (CIE 171:2006, 4.1 to 4.6): their photometry and readings are not public",
      "The second distribution of 5.2: its table is not public; an asymmetric one of our own is "
      "used",
      "Gloss and mirrors: all surfaces are diffuse"};
  return list;
}

std::string markdown_cell(const std::string& text) {
  std::string safe;
  for (const char c : report::printable(text))
    safe += c == '|' ? std::string("\\|") : std::string(1, c);
  return safe;
}

std::string exact_words(const JudgedNumber& n) {
  return value_words(n.measured.exact) + (n.measured.unit.empty() ? "" : " " + n.measured.unit);
}

std::string html_page(const std::string& title, const std::string& style, const std::string& body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n<meta "
      "name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<meta "
      "http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
      "'unsafe-inline'\"/>\n<title>{}</title>\n<style>\n{}{}</style>\n</head>\n<body>\n{}"
      "</body>\n</html>\n",
      title, report::html_style(), style, body);
}

std::string case_html(const JudgedCase& item, const std::vector<std::string>& printed,
                      bool has_timing) {
  std::string html = fmt::format(
      "<h3>{} <span class=\"id\">{}</span></h3>\n<p class=\"quiet\">{}{}: <b>{}</b>{}</p>\n",
      report::escape_html(item.test.title), report::escape_html(item.test.name),
      report::escape_html(item.test.source),
      has_timing ? fmt::format("; {:.2f} s, {:.3g} million rays", item.seconds,
                               1e-6 * static_cast<double>(item.result.rays))
                 : "",
      verdict_name(item.verdict),
      item.result.problem.empty() ? "" : ": " + report::escape_html(item.result.problem));
  return html + numbers_html(item, printed);
}

std::string render_report_markdown(const RunResult& result, bool has_timing) {
  std::string text = fmt::format(
      "# Validation report\n\nWritten by `luxgate selftest --report FOLDER`, never by hand: {} "
      "cases, "
      "{} numbers, {}. {}\n\nEvery case is a situation whose light is known exactly: by a "
      "closed form, by quadrature or by a matrix solution\nthat shares nothing with the "
      "calculation. The row shows the number that is furthest off; the HTML report has all.\n"
      "\"in\": the exact value is in our interval, at a level that all numbers together miss in "
      "fewer than one of a thousand\nseeds. {}.\n",
      result.cases.size(), result.numbers(), seeds_words(result),
      result.wrong() == 0 ? "All are right." : fmt::format("{} are OUT.", result.wrong()),
      coverage_words(result));
  for (const Kind& kind : kinds()) {
    text += fmt::format(
        "\n## {}\n\n| case | what | numbers | exact | ours | 95 % interval | "
        "deviation |{} verdict |\n|---|---|---|---|---|---|---|{}---|\n",
        kind.title, has_timing ? " time |" : "", has_timing ? "---|" : "");
    for (const JudgedCase& item : result.cases) {
      if (item.test.kind == kind.name) text += case_row(item, has_timing);
    }
  }
  text += "\n## Not covered\n\n";
  for (const std::string& item : not_covered()) text += "- " + item + "\n";
  return text;
}

std::string render_report_html(const RunResult& result, bool has_timing) {
  std::string body = fmt::format(
      "<p class=\"eyebrow\">luxgate {}</p>\n<h1>Validation report</h1>\n<p>{} cases, {} "
      "numbers, {}: <b>{}</b>. {}. "
      "Verdicts are at a level that all numbers together miss in fewer than one of a thousand "
      "seeds.</p>\n",
      report::escape_html(result.program), result.cases.size(), result.numbers(),
      seeds_words(result),
      result.wrong() == 0 ? "all right" : fmt::format("{} OUT", result.wrong()),
      report::escape_html(coverage_words(result)));
  for (const Kind& kind : kinds()) {
    body += "<h2>" + report::escape_html(kind.title) + "</h2>\n";
    for (const JudgedCase& item : result.cases) {
      if (item.test.kind == kind.name) body += case_html(item, {}, has_timing);
    }
  }
  body += "<h2>Not covered</h2>\n<ul>\n";
  for (const std::string& item : not_covered()) {
    body += "<li>" + report::escape_html(item) + "</li>\n";
  }
  return html_page("Validation report", "", body + "</ul>\n");
}

}  // namespace cli::selftest
