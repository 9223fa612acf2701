#include "report/shell/options/project_options.h"

#include "calc/base/diagnostics.h"
#include "calc/base/utf8.h"
#include "report/check/load_rules.h"
#include "report/shell/command/config_file.h"
#include "report/shell/command/option_values.h"
#include "report/shell/options/project_folders.h"

#include <fmt/format.h>

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string_view>
#include <system_error>
#include <unordered_set>
#include <utility>

namespace cli {
namespace {

constexpr std::size_t kLargestListBytes = std::size_t{256} << 20;
constexpr std::size_t kLargestProjectBytes = std::size_t{512} << 20;  // as of a file

struct FileCloser {
  void operator()(std::FILE* file) const {
    if (file != stdin) std::fclose(file);
  }
};

// Pipes, too: it is mostly made by another program. "" or why it cannot be read.
std::string read_all(const std::string& path, std::size_t most, std::string& bytes) {
  const std::unique_ptr<std::FILE, FileCloser> file(
      path == kStandardInput ? stdin : std::fopen(path.c_str(), "rb"));
  if (!file) return std::strerror(errno);
  std::array<char, 65536> part{};
  while (const std::size_t got = std::fread(part.data(), 1, part.size(), file.get())) {
    bytes.append(part.data(), got);
    if (bytes.size() > most) return fmt::format("it is larger than {} MiB", most >> 20);
  }
  return std::ferror(file.get()) != 0 ? std::strerror(errno) : "";
}

std::string read_standard_input(ProjectOptions& options) {
  const auto& projects = options.projects;
  if (std::find(projects.begin(), projects.end(), kStandardInput) == projects.end()) return "";
  if (!options.takes_standard_input) {
    return "a project from standard input ('-') can be checked, planned and validated, nothing "
           "else; write ./- for a file of that name";
  }
  if (options.list_file == kStandardInput) {
    return "standard input cannot be a project and the list of --files-from";
  }
  if (options.standard_input) return "";
  std::string bytes;
  std::string problem = read_all(kStandardInput, kLargestProjectBytes, bytes);
  if (!problem.empty()) return fmt::format("cannot read standard input: {}", problem);
  options.standard_input = std::move(bytes);
  struct stat status {};
  std::error_code unknown;  // without /proc
  if (fstat(STDIN_FILENO, &status) == 0 && S_ISREG(status.st_mode)) {
    options.standard_input_file =
        std::filesystem::read_symlink("/proc/self/fd/0", unknown).string();
  }
  return "";
}

std::string add_listed(ProjectOptions& options) {
  const std::string name = options.list_file == kStandardInput
                               ? "standard input"
                               : fmt::format("'{}'", options.list_file);
  std::string bytes;
  std::string problem = read_all(options.list_file, kLargestListBytes, bytes);
  if (!problem.empty()) return fmt::format("--files-from: cannot read {}: {}", name, problem);
  std::vector<std::string> listed = parse_project_list(bytes, problem);
  if (!problem.empty()) return fmt::format("--files-from: {}: {}", name, problem);
  std::move(listed.begin(), listed.end(), std::back_inserter(options.projects));
  return "";
}

}  // namespace

Place projects_place(ProjectOptions& options) {
  return {"projects", "PROJECT.xml",
          options.takes_standard_input
              ? "Project files, folders that are searched for projects, or - for standard input"
              : "Project files, or folders that are searched for projects",
          &options.projects, false};
}

std::vector<Option> project_options(ProjectOptions& options) {
  std::vector<Option> all{
      {"--files-from", "FILE",
       "Read more project paths from a list, one per line; '-' is standard input. Paths may also "
       "end with a zero byte, as 'find -print0' writes them. A list has no limit of length",
       some_text(options.list_file)},
      rules_option(options.rule_files),
      allow_option(options.allowed)};
  add(all, config_options(options.config));
  add(all, {{"-v,--verbose", "",
             "Print settings in force, files that are read and their sizes to standard error",
             &options.is_verbose}});
  return all;
}

std::string complete_projects(ProjectOptions& options) {
  if (!options.list_file.empty()) {
    if (std::string problem = add_listed(options); !problem.empty()) return problem;
  }
  if (std::string problem = read_standard_input(options); !problem.empty()) return problem;
  options.folders.clear();
  for (const std::string& project : options.projects) {
    if (is_folder(project)) options.folders.push_back(project);
  }
  if (std::string problem = expand_folders(options.projects); !problem.empty()) return problem;
  if (options.projects.empty()) return "no project: PROJECT.xml or --files-from is needed";
  std::unordered_set<std::string> known;
  for (const std::string& project : options.projects) {
    if (calc::diagnostic_from_name(project)) {  // "--strict ID" is easily written
      return fmt::format("'{0}' is the id of a message, not a project; write --strict={0}",
                         project);
    }
    if (!known.insert(std::filesystem::path(project).lexically_normal().string()).second) {
      return fmt::format("project '{}' is given twice", project);
    }
  }
  return "";
}

std::vector<std::string> places_of(const ProjectOptions& options) {
  std::vector<std::string> places = options.allowed;
  std::unordered_set<std::string> known;
  std::error_code ignored;
  for (const std::string& project : options.projects) {
    const std::filesystem::path path(project);
    // The command line may name a link, whatever it leads to.
    if (std::filesystem::is_symlink(path, ignored)) places.push_back(project);
    const std::string folder = path.has_parent_path() ? path.parent_path().string() : ".";
    if (known.insert(folder).second) places.push_back(folder);
  }
  places.insert(places.end(), options.rule_files.begin(), options.rule_files.end());
  calc::Diagnostics told_when_they_are_read;
  for (std::string& file : check::rule_files(options.rule_files, told_when_they_are_read)) {
    places.push_back(std::move(file));
  }
  return places;
}

std::string render_project_list(const std::vector<std::string>& projects) {
  const bool has_breaks =
      std::any_of(projects.begin(), projects.end(), [](const std::string& project) {
        return project.find_first_of("\r\n") != std::string::npos;
      });
  std::string text;
  for (const std::string& project : projects) {
    text += project;
    text += has_breaks ? '\0' : '\n';
  }
  return text;
}

std::vector<std::string> parse_project_list(const std::string& bytes, std::string& problem) {
  if (calc::has_utf16_mark(bytes)) {
    problem = "it is UTF-16; UTF-8 is allowed";
    return {};
  }
  std::string_view rest = calc::without_byte_order_mark(bytes);
  const bool has_zeros = rest.find('\0') != std::string_view::npos;
  const char end_of_path = has_zeros ? '\0' : '\n';
  std::vector<std::string> projects;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(end_of_path), rest.size());
    std::string_view path = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (!has_zeros && path.ends_with('\r')) path.remove_suffix(1);
    if (!path.empty()) projects.emplace_back(path);
  }
  if (projects.empty()) problem = "it names no project";
  return projects;
}

}  // namespace cli
