#include "report/formats/pdf.h"

#include "calc/base/text.h"
#include "report/html/html.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

namespace report {
namespace {

class PdfWriter : public FormatWriter {
 public:
  PdfWriter(const DocumentFrame& frame, const SpillPlace& place, const Texts& t,
            const PageStyle& style, PagePrinter* printer)
      : page_(html_writer(frame, place, t, "", style, &numbers_)), printer_(printer) {}

  void add(const ProjectPart& project) override { page_->add(project); }
  void finish(const DocumentEnd& end, Sink& sink) override {
    const auto write_page = [&](Sink& to) { page_->finish(end, to); };
    if (printer_ == nullptr) return write_page(sink);
    std::string pdf = printer_->print(write_page);
    PageNumbers numbers = printer_->places_in(pdf);
    const bool is_long = std::any_of(numbers.begin(), numbers.end(),
                                     [](const auto& place) { return place.second > kFewPages; });
    if (is_long) {
      numbers_ = std::move(numbers);
      pdf = printer_->print(write_page);
    }
    sink.write(with_fixed_dates(std::move(pdf)));
  }

 private:
  static constexpr int kFewPages = 4;  // among which nobody needs a number

  PageNumbers numbers_;  // before the page, which refers to it
  std::unique_ptr<FormatWriter> page_;
  PagePrinter* printer_;
};

}  // namespace

std::unique_ptr<FormatWriter> pdf_writer(const DocumentFrame& frame, const SpillPlace& place,
                                         const Texts& t, const PageStyle& style,
                                         PagePrinter* printer) {
  return std::make_unique<PdfWriter>(frame, place, t, style, printer);
}

// In a text of the page the bracket would have a backslash before it.
std::string with_fixed_dates(std::string pdf) {
  constexpr std::string_view kFixed = "20000101000000";
  for (const std::string_view key : {"/CreationDate (D:", "/ModDate (D:"}) {
    for (std::size_t at = pdf.find(key); at != pdf.npos; at = pdf.find(key, at)) {
      at += key.size();
      const std::string_view date = std::string_view(pdf).substr(at, kFixed.size());
      if (date.size() == kFixed.size() && std::all_of(date.begin(), date.end(), calc::is_digit)) {
        pdf.replace(at, kFixed.size(), kFixed);
      }
    }
  }
  return pdf;
}

}  // namespace report
