#include "report/tools/selftest/report.h"

#include "calc/base/text.h"
#include "report/html/html_markup.h"
#include "report/html/html_style.h"
#include "report/text/markup.h"
#include "report/text/plain_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cli::selftest {
namespace {

// In a cell of a Markdown table.
std::string cell(const std::string& text) {
  std::string safe;
  for (const char c : report::printable(text))
    safe += c == '|' ? std::string("\\|") : std::string(1, c);
  return safe;
}

std::string exact_words(const JudgedNumber& n) {
  return value_words(n.measured.exact) + (n.measured.unit.empty() ? "" : " " + n.measured.unit);
}

std::string case_row(const JudgedCase& item, bool has_timing) {
  const JudgedNumber* worst = item.worst();
  std::string row = fmt::format("| {} | {} | {} ", item.test.name, cell(item.test.title),
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

std::size_t held_of(const JudgedCase& item) {
  return static_cast<std::size_t>(
      std::count_if(item.numbers.begin(), item.numbers.end(),
                    [](const JudgedNumber& n) { return n.verdict == Verdict::right; }));
}

bool is_cie(const OpenCase& item) {
  return item.judged.test.title.find("CIE 171") != std::string::npos && item.not_covered.empty();
}

std::string cie_tables(const OpenCases& open) {
  std::string text;
  for (const OpenCase& item : open.cases) {
    if (!is_cie(item)) continue;
    text += fmt::format(
        "\n### {}\n\n| point | exact, lx | ours, lx | deviation | printed | ours to printed |\n"
        "|---|---|---|---|---|---|\n",
        item.judged.test.name);
    for (std::size_t k = 0; k < item.judged.numbers.size(); ++k) {
      const JudgedNumber& n = item.judged.numbers[k];
      const double printed = calc::parse_number(item.printed[k]).value_or(0.0);
      text += fmt::format(
          "| {} | {} | {} | {} | {} | {} |\n", cell(n.measured.what), value_words(n.measured.exact),
          value_words(n.stated.value), deviation_words(n), cell(item.printed[k]),
          printed > 0.0 ? fmt::format("{:+.2f} %", 100.0 * (n.stated.value / printed - 1.0)) : "");
    }
  }
  return text;
}

// Where samples of whole luminous surfaces are too rare near the point.
std::string too_vague(const OpenCases& open) {
  std::string names;
  for (const OpenCase& item : open.cases) {
    if (item.judged.verdict != Verdict::too_vague) continue;
    names += (names.empty() ? "" : ", ") + item.judged.test.name;
  }
  if (names.empty()) return "";
  return "\nToo vague: " + names +
         ". Their luminous surfaces are wide beside the distance of the points, and each is one "
         "luminaire here: it needs a finer division.\n";
}

// The ten numbers with the largest relative deviation, right or not.
std::string furthest_off(const OpenCases& open) {
  constexpr std::size_t kShown = 10;
  std::vector<std::pair<const JudgedNumber*, const std::string*>> all;
  for (const OpenCase& item : open.cases) {
    for (const JudgedNumber& n : item.judged.numbers) {
      if (n.measured.exact != 0.0) all.emplace_back(&n, &item.judged.test.name);
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return std::abs(a.first->deviation()) > std::abs(b.first->deviation());
  });
  all.resize(std::min(all.size(), kShown));
  std::string text =
      "| case | number | exact | ours | 95 % interval | deviation | verdict |\n"
      "|---|---|---|---|---|---|---|\n";
  for (const auto& [n, name] : all) {
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", *name, cell(n->measured.what),
                        exact_words(*n), value_words(n->stated.value), interval_words(*n),
                        deviation_words(*n), verdict_name(n->verdict));
  }
  return text;
}

std::string not_calculated(const OpenCases& open) {
  std::string text;
  for (const OpenCase& item : open.cases) {
    const std::string& name = item.judged.test.name;
    if (!item.not_covered.empty()) {
      text += fmt::format("- {}: {}\n", name, item.not_covered);
      continue;
    }
    for (const std::string& part : item.left_out) text += fmt::format("- {}, {}\n", name, part);
  }
  return text.empty() ? "Nothing.\n" : text;
}

}  // namespace

const std::vector<std::string>& not_covered() {
  static const std::vector<std::string> list = {
      "Daylight (CIE 171:2006, 5.9 to 5.14): luxgate has no sky and no sun",
      "Transmission through glass (5.5): luxgate has no transparent surfaces",
      "Measured rooms (CIE 171:2006, 4.1 to 4.6): their photometry and readings are not public",
      "The second distribution of 5.2: its table was not seen; an own asymmetric one stands for it",
      "Gloss and mirrors: all surfaces are diffuse"};
  return list;
}

std::string render_report_markdown(const RunResult& result, bool has_timing) {
  std::string text = fmt::format(
      "# Validation report\n\nWritten by `luxgate selftest --report FOLDER`, never by hand: {} "
      "cases, "
      "{} numbers, seed {}. {}\n\nEvery case is a situation whose light is known exactly: by a "
      "closed form, by quadrature or by a matrix solution\nthat shares nothing with the "
      "calculation. The row shows the number that is furthest off; the HTML report has all.\n"
      "\"in\": the exact value lies in our interval, at a level that all numbers together miss in "
      "fewer than one of a thousand\nseeds. Of {} sampled numbers, {} lie in their stated 95 % "
      "interval.\n",
      result.cases.size(), result.numbers(), result.seed,
      result.wrong() == 0 ? "All are right." : fmt::format("{} are OUT.", result.wrong()),
      result.sampled(), result.held());
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

std::string render_open_markdown(const OpenCases& open) {
  if (open.cases.empty()) return "";
  std::size_t numbers = 0, held = 0, run = 0;
  for (const OpenCase& item : open.cases) {
    if (!item.not_covered.empty()) continue;
    ++run;
    numbers += item.judged.numbers.size();
    held += held_of(item.judged);
  }
  std::string text = fmt::format(
      "# Open validation cases\n\nWritten by `luxgate selftest --report FOLDER` with "
      "LUXGATE_SHARED_DATA: {} of {} cases were calculated, {} of {}\nnumbers lie in their "
      "interval. Photometry files are held to their own linear interpolation.\n\n"
      "| case | in | of | worst exact | ours | deviation | verdict |\n"
      "|---|---|---|---|---|---|---|\n",
      run, open.cases.size(), held, numbers);
  for (const OpenCase& item : open.cases) {
    const JudgedCase& judged = item.judged;
    if (!item.not_covered.empty()) continue;
    const JudgedNumber* worst = judged.worst();
    text += fmt::format(
        "| {} | {} | {} | {} | {} | {} | {} |\n", judged.test.name, held_of(judged),
        judged.numbers.size(),
        worst != nullptr ? exact_words(*worst) + " (" + cell(worst->measured.what) + ")" : "",
        worst != nullptr ? value_words(worst->stated.value) : "",
        worst != nullptr ? deviation_words(*worst) : "",
        judged.result.problem.empty() ? verdict_name(judged.verdict) : cell(judged.result.problem));
  }
  return text + too_vague(open) + "\n## Furthest off\n\n" + furthest_off(open) +
         "\n## CIE 171:2006, point by point\n" + cie_tables(open) + "\n## Not calculated\n\n" +
         not_calculated(open);
}

std::string render_report_html(const RunResult& result, const OpenCases& open, bool has_timing) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n<meta "
      "name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<meta "
      "http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
      "'unsafe-inline'\"/>\n<title>Validation "
      "report</title>\n<style>\n{}</style>\n</head>\n<body>\n"
      "<p class=\"eyebrow\">luxgate {} · {}</p>\n<h1>Validation report</h1>\n<p>{} cases, {} "
      "numbers, "
      "seed {}: <b>{}</b>. Of {} sampled numbers, {} lie in their stated 95 % interval. Verdicts "
      "are "
      "at a level that all numbers together miss in fewer than one of a thousand seeds.</p>\n",
      report::html_style(), report::escape_html(result.program), report::escape_html(result.tracer),
      result.cases.size(), result.numbers(), result.seed,
      result.wrong() == 0 ? "all right" : fmt::format("{} OUT", result.wrong()), result.sampled(),
      result.held());
  for (const Kind& kind : kinds()) {
    html += "<h2>" + report::escape_html(kind.title) + "</h2>\n";
    for (const JudgedCase& item : result.cases) {
      if (item.test.kind == kind.name) html += case_html(item, {}, has_timing);
    }
  }
  if (!open.cases.empty()) html += "<h2>Open validation cases</h2>\n";
  for (const OpenCase& item : open.cases) {
    if (item.not_covered.empty()) {
      html += case_html(item.judged, item.printed, has_timing);
      for (const std::string& part : item.left_out) {
        html += "<p>Not calculated: " + report::escape_html(part) + "</p>\n";
      }
    } else {
      html += fmt::format("<h3>{} <span class=\"id\">{}</span></h3><p>Not calculated: {}</p>\n",
                          report::escape_html(item.judged.test.title),
                          report::escape_html(item.judged.test.name),
                          report::escape_html(item.not_covered));
    }
  }
  html += "<h2>Not covered</h2>\n<ul>\n";
  for (const std::string& item : not_covered()) {
    html += "<li>" + report::escape_html(item) + "</li>\n";
  }
  return html + "</ul>\n</body>\n</html>\n";
}

}  // namespace cli::selftest
