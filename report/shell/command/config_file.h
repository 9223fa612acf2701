#pragma once
// luxgate.toml: settings that a folder of projects shares, so that nobody forgets them on the
// command line. A setting is an option of the same name, without its dashes, and is read as that
// option's value is. What may be set is what says how projects are judged and shown; where files
// are written, what is selected and who may waive what stays with who types the command.

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

// Names of all settings, in the order in which they are shown.
std::vector<std::string_view> setting_names();

// --config and --no-config
std::vector<Option> config_options(ConfigChoice& choice);

// As the file has it.
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

// Where files are looked for that nobody names: on the disk, or in a git revision.
struct ConfigPlaces {
  std::function<bool(const std::string& path)> has;
  // Links lead nowhere outside of the file's own folder.
  std::function<calc::FileContent(const std::string& path)> read;
  // Whether links in the names of folders are those of the disk: a revision has its own.
  bool has_links_of_disk = true;
};
ConfigPlaces config_on_disk();
// Of the repository of the first of these projects. `problem` says why there is none.
ConfigPlaces config_in_revision(const std::string& revision, const Environment& environment,
                                const std::vector<std::string>& projects, std::string& problem);

// The closest luxgate.toml in the folders of these projects (of none: in the current one) and those
// above, up to the top of a git repository. "" if there is none. `problem`: projects have several.
std::string find_config(const ConfigPlaces& places, const std::vector<std::string>& projects,
                        std::string& problem);
// The same, or the one that the choice names or rules out.
std::string find_config(const ConfigChoice& choice, const ConfigPlaces& places,
                        const std::vector<std::string>& projects, std::string& problem);

// Empty after an error: not readable, no TOML, settings that there are not, tables, dates, and
// paths that lead out of the file's folder. is_named: on the command line; then it is on the disk,
// and may be a link that leads anywhere.
std::optional<ConfigFile> read_config(const std::string& path, bool is_named,
                                      const ConfigPlaces& places, calc::Diagnostics& diagnostics);

// What the second file says otherwise than the first, by name; either may be missing.
std::vector<SettingChange> changed_settings(const std::optional<ConfigFile>& before,
                                            const std::optional<ConfigFile>& after);

// Gives the options of the command their values from the file, but those that are given on the
// command line, and those that the command does not have. Reports what an option refuses.
void apply_config(const ConfigFile& file, const Command& command,
                  const std::function<bool(const Option&)>& is_given,
                  calc::Diagnostics& diagnostics);

}  // namespace cli
