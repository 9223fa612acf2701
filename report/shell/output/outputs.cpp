#include "report/shell/output/outputs.h"
#include "calc/base/diagnostic_ids.h"
#include "report/document/shown_plane.h"

#include "calc/base/real_path.h"
#include "report/formats/format.h"
#include "report/formats/write.h"
#include "report/html/drawings/heatmap_svg.h"
#include "report/html/page/html.h"
#include "report/html/page/html_pages.h"
#include "report/images/exr.h"
#include "report/images/heatmap.h"
#include "report/images/png.h"
#include "report/shell/process/print.h"
#include "report/text/folded_warnings.h"
#include "report/text/room_overview.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

namespace cli {
namespace {

namespace fs = std::filesystem;

// The closest folder at or above `path` that exists.
fs::path existing_folder(fs::path path) {
  std::error_code ignored;
  while (!path.empty() && !fs::exists(path, ignored)) {
    if (path == path.parent_path()) break;
    path = path.parent_path();
  }
  return path.empty() ? fs::path(".") : path;
}

}  // namespace

std::string writability(const std::string& file) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored))
    return fmt::format("cannot write '{}': it is a folder", file);
  const fs::path folder = existing_folder(fs::path(file).parent_path());
  if (!fs::is_directory(folder, ignored)) {
    return fmt::format("cannot write '{}': '{}' is not a folder", file, folder.string());
  }
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    return fmt::format("cannot write '{}': no permission to write to '{}'", file, folder.string());
  }
  return "";
}

namespace {

// Where temporary files can be made; "" = nowhere.
std::string temporary_folder() {
  std::error_code failure;
  const fs::path folder = fs::temp_directory_path(failure);
  return failure || access(folder.c_str(), W_OK | X_OK) != 0 ? "" : folder.string();
}

bool is_pipe_or_device(const std::string& file) {
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  return fs::exists(status) && !fs::is_regular_file(status);
}

// The closest one that exists; links followed.
std::string folder_of_file(const std::string& file) {
  return existing_folder(fs::path(path_identity(file)).parent_path()).string();
}

std::string cannot_write(const std::string& path, const std::string& why) {
  return fmt::format("cannot write '{}': {}", path, why);
}

// Writes files, but never over an input.
class GuardedFiles {
 public:
  explicit GuardedFiles(double most_bytes) : most_bytes_(most_bytes) {}  // of each

  void add_inputs(const std::set<std::string>& inputs) {
    for (const std::string& input : inputs) {
      if (!inputs_.insert(input).second) continue;
      const std::string identity = path_identity(input);
      identities_.insert(identity);
      if (written_.contains(identity)) {
        problems_.push_back(
            fmt::format("'{}' was read as an input after it had been overwritten", input));
      }
    }
  }

  // "" or a message. It appears with the others, see publish().
  std::string add(const std::string& path, const std::function<void(report::Sink&)>& make) {
    return guarded(path, [&] { return set_.add(path, make); });
  }
  // Messages.
  std::vector<std::string> publish() { return set_.publish(published_); }
  // Written at once, while inputs may still come.
  std::string write_early(const std::string& path, const std::function<std::string()>& make) {
    std::string problem = guarded(path, [&] {
      const std::string bytes = make();
      report::fail_beyond(static_cast<double>(bytes.size()), most_bytes_);
      return report::write_file_atomically(path, bytes);
    });
    if (problem.empty()) {
      written_.insert(path_identity(path));
      early_.push_back(path);
    }
    return problem;
  }

  bool is_input(const std::string& path) const { return identities_.contains(path_identity(path)); }
  // All that has been written: what was published first.
  std::vector<std::string> written() const {
    std::vector<std::string> files = published_;
    files.insert(files.end(), early_.begin(), early_.end());
    return files;
  }
  // Inputs that came too late.
  const std::vector<std::string>& problems() const { return problems_; }

 private:
  std::string guarded(const std::string& path, const std::function<std::string()>& write) const {
    if (is_input(path)) {
      return fmt::format("'{}' was read as an input and is not overwritten", path);
    }
    try {
      const std::string problem = write();
      return problem.empty() ? "" : cannot_write(path, problem);
    } catch (const std::exception& error) {
      return cannot_write(path, error.what());
    }
  }

  const double most_bytes_;
  report::FileSet set_;
  std::set<std::string> inputs_, identities_;
  std::set<std::string> written_;  // early; identities
  std::vector<std::string> published_, early_;
  std::vector<std::string> problems_;
};

void add_problem(std::string problem, std::vector<std::string>& problems) {
  if (!problem.empty()) problems.push_back(std::move(problem));
}

// A PNG, an SVG and an EXR of every computed plane, and the pictures of rooms.
class Images {
 public:
  Images(const std::string& folder, const report::Provenance& provenance, const report::Texts& t,
         const report::PageStyle& style)
      : folder_(folder), provenance_(provenance), t_(t), style_(style) {}

  void add(const report::ProjectPart& project, GuardedFiles& files) {
    const report::ColourScales scales(project, style_.scale, style_.palette);
    for (const report::SpacePart& space : project.spaces) {
      for (const report::PlanePart& plane : space.planes) {
        if (plane.is_computed && report::has_cells(plane))
          add_plane(project, space, plane, scales, files);
      }
      add_pictures(project, space, files);
    }
  }

  const std::vector<std::string>& problems() const { return problems_; }

 private:
  // Names are given once.
  std::string path_of(const std::string& wanted) {
    std::string stem = wanted;
    for (int i = 2; !taken_.insert(stem).second; ++i) stem = fmt::format("{}-{}", wanted, i);
    return (fs::path(folder_) / stem).string();
  }
  void write(GuardedFiles& files, const std::string& path,
             const std::function<std::string()>& make) {
    add_problem(files.write_early(path, make), problems_);
  }

  void add_plane(const report::ProjectPart& project, const report::SpacePart& space,
                 const report::PlanePart& own_plane, const report::ColourScales& scales,
                 GuardedFiles& files) {
    const report::ShownPlane shown(own_plane);
    const report::PlanePart& plane = *shown;
    const std::string path = path_of(image_stem(project, plane));
    const std::string title = report::plane_picture_title(t_, space, plane);
    const auto write_png = [&](const report::PlaneScale& scale) {
      write(files, path + ".png", [&] {
        return report::render_heatmap_png(plane, scale.scale, title,
                                          std::string(report::sharing_words(t_, scale.among)));
      });
    };
    if (report::has_all_values(plane)) {
      const report::PlaneScale scale = scales.of(space, plane);
      write_png(scale);
      write(files, path + ".svg",
            [&] { return report::render_heatmap_svg(t_, space, plane, scale); });
    } else {
      write_png({report::scale_of(plane, style_.palette)});
    }
    write(files, path + ".exr",
          [&] { return report::render_exr(provenance_, project, space, own_plane); });
  }

  // Names are those of the room's planes with the picture's in place of the plane's.
  void add_pictures(const report::ProjectPart& project, const report::SpacePart& space,
                    GuardedFiles& files) {
    for (const report::RoomPicture& picture : space.pictures.list) {
      const std::string path = path_of(
          safe_name(fs::path(project.path).stem().string() + "-" + space.id + "-" + picture.name));
      write(files, path + ".png", [&] { return picture.labelled_png; });
      if (!picture.exr.empty()) write(files, path + ".exr", [&] { return picture.exr; });
    }
  }

  std::string folder_;
  report::Provenance provenance_;
  report::Texts t_;
  report::PageStyle style_;
  std::set<std::string> taken_;
  std::vector<std::string> problems_;
};

// Of the pages that belong to an index: the index's whole name, so that no two share it.
fs::path rooms_folder(const fs::path& index) {
  return index.parent_path() / (index.filename().string() + "-rooms");
}

// "p1s2.html", "p1s2-3.html": the names of pages, and of nothing else that we write.
bool is_page_name(std::string_view name) {
  const auto number = [&name] {
    const std::size_t digits = std::min(name.find_first_not_of("0123456789"), name.size());
    name.remove_prefix(digits);
    return digits > 0;
  };
  const auto word = [&name](std::string_view expected) {
    if (!name.starts_with(expected)) return false;
    name.remove_prefix(expected.size());
    return true;
  };
  if (!word("p") || !number() || !word("s") || !number()) return false;
  if (name.starts_with("-") && !(word("-") && number())) return false;
  return name == ".html";
}

// Whether this is or could be a page in that folder.
bool is_page_of(const fs::path& folder, const std::string& file) {
  const fs::path path = path_identity(file);
  return is_page_name(path.filename().string()) &&
         path.parent_path() == fs::path(path_identity(folder.string()));
}

// Pages of an earlier run that this one has not: nothing links to them, and they tell old results.
std::vector<std::string> remove_stale_pages(const fs::path& folder,
                                            const std::set<std::string>& written,
                                            const GuardedFiles& files) {
  std::vector<fs::path> stale;
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const std::string name = entry->path().filename().string();
    std::error_code ignored;
    if (!is_page_name(name) || written.contains(name)) continue;
    if (entry->is_regular_file(ignored) && !files.is_input(entry->path().string()))
      stale.push_back(entry->path());
  }
  std::vector<std::string> problems;
  for (const fs::path& path : stale) {
    fs::remove(path, failure);
    if (failure) {
      problems.push_back(fmt::format("cannot remove '{}', a page of an earlier report: {}",
                                     path.string(), failure.message()));
    }
  }
  return problems;
}

// The pages of an index. They name planes by position: none must be a file that is there for
// another reason, which the folder of its own sees to.
class RoomPages {
 public:
  RoomPages(const std::string& index, const report::Provenance& provenance, const report::Texts& t,
            const report::PageStyle& style)
      : folder_(rooms_folder(index)),
        back_("../" + report::url_name(fs::path(index).filename().string())),
        provenance_(provenance),
        t_(t),
        style_(style) {}

  // From the index to the pages.
  std::string address() const { return report::url_name(folder_.filename().string()); }

  void add(const report::ProjectPart& project, GuardedFiles& files,
           std::vector<std::string>& problems) {
    for (const report::HtmlPage& page : report::html_pages(project, projects_)) {
      written_.insert(page.name);
      const auto make = [&] {
        return report::render_html_page(provenance_, project, page, back_, t_, style_);
      };
      add_problem(files.write_early((folder_ / page.name).string(), make), problems);
    }
    ++projects_;
  }

  std::vector<std::string> remove_stale(const GuardedFiles& files) const {
    return remove_stale_pages(folder_, written_, files);
  }

 private:
  fs::path folder_;
  std::string back_;
  report::Provenance provenance_;
  report::Texts t_;
  report::PageStyle style_;
  std::size_t projects_ = 0;  // so far
  std::set<std::string> written_;
};

// "" or why the pages beside an index cannot be written: an input or another planned file may be
// one of them, or their folder is none.
std::string pages_problem(const std::string& index, const std::vector<OutputFormat>& planned,
                          const std::vector<std::string>& inputs) {
  const fs::path folder = rooms_folder(index);
  std::error_code ignored;
  if (fs::is_symlink(folder, ignored)) {
    return fmt::format(
        "'{}' is a link, but the pages of '{}' need their own folder, in which old pages "
        "are removed; delete the link",
        folder.string(), index);
  }
  for (const std::string& input : inputs) {
    if (is_page_of(folder, input))
      return fmt::format("'{}' is an input and could be overwritten by a page of '{}'", input,
                         index);
  }
  for (const OutputFormat& other : planned) {
    if (is_page_of(folder, other.file))
      return fmt::format("'{}' would be written twice: '{}' has a page of this name", other.file,
                         index);
  }
  return writability((folder / "p1s1.html").string());
}

}  // namespace

std::string path_identity(const std::string& file) { return calc::real_path(file).string(); }

std::vector<std::string> written_rooms(const OutputOptions& options) {
  std::vector<std::string> places;
  if (!options.folder.empty()) places.push_back(options.folder);
  for (const OutputFormat& planned : planned_files(options)) {
    places.push_back(is_pipe_or_device(planned.file) ? planned.file : folder_of_file(planned.file));
    if (planned.format->is_html && options.html_split) {
      places.push_back(folder_of_file((rooms_folder(planned.file) / "p1s1.html").string()));
    }
  }
  return places;
}

void open_spill_files(OutputOptions& options) {
  constexpr std::size_t kEnough = 16;  // a format needs a few
  options.spill_files = std::make_shared<report::SpillFiles>(temporary_folder(), kEnough);
}

std::string check_outputs(const OutputOptions& options, const std::vector<std::string>& read) {
  std::set<std::string> inputs, seen;
  for (const std::string& file : read) inputs.insert(path_identity(file));
  const std::vector<OutputFormat> planned = planned_files(options);
  for (const OutputFormat& format : planned) {
    const std::string name = path_identity(format.file);
    if (inputs.contains(name)) {
      return fmt::format("'{}' is an input and would be overwritten", format.file);
    }
    if (!seen.insert(name).second) {
      return fmt::format("'{}' would be written twice", format.file);
    }
    std::string problem = writability(format.file);
    if (problem.empty() && format.format->is_html && options.html_split)
      problem = pages_problem(format.file, planned, read);
    if (!problem.empty()) return problem;
  }
  return "";
}

namespace {

// For what has no folder of its own: standard output, pipes.
report::SpillPlace spill_place(const OutputOptions& options) {
  report::SpillPlace place;
  if (!options.spill_files) place.folder = temporary_folder();
  place.files = options.spill_files;
  // Where there is none, memory must do.
  return place.folder.empty() && !place.files ? report::SpillPlace::memory() : place;
}

report::SpillPlace spill_place(const OutputOptions& options, const std::string& file) {
  if (is_pipe_or_device(file)) return spill_place(options);
  report::SpillPlace place;
  place.folder = folder_of_file(file);
  return place;
}

// What tells one version of a regular file from the next.
struct FileState {
  bool is_there = false;
  std::uint64_t device = 0, number = 0;
  std::int64_t changed_s = 0, changed_ns = 0;

  bool operator==(const FileState&) const = default;
};

FileState state_of(const std::string& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return {};
  return {true, status.st_dev, status.st_ino, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

// One format on its way into its file. What goes wrong is kept until the end.
class OutputFile {
 public:
  OutputFile(const OutputFormat& planned, const OutputOptions& options,
             const report::DocumentFrame& frame)
      : file_(planned.file), before_(state_of(planned.file)), most_bytes_(options.most_bytes) {
    const report::Texts t = report_texts(options);
    report::TextOptions text;
    text.lists_passes = options.lists_passes;
    text.shows_notes = options.shows_notes;
    report::SpillPlace place = spill_place(options, file_);
    place.most_bytes = most_bytes_;
    if (planned.format->is_html && options.html_split) {
      pages_.emplace(file_, frame.provenance, t, options.page);
      writer_ = report::html_writer(frame, place, t, pages_->address(), options.page);
    } else {
      writer_ =
          planned.format->writer(frame, place, {text, t, options.page, options.printer.get()});
    }
  }

  void add(const report::ProjectPart& project, GuardedFiles& files) {
    if (pages_) pages_->add(project, files, problems_);
    if (!writer_) return;
    try {
      writer_->add(project);
    } catch (const std::exception& error) {
      failure_ = cannot_write(file_, error.what());
      writer_.reset();  // others may need the room on the disk
    }
  }

  // The file waits then for the others. The index links to the pages, and so comes after them.
  void finish(const report::DocumentEnd& end, GuardedFiles& files) {
    const auto make = [&](report::Sink& sink) {
      report::LimitedSink limited(sink, most_bytes_);
      writer_->finish(end, limited);
    };
    if (writer_) failure_ = files.add(file_, make);
    writer_.reset();
    add_problem(std::move(failure_), problems_);
  }
  // Somebody else has written it since this run began: two runs have one place for their results.
  bool is_contended() const { return !(state_of(file_) == before_); }
  const std::string& file() const { return file_; }
  // After all files have taken their places.
  std::vector<std::string> problems(const GuardedFiles& files) {
    if (pages_) {
      for (std::string& problem : pages_->remove_stale(files)) {
        add_problem(std::move(problem), problems_);
      }
    }
    return std::move(problems_);
  }

 private:
  std::string file_;
  FileState before_;
  double most_bytes_;
  std::optional<RoomPages> pages_;
  std::unique_ptr<report::FormatWriter> writer_;  // null after a failure
  std::string failure_;
  std::vector<std::string> problems_;
};

// What cannot be written any more is an empty reason.
class StandardOutput : public report::Sink {
 public:
  void write(std::string_view bytes) override {
    if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size())
      throw report::WriteFailure("");
  }
  static void finish() {
    if (std::fflush(stdout) != 0) throw report::WriteFailure("");
  }
};

}  // namespace

// So that what is in it can stand in the unnamed namespace.
class OutputFiles {
 public:
  virtual ~OutputFiles() = default;
  virtual void add(const report::ProjectPart& project, const std::set<std::string>& inputs) = 0;
  // Messages, one for each file that could not be written.
  virtual std::vector<std::string> finish(const report::DocumentEnd& end,
                                          const std::set<std::string>& inputs) = 0;
  // Files.
  virtual std::vector<std::string> written() const = 0;
};

namespace {

class PlannedFiles final : public OutputFiles {
 public:
  PlannedFiles(const OutputOptions& options, const report::DocumentFrame& frame)
      : writes_early_(options.images || options.html_split), files_(options.most_bytes) {
    for (const OutputFormat& planned : planned_files(options)) {
      outputs_.emplace_back(planned, options, frame);
    }
    if (options.images)
      images_.emplace(options.folder, frame.provenance, report_texts(options), options.page);
  }

  void add(const report::ProjectPart& project, const std::set<std::string>& inputs) override {
    if (writes_early_) files_.add_inputs(inputs);
    for (OutputFile& output : outputs_) output.add(project, files_);
    if (images_) images_->add(project, files_);
  }

  std::vector<std::string> finish(const report::DocumentEnd& end,
                                  const std::set<std::string>& inputs) override {
    files_.add_inputs(inputs);
    for (OutputFile& output : outputs_) output.finish(end, files_);
    warn_of_others();
    std::vector<std::string> problems = files_.publish();
    for (OutputFile& output : outputs_) {
      for (std::string& problem : output.problems(files_)) problems.push_back(std::move(problem));
    }
    if (images_) {
      problems.insert(problems.end(), images_->problems().begin(), images_->problems().end());
    }
    problems.insert(problems.end(), files_.problems().begin(), files_.problems().end());
    return problems;
  }
  std::vector<std::string> written() const override { return files_.written(); }

 private:
  void warn_of_others() const {
    calc::Diagnostics diagnostics;
    for (const OutputFile& output : outputs_) {
      if (!output.is_contended()) continue;
      diagnostics.report(calc::DiagnosticId::output_written_meanwhile, {output.file(), 0, 0});
    }
    print_diagnostics(diagnostics.all(), false);
  }

  bool writes_early_;  // images or pages
  GuardedFiles files_;
  std::deque<OutputFile> outputs_;
  std::optional<Images> images_;
};

}  // namespace

void print_messages(const report::ProjectPart& project, const OutputOptions& options,
                    const Environment& environment) {
  const bool is_text = stdout_format(options) == &report::formats().front();
  const bool folds = environment.stderr_is_terminal && is_text && !options.quiet &&
                     !options.shows_notes && !options.lists_passes && report::has_overview(project);
  if (!folds) return print_diagnostics(project.diagnostics, options.quiet);
  for (const std::string& line : report::folded_warnings(project, environment.stderr_columns)) {
    tell("{}\n", line);
  }
}

ResultFiles::ResultFiles(const OutputOptions& options, const Environment& environment,
                         report::DocumentFrame frame)
    : frame_(std::move(frame)),
      most_bytes_(options.most_bytes),
      is_quiet_(options.quiet),
      files_(std::make_unique<PlannedFiles>(options, frame_)) {
  const report::Format* format = stdout_format(options);
  if (format == nullptr) return;
  const report::TextOptions terminal{use_color(options.color, environment),
                                     environment.stdout_columns, options.lists_passes,
                                     options.shows_notes, !options.are_messages_printed};
  report::SpillPlace place = spill_place(options);
  place.most_bytes = most_bytes_;
  for_stdout_ = format->writer(
      frame_, place, {terminal, report_texts(options), options.page, options.printer.get()});
}

ResultFiles::~ResultFiles() = default;

void ResultFiles::add(const report::ProjectPart& project, const std::set<std::string>& inputs) {
  files_->add(project, inputs);
  if (!for_stdout_ || !stdout_failure_.empty()) return;
  try {
    for_stdout_->add(project);
  } catch (const std::exception& error) {
    stdout_failure_ = error.what();
  }
}

bool ResultFiles::finish(const report::DocumentEnd& end, const std::set<std::string>& inputs) {
  const std::vector<std::string> problems = files_->finish(end, inputs);
  for (const std::string& problem : problems) {
    print_error(calc::DiagnosticId::output_not_possible, problem);
  }
  const bool is_printed = !for_stdout_ || print(end);
  if (!is_quiet_) tell_written(files_->written());
  return problems.empty() && is_printed;
}

bool ResultFiles::print(const report::DocumentEnd& end) {
  std::string problem = "cannot write to standard output";
  try {
    if (!stdout_failure_.empty()) throw report::WriteFailure(stdout_failure_);
    StandardOutput output;
    report::LimitedSink limited(output, most_bytes_);
    for_stdout_->finish(end, limited);
    StandardOutput::finish();
    return true;
  } catch (const std::exception& error) {
    if (*error.what() != '\0') problem += fmt::format(": {}", error.what());
  }
  print_error(calc::DiagnosticId::output_not_possible, problem);
  return false;
}

bool write_results(const OutputOptions& options, const Environment& environment,
                   const report::Document& document, const std::set<std::string>& inputs) {
  ResultFiles results(options, environment, report::frame_of(document));
  bool is_first = true;
  for (const report::ProjectPart& project : document.projects) {
    results.add(project, is_first ? inputs : std::set<std::string>());
    is_first = false;
  }
  return results.finish(report::end_of(document), inputs);
}

std::string safe_name(const std::string& wanted) {
  std::string safe;
  for (const char c : wanted) {
    const bool is_kept = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                         (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
    const bool is_continuation = (static_cast<unsigned char>(c) & 0xC0u) == 0x80u;  // of UTF-8
    if (is_continuation) continue;
    safe += is_kept ? c : '_';
  }
  return safe;
}

std::string image_stem(const report::ProjectPart& project, const report::PlanePart& plane) {
  return safe_name(fs::path(project.path).stem().string() + "-" + plane.id);
}

}  // namespace cli
