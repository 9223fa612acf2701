// Reports of synthetic results for the browser test, and what they cost.
//   make_reports FOLDER PROBE.js

#include "report/formats/write.h"
#include "report/html/page/html.h"
#include "report/html/page/html_pages.h"
#include "tests/support/hostile_document.h"
#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

namespace {

bool all_written = true;

void write(const std::string& path, const std::string& text) {
  const std::string problem = report::write_file_atomically(path, text);
  if (problem.empty()) return;
  fmt::print(stderr, "{}: {}\n", path, problem);
  all_written = false;
}

// Rooms of eight planes; every seventh plane fails, every eleventh is undecided.
report::Document planes_document(int planes) {
  report::Document document = report::small_document();
  report::ProjectPart& project = document.projects[0];
  project.spaces.clear();
  for (int i = 0; i < planes; ++i) {
    if (i % 8 == 0) {
      report::SpacePart space = report::sample_office();
      space.planes.clear();
      space.id = fmt::format("r{}", i / 8 + 1);
      space.name = fmt::format("Room {}", i / 8 + 1);
      project.spaces.push_back(space);
    }
    report::PlanePart plane = report::sample_office().planes[0];
    plane.id = fmt::format("plane-{}", i + 1);
    plane.name = fmt::format("Work plane {}", i + 1);
    const double average = plane.average.value;
    const double limit = i % 7 == 0    ? std::round(1.05 * average)
                         : i % 11 == 0 ? std::round(10.0 * average) / 10.0
                                       : std::round(0.9 * average);
    plane.findings = {report::sample_finding(rules::Metric::average, limit, plane.average, "34.2")};
    for (int look = 0; look < 4; ++look) {
      const double half = plane.average.half_width() * (5 - look);
      const auto estimate = report::estimate(average, half);
      const auto finding = report::sample_finding(rules::Metric::average, limit, estimate);
      plane.looks.push_back({1024ULL << look,
                             4096ULL << look,
                             plane.points.size(),
                             estimate,
                             {{finding.verdict, finding.measured}}});
    }
    project.spaces.back().planes.push_back(plane);
  }
  return document;
}

// As it is, line ends included: the hash of the page's script depends on them.
std::string attribute(const std::string& text) {
  std::string quoted;
  for (const char c : text) {
    if (c == '&')
      quoted += "&amp;";
    else if (c == '"')
      quoted += "&quot;";
    else
      quoted += c;
  }
  return quoted;
}

std::string frame(const std::string& title, int width, const std::string& html) {
  return fmt::format(
      "<iframe title=\"{} at {} px\" width=\"{}\" height=\"900\" style=\"border:0\" "
      "srcdoc=\"{}\"></iframe>\n",
      title, width, width, attribute(html));
}

std::string frames(const std::string& title, const std::string& html) {
  return frame(title, 360, html) + frame(title, 800, html) + frame(title, 1400, html);
}

std::string file_text(const char* path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const std::string folder = argv[1];
  const std::string two = report::render_html(report::sample_document());
  const std::string forty = report::render_html(planes_document(40));
  const report::Document many = planes_document(400);

  const auto start = std::chrono::steady_clock::now();
  const std::string index = report::rendered_index(many, "split-rooms");
  std::size_t bytes = index.size(), largest = 0;
  std::string room;
  for (const report::HtmlPage& page : report::pages_of(many)) {
    const std::string html = report::rendered_page(many, page, "../split.html");
    bytes += html.size();
    largest = std::max(largest, html.size());
    write(folder + "/split-rooms/" + page.name, html);
    if (room.empty()) room = html;
  }
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  fmt::print(
      "400 planes split: {:.2f} s, {} bytes a plane, index {} bytes, largest page {} bytes\n",
      seconds, bytes / 400, index.size(), largest);

  const report::Texts german(report::Language::german, true);
  const std::string german_two = report::render_html(report::sample_document(), german);
  const std::string german_forty = report::render_html(planes_document(40), german);
  const std::string hostile = report::render_html(report::hostile_document());
  write(folder + "/two.html", two);
  write(folder + "/forty.html", forty);
  write(folder + "/split.html", index);
  write(folder + "/hostile.html", hostile);
  write(folder + "/german.html", german_two);
  write(folder + "/probe.html",
        "<!DOCTYPE html><html lang=\"en\"><head><meta "
        "charset=\"utf-8\"><title>probe</title></head><body><pre "
        "id=\"result\">PROBE did not run</pre>\n" +
            frames("two", two) + frames("German", german_two) + frames("forty", forty) +
            frame("German forty", 360, german_forty) + frames("split", index) +
            frame("room", 360, room) + frame("room", 1400, room) + frame("hostile", 360, hostile) +
            frame("hostile", 1400, hostile) + "<script>" + file_text(argv[2]) +
            "</script></body></html>\n");
  return all_written ? 0 : 1;
}
