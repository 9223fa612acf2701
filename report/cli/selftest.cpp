#include "report/cli/selftest.h"

#include "calc/radiosity/rays.h"
#include "report/cli/interrupt.h"
#include "report/cli/selftest/run_result.h"
#include "report/cli/version.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
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

// Cases one after the other; empty when interrupted.
std::vector<selftest::JudgedCase> run_cases(std::vector<SelftestCase> cases,
                                            const SelftestOptions& options, bool shows_progress) {
  std::vector<selftest::JudgedCase> judged;
  for (SelftestCase& item : cases) {
    if (interrupted()) return {};
    if (shows_progress) {
      fmt::print(stderr, "\r\x1b[K{} of {}: {}", judged.size() + 1, cases.size(), item.name);
      std::fflush(stderr);
    }
    const auto begin = std::chrono::steady_clock::now();
    selftest::Effort effort;
    effort.seed = options.seed;
    effort.jobs = options.jobs;
    selftest::CaseResult result = item.run(effort);
    judged.push_back(selftest::judge(std::move(item), std::move(result)));
    judged.back().seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  if (shows_progress) fmt::print(stderr, "\r\x1b[K");
  return judged;
}

}  // namespace

CommandOutcome run_selftest(const SelftestOptions& options, const Environment& environment) {
  CommandOutcome outcome;
  std::vector<SelftestCase> cases = chosen_cases(options);
  if (options.lists) {
    outcome.text = selftest::render_list(cases);
    return outcome;
  }
  selftest::RunResult result;
  result.seed = options.seed;
  result.program = program_version();
  result.tracer = calc::tracer_version();
  result.cases = run_cases(std::move(cases), options, environment.stderr_is_terminal);
  if (interrupted()) {
    fmt::print(stderr, "luxgate: interrupted; nothing was written\n");
    outcome.code = kInterrupted;
    return outcome;
  }
  if (result.wrong() > 0) outcome.code = kNotMet;
  const selftest::TextStyle style{options.shows_all, options.has_timing,
                                  use_color(ColorChoice::automatic, environment)};
  outcome.text = options.as_json ? selftest::render_json(result, options.has_timing)
                                 : selftest::render_text(result, style);
  return outcome;
}

}  // namespace cli
