#include "report/shell/outputs.h"

#include "report/formats/write.h"
#include "report/html/heatmap_svg.h"
#include "report/html/html.h"
#include "report/html/html_pages.h"
#include "report/images/exr.h"
#include "report/images/heatmap.h"
#include "report/images/png.h"
#include "report/shell/print.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <functional>
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

// Writes what `make` gives; "" or a message.
std::string write_made(const std::string& path, const std::function<std::string()>& make) {
  try {
    const std::string problem = report::write_file_atomically(path, make());
    return problem.empty() ? "" : fmt::format("cannot write '{}': {}", path, problem);
  } catch (const std::exception& error) {
    return fmt::format("cannot write '{}': {}", path, error.what());
  }
}

// Writes files one by one, but never over an input.
class Writer {
 public:
  explicit Writer(const std::set<std::string>& inputs) {
    for (const std::string& input : inputs) inputs_.insert(path_identity(input));
  }

  void write(const std::string& path, const std::function<std::string()>& make) {
    std::string problem =
        is_input(path) ? fmt::format("'{}' was read as an input and is not overwritten", path)
                       : write_made(path, make);
    if (!problem.empty()) problems_.push_back(std::move(problem));
  }

  bool is_input(const std::string& path) const { return inputs_.contains(path_identity(path)); }
  void add_problem(std::string problem) { problems_.push_back(std::move(problem)); }
  const std::vector<std::string>& problems() const { return problems_; }

 private:
  std::set<std::string> inputs_;
  std::vector<std::string> problems_;
};

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

// Of a room's pictures; names are those of its planes with the picture's in place of the plane's.
void write_pictures(const std::string& folder, const report::ProjectPart& project,
                    const report::SpacePart& space, std::set<std::string>& taken, Writer& writer) {
  for (const report::RoomPicture& picture : space.pictures.list) {
    const std::string wanted =
        safe_name(fs::path(project.path).stem().string() + "-" + space.id + "-" + picture.name);
    std::string stem = wanted;
    for (int i = 2; !taken.insert(stem).second; ++i) stem = fmt::format("{}-{}", wanted, i);
    const std::string path = (fs::path(folder) / stem).string();
    writer.write(path + ".png", [&] { return picture.labelled_png; });
    writer.write(path + ".exr", [&] { return picture.exr; });
  }
}

void write_images(const std::string& folder, const report::Document& document,
                  const report::Texts& t, Writer& writer) {
  std::set<std::string> taken;
  for (const report::ProjectPart& project : document.projects) {
    for (const report::SpacePart& space : project.spaces) {
      for (const report::PlanePart& plane : space.planes) {
        if (!plane.is_computed || !report::has_cells(plane)) continue;
        const std::string wanted = image_stem(project, plane);
        std::string stem = wanted;
        for (int i = 2; !taken.insert(stem).second; ++i) stem = fmt::format("{}-{}", wanted, i);
        const std::string path = (fs::path(folder) / stem).string();
        writer.write(path + ".png", [&] { return report::render_heatmap_png(plane); });
        if (report::has_all_values(plane)) {
          writer.write(path + ".svg", [&] { return report::render_heatmap_svg(t, space, plane); });
        }
        writer.write(path + ".exr",
                     [&] { return report::render_exr(document, project, space, plane); });
      }
      write_pictures(folder, project, space, taken, writer);
    }
  }
}

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
                                            const Writer& writer) {
  std::vector<fs::path> stale;
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const std::string name = entry->path().filename().string();
    std::error_code ignored;
    if (!is_page_name(name) || written.contains(name)) continue;
    if (entry->is_regular_file(ignored) && !writer.is_input(entry->path().string()))
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

// The page of a room names its planes by position: it must not be a file that is there for another
// reason, which the folder of its own sees to. The index comes last, since it links to the others.
void write_html_pages(const std::string& file, const report::Document& document,
                      const report::Texts& t, Writer& writer) {
  const fs::path index = file;
  const fs::path folder = rooms_folder(index);
  const std::string back = "../" + report::url_name(index.filename().string());
  std::set<std::string> written;
  for (const report::HtmlPage& page : report::html_pages(document)) {
    written.insert(page.name);
    writer.write((folder / page.name).string(),
                 [&] { return report::render_html_page(document, page, back, t); });
  }
  const std::string address = report::url_name(folder.filename().string());
  writer.write(file, [&] { return report::render_html_index(document, address, t); });
  for (std::string& problem : remove_stale_pages(folder, written, writer))
    writer.add_problem(std::move(problem));
}

// "" or why the pages beside an index cannot be written: an input or another planned file may be
// one of them, or their folder is none.
std::string pages_problem(const std::string& index, const std::vector<OutputFormat>& planned,
                          const std::vector<std::string>& inputs) {
  const fs::path folder = rooms_folder(index);
  for (const std::string& input : inputs) {
    if (is_page_of(folder, input))
      return fmt::format("'{}' is an input and could be overwritten by a page of '{}'", input,
                         index);
  }
  for (const OutputFormat& other : planned) {
    if (is_page_of(folder, other.file))
      return fmt::format("'{}' would be written twice: '{}' has pages of such names", other.file,
                         index);
  }
  return writability((folder / "p1s1.html").string());
}

}  // namespace

std::string path_identity(const std::string& file) {
  std::error_code ignored;
  const fs::path path = fs::weakly_canonical(fs::absolute(file, ignored), ignored);
  return path.empty() ? fs::path(file).lexically_normal().string() : path.string();
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

std::vector<std::string> write_outputs(const OutputOptions& options,
                                       const report::Document& document,
                                       const std::set<std::string>& inputs) {
  Writer writer(inputs);
  const report::Texts t = report_texts(options);
  report::TextOptions files;
  files.lists_passes = options.lists_passes;
  for (const OutputFormat& format : planned_files(options)) {
    if (format.format->is_html && options.html_split) {
      write_html_pages(format.file, document, t, writer);
    } else {
      writer.write(format.file, [&] { return format.format->render(document, {files, t}); });
    }
  }
  if (options.images) write_images(options.folder, document, t, writer);
  return writer.problems();
}

bool write_results(const OutputOptions& options, const Environment& environment,
                   const report::Document& document, const std::set<std::string>& inputs) {
  bool is_written = true;
  for (const std::string& problem : write_outputs(options, document, inputs)) {
    print_error(calc::DiagnosticId::output_not_possible, problem);
    is_written = false;
  }
  if (const report::Format* format = stdout_format(options)) {
    const report::TextOptions terminal{use_color(options.color, environment),
                                       environment.stdout_columns, options.lists_passes,
                                       !options.are_messages_printed};
    if (!print_result(format->render(document, {terminal, report_texts(options)}))) {
      print_error(calc::DiagnosticId::output_not_possible, "cannot write to standard output");
      is_written = false;
    }
  }
  return is_written;
}

std::string image_stem(const report::ProjectPart& project, const report::PlanePart& plane) {
  return safe_name(fs::path(project.path).stem().string() + "-" + plane.id);
}

}  // namespace cli
