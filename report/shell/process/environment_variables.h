#pragma once
// The environment variables that the program reads, in one table: for help, manual pages and the
// readers. Reading a name that is not in the table does not compile.

#include <algorithm>
#include <array>
#include <string_view>

namespace cli {

struct EnvironmentVariable {
  std::string_view name, meaning;
  // The commands that it affects: those with one of these options, and these commands ("rules diff"
  // is an action). Lists with commas.
  std::string_view options, commands = {};
};

inline constexpr auto kEnvironmentVariables = std::to_array<EnvironmentVariable>({
    {"SOURCE_DATE_EPOCH",
     "Seconds since 1970: the date of reports, and the day for which waivers are checked, "
     "unless --timestamp gives one",
     "--timestamp", "plan,validate,rules diff"},
    {"LUXGATE_STORE", "Folder of the result cache, unless --store names one", "--store"},
    {"NO_COLOR", "Not empty: --color auto prints no colours", "--color"},
    {"CLICOLOR_FORCE",
     "Not empty and not 0: --color auto prints colours, also where standard output is not a "
     "terminal. NO_COLOR comes first",
     "--color"},
    {"TERM", "dumb: --color auto prints no colours", "--color"},
    {"LUXGATE_CHROMIUM",
     "Chromium or Chrome, which prints PDF files: its path, or its name in PATH; default the first "
     "of the usual names that is in PATH",
     "--paper"},
    {"PATH", "Folders in which Chromium is searched", "--paper"},
    {"TMPDIR",
     "Folder of temporary files: of reports longer than memory that go to standard output, and of "
     "pages that are printed; default /tmp",
     "--paper"},
    {"GIT_DIR", "The git repository of --against, as for git", "--against"},
    {"GIT_WORK_TREE", "Its work tree, as for git", "--against"},
    {"GIT_INDEX_FILE", "What is staged for the next commit, as git tells hooks", "--against"},
    {"LUXGATE_PROGRAM_CACHE",
     "Folder in which compiled OpenGL programs are kept; 'off': none. Default luxgate/programs in "
     "XDG_CACHE_HOME, else in ~/.cache",
     "", "check,watch,sweep,submit,converge,vpl"},
    {"XDG_CACHE_HOME", "See LUXGATE_PROGRAM_CACHE", "", "check,watch,sweep,submit,converge,vpl"},
    {"HOME",
     "See LUXGATE_PROGRAM_CACHE; --sandbox lets the drivers read .drirc there, and --against the "
     "settings of git",
     "--sandbox", "check,watch,sweep,submit,converge,vpl"},
    {"LD_LIBRARY_PATH",
     "Folders that --sandbox lets the system's libraries read, and in which drivers of OpenGL are "
     "looked for where it finds no GPU",
     "--sandbox,--gl-device", "devices"},
    {"LIBGL_DRIVERS_PATH", "The same, of drivers of OpenGL", "--sandbox"},
    {"GBM_BACKENDS_PATH", "The same, of drivers of OpenGL", "--sandbox"},
    {"__EGL_VENDOR_LIBRARY_DIRS",
     "The same, of drivers of OpenGL; where that finds no GPU it is said if this is why",
     "--sandbox,--gl-device", "devices"},
    {"__EGL_VENDOR_LIBRARY_FILENAMES", "As __EGL_VENDOR_LIBRARY_DIRS", "--sandbox,--gl-device",
     "devices"},
    {"DRIRC_CONFIGDIR", "The same, of drivers of OpenGL", "--sandbox"},
    {"TZ", "The same, of the time zone", "--sandbox"},
    {"TZDIR", "The same, of the time zone", "--sandbox"},
    {"NVIDIA_DRIVER_CAPABILITIES",
     "Where OpenGL finds no GPU: whether the container was given the driver's OpenGL",
     "--gl-device", "devices"},
    {"NVIDIA_VISIBLE_DEVICES", "The same: whether it was given a slice of a GPU (MIG)",
     "--gl-device", "devices"},
    {"container", "Not empty: the program runs in a container, for the same words", "--gl-device",
     "devices"},
    {"KUBERNETES_SERVICE_HOST", "As container", "--gl-device", "devices"},
    {"LUXGATE_ISA",
     "For tests: which of the processor's vectors are used, a name that 'luxgate version --json' "
     "lists",
     "--jobs", "version"},
    {"LUXGATE_GL_FAULT", "For tests: how OpenGL fails", "--gl-device", "devices"},
});

constexpr bool is_environment_variable(std::string_view name) {
  return std::any_of(kEnvironmentVariables.begin(), kEnvironmentVariables.end(),
                     [name](const EnvironmentVariable& known) { return known.name == name; });
}

// The name of a variable in the table; other names do not compile.
class VariableName {
 public:
  consteval VariableName(const char* name) : name_(name) {
    if (!is_environment_variable(name)) throw "not in kEnvironmentVariables";
  }
  constexpr const char* text() const { return name_; }

 private:
  const char* name_;
};

}  // namespace cli
