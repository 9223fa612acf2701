// What tests/validation keeps beside the program's own report: cases whose tables are not part of
// the program, and how the error grows towards the ends of what can be asked for.
//   validation_report open FOLDER     open-cases.md and open-cases.html, from the tables in
//                                     $LUXGATE_SHARED_DATA/validation
//   validation_report sweeps FOLDER   sweeps.md, sweeps.csv and sweeps.html; takes minutes
// FOLDER is made if needed. Exit code 0: written; 2: not. Whether open cases are right is said in
// the text alone: some ask for what luxgate is not.

#include "calc/base/file_reader.h"
#include "report/formats/write.h"
#include "tests/validation/open_cases.h"
#include "tests/validation/sweep.h"

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

struct ReportFile {
  std::string name, text;
};

int fail(const std::string& why) {
  std::fprintf(stderr, "%s\n", why.c_str());
  return 2;
}

void announce(const std::string& what) { std::fprintf(stderr, "%s\n", what.c_str()); }

int write(const std::string& folder, const std::vector<ReportFile>& files) {
  for (const ReportFile& file : files) {
    const std::string path = folder + "/" + file.name;
    const std::string problem = report::write_file_atomically(path, file.text);
    if (!problem.empty()) return fail("cannot write '" + path + "': " + problem);
  }
  return 0;
}

int write_open_cases(const std::string& folder) {
  const char* data = std::getenv("LUXGATE_SHARED_DATA");
  if (data == nullptr || *data == '\0') return fail("LUXGATE_SHARED_DATA is not set");
  const validation::OpenCases open = validation::run_open_cases(
      std::string(data) + "/validation", calc::DiskFileReader(), {}, announce);
  if (!open.problem.empty()) return fail(open.problem);
  return write(folder, {{"open-cases.md", validation::render_open_markdown(open)},
                        {"open-cases.html", validation::render_open_html(open)}});
}

int write_sweeps(const std::string& folder) {
  const std::vector<validation::Sweep> sweeps = validation::run_sweeps({}, announce);
  return write(folder, {{"sweeps.md", validation::render_sweeps_markdown(sweeps)},
                        {"sweeps.csv", validation::render_sweeps_csv(sweeps)},
                        {"sweeps.html", validation::render_sweeps_html(sweeps)}});
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view what = argc == 3 ? argv[1] : "";
  if (what == "open") return write_open_cases(argv[2]);
  if (what == "sweeps") return write_sweeps(argv[2]);
  return fail("validation_report open|sweeps FOLDER");
}
