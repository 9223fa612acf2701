// Reading photometry files: files a minute on one core, and memory for a large one.
#include "calc/base/diagnostics.h"
#include "calc/base/file_reader.h"
#include "calc/photometry/read/photometry_file.h"
#include "tests/bench/experiments.h"
#include "tests/bench/memory.h"
#include "tests/bench/photometry.h"
#include "tests/bench/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace bench {
namespace {

namespace fs = std::filesystem;

constexpr double kGoalFilesPerMinute = 10'000.0;

// A folder of its own, removed in the end.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "luxgate-bench-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string write(const std::string& name, const std::string& text) const {
    const fs::path path = path_ / name;
    std::ofstream(path, std::ios::binary) << text;
    return path.string();
  }

 private:
  fs::path path_;
};

// Without any symmetry, so that every value of the file counts; `planes` = 1 is axial.
WebTable table_of(int planes, int gammas) {
  WebTable table{fmt::format("{} x {}", planes, gammas), {}, {}, {}};
  for (int g = 0; g < gammas; ++g) table.gamma_deg.push_back(180.0 * g / (gammas - 1));
  for (int c = 0; c < planes; ++c) {
    table.c_deg.push_back(planes == 1 ? 0.0 : 360.0 * c / (planes - 1));
    for (int g = 0; g < gammas; ++g) {
      const int turn = c == planes - 1 ? 0 : c;
      table.cd.push_back(1234.567 * (1.1 + std::cos(0.0174 * g) + 0.1 * std::sin(0.1 * turn)));
    }
  }
  return table;
}

double read_once(const std::string& path) {
  const calc::FileContent content = calc::DiskFileReader().read(path);
  calc::Diagnostics diagnostics;
  const auto web = calc::parse_photometry(content.bytes, path, diagnostics);
  if (!web) throw std::runtime_error("a file of the benchmark was refused: " + path);
  return web->flux_lm();
}

// Processor seconds per file, which other work on the machine does not change much: the best of
// some rounds of at least `least_s` each.
double seconds_per_file(const std::string& path, int rounds, double least_s) {
  double best_s = 1.0e30;
  for (int round = 0; round < rounds; ++round) {
    const std::clock_t start = std::clock();
    double elapsed_s = 0.0;
    int files = 0;
    for (; elapsed_s < least_s || files == 0; ++files) {
      read_once(path);
      elapsed_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    }
    best_s = std::min(best_s, std::max(1.0e-9, elapsed_s / files));
  }
  return best_s;
}

struct Size {
  const char* name;
  int planes, gammas;
};

}  // namespace

void run_files(const Options& options) {
  const bool is_smoke = options.most_size > 0;
  const Folder folder;
  Table table("reading LM-63 files from disk; processor time",
              {"planes x angles", "KiB", "ms", "files/min", "of the goal", "MB/s"});
  for (const Size& size : {Size{"axial", 1, 37}, Size{"small", 5, 19}, Size{"usual", 25, 37},
                           Size{"fine", 73, 91}, Size{"1 degree", 361, 181}}) {
    const std::string text = ies_text(table_of(size.planes, size.gammas));
    const std::string path = folder.write(fmt::format("{}.ies", size.planes), text);
    const double file_s =
        seconds_per_file(path, is_smoke ? 1 : options.repeats, is_smoke ? 0.0 : 0.3);
    const auto bytes = static_cast<double>(text.size());
    table.add({fmt::format("{} {} x {}", size.name, size.planes, size.gammas),
               fmt::format("{:.1f}", bytes / 1024.0), fmt::format("{:.3f}", 1000.0 * file_s),
               count(60.0 / file_s), fmt::format("{:.1f}", 60.0 / file_s / kGoalFilesPerMinute),
               fmt::format("{:.1f}", bytes / file_s / 1.0e6)});
    if (is_smoke) break;
  }
  table.print();
  if (is_smoke) return;

  const std::string large = folder.write("large.ies", ies_text(table_of(361, 361)));
  const double mib = static_cast<double>(fs::file_size(large)) / (1024.0 * 1024.0);
  reset_peak_memory();
  const double before = used_memory_mib();
  read_once(large);
  const double peak = peak_memory_mib() - before;
  fmt::print("  a file of {:.2f} MiB takes {:.1f} MiB more at its peak, {:.1f} times its size\n",
             mib, peak, peak / mib);
}

}  // namespace bench
