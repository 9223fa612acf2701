#pragma once
// luxgate.toml: settings that a folder of projects shares, so that nobody forgets them on the
// command line. A setting is an option of the same name without dashes, and its value is read as
// the option's. Settings say how projects are judged and shown; output files, selections and waiver
// permissions are only on the command line.

#include "calc/base/diagnostics.h"
#include "calc/base/file_reader.h"
#include "report/shell/command/command.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

inline constexpr const char* kConfigName = "luxgate.toml";

// Returns the names of all settings, in the order in which they are shown.
std::vector<std::string_view> setting_names();

// Returns --config and --no-config.
std::vector<Option> config_options(ConfigChoice& choice);

// A setting as in the file.
struct ConfigSetting {
  std::string name;
  std::vector<std::string> values;  // one unless is_list; of `rules` as paths from here
  bool is_list = false;
  std::optional<bool> flag;  // true or false: then there are no values
  calc::SourceLocation where;

  std::string words() const;  // for people: "0.01", "true", "[a.xml, b.xml]"
};

struct ConfigFile {
  std::string path;
  std::vector<ConfigSetting> settings;  // in the order of the file
};

// Where files without a given path are searched: on the disk, or in a git revision.
struct ConfigPlaces {
  std::function<bool(const std::string& path)> has;
  // Reads a file; links cannot lead outside the file's own folder.
  std::function<calc::FileContent(const std::string& path)> read;
  // Folder names may contain links of the disk; a revision has its own.
  bool has_links_of_disk = true;
};
ConfigPlaces config_on_disk();
// Returns the places in the repository of the first of these projects. `problem` says why there is
// none.
ConfigPlaces config_in_revision(const std::string& revision, const Environment& environment,
                                const std::vector<std::string>& projects, std::string& problem);

// Returns the closest luxgate.toml in the folders of these projects (without projects: in the
// current folder) and those above, up to the top of a git repository. "" if there is none.
// `problem`: projects have several.
std::string find_config(const ConfigPlaces& places, const std::vector<std::string>& projects,
                        std::string& problem);
// Returns the same, or the file that the choice names or excludes.
std::string find_config(const ConfigChoice& choice, const ConfigPlaces& places,
                        const std::vector<std::string>& projects, std::string& problem);

// Returns the settings; empty after an error: not readable, no TOML, unknown settings, tables,
// dates, and paths that lead out of the file's folder. is_named: on the command line; then it is on
// the disk, and may be a link to anywhere.
std::optional<ConfigFile> read_config(const std::string& path, bool is_named,
                                      const ConfigPlaces& places, calc::Diagnostics& diagnostics);

// Returns the settings that differ in the second file, by name; either file may be missing.
std::vector<SettingChange> changed_settings(const std::optional<ConfigFile>& before,
                                            const std::optional<ConfigFile>& after);

// Gives the options of the command their values from the file, except options on the command line
// or unknown to the command. Reports values that an option refuses.
void apply_config(const ConfigFile& file, const Command& command,
                  const std::function<bool(const Option&)>& is_given,
                  calc::Diagnostics& diagnostics);

}  // namespace cli
