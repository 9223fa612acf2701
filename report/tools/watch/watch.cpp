#include "report/tools/watch/watch.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/store/entry_folder.h"
#include "calc/store/memory_store.h"
#include "report/check/in_order.h"
#include "report/check/run.h"
#include "report/formats/console.h"
#include "report/html/chapters/data_sheets.h"
#include "report/html/page/html.h"
#include "report/revision/revise.h"
#include "report/shell/options/open_backend.h"
#include "report/shell/options/project_reader.h"
#include "report/shell/options/recording_reader.h"
#include "report/shell/options/selection_option.h"
#include "report/shell/output/outputs.h"
#include "report/shell/output/progress.h"
#include "report/shell/process/interrupt.h"
#include "report/shell/process/print.h"
#include "report/text/words.h"
#include "report/tools/check/check_options.h"
#include "report/tools/check/check_setup.h"
#include "report/tools/check/checked_document.h"
#include "report/tools/watch/file_stamps.h"
#include "report/tools/watch/input_watch.h"
#include "report/tools/watch/report_server.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace cli {
namespace {

// Looks of half that size are forgotten together, so that there is always room for new ones.
constexpr std::size_t kMostStoreBytes = std::size_t{1} << 30;

constexpr const char* kWatchNotes =
    "The terminal shows the whole result first. After each save it shows what changed, and\n"
    "the time from the save to the verdict. Only what changed is calculated again. A change\n"
    "during a calculation starts it again. Ctrl-C ends the command.";

struct WatchOptions {
  CheckOptions check;
  bool serves = false;
};

class WatchObserver : public check::Observer {
 public:
  WatchObserver(Progress& progress, const std::string& path, InputWatch& watch)
      : progress_(progress, path), watch_(watch) {}

  void start_project(std::size_t spaces) override { progress_.start_project(spaces); }
  void start_space(const std::string& id) override { progress_.start_space(id); }
  bool go_on(const calc::SolveProgress& progress) override {
    progress_.update(progress);
    return !is_stopped();
  }
  bool is_stopped() const override { return interrupted() || watch_.has_changed(); }

 private:
  ProjectProgress progress_;
  InputWatch& watch_;
};

double seconds_since(std::int64_t ns_since_1970) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  constexpr double kPerSecond = 1e9;
  const std::int64_t now_ns = std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
  return static_cast<double>(now_ns - ns_since_1970) / kPerSecond;
}

// Of the newest of these files; empty where none was written just now, but moved or removed.
std::optional<double> seconds_since_save(const FileStamps& changed) {
  constexpr double kJustNow_s = 3600.0;
  std::int64_t newest_ns = 0;
  for (const auto& [path, stamp] : changed) newest_ns = std::max(newest_ns, stamp.modified_ns);
  const double since_s = seconds_since(newest_ns);
  if (newest_ns == 0 || since_s < 0.0 || since_s > kJustNow_s) return std::nullopt;
  return since_s;
}

// One run of the command.
class Watch {
 public:
  Watch(const WatchOptions& options, const RunContext& context)
      : options_(options.check),
        context_(context),
        progress_style_(context.environment.stderr_is_terminal ? ProgressStyle::one_line
                                                               : ProgressStyle::none) {
    options_.output.are_messages_printed = true;
  }

  ExitCode run(bool serves) {
    if (serves) {
      std::string problem;
      server_ = ReportServer::start(problem);
      if (server_ == nullptr) {
        print_error(calc::DiagnosticId::output_not_possible, problem);
        return kNotJudged;
      }
      tell("luxgate: the report is at {}\n", server_->address());
    }
    watch_for_interrupt();
    FileStamps changed;
    while (!interrupted()) {
      if (!check(changed)) return kNotJudged;
      changed = watch_.wait([] { return interrupted(); });
    }
    return exit_code_;
  }

 private:
  // False: nothing can be checked on this machine, whatever the files hold.
  bool check(const FileStamps& changed) {
    const ProjectReader disk(options_.input);
    const StampedReader stamped(disk);
    const RecordingReader files(stamped);
    for (const std::string& path : options_.input.rule_files) stamped.note(path);
    bool is_good = true;
    std::optional<report::Document> document = check_files(files, is_good);
    const bool is_overtaken = watch_.has_changed();
    watch_.set(stamped.stamps(), !is_overtaken);
    if (!is_good || interrupted()) return is_good;
    if (!is_overtaken) show(document ? *std::move(document) : none(), files.paths(), changed);
    return true;
  }

  // Empty: rule packs cannot be read, which has been printed; is_good false: see check().
  std::optional<report::Document> check_files(const RecordingReader& files, bool& is_good) {
    auto packs = load_packs_or_print(options_.input.rule_files, files);
    if (!packs) return std::nullopt;
    if (!open(files, *std::move(packs))) {
      is_good = false;
      return std::nullopt;
    }
    memory_->clear_above(kMostStoreBytes / 2);
    report::Document document;
    document.provenance = provenance_of(options_, *run_);
    const std::vector<std::string>& paths = options_.input.projects;
    Progress progress(progress_style_, context_.environment.stderr_columns);
    progress.expect(paths.size());
    const auto go_on = [this] { return !interrupted() && !watch_.has_changed(); };
    document.projects.resize(paths.size());
    const auto work = [&](std::size_t p) {
      WatchObserver observer(progress, paths[p], watch_);
      document.projects[p] = run_->check(paths[p], observer);
    };
    const auto deliver = [&](std::size_t p) { progress.done(paths[p]); };
    check::in_order(paths.size(), run_->concurrency(), work, deliver, go_on);
    progress.clear();
    if (!go_on()) return std::nullopt;
    complete_provenance(document.provenance, report::totals_of(document), *run_);
    return document;
  }

  // Where rule packs cannot be read nothing is judged: an older result must not stand there.
  report::Document none() const {
    report::Document document;
    if (run_) document.provenance = provenance_of(options_, *run_);
    for (const std::string& path : options_.input.projects) {
      document.projects.emplace_back().path = path;
    }
    return document;
  }

  // The backend is opened once; files, packs and the day are those of now.
  bool open(const RecordingReader& files, std::vector<rules::RulePack> packs) {
    if (run_) {
      run_ = run_->with_settings(options_.settings).with_files(files).with_packs(std::move(packs));
      return true;
    }
    run_ = open_run_or_print(options_, context_, files, std::move(packs));
    if (!run_) return false;
    if (options_.store.empty()) {
      run_ = run_->with_light_in(memory_);
    } else {
      run_ = run_->with_light_in(std::make_shared<calc::EntryFolder>(options_.store));
    }
    return true;
  }

  void show(report::Document document, const std::set<std::string>& inputs,
            const FileStamps& changed) {
    for (const report::ProjectPart& project : document.projects) {
      print_messages(project, options_.output, context_.environment);
      if (options_.output.page.sheets) options_.output.page.sheets->see(project, "");
    }
    std::optional<report::Document> shown;
    if (last_) {
      shown = document;
      shown->revision = report::revise(*last_, document, "the last save", {});
    }
    const report::Document& of_now = shown ? *shown : document;
    if (shown && !options_.output.lists_passes) {
      const bool is_coloured = use_color(options_.output.color, context_.environment);
      print_result(report::render_revision_text({}, of_now, is_coloured,
                                                context_.environment.stdout_columns) +
                   report::summary_words(report::totals_of(of_now)) + "\n");
    } else {
      write_results(options_.output, context_.environment, of_now, inputs);
    }
    if (server_) server_->show(report::render_html(of_now));
    exit_code_ = exit_code_of(report::outcome_of(document));
    if (report::totals_of(document).is_selection_empty()) {
      print_nothing_chosen(options_.settings.selection);
    }
    say_how_long(changed);
    if (is_judged(document)) last_ = std::move(document);
  }

  void say_how_long(const FileStamps& changed) {
    const std::optional<double> took_s = seconds_since_save(changed);
    const std::string took =
        took_s ? fmt::format("{:.2f} s after the save; ", *took_s) : std::string();
    tell("luxgate: {}waiting for changes, Ctrl-C ends\n\n", took);
  }

  static bool is_judged(const report::Document& document) {
    return std::all_of(document.projects.begin(), document.projects.end(),
                       [](const report::ProjectPart& project) { return project.is_judged; });
  }

  CheckOptions options_;
  const RunContext& context_;
  const ProgressStyle progress_style_;
  InputWatch watch_;
  std::unique_ptr<ReportServer> server_;
  std::shared_ptr<calc::MemoryStore> memory_ = std::make_shared<calc::MemoryStore>(kMostStoreBytes);
  std::optional<check::Run> run_;
  std::optional<report::Document> last_;  // of which everything could be judged
  ExitCode exit_code_ = kInterrupted;     // before the first result
};

std::string complete(CheckOptions& options, const Environment& environment) {
  if (std::string problem = take_store(environment.store, options.store); !problem.empty()) {
    return problem;
  }
  return complete_work(options.settings.radiosity, options.backend);
}

}  // namespace

Command watch_command() {
  const auto options = std::make_shared<WatchOptions>();
  CheckOptions& check = options->check;
  check.pictures = false;
  Command command{"watch", "Check projects again whenever one of their files changes"};
  command.places = {projects_place(check.input)};
  command.options = project_options(check.input);
  command.config = &check.input.config;
  add(command.options, {{"--serve", "",
                         "Show the report in a browser and keep it up to date. Only this machine "
                         "can reach it, at an address that nobody can guess",
                         &options->serves},
                        color_option(check.output.color)});
  add(command.options, text_options(check.output));
  add(command.options, selection_options(check.settings.selection));
  add(command.options, accuracy_options(check.settings));
  add(command.options, work_options(check.settings.radiosity));
  add(command.options, backend_options(check.backend));
  add(command.options, {store_option(check.store)});
  command.notes = kWatchNotes;
  command.examples = {
      {"luxgate watch office.xml --serve", "The report in a browser, kept up to date"}};
  command.exit_codes = {{kAllMet, "at the end every requirement was met or waived"},
                        {kNotMet, "at the end a requirement was not met"},
                        {kNotJudged, "an error, or at the end something could not be judged"},
                        {kUndecided, "at the end nothing failed, but a result was undecided"},
                        {kInterrupted, "ended before the first result"}};
  command.most_used = {"--serve", "--rules", "--passes",  "--goal",
                       "--jobs",  "--store", "--backend", "--color"};
  command.complete_projects = [options] { return complete_projects(options->check.input); };
  command.complete = [options](const Environment& environment) {
    return complete(options->check, environment);
  };
  command.run = [options](const RunContext& context) {
    return Watch(*options, context).run(options->serves);
  };
  return command;
}

}  // namespace cli
