#include "report/tools/store/store.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/store/entry_folder.h"
#include "calc/store/folder_care.h"
#include "report/shell/command/option_values.h"
#include "report/shell/process/print.h"
#include "report/text/plain_text.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <utility>

namespace cli {
namespace {

constexpr std::pair<std::string_view, std::uint64_t> kUnits[] = {{"", 1},
                                                                 {"B", 1},
                                                                 {"kB", 1000},
                                                                 {"MB", 1000'000},
                                                                 {"GB", 1000'000'000},
                                                                 {"TB", 1000'000'000'000},
                                                                 {"KiB", std::uint64_t{1} << 10},
                                                                 {"MiB", std::uint64_t{1} << 20},
                                                                 {"GiB", std::uint64_t{1} << 30},
                                                                 {"TiB", std::uint64_t{1} << 40}};

struct StoreOptions {
  std::string folder;
  std::uint64_t max_bytes = 0;
};

std::string bytes_words(std::uint64_t bytes) {
  constexpr double kKibi = 1024.0;
  double value = static_cast<double>(bytes);
  for (const char* unit : {"B", "KiB", "MiB", "GiB"}) {
    if (value < kKibi) return fmt::format("{:.{}f} {}", value, *unit == 'B' ? 0 : 1, unit);
    value /= kKibi;
  }
  return fmt::format("{:.1f} TiB", value);
}

std::string moment_words(std::int64_t seconds) {
  return fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(static_cast<std::time_t>(seconds)));
}

std::string count_words(const calc::StoreCount& count) {
  std::string text = fmt::format("{} entries, {}", count.entries, bytes_words(count.bytes));
  if (count.entries > 0) {
    text += fmt::format("; last used from {} to {}", moment_words(count.oldest_use_s),
                        moment_words(count.newest_use_s));
  }
  if (count.left_behind > 0) {
    text += fmt::format("; {} files of writers at work or killed", count.left_behind);
  }
  return text + "\n";
}

// problem: "" = there is none.
CommandOutcome outcome(const StoreOptions& options, const std::string& problem, std::string text) {
  calc::Diagnostics diagnostics;
  if (!problem.empty()) {
    diagnostics.report(calc::DiagnosticId::file_not_readable, {options.folder, 0, 0},
                       options.folder, problem);
  }
  return {problem.empty() ? kAllMet : kNotJudged, std::move(text), diagnostics.all()};
}

CommandOutcome info(const StoreOptions& options) {
  const calc::StoreCount count = calc::count_entries(options.folder);
  return outcome(options, count.problem, count_words(count));
}

CommandOutcome verify(const StoreOptions& options) {
  std::string text;
  std::uint64_t damaged = 0;
  const calc::StoreCount count =
      calc::verify_entries(options.folder, [&](const std::string& place, const std::string& why) {
        ++damaged;
        text += fmt::format("{}: {}\n", place, report::printable(why));
      });
  text += fmt::format("{} of {} entries are damaged\n", damaged, count.entries);
  CommandOutcome result = outcome(options, count.problem, std::move(text));
  if (damaged > 0) result.code = kNotJudged;
  return result;
}

CommandOutcome prune(const StoreOptions& options) {
  const calc::PruneResult result =
      calc::prune_entries(options.folder, options.max_bytes, std::time(nullptr));
  std::string text = fmt::format("Deleted {} entries, {}", result.deleted_entries,
                                 bytes_words(result.deleted_bytes));
  if (result.deleted_left_behind > 0) {
    text += fmt::format(", and {} files of killed writers", result.deleted_left_behind);
  }
  text += fmt::format(". Left: {}", count_words(result.kept));
  calc::Diagnostics diagnostics;
  if (!result.problem.empty()) {
    diagnostics.report(calc::DiagnosticId::output_not_possible, {options.folder, 0, 0},
                       result.problem);
  }
  return {result.problem.empty() ? kAllMet : kNotJudged, std::move(text), diagnostics.all()};
}

// "" or why there is no store to look at.
std::string problem_with_folder(const std::string& folder) {
  std::error_code ignored;
  if (!std::filesystem::exists(folder, ignored)) {
    return fmt::format("there is no folder '{}'", folder);
  }
  return calc::problem_with_store(folder);
}

using Work = CommandOutcome (*)(const StoreOptions&);

Command store_action(std::string name, std::string summary,
                     const std::shared_ptr<StoreOptions>& options, Work work) {
  Command command{std::move(name), std::move(summary)};
  command.places = {{"dir", "DIR", "Folder of 'check --store'", &options->folder}};
  command.examples = {{fmt::format("luxgate store {} cache", command.name), ""}};
  command.exit_codes = {{0, "no error"}, {2, "an error or a damaged entry"}};
  command.complete = [options](const Environment&) { return problem_with_folder(options->folder); };
  command.run = [options, work](const RunContext&) { return print_outcome(work(*options)); };
  return command;
}

Command prune_action() {
  const auto options = std::make_shared<StoreOptions>();
  options->max_bytes = std::numeric_limits<std::uint64_t>::max();
  Command command = store_action(
      "prune", "Delete entries until the rest has a given size, those unused for longest first",
      options, prune);
  command.examples = {{"luxgate store prune cache --max-size 2GiB", ""}};
  command.options = {{"--max-size", "SIZE",
                      "Keep at most this size, as 500MB, 2GiB or 0; needed. An entry counts as "
                      "used when it is written, and once a day at most when it is read",
                      [options](const std::string& text) -> std::string {
                        const auto bytes = parse_bytes(text);
                        if (!bytes) return "a whole number and a unit are needed: 500MB, 2GiB";
                        options->max_bytes = *bytes;
                        return "";
                      }}};
  command.complete = [options](const Environment&) -> std::string {
    if (options->max_bytes == std::numeric_limits<std::uint64_t>::max()) {
      return "--max-size is needed: 500MB, 2GiB";
    }
    return problem_with_folder(options->folder);
  };
  return command;
}

}  // namespace

std::optional<std::uint64_t> parse_bytes(std::string_view text) {
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  const auto count = parse_count(text.substr(0, digits));
  if (!count) return std::nullopt;
  for (const auto& [unit, bytes] : kUnits) {
    if (unit != text.substr(digits)) continue;
    if (*count > (std::numeric_limits<std::uint64_t>::max() - 1) / bytes) return std::nullopt;
    return *count * bytes;
  }
  return std::nullopt;
}

Command store_command() {
  Command command{"store", "Show, check and prune a result cache ('check --store')"};
  command.actions = {
      store_action("info", "Print how many entries there are, their size, and when they were used",
                   std::make_shared<StoreOptions>(), info),
      prune_action(),
      store_action("verify",
                   "Read all entries and print which are damaged: format, checksum and key",
                   std::make_shared<StoreOptions>(), verify)};
  return command;
}

}  // namespace cli
