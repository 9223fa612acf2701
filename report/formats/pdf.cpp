#include "report/formats/pdf.h"

#include "calc/base/text.h"
#include "report/html/client/client_page.h"
#include "report/html/page/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace report {
namespace {

class PdfWriter : public FormatWriter {
 public:
  PdfWriter(const DocumentFrame& frame, const SpillPlace& place, const Texts& t,
            const PageStyle& style, PagePrinter* printer)
      : page_(style.detail == Detail::full ? html_writer(frame, place, t, "", style, &numbers_)
                                           : client_writer(frame, place, t, style, &numbers_)),
        printer_(printer) {}

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
    sink.write(reproducible_pdf(std::move(pdf)));
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

// Titles and other texts stand behind keys of their own ("/Title (node00000001)").
std::string with_counted_ids(std::string pdf) {
  constexpr std::string_view kStart = "(node";
  constexpr std::size_t kDigits = 8;
  std::vector<std::size_t> places;  // of the digits
  std::map<std::string, std::size_t> number_of;
  for (std::size_t at = pdf.find(kStart); at != pdf.npos; at = pdf.find(kStart, at)) {
    const std::string_view before = std::string_view(pdf).substr(0, at);
    at += kStart.size();
    const std::string digits = pdf.substr(at, kDigits);
    const bool is_id = before.ends_with("/ID ") || before.ends_with('[') ||
                       before.ends_with(") ") || before.ends_with("R ");
    if (!is_id || digits.size() != kDigits || pdf.compare(at + kDigits, 1, ")") != 0 ||
        !std::all_of(digits.begin(), digits.end(), calc::is_digit)) {
      continue;
    }
    places.push_back(at);
    number_of[digits] = 0;
  }
  std::size_t next = 0;
  for (auto& [digits, number] : number_of) number = ++next;
  for (const std::size_t at : places) {
    const std::size_t number = number_of.at(pdf.substr(at, kDigits));
    pdf.replace(at, kDigits, fmt::format("{:08}", number));
  }
  return pdf;
}

std::string reproducible_pdf(std::string pdf) {
  return with_counted_ids(with_fixed_dates(std::move(pdf)));
}

}  // namespace report
