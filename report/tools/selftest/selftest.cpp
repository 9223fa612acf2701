#include "report/tools/selftest/selftest.h"

#include "calc/base/diagnostic_ids.h"
#include "report/document/program_version.h"
#include "report/formats/write.h"
#include "report/shell/process/interrupt.h"
#include "report/shell/process/print.h"
#include "report/tools/selftest/report.h"

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
      tell("\r\x1b[K{}", what);
      std::fflush(stderr);
    }
    return true;
  }
  void clear() const {
    if (is_on_) tell("\r\x1b[K");
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
    std::vector<selftest::CaseResult> of_seeds;
    selftest::Effort effort = effort_of(options);
    for (int s = 0; s < options.seeds && !interrupted(); ++s, ++effort.seed) {
      of_seeds.push_back(item.run(effort));
    }
    if (of_seeds.empty()) break;
    judged.push_back(selftest::judge(std::move(item), of_seeds));
    judged.back().seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  return judged;
}

CommandOutcome interrupted_outcome() {
  tell("luxgate: interrupted; nothing was written\n");
  return {kInterrupted, "", {}};
}

void write_report(const SelftestOptions& options, const selftest::RunResult& result,
                  CommandOutcome& outcome) {
  calc::Diagnostics diagnostics;
  const std::filesystem::path folder = options.report_folder;
  std::vector<std::string> written;
  const auto write = [&](const char* name, const std::string& text) {
    const std::string path = (folder / name).string();
    const std::string problem = report::write_file_atomically(path, text);
    if (problem.empty()) {
      written.push_back(path);
      return;
    }
    diagnostics.report(calc::DiagnosticId::output_not_possible, {},
                       fmt::format("cannot write '{}': {}", path, problem));
  };
  write("validation.md", selftest::render_report_markdown(result, options.has_timing));
  write("validation.html", selftest::render_report_html(result, options.has_timing));
  tell_written(written);
  if (diagnostics.has_errors()) outcome.code = kNotJudged;
  outcome.diagnostics = diagnostics.all();
}

}  // namespace

CommandOutcome run_selftest(const SelftestOptions& options, const Environment& environment) {
  const Announcer announce(environment.stderr_is_terminal);
  CommandOutcome outcome;
  std::vector<SelftestCase> cases = chosen_cases(options);
  if (options.lists) {
    outcome.text = selftest::render_list(cases);
    return outcome;
  }
  selftest::RunResult result;
  result.seed = options.seed;
  result.seeds = options.seeds;
  result.program = report::program_version();
  result.cases = run_cases(std::move(cases), options, announce);
  announce.clear();
  if (!begin_to_write()) return interrupted_outcome();
  if (result.numbers() > selftest::kMostNumbers) {
    throw std::logic_error("the selftest has more numbers than its level allows for");
  }
  if (result.wrong() > 0) outcome.code = kNotMet;
  const selftest::TextStyle style{options.shows_all, options.has_timing,
                                  use_color(ColorChoice::automatic, environment)};
  outcome.text = options.as_json ? selftest::render_json(result, options.has_timing)
                                 : selftest::render_text(result, style);
  if (!options.report_folder.empty()) write_report(options, result, outcome);
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
