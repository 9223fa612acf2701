#include "report/shell/process/environment.h"

#include "report/shell/process/environment_variables.h"

#include <unistd.h>

#include <sys/ioctl.h>
#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <initializer_list>
#include <string_view>

namespace cli {
namespace {

std::string variable(VariableName name) {
  const char* value = std::getenv(name.text());
  return value == nullptr ? "" : value;
}

std::string program_folder() {
  const std::string own = variable("LUXGATE_PROGRAM_CACHE");
  if (!own.empty()) return own == "off" ? "" : own;
  // Relative paths are not allowed there. [XDG]
  const std::string cache = variable("XDG_CACHE_HOME");
  if (cache.starts_with('/')) return cache + "/luxgate/programs";
  const std::string home = variable("HOME");
  return home.starts_with('/') ? home + "/.cache/luxgate/programs" : "";
}

std::vector<std::string> library_places() {
  std::vector<std::string> places;
  for (const VariableName name : std::initializer_list<VariableName>{
           "LD_LIBRARY_PATH", "LIBGL_DRIVERS_PATH", "GBM_BACKENDS_PATH",
           "__EGL_VENDOR_LIBRARY_DIRS", "__EGL_VENDOR_LIBRARY_FILENAMES", "DRIRC_CONFIGDIR", "TZ",
           "TZDIR"}) {
    const std::string list = variable(name);
    std::string_view rest = list;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find(':'), rest.size());
      if (rest.starts_with('/')) places.emplace_back(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
  const std::string home = variable("HOME");
  if (!home.empty()) places.push_back(home + "/.drirc");
  return places;
}

int columns_of(int descriptor) {
  winsize size{};
  return ioctl(descriptor, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

}  // namespace

Environment read_environment() {
  Environment environment;
  environment.source_date_epoch = variable("SOURCE_DATE_EPOCH");
  environment.no_color = variable("NO_COLOR");
  environment.clicolor_force = variable("CLICOLOR_FORCE");
  environment.term = variable("TERM");
  environment.gl_fault = variable("LUXGATE_GL_FAULT");
  environment.program_folder = program_folder();
  environment.git_dir = variable("GIT_DIR");
  environment.git_work_tree = variable("GIT_WORK_TREE");
  environment.git_index_file = variable("GIT_INDEX_FILE");
  environment.chromium = variable("LUXGATE_CHROMIUM");
  environment.search_path = variable("PATH");
  environment.store = variable("LUXGATE_STORE");
  environment.library_places = library_places();
  environment.stdout_is_terminal = isatty(STDOUT_FILENO) == 1;
  environment.stderr_is_terminal = isatty(STDERR_FILENO) == 1;
  if (environment.stdout_is_terminal) environment.stdout_columns = columns_of(STDOUT_FILENO);
  if (environment.stderr_is_terminal) environment.stderr_columns = columns_of(STDERR_FILENO);
  return environment;
}

bool use_color(ColorChoice choice, const Environment& environment) {
  if (choice != ColorChoice::automatic) return choice == ColorChoice::always;
  if (!environment.no_color.empty()) return false;
  if (!environment.clicolor_force.empty() && environment.clicolor_force != "0") return true;
  return environment.stdout_is_terminal && environment.term != "dumb";
}

}  // namespace cli
