#include "report/shell/command/config_file.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/file_kind.h"
#include "calc/base/file_reader.h"
#include "calc/base/text.h"
#include "report/git/git_tree_reader.h"
#include "report/shell/command/option_values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sys/stat.h>
#include <toml++/toml.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <system_error>
#include <utility>
#include <variant>

namespace cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = 1 << 16;  // the parser recurses, a part of a dotted key a level

struct SettingRow {
  std::string_view name;
  bool is_path = false;  // relative to the file's folder, and within it
};
constexpr std::array kSettings = {
    SettingRow{"rules", true}, SettingRow{"goal"},         SettingRow{"tolerance"},
    SettingRow{"confidence"},  SettingRow{"seed"},         SettingRow{"replicates"},
    SettingRow{"max-paths"},   SettingRow{"by-luminaire"}, SettingRow{"strict"},
    SettingRow{"language"},    SettingRow{"decimal"},      SettingRow{"paper"},
    SettingRow{"detail"},      SettingRow{"annex"},        SettingRow{"cover"},
    SettingRow{"scale"},       SettingRow{"palette"},      SettingRow{"dxf-scale"},
    SettingRow{"dxf-unit"},    SettingRow{"passes"},       SettingRow{"notes"},
    SettingRow{"pictures"},    SettingRow{"datasheets"},   SettingRow{"advice"}};

const SettingRow* find_row(std::string_view name) {
  const auto* row = std::find_if(kSettings.begin(), kSettings.end(),
                                 [&](const SettingRow& one) { return one.name == name; });
  return row == kSettings.end() ? nullptr : row;
}

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

// The closest file in this folder or above it, as a path without links; "" = none.
std::string closest_config(const ConfigPlaces& places, const fs::path& folder) {
  std::error_code failure;
  fs::path at = places.has_links_of_disk ? fs::weakly_canonical(folder, failure)
                                         : fs::absolute(folder, failure).lexically_normal();
  if (failure) return "";
  if (!at.has_filename()) at = at.parent_path();  // "designs/"
  while (true) {
    if (places.has((at / kConfigName).string())) return (at / kConfigName).string();
    if (is_there(at / ".git") || at == at.root_path() || at == at.parent_path()) return "";
    at = at.parent_path();
  }
}

std::string folder_of(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

// As in /tmp: nobody has asked for such a file.
bool is_of_a_stranger(const std::string& path) {
  struct stat file {
  }, folder{};
  if (lstat(path.c_str(), &file) != 0) return false;
  if (stat(folder_of(path).c_str(), &folder) != 0) return false;
  return file.st_uid != 0 && file.st_uid != geteuid() && (folder.st_mode & S_IWOTH) != 0;
}

// From the current folder. Links stay as they are: where they lead is looked at when it is read.
std::string shown(const std::string& path) {
  std::error_code failure;
  const fs::path here = fs::current_path(failure);
  return failure ? path : fs::path(path).lexically_proximate(here).string();
}

// A scalar as it would stand on a command line; empty: it is none.
std::optional<std::string> scalar_text(const toml::node& node) {
  if (const auto* text = node.as_string()) return text->get();
  if (const auto* number = node.as_integer()) return fmt::format("{}", number->get());
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  return std::nullopt;
}

class ConfigReader {
 public:
  ConfigReader(std::string path, calc::Diagnostics& diagnostics)
      : path_(std::move(path)), diagnostics_(diagnostics) {}

  std::vector<ConfigSetting> read(const toml::table& table) {
    std::vector<ConfigSetting> settings;
    for (const auto& [key, node] : table) {
      const calc::SourceLocation where = place_of(key.source());
      const std::string name(key.str());
      const SettingRow* row = find_row(name);
      if (row == nullptr) {
        diagnostics_.report(calc::DiagnosticId::config_unknown, where, name,
                            fmt::format("{}{}", fmt::join(setting_names(), ", "),
                                        calc::suggestion(name, setting_names())));
        continue;
      }
      ConfigSetting setting{name, {}, false, {}, where};
      if (read_value(node, *row, setting)) settings.push_back(std::move(setting));
    }
    std::sort(settings.begin(), settings.end(), [](const auto& a, const auto& b) {
      return std::pair(a.where.line, a.where.column) < std::pair(b.where.line, b.where.column);
    });
    return settings;
  }

 private:
  calc::SourceLocation place_of(const toml::source_region& source) const {
    return {path_, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
  }

  bool refuse(const ConfigSetting& setting, const std::string& problem) {
    diagnostics_.report(calc::DiagnosticId::config_value, setting.where, setting.name, problem);
    return false;
  }

  bool read_value(const toml::node& node, const SettingRow& row, ConfigSetting& setting) {
    if (const auto* flag = node.as_boolean()) {
      setting.flag = flag->get();
      return true;
    }
    if (const auto* list = node.as_array()) {
      setting.is_list = true;
      for (const toml::node& item : *list) {
        if (!add_value(item, row, setting)) return false;
      }
      return true;
    }
    return add_value(node, row, setting);
  }

  bool add_value(const toml::node& node, const SettingRow& row, ConfigSetting& setting) {
    std::optional<std::string> text = scalar_text(node);
    if (!text) return refuse(setting, "a text, a number, true, false or a list of texts is needed");
    if (text->find('\0') != text->npos) return refuse(setting, "it has a byte 0 in it");
    if (row.is_path) {
      const std::string problem = resolve(*text);
      if (!problem.empty()) return refuse(setting, fmt::format("'{}': {}", *text, problem));
    }
    setting.values.push_back(std::move(*text));
    return true;
  }

  // Whoever writes the file must not have the program read what it could not see itself.
  std::string resolve(std::string& path) const {
    const fs::path folder = folder_of(path_);
    std::error_code failure;
    const fs::path top = fs::weakly_canonical(folder, failure);
    if (failure) return failure.message();
    const fs::path whole = fs::weakly_canonical(folder / path, failure);
    if (failure) return failure.message();
    const fs::path within = whole.lexically_relative(top);
    if (fs::is_directory(whole, failure)) return "files are allowed, folders are not";
    if (fs::path(path).is_absolute() || within.empty() || *within.begin() == "..") {
      return fmt::format("only files of the folder of {}, and below it, are allowed", kConfigName);
    }
    path = (folder / path).lexically_normal().string();
    return "";
  }

  std::string path_;
  calc::Diagnostics& diagnostics_;
};

// "" or what is wrong.
std::string apply(const ConfigSetting& setting, const Option& option) {
  constexpr const char* kNeedsFlag = "true or false is needed";
  if (bool* const* flag = std::get_if<bool*>(&option.target)) {
    if (!setting.flag) return kNeedsFlag;
    **flag = *setting.flag;
    return "";
  }
  const auto& parser = std::get<ValueParser>(option.target);
  const bool is_flag = option.value_name.empty();
  if (setting.flag) {
    if (!is_flag) return fmt::format("a value is needed ({})", option.value_name);
    return *setting.flag ? parser("") : "";
  }
  if (is_flag) {
    return option.may_have_value ? parser(fmt::format("{}", fmt::join(setting.values, ",")))
                                 : kNeedsFlag;
  }
  if (setting.is_list && !option.repeats) return "it has one value, no list";
  for (const std::string& value : setting.values) {
    const std::string problem = parser(value);
    if (!problem.empty()) return fmt::format("'{}': {}", value, problem);
  }
  return "";
}

}  // namespace

std::vector<std::string_view> setting_names() {
  std::vector<std::string_view> names;
  for (const SettingRow& row : kSettings) names.push_back(row.name);
  return names;
}

std::vector<Option> config_options(ConfigChoice& choice) {
  return {{"--config", "FILE",
           fmt::format("Read settings from this file instead of the closest {}. It is searched for "
                       "in the folder of the projects and above, up to the top of a git "
                       "repository. Options of the command line come first. With --against the "
                       "file of that revision is read, with --policy none",
                       kConfigName),
           some_text(choice.file)},
          {"--no-config", "", "Read no settings file", &choice.is_off, false, {"--config"}}};
}

std::string ConfigSetting::words() const {
  if (flag) return *flag ? "true" : "false";
  const std::string list = fmt::format("{}", fmt::join(values, ", "));
  return is_list ? "[" + list + "]" : list;
}

ConfigPlaces config_on_disk() {
  // Whatever is called so: what is no file is an error when it is read.
  return {[](const std::string& path) {
            std::error_code ignored;
            return fs::exists(fs::symlink_status(path, ignored));
          },
          [](const std::string& path) {
            if (is_of_a_stranger(path)) {
              return calc::FileContent{{},
                                       "it belongs to another user and lies in a folder that "
                                       "everybody may write into; name it by --config, or give "
                                       "--no-config"};
            }
            return calc::DiskFileReader().read_within(folder_of(path), path);
          }};
}

ConfigPlaces config_in_revision(const std::string& revision, const Environment& environment,
                                const std::vector<std::string>& projects, std::string& problem) {
  using Reader = std::shared_ptr<git::GitTreeReader>;
  const git::GitPlaces repository{environment.git_dir, environment.git_work_tree};
  const auto known = std::make_shared<std::map<std::string, Reader>>();  // by folder
  // Each in the repository in which it lies: of a submodule, that.
  const auto reader_of = [=](const std::string& path, std::string& why) {
    const auto [at, is_new] = known->try_emplace(folder_of(path));
    if (is_new) at->second = git::GitTreeReader::open(path, revision, repository, why);
    return at->second;
  };
  if (reader_of(projects.empty() ? "./-" : projects.front(), problem) == nullptr) return {};
  return {[reader_of](const std::string& path) {
            std::string ignored;
            const Reader files = reader_of(path, ignored);
            return files != nullptr && files->path_in_repository(path).has_value() &&
                   files->has_file(path);
          },
          [reader_of](const std::string& path) {
            std::string why;
            const Reader files = reader_of(path, why);
            return files == nullptr ? calc::FileContent{{}, why}
                                    : files->read_within(folder_of(path), path);
          },
          false};
}

std::string find_config(const ConfigPlaces& places, const std::vector<std::string>& projects,
                        std::string& problem) {
  std::set<fs::path> folders;
  for (const std::string& project : projects) folders.insert(fs::path(project).parent_path());
  if (folders.empty()) folders.insert(fs::path());
  std::set<std::string> found;
  for (const fs::path& folder : folders) {
    found.insert(closest_config(places, folder.empty() ? "." : folder));
  }
  if (found.size() > 1) {
    std::vector<std::string> names;
    for (const std::string& path : found) {
      names.push_back(path.empty() ? "none" : "'" + shown(path) + "'");
    }
    problem = fmt::format(
        "these projects have different settings ({}): give --config FILE or --no-config",
        calc::list_names(names, 4));
    return "";
  }
  return found.begin()->empty() ? "" : shown(*found.begin());
}

std::string find_config(const ConfigChoice& choice, const ConfigPlaces& places,
                        const std::vector<std::string>& projects, std::string& problem) {
  if (choice.is_off) return "";
  if (choice.file.empty()) return find_config(places, projects, problem);
  if (!is_file(choice.file)) problem = fmt::format("--config: '{}' is no file", choice.file);
  return choice.file;
}

std::optional<ConfigFile> read_config(const std::string& path, bool is_named,
                                      const ConfigPlaces& places, calc::Diagnostics& diagnostics) {
  const std::size_t errors = diagnostics.error_count();
  const calc::FileContent content =
      is_named ? calc::DiskFileReader().read(path) : places.read(path);
  if (!content.ok()) {
    diagnostics.report(calc::DiagnosticId::file_not_readable, {path, 0, 0}, path, content.error);
    return std::nullopt;
  }
  if (content.bytes.size() > kMostBytes) {
    diagnostics.report(calc::DiagnosticId::config_syntax, {path, 0, 0}, "it is larger than 64 KiB");
    return std::nullopt;
  }
  if (!calc::check_file_kind(content.bytes, path, calc::FileUse::settings, diagnostics)) {
    return std::nullopt;
  }
  ConfigFile file{path, {}};
  try {
    file.settings = ConfigReader(path, diagnostics).read(toml::parse(content.bytes, path));
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    diagnostics.report(calc::DiagnosticId::config_syntax,
                       {path, static_cast<int>(at.line), static_cast<int>(at.column)},
                       error.description());
  }
  if (diagnostics.error_count() > errors) return std::nullopt;
  return file;
}

std::vector<SettingChange> changed_settings(const std::optional<ConfigFile>& before,
                                            const std::optional<ConfigFile>& after) {
  const auto words_of = [](const std::optional<ConfigFile>& file, std::string_view name) {
    if (!file) return std::string();
    for (const ConfigSetting& setting : file->settings) {
      if (setting.name == name) return setting.words();
    }
    return std::string();
  };
  std::vector<SettingChange> changes;
  for (const std::string_view name : setting_names()) {
    std::string was = words_of(before, name), is = words_of(after, name);
    if (was != is) changes.push_back({std::string(name), std::move(was), std::move(is)});
  }
  return changes;
}

void apply_config(const ConfigFile& file, const Command& command,
                  const std::function<bool(const Option&)>& is_given,
                  calc::Diagnostics& diagnostics) {
  for (const ConfigSetting& setting : file.settings) {
    for (const Option& option : command.options) {
      if (option.long_name() != "--" + setting.name || is_given(option)) continue;
      const std::string problem = apply(setting, option);
      if (problem.empty()) continue;
      diagnostics.report(calc::DiagnosticId::config_value, setting.where, setting.name, problem);
    }
  }
}

}  // namespace cli
