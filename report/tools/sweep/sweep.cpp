#include "report/tools/sweep/sweep.h"

#include "calc/store/entry_folder.h"
#include "calc/store/memory_store.h"
#include "report/check/in_order.h"
#include "report/check/set_values.h"
#include "report/shell/interrupt.h"
#include "report/shell/option_values.h"
#include "report/shell/print.h"
#include "report/shell/progress.h"
#include "report/text/shell_words.h"
#include "report/text/words.h"
#include "report/tools/check/check_setup.h"
#include "report/tools/check/checked_document.h"
#include "report/tools/check/store_words.h"
#include "report/tools/check/watched_project.h"
#include "report/tools/sweep/sweep_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

namespace cli {
namespace {

// Looks beyond half of it are forgotten together, so that there is room for new ones.
constexpr std::size_t kMostSweepStoreBytes = std::size_t{1} << 30;

constexpr std::size_t kMostLogged = 100;

constexpr const char* kSweepFooter =
    "All combinations are checked, the last --vary fastest. What a change does not touch is taken\n"
    "from the store, or from memory without one: limits, dimming and maintenance factors trace no\n"
    "ray. A margin is (value - limit) / limit, turned for upper limits, so that above 0 is good;\n"
    "that of a variant is the smallest over all requirements that count. Limits of 0, aggregates\n"
    "and classes have none: the verdict knows them, 'N without' counts them. Power is installed\n"
    "power.\n"
    "On the front ('on') is a variant that passes if no other one that passes has a margin as\n"
    "large with less power, or a larger one with as much; 'perhaps' if others have, but none with\n"
    "its whole interval: --goal accuracy makes intervals narrow. Variants with the same power and\n"
    "margin are on it together.\n"
    "Exit codes:\n"
    "  0    done: every variant was judged, whatever its verdict\n"
    "  2    usage, input or file error, or a variant that could not be judged\n"
    "  130  interrupted; what was finished is in the --store";

// Every file is read once, so that all variants are of the same files.
class KeptFiles : public calc::FileReader {
 public:
  explicit KeptFiles(const calc::FileReader& files) : files_(files) {}

  calc::FileContent read(const std::string& path) const override {
    const std::scoped_lock lock(mutex_);
    const auto known = contents_.find(path);
    return known != contents_.end() ? known->second
                                    : contents_.emplace(path, files_.read(path)).first->second;
  }
  std::set<std::string> paths() const {
    const std::scoped_lock lock(mutex_);
    std::set<std::string> paths;
    for (const auto& [path, content] : contents_) paths.insert(path);
    return paths;
  }

 private:
  const calc::FileReader& files_;
  mutable std::mutex mutex_;
  mutable std::map<std::string, calc::FileContent> contents_;
};

struct DoneVariant {
  report::ProjectPart part;
  calc::LookCounts looks;
};

// Most variants have the same to say: each thing is told once.
class VariantMessages {
 public:
  void add(std::size_t variant, const std::vector<calc::Diagnostic>& diagnostics) {
    std::set<std::string> told;  // of this variant
    for (const calc::Diagnostic& diagnostic : diagnostics) {
      const std::string words = calc::format_diagnostic(diagnostic);
      if (!told.insert(words).second) continue;
      const auto [place, is_new] = place_.try_emplace(words, messages_.size());
      if (is_new) messages_.push_back({diagnostic, variant, 0});
      Message& message = messages_[place->second];
      message.first = std::min(message.first, variant);
      ++message.variants;
    }
  }
  void print(std::size_t variants, bool errors_only) const {
    std::vector<Message> messages = messages_;
    std::stable_sort(messages.begin(), messages.end(),
                     [](const Message& a, const Message& b) { return a.first < b.first; });
    std::vector<calc::Diagnostic> list;
    for (const Message& message : messages) {
      list.push_back(message.diagnostic);
      if (message.variants == variants) continue;
      list.back().message +=
          message.variants == 1
              ? fmt::format(" (variant {})", message.first + 1)
              : fmt::format(" (variant {} and {} more)", message.first + 1, message.variants - 1);
    }
    print_diagnostics(list, errors_only);
  }

 private:
  struct Message {
    calc::Diagnostic diagnostic;
    std::size_t first = 0, variants = 0;
  };
  std::vector<Message> messages_;
  std::map<std::string, std::size_t> place_;
};

bool can_write_sweep(const SweepOptions& options, const std::set<std::string>& inputs) {
  calc::Diagnostics diagnostics;
  check_data_outputs(options.outputs, inputs, diagnostics);
  print_diagnostics(diagnostics.all(), true);
  return !diagnostics.has_errors();
}

std::string sweep_words(const SweepOptions& options) {
  std::string words = "luxgate sweep" + reproducible_words(options.check);
  for (const Vary& vary : options.vary) {
    words += " --vary " +
             report::shell_quoted(fmt::format("{}={}", vary.path, fmt::join(vary.values, ",")));
  }
  return words;
}

std::vector<check::SetValue> all_settings(const SweepOptions& options,
                                          const std::vector<std::string>& values) {
  std::vector<check::SetValue> all = options.check.set;
  const std::vector<check::SetValue> own = settings_of_variant(options.vary, values);
  all.insert(all.end(), own.begin(), own.end());
  return all;
}

// Numbers of those that this run does, in the order in which it does them: neighbours stand far
// from each other, since they need the same looks, and two at a time would both compute them.
std::vector<std::size_t> own_variants(const SweepOptions& options) {
  const BatchShare& share = options.check.batch.share;
  std::vector<std::size_t> own;
  for (std::size_t v = 0; v < count_variants(options.vary); ++v) {
    if (share.count == 0 || v % share.count + 1 == share.number) own.push_back(v);
  }
  if (own.empty()) return own;
  constexpr double kGoldenShare = 0.618;
  const std::size_t count = own.size();
  auto stride = static_cast<std::size_t>(kGoldenShare * static_cast<double>(count)) + 1;
  while (std::gcd(stride, count) != 1) ++stride;
  std::vector<std::size_t> spread;
  for (std::size_t i = 0; i < count; ++i) spread.push_back(own[i * stride % count]);
  return spread;
}

std::string render_sweep(DataFormat kind, const Sweep& sweep) {
  switch (kind) {
    case DataFormat::csv:
      return render_sweep_csv(sweep);
    case DataFormat::json:
      return render_sweep_json(sweep);
    case DataFormat::html:
      return render_sweep_html(sweep);
    default:
      return render_sweep_text(sweep);
  }
}

ExitCode write_sweep(const SweepOptions& options, const Sweep& sweep,
                     const std::set<std::string>& inputs) {
  if (!can_write_sweep(options, inputs)) return kNotJudged;
  calc::Diagnostics diagnostics;
  const std::string text = write_data_outputs(
      options.outputs, [&](DataFormat kind) { return render_sweep(kind, sweep); }, diagnostics);
  print_diagnostics(diagnostics.all(), true);
  const bool is_asked = std::any_of(options.outputs.begin(), options.outputs.end(),
                                    [](const DataOutput& output) { return output.file.empty(); });
  const bool is_printed = options.check.output.quiet && !is_asked ? true : print_result(text);
  const bool is_judged = count_outcomes(sweep.rows).not_judged == 0;
  return is_printed && is_judged && !diagnostics.has_errors() ? kAllMet : kNotJudged;
}

std::string complete_sweep(SweepOptions& options, const Environment& environment) {
  CheckOptions& check = options.check;
  check.input.projects = {options.project};
  if (options.vary.empty()) return "--vary is missing: what is to have several values?";
  if (const std::size_t count = count_variants(options.vary); count > kMostVariants) {
    return fmt::format("--vary: these are more than {} variants", kMostVariants);
  }
  if (std::string problem = data_output_problem(options.outputs); !problem.empty()) return problem;
  if (std::string problem = take_store(environment.store, check.store); !problem.empty()) {
    return problem;
  }
  if (check.batch.share.count > 0) {
    if (check.store.empty()) return "--shard needs --store";
    if (!options.outputs.empty()) {
      return "--shard writes no table; leave --format to the run that follows all shards";
    }
    if (check.settings.radiosity.time_limit_s > 0.0) {
      return "--shard and --time-limit exclude each other";
    }
  }
  return complete_work(check.settings.radiosity, check.backend);
}

Option vary_option(std::vector<Vary>& vary) {
  const auto parse = [&vary](const std::string& text) -> std::string {
    std::string problem;
    std::optional<Vary> one = parse_vary(text, problem);
    if (one) vary.push_back(*std::move(one));
    return problem;
  };
  return {"--vary", "PATH=LIST",
          "Values that an attribute of the project takes, one after the other: a,b,c or\n"
          "from:to:step, or both mixed. PATH is as of --set: linear.flux-lm=3000:5000:500,\n"
          "room.L.columns=3,4,5. Can be repeated: all combinations, at most 100000",
          parse, true};
}

}  // namespace

ExitCode run_sweep(const SweepOptions& asked, const RunContext& context) {
  const calc::DiskFileReader disk;
  const KeptFiles files(disk);
  SweepOptions options = asked;
  CheckOptions& check = options.check;
  check.settings.today = day_of(check.settings);  // one for all, also over midnight
  std::set<std::string> inputs(check.input.rule_files.begin(), check.input.rule_files.end());
  inputs.insert(options.project);
  if (!can_write_sweep(options, inputs)) return kNotJudged;
  const std::vector<check::SetValue> first =
      all_settings(options, values_of_variant(options.vary, 0));
  if (!check_values_or_print(check.input, first, "vary", files)) return kNotJudged;
  const check::SetReader first_files(files, check.input.projects, first);
  const std::optional<CheckSetup> setup = set_up_or_print(check, context, first_files);
  if (!setup) return kNotJudged;

  watch_for_interrupt();
  const calc::Stages stages = setup->opened.stages();
  calc::MemoryStore memory(kMostSweepStoreBytes);
  std::optional<calc::EntryFolder> folder;
  if (!check.store.empty()) folder.emplace(check.store);
  calc::EntryStore& entries = folder ? static_cast<calc::EntryStore&>(*folder) : memory;
  const calc::LookStore store{entries, setup->opened.identity};

  const std::vector<std::size_t> own = own_variants(options);
  // A line for each of thousands would hide what else a log says.
  const ProgressStyle style = progress_style(check.output, context.environment);
  Progress progress(
      style == ProgressStyle::log && own.size() > kMostLogged ? ProgressStyle::none : style,
      context.environment.stderr_columns, "variants");
  progress.expect(own.size());
  Sweep sweep{options.project, options.vary, check.set, {}, "", {}};
  sweep.check_words = reproducible_words(check);
  sweep.provenance = provenance_of(check, setup->backend.backend, setup->opened.description);
  sweep.provenance.command_line = sweep_words(options);
  report::Totals totals;
  calc::LookCounts looks;
  VariantMessages messages;
  std::vector<std::optional<DoneVariant>> done(own.size());
  const auto name_of = [&](std::size_t i) { return fmt::format("variant {}", own[i] + 1); };
  const auto work = [&](std::size_t i) {
    WatchedProject observer(progress, name_of(i));
    const std::vector<check::SetValue> values =
        all_settings(options, values_of_variant(options.vary, own[i]));
    const check::SetReader variant(files, check.input.projects, values);
    DoneVariant result;
    result.part =
        check_safely(options.project, {check.settings, variant, setup->packs, stages, observer,
                                       nullptr, &store, setup->crew.most_begun});
    result.looks = observer.looks();
    done[i] = std::move(result);
  };
  const auto deliver = [&](std::size_t i) {
    if (interrupted()) return;
    const report::ProjectPart& part = done[i]->part;
    messages.add(own[i], part.diagnostics);
    progress.done(name_of(i), report::outcome_words(report::outcome_of(part)));
    totals.add(part);
    looks.read += done[i]->looks.read;
    looks.computed += done[i]->looks.computed;
    sweep.rows.push_back(row_of(own[i], values_of_variant(options.vary, own[i]), part));
    done[i].reset();
    memory.clear_above(kMostSweepStoreBytes / 2);
  };
  check::in_order(own.size(), setup->crew, work, deliver, [] { return !interrupted(); });
  progress.clear();
  if (interrupted()) {
    fmt::print(stderr, "luxgate: interrupted; nothing was written{}\n",
               folder ? ", what was finished is in the store" : "");
    return kInterrupted;
  }
  messages.print(own.size(), check.output.quiet);
  complete_provenance(sweep.provenance, totals, check.settings.today, setup->backend.backend);
  std::sort(sweep.rows.begin(), sweep.rows.end(),
            [](const SweepRow& a, const SweepRow& b) { return a.variant < b.variant; });
  find_front(sweep.rows);
  if (!check.output.quiet) {
    fmt::print(stderr, "luxgate: {} variants; {} looks of planes computed, {} taken from {}\n",
               own.size(), looks.computed, looks.read, folder ? "the store" : "memory");
    if (folder) print_troubles(check.store, folder->troubles());
  }
  if (check.batch.share.count > 0) {
    const bool is_written = folder->troubles().not_written.empty();
    return is_written && count_outcomes(sweep.rows).not_judged == 0 ? kAllMet : kNotJudged;
  }
  std::set<std::string> read = files.paths();
  read.insert(inputs.begin(), inputs.end());
  return write_sweep(options, sweep, read);
}

Command sweep_command() {
  const auto options = std::make_shared<SweepOptions>();
  CheckOptions& check = options->check;
  check.pictures = false;
  Command command{"sweep", "Check variants of one project and compare them"};
  command.places = {project_place(options->project)};
  command.options = {
      vary_option(options->vary), set_option(check.set), rules_of_projects(check.input),
      data_format_option(options->outputs,
                         "text, csv, json or html, into a file or to standard output; default "
                         "text. Can be repeated")};
  add(command.options, accuracy_options(check.settings));
  add(command.options, work_options(check.settings.radiosity));
  add(command.options, backend_options(check.backend));
  add(command.options,
      {store_option(check.store),
       shard_option(check.batch.share,
                    "Calculate only every N-th variant, from the I-th on, into --store, and write "
                    "no\n"
                    "table: for as many machines. Then the same command without --shard finds all\n"
                    "light there"),
       quiet_option(check.output.quiet)});
  command.footer = kSweepFooter;
  command.complete = [options](const Environment& environment) {
    return complete_sweep(*options, environment);
  };
  command.run = [options](const RunContext& context) { return run_sweep(*options, context); };
  return command;
}

}  // namespace cli
