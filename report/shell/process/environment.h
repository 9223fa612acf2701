#pragma once
// The program's inputs from its surroundings, as a value so that tests can choose it.

#include <string>
#include <vector>

namespace cli {

struct Environment {
  std::string source_date_epoch, no_color, clicolor_force, term;  // "" = not set
  std::string gl_fault;  // LUXGATE_GL_FAULT, for tests; see find_gl_fault()
  // The folder of compiled shaders: LUXGATE_PROGRAM_CACHE, or luxgate/programs in XDG_CACHE_HOME or
  // ~/.cache; "" = none, if none of these is set or the first is "off".
  std::string program_folder;
  std::string git_dir, git_work_tree, git_index_file;  // GIT_DIR and so on, see git::GitPlaces
  // For finding the printer: LUXGATE_CHROMIUM and PATH, see find_chromium().
  std::string chromium, search_path;
  std::string store;  // LUXGATE_STORE: the result cache if --store does not name it
  // Files and folders of libraries and drivers besides the system's usual ones, from the variables
  // of the dynamic linker, Mesa and glvnd, and the time zone's.
  std::vector<std::string> library_places;
  bool stdout_is_terminal = false;
  bool stderr_is_terminal = false;
  int stdout_columns = 0;  // width of the terminal at standard output; 0 = none or not known
  int stderr_columns = 0;  // the same of standard error
};
Environment read_environment();

enum class ColorChoice { automatic, always, never };

// Returns whether standard output has colours: by --color, then NO_COLOR (set: off), CLICOLOR_FORCE
// (set and not "0": on), TERM=dumb (off), then whether it is a terminal.
bool use_color(ColorChoice choice, const Environment& environment);

}  // namespace cli
