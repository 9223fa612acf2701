#include "calc/base/text.h"
#include "report/text/markup.h"
#include "report/tools/selftest/report.h"
#include "tests/validation/open_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace validation {

using namespace cli::selftest;

namespace {

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
          "| {} | {} | {} | {} | {} | {} |\n", markdown_cell(n.measured.what),
          value_words(n.measured.exact), value_words(n.stated.value), deviation_words(n),
          markdown_cell(item.printed[k]),
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
    text +=
        fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", *name,
                    markdown_cell(n->measured.what), exact_words(*n), value_words(n->stated.value),
                    interval_words(*n), deviation_words(*n), verdict_name(n->verdict));
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

std::string render_open_markdown(const OpenCases& open) {
  std::size_t numbers = 0, held = 0, run = 0;
  for (const OpenCase& item : open.cases) {
    if (!item.not_covered.empty()) continue;
    ++run;
    numbers += item.judged.numbers.size();
    held += held_of(item.judged);
  }
  std::string text = fmt::format(
      "# Open validation cases\n\nWritten by `validation_report open FOLDER` with "
      "LUXGATE_SHARED_DATA: {} of {} cases were calculated, {} of {}\nnumbers lie in their "
      "interval. Photometry files are held to their own linear interpolation.\n\n"
      "| case | in | of | worst exact | ours | deviation | verdict |\n"
      "|---|---|---|---|---|---|---|\n",
      run, open.cases.size(), held, numbers);
  for (const OpenCase& item : open.cases) {
    const JudgedCase& judged = item.judged;
    if (!item.not_covered.empty()) continue;
    const JudgedNumber* worst = judged.worst();
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", judged.test.name, held_of(judged),
                        judged.numbers.size(),
                        worst != nullptr
                            ? exact_words(*worst) + " (" + markdown_cell(worst->measured.what) + ")"
                            : "",
                        worst != nullptr ? value_words(worst->stated.value) : "",
                        worst != nullptr ? deviation_words(*worst) : "",
                        judged.result.problem.empty() ? verdict_name(judged.verdict)
                                                      : markdown_cell(judged.result.problem));
  }
  return text + too_vague(open) + "\n## Furthest off\n\n" + furthest_off(open) +
         "\n## CIE 171:2006, point by point\n" + cie_tables(open) + "\n## Not calculated\n\n" +
         not_calculated(open);
}

std::string render_open_html(const OpenCases& open) {
  std::string body = "<h1>Open validation cases</h1>\n";
  for (const OpenCase& item : open.cases) {
    if (item.not_covered.empty()) {
      body += case_html(item.judged, item.printed, false);
      for (const std::string& part : item.left_out) {
        body += "<p>Not calculated: " + report::escape_html(part) + "</p>\n";
      }
    } else {
      body += fmt::format("<h3>{} <span class=\"id\">{}</span></h3><p>Not calculated: {}</p>\n",
                          report::escape_html(item.judged.test.title),
                          report::escape_html(item.judged.test.name),
                          report::escape_html(item.not_covered));
    }
  }
  return html_page("Open validation cases", "", body);
}

}  // namespace validation
