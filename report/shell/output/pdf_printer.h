#pragma once
// Prints pages to PDF with Chromium, which is searched only when needed: luxgate works without it.

#include "report/formats/pdf.h"
#include "report/shell/output/output_options.h"
#include "report/shell/process/environment.h"

#include <sys/types.h>

#include <memory>
#include <optional>
#include <string>

namespace cli {

// LUXGATE_CHROMIUM, or the first of chromium, chromium-browser and google-chrome in PATH. path: "",
// and problem: the reason, with what to install.
struct FoundChromium {
  std::string path, problem;
};
FoundChromium find_chromium(const Environment& environment);

// A separate process, started before this process gives up the right to start any (sandbox.h),
// receives pages through a socket and returns PDFs. It ends with this process, however that ends,
// and leaves nothing behind. Chromium runs without a network and without the user's settings, in a
// new folder for each page. It is ended when it takes far longer than a page of that size does.
class PdfPrinter : public report::PagePrinter {
 public:
  // Starts the process; requires that no other thread runs yet. Throws std::system_error.
  explicit PdfPrinter(const std::string& chromium);
  ~PdfPrinter() override;

  std::string print(const std::function<void(report::Sink&)>& write_page) override;
  report::PageNumbers places_in(const std::string& pdf) override;

 private:
  int socket_ = -1;
  pid_t process_ = -1;
};

// Opens options.printer if a PDF is requested. Returns false after an error, which is printed.
bool open_printer_or_print(OutputOptions& options, const Environment& environment);
// Opens the printer always, in the same way.
bool open_printer_or_print(std::optional<PdfPrinter>& printer, const Environment& environment);

}  // namespace cli
