#pragma once
// Pages to PDF by Chromium, which is found when it is needed: luxgate works without it.

#include "report/formats/pdf.h"
#include "report/shell/output/output_options.h"
#include "report/shell/process/environment.h"

#include <sys/types.h>

#include <memory>
#include <optional>
#include <string>

namespace cli {

// LUXGATE_CHROMIUM, or the first of chromium, chromium-browser and google-chrome in PATH. path: "",
// and problem: why, with what to install.
struct FoundChromium {
  std::string path, problem;
};
FoundChromium find_chromium(const Environment& environment);

// A process of its own, which is started before this one gives up to start any (sandbox.h), takes
// pages through a socket and gives PDFs back. It ends with this one, whatever ends that, and leaves
// nothing behind. Chromium runs without a network and without the user's settings, in a folder that
// is made for each page. It is ended when it takes far longer than a page of that size does.
class PdfPrinter : public report::PagePrinter {
 public:
  // Before other threads are started. Throws std::system_error.
  explicit PdfPrinter(const std::string& chromium);
  ~PdfPrinter() override;

  std::string print(const std::function<void(report::Sink&)>& write_page) override;
  report::PageNumbers places_in(const std::string& pdf) override;

 private:
  int socket_ = -1;
  pid_t process_ = -1;
};

// Where a PDF is asked for: into options.printer. False after an error, which has been printed.
bool open_printer_or_print(OutputOptions& options, const Environment& environment);
// Likewise, always.
bool open_printer_or_print(std::optional<PdfPrinter>& printer, const Environment& environment);

}  // namespace cli
