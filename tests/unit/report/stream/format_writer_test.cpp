#include "report/stream/format_writer.h"

#include "report/formats/format.h"
#include "report/html/page/html.h"
#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace report::format_writer_test {
namespace {

// Of every kind, and twice: names repeat, and rules occur that were not in the first one.
Document batch() {
  Document document = small_document();
  for (int copy = 1; copy < 4; ++copy) {
    for (ProjectPart& project : sample_document().projects) {
      project.path = std::to_string(copy) + "/" + project.path;
      for (calc::Diagnostic& diagnostic : project.diagnostics) diagnostic.where.file = project.path;
      document.projects.push_back(std::move(project));
    }
    document.projects.push_back(small_document().projects[0]);
    document.projects.back().path = std::to_string(copy) + ".xml";
  }
  return document;
}

// Every project is gone before the next one comes, and the memory holds next to nothing.
std::string streamed(const Document& document, const MakeFormatWriter& make) {
  DocumentFrame frame = frame_of(document);
  const std::unique_ptr<FormatWriter> writer = make(frame, {testing::TempDir(), 100});
  for (const ProjectPart& project : document.projects) {
    auto forgotten = std::make_unique<ProjectPart>(project);
    writer->add(*forgotten);
    *forgotten = {};
  }
  TextSink sink;
  writer->finish(end_of(document), sink);
  return sink.text;
}

TEST(FormatWriters, NeedNoProjectThatIsGoneAndLittleMemory) {
  const FormatStyle style{{true, 90, true, true}, Texts(Language::german, true)};
  for (const Document& document : {batch(), small_document(), sample_document(), Document{}}) {
    for (const Format& format : formats()) {
      const auto make = [&](const DocumentFrame& frame, const SpillPlace& place) {
        return format.writer(frame, place, style);
      };
      EXPECT_EQ(streamed(document, make), format.render(document, style)) << format.name;
    }
    const auto index = [](const DocumentFrame& frame, const SpillPlace& place) {
      return html_writer(frame, place, {}, "x-rooms");
    };
    EXPECT_EQ(streamed(document, index), rendered_index(document, "x-rooms"));
  }
}

// Who makes a writer may forget what it was made with.
TEST(FormatWriters, KeepTheirStyle) {
  const Document document = small_document();
  const DocumentFrame frame = frame_of(document);
  FormatStyle style;
  style.page.paper = Paper::letter;
  const std::unique_ptr<FormatWriter> writer =
      find_format("html")->writer(frame, {testing::TempDir(), 100}, style);
  style.page.paper = Paper::a4;
  for (const ProjectPart& project : document.projects) writer->add(project);
  TextSink sink;
  writer->finish(end_of(document), sink);
  EXPECT_NE(sink.text.find("size: letter;"), std::string::npos);
}

// From what needs attention and from the summary.
TEST(FormatWriters, LinkToThePlanesOfTheirOwnProject) {
  Document document = small_document();
  document.projects.resize(3, document.projects[0]);
  const std::string html = render_html(document);
  for (const char* link : {"href=\"#p1s1k1\"", "href=\"#p2s1k1\"", "href=\"#p3s1k1\""}) {
    std::size_t count = 0;
    for (std::size_t at = html.find(link); at != std::string::npos; at = html.find(link, at + 1))
      ++count;
    EXPECT_EQ(count, 2U) << link;
  }
}

// Few planes are not folded, even if it is the last project that makes them many.
TEST(FormatWriters, FoldPlanesByTheNumberOfAll) {
  Document document = small_document();
  document.projects[0].spaces[0].planes[0].findings.pop_back();  // all it has left passes
  const auto folds = [&document](std::size_t projects) {
    document.projects.resize(projects, document.projects[0]);
    return render_html(document).find("<details class=\"card\">") != std::string::npos;
  };
  EXPECT_FALSE(folds(1));
  EXPECT_FALSE(folds(3));
  EXPECT_TRUE(folds(4));
}

}  // namespace
}  // namespace report::format_writer_test
