#include "report/formats/pdf.h"

#include "report/html/page/html.h"
#include "tests/support/rendered.h"
#include "tests/support/sample_document.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace report::pdf_test {
namespace {

class PrinterOfTest : public PagePrinter {
 public:
  std::string print(const std::function<void(Sink&)>& write_page) override {
    TextSink page;
    write_page(page);
    ++prints;
    return "%PDF of " + page.text + "/CreationDate (D:20261125141516+00'00')";
  }
  PageNumbers places_in(const std::string&) override { return places; }

  PageNumbers places;
  int prints = 0;
};

std::string rendered(PagePrinter* printer, Detail detail = Detail::full) {
  return render_whole(sample_document(), [&](const DocumentFrame& frame, const SpillPlace& place) {
    PageStyle style;
    style.detail = detail;
    return pdf_writer(frame, place, {}, style, printer);
  });
}

TEST(Pdf, IsThePageAsItsPrinterMakesIt) {
  FormatStyle client;
  client.page.detail = Detail::client;
  for (const auto& [detail, page] :
       {std::pair{Detail::full, render_html(sample_document())},
        std::pair{Detail::automatic, report::rendered("html", sample_document(), client)}}) {
    PrinterOfTest printer;
    EXPECT_EQ(rendered(&printer, detail),
              "%PDF of " + page + "/CreationDate (D:20000101000000+00'00')");
    EXPECT_EQ(rendered(nullptr, detail), page);
  }
}

TEST(Pdf, ContentsOfLongOnesNamePages) {
  PrinterOfTest printer;
  printer.places = {{"summary", 4}};
  EXPECT_EQ(rendered(&printer).find("<span class=\"page-number\""), std::string::npos);
  EXPECT_EQ(printer.prints, 1);
  printer.places["provenance"] = 17;
  const std::string pdf = rendered(&printer);
  EXPECT_EQ(printer.prints, 3);
  for (const char* words : {"<a href=\"#summary\">Summary</a><span class=\"page-number\">4</span>",
                            "Provenance</a><span class=\"page-number\">17</span>"}) {
    EXPECT_NE(pdf.find(words), std::string::npos) << words;
  }
  // Nothing else changes from the first time to the second.
  printer.places.clear();
  std::string plain = pdf;
  for (std::size_t at = plain.find("<span class=\"page-number\""); at != std::string::npos;
       at = plain.find("<span class=\"page-number\"")) {
    plain.erase(at, plain.find("</span>", at) + 7 - at);
  }
  EXPECT_EQ(plain, rendered(&printer));
}

TEST(Pdf, DatesOfOurOwnAreFixed) {
  EXPECT_EQ(with_fixed_dates("<</CreationDate (D:20261125141516+00'00')\n/ModDate "
                             "(D:20261125141517+00'00')>>"),
            "<</CreationDate (D:20000101000000+00'00')\n/ModDate (D:20000101000000+00'00')>>");
  for (const char* other : {"", "/CreationDate (D:2026", "/ModDate (D:2026112514151x)",
                            "(/ModDate \\(D:20261125141516)"}) {
    EXPECT_EQ(with_fixed_dates(other), other);
  }
}

// As Chromium writes them; the order of a tree of names stays.
TEST(Pdf, ElementsAreCountedFromOne) {
  const auto pdf = [](const char* a, const char* b) {
    return fmt::format(
        "/A [<</Headers [(node{1}) (node{0})]>>]\n/ID (node{0})>>\n/ID (node{1})>>"
        "<</Names [(node{0}) 3 0 R (node{1}) 4 0 R]>>",
        a, b);
  };
  EXPECT_EQ(with_counted_ids(pdf("00000113", "00000121")), pdf("00000001", "00000002"));
  EXPECT_EQ(with_counted_ids(pdf("00000114", "00000122")), pdf("00000001", "00000002"));
  // What a room may be called.
  for (const char* other : {"", "/Title (node00000113)", "/ID (node0000011", "/ID (node00x00113)",
                            "/ID (node000001134)", "[\\(node00000113)"}) {
    EXPECT_EQ(with_counted_ids(other), other);
  }
}

}  // namespace
}  // namespace report::pdf_test
