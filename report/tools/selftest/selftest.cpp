#include "report/tools/selftest/selftest.h"

#include "calc/base/diagnostics.h"
#include "calc/base/file_reader.h"
#include "calc/rays/triangle_tree.h"
#include "report/document/program_version.h"
#include "report/formats/write.h"
#include "report/shell/interrupt.h"
#include "report/tools/selftest/report.h"
#include "report/tools/selftest/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <utility>

namespace cli {
namespace {

using selftest::SelftestCase;

std::vector<SelftestCase> chosen_cases(const SelftestOptions& options) {
  std::vector<SelftestCase> cases = selftest::all_cases();
  if (options.only.empty()) return cases;
  const auto is_wanted = [&](const std::string& name) {
    return std::find(options.only.begin(), options.only.end(), name) != options.only.end();
  };
  cases.erase(std::remove_if(cases.begin(), cases.end(),
                             [&](const SelftestCase& item) {
                               return !is_wanted(item.name) && !is_wanted(item.kind);
                             }),
              cases.end());
  return cases;
}

class Announcer {
 public:
  explicit Announcer(bool is_on) : is_on_(is_on) {}
  // False when interrupted.
  bool operator()(const std::string& what) const {
    if (interrupted()) return false;
    if (is_on_) {
      fmt::print(stderr, "\r\x1b[K{}", what);
      std::fflush(stderr);
    }
    return true;
  }
  void clear() const {
    if (is_on_) fmt::print(stderr, "\r\x1b[K");
  }

 private:
  bool is_on_;
};

selftest::Effort effort_of(const SelftestOptions& options) {
  selftest::Effort effort;
  effort.seed = options.seed;
  effort.jobs = options.jobs;
  return effort;
}

// Cases one after the other, up to an interruption.
std::vector<selftest::JudgedCase> run_cases(std::vector<SelftestCase> cases,
                                            const SelftestOptions& options,
                                            const Announcer& announce) {
  std::vector<selftest::JudgedCase> judged;
  for (SelftestCase& item : cases) {
    if (!announce(fmt::format("{} of {}: {}", judged.size() + 1, cases.size(), item.name))) break;
    const auto begin = std::chrono::steady_clock::now();
    selftest::CaseResult result = item.run(effort_of(options));
    judged.push_back(selftest::judge(std::move(item), std::move(result)));
    judged.back().seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  return judged;
}

struct ReportFile {
  std::string name, text;
};

void write_files(const std::string& folder, const std::vector<ReportFile>& files,
                 CommandOutcome& outcome) {
  calc::Diagnostics diagnostics;
  for (const ReportFile& file : files) {
    const std::string path = (std::filesystem::path(folder) / file.name).string();
    const std::string problem = report::write_file_atomically(path, file.text);
    if (problem.empty()) continue;
    diagnostics.report(calc::DiagnosticId::output_not_possible, {},
                       fmt::format("cannot write '{}': {}", path, problem));
  }
  if (diagnostics.has_errors()) outcome.code = kNotJudged;
  outcome.diagnostics = diagnostics.all();
}

CommandOutcome interrupted_outcome() {
  fmt::print(stderr, "luxgate: interrupted; nothing was written\n");
  return {kInterrupted, "", {}};
}

CommandOutcome sweep(const SelftestOptions& options, const Announcer& announce) {
  const std::vector<selftest::Sweep> sweeps = selftest::run_sweeps(effort_of(options), announce);
  announce.clear();
  if (interrupted()) return interrupted_outcome();
  CommandOutcome outcome;
  outcome.text = selftest::render_sweeps_markdown(sweeps);
  write_files(options.sweep_folder,
              {{"sweeps.csv", selftest::render_sweeps_csv(sweeps, options.has_timing)},
               {"sweeps.html", selftest::render_sweeps_html(sweeps)},
               {"sweeps.md", outcome.text}},
              outcome);
  return outcome;
}

// The open cases count for the report, not for the exit code: some ask for what luxgate is not.
void write_report(const SelftestOptions& options, const std::string& shared_data,
                  const selftest::RunResult& result, const Announcer& announce,
                  CommandOutcome& outcome) {
  selftest::OpenCases open;
  if (!shared_data.empty()) {
    open = selftest::run_open_cases(shared_data + "/validation", calc::DiskFileReader(),
                                    effort_of(options), announce);
    announce.clear();
    if (interrupted()) return;
    if (!open.problem.empty()) outcome.text += "Open cases: " + open.problem + "\n";
  }
  std::vector<ReportFile> files = {
      {"validation.md", selftest::render_report_markdown(result, options.has_timing)},
      {"validation.html", selftest::render_report_html(result, open, options.has_timing)}};
  if (!open.cases.empty()) {
    files.push_back({"open-cases.md", selftest::render_open_markdown(open)});
  }
  write_files(options.report_folder, files, outcome);
}

}  // namespace

CommandOutcome run_selftest(const SelftestOptions& options, const Environment& environment) {
  const Announcer announce(environment.stderr_is_terminal);
  if (!options.sweep_folder.empty()) return sweep(options, announce);
  CommandOutcome outcome;
  std::vector<SelftestCase> cases = chosen_cases(options);
  if (options.lists) {
    outcome.text = selftest::render_list(cases);
    return outcome;
  }
  selftest::RunResult result;
  result.seed = options.seed;
  result.program = report::program_version();
  result.tracer = calc::tree_builder_version();
  result.cases = run_cases(std::move(cases), options, announce);
  announce.clear();
  if (interrupted()) return interrupted_outcome();
  if (result.numbers() > selftest::kMostNumbers) {
    throw std::logic_error("the selftest has more numbers than its level allows for");
  }
  if (result.wrong() > 0) outcome.code = kNotMet;
  const selftest::TextStyle style{options.shows_all, options.has_timing,
                                  use_color(ColorChoice::automatic, environment)};
  outcome.text = options.as_json ? selftest::render_json(result, options.has_timing)
                                 : selftest::render_text(result, style);
  if (!options.report_folder.empty()) {
    write_report(options, environment.shared_data, result, announce, outcome);
    if (interrupted()) return interrupted_outcome();
  }
  return outcome;
}

Command selftest_command() {
  const auto options = std::make_shared<SelftestOptions>();
  Command command = selftest_syntax(*options);
  command.run = [options](const RunContext& context) {
    watch_for_interrupt();
    return print_outcome(run_selftest(*options, context.environment));
  };
  return command;
}

}  // namespace cli
