// Benchmarks of the calculation core: bench_core EXPERIMENT [NAME...] [--option value...]; see
// README.md.
#include "tests/bench/experiments.h"
#include "tests/bench/scenes.h"

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <sstream>
#include <stdexcept>
#include <string>

namespace bench {
namespace {

struct Experiment {
  const char* name;
  void (*run)(const Options&);
  const char* takes;
};

constexpr Experiment kExperiments[] = {
    {"converge", run_converge, "SCENE..."},
    {"accuracy", run_accuracy, "SCENE..."},
    {"ratios", run_ratios, "SCENE..."},
    {"near", run_near, "[12|1000|washers|spots...]"},
    {"openings", run_openings, ""},
    {"stiff", run_stiff, ""},
    {"coverage", run_coverage, "[SEEDS]"},
    {"sparse", run_sparse, "[SEEDS [FAMILY]]"},
    {"verdicts", run_verdicts, "[SCENE [SEEDS]]"},
    {"scaling", run_scaling, "[points|luminaires|triangles|reflectance]"},
    {"files", run_files, ""},
    {"projects", run_projects, "FOLDER"},
    {"smoke", run_smoke, ""},
};

std::uint64_t whole_number(const std::string& name, const std::string& text) {
  std::size_t used = 0;
  std::uint64_t value = 0;
  try {
    value = std::stoull(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  if (used == 0 || used != text.size()) {
    throw std::runtime_error(fmt::format("{}: '{}' is no whole number", name, text));
  }
  return value;
}

void set_option(Options& options, const std::string& name, const std::string& text) {
  const auto number = [&] { return whole_number(name, text); };
  const auto small_number = [&] { return static_cast<int>(number()); };
  if (name == "--reference") {
    options.reference_file = text;
  } else if (name == "--reference-by") {
    if (text != "pool" && text != "paths") {
      throw std::runtime_error("--reference-by: 'pool' or 'paths'");
    }
    options.reference_by = text;
  } else if (name == "--reference-paths") {
    options.reference_paths = number();
  } else if (name == "--reference-replicates") {
    options.reference_replicates = small_number();
  } else if (name == "--min-paths") {
    options.min_paths = number();
  } else if (name == "--max-paths") {
    options.max_paths = number();
  } else if (name == "--replicates") {
    options.replicates = small_number();
  } else if (name == "--seed") {
    options.seed = number();
  } else if (name == "--repeats") {
    options.repeats = small_number();
  } else if (name == "--most-size") {
    options.most_size = small_number();
  } else if (name == "--threads") {
    options.threads.clear();
    std::istringstream list(text);
    for (std::string item; std::getline(list, item, ',');) {
      options.threads.push_back(static_cast<int>(whole_number(name, item)));
    }
    if (options.threads.empty()) throw std::runtime_error("--threads: a list such as 1,2");
  } else {
    throw std::runtime_error(fmt::format("no option '{}'", name));
  }
}

Options read_options(int argc, char** argv) {
  Options options;
  options.experiment = argv[1];
  for (int i = 2; i < argc; ++i) {
    const std::string word = argv[i];
    if (!word.starts_with("--")) {
      options.names.push_back(word);
    } else if (i + 1 < argc) {
      set_option(options, word, argv[++i]);
    } else {
      throw std::runtime_error(fmt::format("'{}' needs a value", word));
    }
  }
  return options;
}

int run(int argc, char** argv) {
  if (argc < 2) {
    for (const Experiment& e : kExperiments)
      fmt::print(stderr, "bench_core {} {}\n", e.name, e.takes);
    fmt::print(stderr, "scenes: {}\n", fmt::join(room_names(), ", "));
    return 2;
  }
  const Options options = read_options(argc, argv);
  for (const Experiment& experiment : kExperiments) {
    if (options.experiment != experiment.name) continue;
    const bool needs_name = std::string(experiment.takes).find_first_of("SF") == 0;
    if (needs_name && options.names.empty()) {
      throw std::runtime_error(fmt::format("{} needs {}", experiment.name, experiment.takes));
    }
    experiment.run(options);
    return 0;
  }
  throw std::runtime_error(fmt::format("no experiment '{}'", options.experiment));
}

}  // namespace

void run_projects(const Options& options) {
  for (const char* name : {"room", "office", "corridor"}) {
    const std::string folder = options.names.front() + "/" + name;
    write_project(find_room(name), folder);
    fmt::print("{}/project.xml\n", folder);
  }
}

}  // namespace bench

int main(int argc, char** argv) {
  try {
    return bench::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_core: %s\n", error.what());
    return 2;
  }
}
