#include "report/tools/photometry/photometry.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/file_hash.h"
#include "calc/base/text.h"
#include "calc/photometry/write/write_eulumdat.h"
#include "calc/photometry/write/write_lm63.h"
#include "report/formats/write.h"
#include "report/images/polar_diagram.h"
#include "report/shell/options/recording_reader.h"
#include "report/shell/output/outputs.h"
#include "report/shell/output/pdf_printer.h"
#include "report/shell/process/exit_code.h"
#include "report/shell/process/print.h"
#include "report/tools/photometry/photometry_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace cli {
namespace {

namespace fs = std::filesystem;

std::string lower_extension(const std::string& path) {
  return calc::ascii_lowered(fs::path(path).extension().string());
}

class Run {
 public:
  Run(const PhotometryOptions& options, const calc::FileReader& disk, bool colour,
      report::PagePrinter* printer)
      : wanted_(options), disk_(disk), colour_(colour), printer_(printer) {
    choice_.lamp_set = wanted_.lamp_set;
    choice_.variant = wanted_.variant;
    choice_.emitter = wanted_.emitter;
  }

  PhotometryRun run() {
    for (const std::string& path : wanted_.files) {
      for (PhotometryFile& file : read_safely(path)) files_.push_back(std::move(file));
    }
    if (wanted_.compare && files_[0].web && files_[1].web) compare();
    if (!wanted_.convert_file.empty() && files_[0].web) convert(files_[0]);
    if (!wanted_.polar_file.empty() && files_[0].web) draw(files_[0], wanted_.polar_file);
    if (!wanted_.polar_folder.empty()) draw_all();
    if (!wanted_.sheet_file.empty() && files_[0].web) write_sheet(files_[0]);
    print();
    return std::move(result_);
  }

 private:
  // Whatever goes wrong with one file must not stop the others.
  std::vector<PhotometryFile> read_safely(const std::string& path) {
    try {
      if (!wants_one_light()) return read_photometry_lights(path, disk_, choice_);
      return {read_photometry_file(path, disk_, choice_)};
    } catch (const std::exception& error) {
      calc::Diagnostics diagnostics;
      diagnostics.report(calc::DiagnosticId::internal_error, {path, 0, 0}, error.what());
      PhotometryFile file;
      file.path = path;
      file.diagnostics = diagnostics.all();
      return {file};
    }
  }
  bool wants_one_light() const {
    return wanted_.compare || !wanted_.convert_file.empty() || !wanted_.polar_file.empty() ||
           !wanted_.sheet_file.empty();
  }

  void compare() {
    comparison_ = calc::compare_webs(*files_[0].web, *files_[1].web);
    const double rms = comparison_->fits.front().rms;
    if (rms <= kNearlySameLight) return;
    others_.report(calc::DiagnosticId::photometry_pair_differs, {}, files_[0].path, files_[1].path,
                   100.0 * rms);
  }

  void convert(const PhotometryFile& file) {
    const std::string& path = wanted_.convert_file;
    const std::optional<std::string> bytes = lower_extension(path) == ".ies"
                                                 ? calc::write_lm63(*file.web, path, others_)
                                                 : calc::write_eulumdat(*file.web, path, others_);
    if (bytes) write(path, *bytes);
  }

  void draw(const PhotometryFile& file, const std::string& path) {
    const std::string& name = file.web->source().luminaire_name;
    try {
      const report::PolarDrawing drawing = report::draw_polar_diagram(
          *file.web, name.empty() ? fs::path(file.path).filename().string() : name);
      write(path, lower_extension(path) == ".png" ? report::render_polar_png(drawing)
                                                  : report::render_polar_svg(drawing));
    } catch (const std::exception& error) {
      others_.report(calc::DiagnosticId::output_not_possible, {},
                     fmt::format("cannot draw '{}': {}", path, error.what()));
    }
  }

  void write_sheet(const PhotometryFile& file) {
    const std::string& path = wanted_.sheet_file;
    const report::Texts t = wanted_.page.texts();
    try {
      const calc::FileContent content = disk_.read(file.path);
      if (!content.ok()) throw std::runtime_error(file.path + ": " + content.error);
      std::string bytes =
          render_photometry_sheet(t, file, calc::sha256_hex(content.bytes), wanted_.page.paper);
      if (lower_extension(path) == ".pdf") {
        if (printer_ == nullptr) throw report::WriteFailure("nothing prints it");
        bytes = report::reproducible_pdf(
            printer_->print([&](report::Sink& sink) { sink.write(bytes); }));
      }
      write(path, bytes);
    } catch (const std::exception& failure) {
      others_.report(calc::DiagnosticId::output_not_possible, {},
                     fmt::format("cannot write '{}': {}", path, failure.what()));
    }
  }

  // a.ies -> a.ies.svg: a.ies and a.ldt often stand side by side.
  void draw_all() {
    std::set<std::string> taken;
    for (const PhotometryFile& file : files_) {
      if (!file.web) continue;
      const std::string wanted = fs::path(file.path).filename().string();
      std::string stem = wanted;
      for (int i = 2; !taken.insert(stem).second; ++i) stem = fmt::format("{}-{}", wanted, i);
      draw(file, (fs::path(wanted_.polar_folder) / (stem + ".svg")).string());
    }
  }

  void write(const std::string& path, const std::string& bytes) {
    const std::string identity = path_identity(path);
    const std::set<std::string> inputs = disk_.paths();
    const bool is_input = std::any_of(inputs.begin(), inputs.end(), [&](const std::string& file) {
      return path_identity(file) == identity;
    });
    std::string problem;
    if (is_input) {
      problem = fmt::format("'{}' was read as an input and is not overwritten", path);
    } else if (std::string reason = report::write_file_atomically(path, bytes); !reason.empty()) {
      problem = fmt::format("cannot write '{}': {}", path, reason);
    }
    if (problem.empty()) {
      written_.push_back(path);
    } else {
      others_.report(calc::DiagnosticId::output_not_possible, {}, problem);
    }
  }

  void print_diagnostic(const calc::Diagnostic& entry, bool warnings_too) {
    const bool is_error = entry.severity() == calc::Severity::error;
    (is_error ? has_errors_ : has_warnings_) = true;
    if (is_error || (warnings_too && !wanted_.quiet)) {
      result_.err += calc::format_diagnostic(entry) + "\n";
    }
  }

  void print() {
    const bool is_text = wanted_.format == PhotometryFormat::text;
    // In full text and in JSON the warnings stand with their file.
    const bool apart = wanted_.format == PhotometryFormat::csv || (is_text && wanted_.compare);
    for (const PhotometryFile& file : files_) {
      for (const calc::Diagnostic& entry : file.diagnostics) print_diagnostic(entry, apart);
    }
    for (const calc::Diagnostic& entry : others_.all()) print_diagnostic(entry, true);
    if (!wanted_.quiet) result_.err += written_words(written_);

    const calc::WebComparison* comparison = comparison_ ? &*comparison_ : nullptr;
    if (wanted_.format == PhotometryFormat::json) {
      result_.out = render_photometry_json(files_, comparison);
    } else if (wanted_.format == PhotometryFormat::csv) {
      result_.out = render_photometry_csv(files_);
    } else if (wanted_.compare && !wanted_.quiet) {
      if (comparison != nullptr) {
        result_.out = render_comparison_text(files_[0], files_[1], *comparison, colour_);
      }
    } else if (!wanted_.quiet) {
      for (const PhotometryFile& file : files_) {
        if (!result_.out.empty()) result_.out += "\n";
        result_.out += render_photometry_text(file, colour_);
      }
    }
    rules::Outcome outcome = rules::Outcome::nothing_asked;
    if (wanted_.strict && has_warnings_) outcome = graver(outcome, rules::Outcome::fail);
    if (has_errors_) outcome = graver(outcome, rules::Outcome::not_judged);
    result_.exit_code = exit_code_of(outcome);
  }

  const PhotometryOptions& wanted_;
  const RecordingReader disk_;
  const bool colour_;
  report::PagePrinter* const printer_;
  calc::PhotometryOptions choice_;
  std::vector<PhotometryFile> files_;
  std::optional<calc::WebComparison> comparison_;
  calc::Diagnostics others_;  // of writing and comparing
  std::vector<std::string> written_;
  bool has_errors_ = false, has_warnings_ = false;
  PhotometryRun result_;
};

}  // namespace

PhotometryRun run_photometry(const PhotometryOptions& options, const calc::FileReader& files,
                             bool colour, report::PagePrinter* printer) {
  return Run(options, files, colour, printer).run();
}

Command photometry_command() {
  const auto options = std::make_shared<PhotometryOptions>();
  Command command = photometry_syntax(*options);
  command.run = [options](const RunContext& context) {
    std::optional<PdfPrinter> printer;
    if (lower_extension(options->sheet_file) == ".pdf" &&
        !open_printer_or_print(printer, context.environment)) {
      return kNotJudged;
    }
    const PhotometryRun result = run_photometry(*options, calc::DiskFileReader(),
                                                use_color(options->color, context.environment),
                                                printer ? &*printer : nullptr);
    tell("{}", result.err);
    return print_result(result.out) ? result.exit_code : kNotJudged;
  };
  return command;
}

}  // namespace cli
