#include "report/tools/sweep/sweep.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/store/entry_folder.h"
#include "calc/store/entry_store.h"
#include "calc/store/memory_store.h"
#include "report/check/in_order.h"
#include "report/check/set_values.h"
#include "report/shell/command/config_file.h"
#include "report/shell/command/option_values.h"
#include "report/shell/options/project_reader.h"
#include "report/shell/output/progress.h"
#include "report/shell/process/interrupt.h"
#include "report/shell/process/print.h"
#include "report/text/shell_words.h"
#include "report/text/words.h"
#include "report/tools/check/check_setup.h"
#include "report/tools/check/checked_document.h"
#include "report/tools/check/store_words.h"
#include "report/tools/check/watched_project.h"
#include "report/tools/sweep/sweep_shards.h"

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

constexpr const char* kSweepNotes =
    "All combinations are checked, the last --vary fastest. What a change does not affect\n"
    "comes from the result cache, or from memory. Limits, dimming and maintenance factors need no\n"
    "new calculation.\n\n"
    "A margin is (value - limit) / limit, with the sign changed for upper limits, so that\n"
    "more than 0 is good. The margin of a variant is the smallest of all requirements that\n"
    "count. Limits of 0, aggregates and classes have no margin: 'N without' counts them.\n"
    "Power and price are those of all installed luminaires. The attribute 'price' of\n"
    "<luminaire-type> is that of one luminaire, in any currency.\n\n"
    "A variant that passes is on the front ('on') if no other one is better: with a margin as\n"
    "large and less power, or with a larger margin and the same power. 'perhaps': others are\n"
    "better, but not with their whole interval. --goal accuracy makes intervals narrow.\n"
    "Variants with the same power and margin are on the front together. With --front price\n"
    "the price counts instead of the power. A variant with a luminaire of unknown power or\n"
    "price is not on the front, and a line says so.";

// Every file is read once, so that all variants are of the same files.
class KeptFiles : public calc::FileReader {
 public:
  explicit KeptFiles(const calc::FileReader& files) : files_(files) {}

  calc::FileContent read_within(const std::string& folder, const std::string& path) const override {
    const std::scoped_lock lock(mutex_);
    const std::pair key(folder, path);
    const auto known = contents_.find(key);
    return known != contents_.end()
               ? known->second
               : contents_.emplace(key, files_.read_within(folder, path)).first->second;
  }
  std::set<std::string> paths() const {
    const std::scoped_lock lock(mutex_);
    std::set<std::string> paths;
    for (const auto& [key, content] : contents_) paths.insert(key.second);
    return paths;
  }

 private:
  const calc::FileReader& files_;
  mutable std::mutex mutex_;
  mutable std::map<std::pair<std::string, std::string>, calc::FileContent> contents_;
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

bool lacks_any_light(const report::ProjectPart& part) {
  return std::any_of(part.spaces.begin(), part.spaces.end(), [](const report::SpacePart& space) {
    return std::any_of(space.planes.begin(), space.planes.end(),
                       [](const report::PlanePart& plane) { return lacks_light(plane); });
  });
}

void print_lacking(const std::string& store, std::vector<std::size_t> lacking,
                   std::size_t variants) {
  if (lacking.empty()) return;
  std::sort(lacking.begin(), lacking.end());
  std::vector<std::string> names;
  for (const std::size_t variant : lacking) names.push_back(std::to_string(variant + 1));
  calc::Diagnostics diagnostics;
  diagnostics.report(calc::DiagnosticId::store_lacks_variants, {store, 0, 0}, names.size(),
                     variants, calc::list_names(names, kMostLackingNamed));
  print_diagnostics(diagnostics.all(), true);
}

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
  if (options.front_of != SweepOptions{}.front_of) {
    words += fmt::format(" --front {}", calc::name_of(options.front_of));
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

// Has nothing, and knows what it was asked for.
class AskedStore : public calc::EntryStore {
 public:
  std::optional<std::string> read(std::string_view key, std::size_t /*most_bytes*/) override {
    const std::scoped_lock lock(mutex_);
    keys_.emplace(key);
    return std::nullopt;
  }
  void write(std::string_view /*key*/, std::string_view /*bytes*/) override {}
  void refuse(std::string_view /*key*/, std::string_view /*why*/) override {}

  std::set<std::string> keys() const { return keys_; }

 private:
  std::mutex mutex_;  // spaces ask at the same time
  std::set<std::string> keys_;
};

class StoppedByInterrupt : public check::Observer {
 public:
  bool is_stopped() const override { return interrupted(); }
};

// In the order in which they are done: neighbours stand far from each other, since they need the
// same looks, and two at a time would both compute them.
std::vector<std::size_t> spread(const std::vector<std::size_t>& own) {
  if (own.empty()) return own;
  constexpr double kGoldenShare = 0.618;
  const std::size_t count = own.size();
  auto stride = static_cast<std::size_t>(kGoldenShare * static_cast<double>(count)) + 1;
  while (std::gcd(stride, count) != 1) ++stride;
  std::vector<std::size_t> in_order;
  for (std::size_t i = 0; i < count; ++i) in_order.push_back(own[i * stride % count]);
  return in_order;
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
      options.outputs, [&](DataFormat kind) { return render_sweep(kind, sweep); },
      options.check.output.quiet, diagnostics);
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
  if (options.vary.empty()) return "--vary is missing: name an attribute and its values";
  if (const std::size_t count = count_variants(options.vary); count > kMostVariants) {
    return fmt::format("--vary: more than {} variants", kMostVariants);
  }
  if (std::string problem = data_output_problem(options.outputs); !problem.empty()) return problem;
  if (std::string problem = take_store(environment.store, check.store); !problem.empty()) {
    return problem;
  }
  const bool is_shard = check.batch.share.count > 0;
  if (is_shard || check.batch.is_stored_only) {
    const char* name = is_shard ? "--shard" : "--stored-only";
    if (check.store.empty()) return fmt::format("{} needs --store", name);
    if (is_shard && check.batch.is_stored_only) {
      return "--shard and --stored-only exclude each other";
    }
    if (check.settings.radiosity.time_limit_s > 0.0) {
      return fmt::format("{} and --time-limit exclude each other", name);
    }
  }
  if (is_shard && !options.outputs.empty()) {
    return "--shard writes no table; leave --format to the run with --stored-only";
  }
  return complete_work(check.settings.radiosity, check.backend);
}

Option vary_option(std::vector<Vary>& vary) {
  const auto parse = [&vary](const std::string& text) -> std::string {
    std::string problem;
    std::optional<Vary> one = parse_vary(text, problem);
    if (!one) return problem;
    for (const std::string& value : one->values) {
      if (problem = check::value_problem(value); !problem.empty()) return problem;
    }
    vary.push_back(*std::move(one));
    return "";
  };
  return {
      "--vary", "PATH=LIST",
      "Try each value of a list for an attribute of the project; repeatable. LIST is a,b,c or "
      "from:to:step, or both mixed. PATH is written as for --set: linear.flux-lm=3000:5000:500, "
      "room.L.columns=3,4,5. Several lists give all combinations, at most 100000",
      parse, true};
}

}  // namespace

ExitCode run_sweep(const SweepOptions& asked, const RunContext& context) {
  watch_for_interrupt();
  const ProjectReader disk(asked.check.input);
  const KeptFiles files(disk);
  SweepOptions options = asked;
  CheckOptions& check = options.check;
  std::set<std::string> inputs(check.input.rule_files.begin(), check.input.rule_files.end());
  inputs.insert(options.project);
  if (!can_write_sweep(options, inputs)) return kNotJudged;
  const std::vector<check::SetValue> first =
      all_settings(options, values_of_variant(options.vary, 0));
  if (!check_values_or_print(check.input, first, "vary", files)) return kNotJudged;
  const check::SetReader first_files(files, check.input.projects, first);
  const std::optional<check::Run> opened = open_run_or_print(check, context, first_files);
  if (!opened) return kNotJudged;
  std::shared_ptr<calc::EntryFolder> folder;
  const auto memory = std::make_shared<calc::MemoryStore>(kMostSweepStoreBytes);
  if (!check.store.empty()) folder = std::make_shared<calc::EntryFolder>(check.store);
  const check::Run run = folder ? opened->with_light_in(folder, check.batch.is_stored_only)
                                : opened->with_light_in(memory);

  const auto check_variant = [&](std::size_t v, check::Observer& observer, const check::Run& of) {
    const std::vector<check::SetValue> values =
        all_settings(options, values_of_variant(options.vary, v));
    const check::SetReader variant(files, check.input.projects, values);
    return of.with_files(variant).check(options.project, observer);
  };
  // Without a ray: a store that is all there is has nothing.
  const auto keys_of = [&](std::size_t v) {
    const auto asked_keys = std::make_shared<AskedStore>();
    StoppedByInterrupt observer;
    if (!interrupted()) check_variant(v, observer, opened->with_light_in(asked_keys, true));
    return asked_keys->keys();
  };
  std::vector<std::size_t> own(count_variants(options.vary));
  std::iota(own.begin(), own.end(), std::size_t{0});
  const BatchShare& share = check.batch.share;
  if (share.count > 0) {
    own = variants_of_shard(options.vary, paths_of_light(options.vary, keys_of), share);
  }
  own = spread(own);
  // A line for each of thousands would hide what else a log says.
  const ProgressStyle style = progress_style(check.output, context.environment);
  Progress progress(
      style == ProgressStyle::log && own.size() > kMostLogged ? ProgressStyle::none : style,
      context.environment.stderr_columns, "variants");
  progress.expect(own.size());
  Sweep sweep{options.project, options.vary, check.set, {}, "", {}, options.front_of};
  sweep.check_words = reproducible_words(check);
  sweep.provenance = provenance_of(check, run);
  sweep.provenance.command_line = sweep_words(options);
  report::Totals totals;
  calc::LookCounts looks;
  VariantMessages messages;
  std::vector<std::size_t> lacking;  // variants whose light is not in the store
  std::vector<std::optional<DoneVariant>> done(own.size());
  const auto name_of = [&](std::size_t i) { return fmt::format("variant {}", own[i] + 1); };
  const auto work = [&](std::size_t i) {
    WatchedProject observer(progress, name_of(i));
    DoneVariant result;
    result.part = check_variant(own[i], observer, run);
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
    if (check.batch.is_stored_only && lacks_any_light(part)) lacking.push_back(own[i]);
    sweep.rows.push_back(row_of(own[i], values_of_variant(options.vary, own[i]), part));
    done[i].reset();
    memory->clear_above(kMostSweepStoreBytes / 2);
  };
  check::in_order(own.size(), run.concurrency(), work, deliver, [] { return !interrupted(); });
  progress.clear();
  if (!begin_to_write()) {
    tell("luxgate: interrupted; nothing was written{}\n",
         folder ? ", finished light is in the result cache" : "");
    return kInterrupted;
  }
  messages.print(own.size(), check.output.quiet);
  print_lacking(check.store, std::move(lacking), own.size());
  complete_provenance(sweep.provenance, totals, run);
  std::sort(sweep.rows.begin(), sweep.rows.end(),
            [](const SweepRow& a, const SweepRow& b) { return a.variant < b.variant; });
  find_front(sweep.rows, sweep.front_of);
  if (!check.output.quiet) {
    tell("luxgate: {} variants; {} sampling rounds of planes computed, {} read from {}\n",
         own.size(), looks.computed, looks.read, folder ? "the store" : "memory");
    if (folder && share.count == 0) print_troubles(check.store, folder->troubles());
  }
  if (share.count > 0) {
    const bool is_kept = is_light_kept_or_print(check.store, folder->troubles());
    return is_kept && count_outcomes(sweep.rows).not_judged == 0 ? kAllMet : kNotJudged;
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
      vary_option(options->vary),
      set_option(check.set),
      rules_option(check.input.rule_files),
      allow_option(check.input.allowed),
      {"--front", "NAME",
       "Choose what is compared with the margin: power or price of all luminaires; default power",
       choice<FrontOf>(options->front_of, {{"power", FrontOf::power}, {"price", FrontOf::price}})}};
  add(command.options,
      data_format_options(options->outputs,
                          "text, csv, json or html; default text. It is repeatable. Without FILE, "
                          "or with '-', it goes to standard output, which takes one kind only"));
  add(command.options, config_options(check.input.config));
  command.config = &check.input.config;
  add(command.options, accuracy_options(check.settings));
  add(command.options, work_options(check.settings.radiosity));
  add(command.options, backend_options(check.backend));
  add(command.options,
      {store_option(check.store),
       shard_option(
           check.batch.share,
           "Calculate only share I of N into --store, for N machines; I from 1 to N. No table is "
           "written. Variants that need the same light are in one share, so that more shares than "
           "different lights are of no use. Afterwards the same command with --stored-only writes "
           "the table"),
       stored_only_option(check.batch.is_stored_only), quiet_option(check.output.quiet)});
  command.notes = kSweepNotes;
  command.examples = {
      {"luxgate sweep office.xml --vary linear.flux-lm=3000:5000:500 --vary room.L.columns=3,4,5",
       "Fifteen variants, compared by margin and power"}};
  command.exit_codes = {
      {kAllMet, "done: every variant was judged, whatever its verdict"},
      {kNotJudged,
       "usage, input or file error, or a variant that could not be judged (with --stored-only: "
       "whose light is not in the cache)"},
      {kInterrupted, "interrupted; finished light is in --store"}};
  command.most_used = {"--vary", "--set",    "--rules", "--front", "--goal",
                       "--jobs", "--format", "--json",  "--store", "--quiet"};
  command.complete = [options](const Environment& environment) {
    return complete_sweep(*options, environment);
  };
  command.run = [options](const RunContext& context) { return run_sweep(*options, context); };
  return command;
}

}  // namespace cli
