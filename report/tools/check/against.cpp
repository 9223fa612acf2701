#include "report/tools/check/against.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/sentences.h"
#include "report/check/in_order.h"
#include "report/check/load_rules.h"
#include "report/git/moved_files.h"
#include "report/shell/command/config_file.h"
#include "report/shell/options/project_folders.h"
#include "report/shell/process/print.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

namespace cli {
namespace {

bool is_there(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::exists(path, ignored);
}

// An absolute path, relative to the current folder where `example` is.
std::string named_like(const std::string& example, const std::string& path) {
  if (std::filesystem::path(example).is_absolute()) return path;
  std::error_code error;
  const std::filesystem::path here = std::filesystem::current_path(error);
  return error ? path : std::filesystem::path(path).lexically_relative(here).string();
}

// The luxgate.toml that holds for a project of the revision; "" = none.
std::string settings_of(const git::GitTreeReader& files, const std::string& project) {
  const ConfigPlaces places{[&files](const std::string& path) {
                              return files.path_in_repository(path).has_value() &&
                                     files.has_file(path);
                            },
                            {},
                            false};
  std::string ignored;
  return find_config(places, {project}, ignored);
}

// The same folder, or all of a repository that lies in it.
std::string folder_in(const git::GitTreeReader& repository, const std::string& folder) {
  std::error_code ignored;
  std::filesystem::path whole = std::filesystem::weakly_canonical(folder, ignored);
  if (!whole.has_filename()) whole = whole.parent_path();  // "designs/"
  return repository.root().starts_with(whole.string() + "/") ? repository.root() : folder;
}

std::string too_many_files(const std::string& folder) {
  return fmt::format(
      "'{}' of this revision cannot be searched: it has more than {} files, or folders that are "
      "not among the repository's objects",
      folder, git::GitTreeReader::kMostListed);
}

// A guess that is cheap: what is no project would not be like one either.
bool looks_like_project(const std::string& bytes) {
  return bytes.find("<luxgate") != std::string::npos;
}

// Rule packs of the revision where they lie in a repository, else of today.
class RuleReader : public calc::FileReader {
 public:
  explicit RuleReader(
      std::function<const git::GitTreeReader*(const std::string& path)> repository_of)
      : repository_of_(std::move(repository_of)) {}

  calc::FileContent read_within(const std::string& folder, const std::string& path) const override {
    const git::GitTreeReader* repository = repository_of_(path);
    return repository != nullptr ? repository->read_within(folder, path)
                                 : disk_.read_within(folder, path);
  }

 private:
  std::function<const git::GitTreeReader*(const std::string& path)> repository_of_;
  calc::DiskFileReader disk_;
};

}  // namespace

std::optional<OldState> OldState::open_or_print(const ProjectOptions& input,
                                                const std::string& revision,
                                                const git::GitPlaces& places,
                                                const calc::FileReader& now) {
  OldState state;
  state.revision_ = revision;
  std::set<std::string> problems;
  std::vector<std::string> folders = input.folders;
  for (const std::string& path : input.projects) {
    std::string problem;
    Project project{path, path, state.open(path, places, problem)};
    if (project.files == nullptr) {
      if (problems.insert(problem).second) {
        print_error(calc::DiagnosticId::revision_not_available, revision, problem);
      }
      continue;
    }
    project.was_there = project.files->has(path);
    if (!project.files->names_in(path).empty()) {  // a folder of that name, in which projects were
      project.was_there = false;
      folders.push_back(path);
    }
    project.is_there_now = is_there(path);
    state.projects_.push_back(std::move(project));
  }
  if (!problems.empty()) return std::nullopt;
  std::string problem = state.find_moved(now);
  if (problem.empty()) problem = state.find_gone(folders);
  if (problem.empty()) problem = state.problem_with_settings(input.config);
  if (!problem.empty()) {
    print_error(calc::DiagnosticId::revision_not_available, revision, problem);
    return std::nullopt;
  }
  for (const Project& project : state.projects_) {
    if (!project.was_there && project.is_there_now) {
      state.notes_.push_back(
          calc::say<calc::Sentence::project_is_new>(calc::Message::path(project.path), revision));
    } else if (!project.is_there_now && project.was_there) {
      state.notes_.push_back(
          calc::say<calc::Sentence::project_is_gone>(calc::Message::path(project.path), revision));
    } else if (project.path_then != project.path) {
      state.notes_.push_back(calc::say<calc::Sentence::project_compared_with>(
          calc::Message::path(project.path),
          calc::Message::path(state.shown(project.path_then, project.files))));
    }
  }
  state.find_rules(input.rule_files, places);
  return state;
}

const git::GitTreeReader* OldState::open(const std::string& project, const git::GitPlaces& places,
                                         std::string& problem) {
  std::unique_ptr<git::GitTreeReader> reader =
      git::GitTreeReader::open(project, revision_, places, problem);
  if (reader == nullptr) return nullptr;
  const auto known =
      std::find_if(repositories_.begin(), repositories_.end(),
                   [&](const auto& repository) { return repository->root() == reader->root(); });
  if (known != repositories_.end()) return known->get();
  return repositories_.emplace_back(std::move(reader)).get();
}

// A project that is new may be one that is gone, by another name: what it asks less would not be
// seen otherwise.
std::string OldState::find_moved(const calc::FileReader& now) {
  for (const auto& repository : repositories_) {
    std::vector<Project*> added;
    std::vector<std::string> texts_now;
    for (Project& project : projects_) {
      if (project.was_there || !project.is_there_now || project.files != repository.get()) continue;
      calc::FileContent content = now.read(project.path);
      if (!content.ok()) continue;
      added.push_back(&project);
      texts_now.push_back(std::move(content.bytes));
    }
    if (added.empty()) continue;
    const auto files = repository->files_in(repository->root(), has_project_name,
                                            [](const std::string&) { return true; });
    if (!files) return too_many_files(repository->root());
    std::vector<std::string> gone, texts_gone;
    for (const std::string& inside : *files) {
      const std::string path = repository->root() + "/" + inside;
      if (is_there(path)) continue;
      calc::FileContent content = repository->read(path);
      if (!content.ok() || !looks_like_project(content.bytes)) continue;
      gone.push_back(path);
      texts_gone.push_back(std::move(content.bytes));
    }
    const auto matches = git::match_moved(texts_now, texts_gone);
    for (std::size_t k = 0; k < added.size(); ++k) {
      if (!matches[k]) continue;
      added[k]->path_then = named_like(added[k]->path, gone[*matches[k]]);
      added[k]->was_there = true;
    }
  }
  return "";
}

// Both sides are judged by the settings of where the projects lie now, as they were then. Who moves
// a design must not leave strict ones behind.
std::string OldState::problem_with_settings(const ConfigChoice& choice) const {
  if (choice.is_off || !choice.file.empty()) return "";
  const Project* first = nullptr;
  for (const Project& project : projects_) {
    if (project.is_there_now && first == nullptr) first = &project;
  }
  for (const Project& project : projects_) {
    const bool is_elsewhere = project.path_then != project.path || project.is_gone;
    if (!project.was_there || !is_elsewhere || first == nullptr) continue;
    const std::string now = settings_of(*first->files, first->path);
    const std::string then = settings_of(*project.files, project.path_then);
    if (now == then) continue;
    const auto named = [](const std::string& file) { return file.empty() ? "none" : file; };
    return fmt::format(
        "the settings of '{}' have changed ({} then, {} now): give --config FILE or --no-config",
        project.path_then, named(then), named(now));
  }
  return "";
}

// Who asks for a folder asks for what was in it: a design that is deleted asks for nothing any
// more.
std::string OldState::find_gone(const std::vector<std::string>& folders) {
  std::set<std::string> known;
  for (const Project& project : projects_) {
    for (const std::string& path : {project.path, project.path_then}) {
      const auto inside = project.files->path_in_repository(path);
      if (inside) known.insert(project.files->root() + "/" + *inside);
    }
  }
  std::string problem = open_submodules(folders);
  if (!problem.empty()) return problem;
  for (const std::string& asked : folders) {
    for (const auto& repository : repositories_) {
      const std::string folder = folder_in(*repository, asked);
      // As folders are read: names that begin with a point are left alone.
      const auto is_shown = [](const std::string& name) { return !name.starts_with('.'); };
      const auto is_wanted = [&](const std::string& name) {
        return is_shown(name) && has_project_name(name);
      };
      const auto files = repository->files_in(folder, is_wanted, is_shown);
      if (!files) return too_many_files(folder);
      for (const std::string& inside : *files) {
        const std::string path = repository->root() + "/" + inside;
        // A file that is there, but is no project any more, is gone as well.
        if (!known.insert(path).second) continue;
        const calc::FileContent content = repository->read(path);
        // What cannot be told counts: nothing is lost by a word too many.
        if (content.ok() && !may_be_project(content.bytes)) continue;
        const std::string name = named_like(folder, path);
        projects_.push_back({name, name, repository.get(), false, true, true});
      }
    }
  }
  return "";
}

// A submodule that has no project any more, or is gone, may have had some.
std::string OldState::open_submodules(const std::vector<std::string>& folders) {
  for (std::size_t k = 0; k < repositories_.size(); ++k) {
    for (const std::string& asked : folders) {
      const std::string folder = folder_in(*repositories_[k], asked);
      const auto submodules = repositories_[k]->submodules_in(folder);
      if (!submodules) return too_many_files(folder);
      for (const std::string& inside : *submodules) {
        const std::string path = repositories_[k]->root() + "/" + inside;
        const auto is_known = [&](const auto& one) { return one->root() == path; };
        if (std::any_of(repositories_.begin(), repositories_.end(), is_known)) continue;
        const std::string commit = repositories_[k]->submodule_commit(path);
        if (commit == repositories_[k]->staged_submodule_commit(path)) continue;  // as it was
        std::string why;
        auto reader = git::GitTreeReader::open_alone(path + "/-", commit, {}, why);
        if (reader == nullptr || reader->root() != path) {
          return fmt::format(
              "the submodule '{}' of this revision cannot be read, and may have had projects: "
              "restore it, or check without --against",
              inside);
        }
        repositories_.push_back(std::move(reader));
      }
    }
  }
  return "";
}

// Those in a repository are questions of the revision, too; others are as they are now.
void OldState::find_rules(const std::vector<std::string>& paths, const git::GitPlaces& places) {
  for (const std::string& path : paths) {
    // Of a submodule of one of the designs' repositories: those that it had.
    std::string ignored;
    auto own = git::GitTreeReader::open(path, revision_, places, ignored);
    const auto is_within = [&](const auto& one) {
      return own->root().starts_with(one->root() + "/");
    };
    const auto is_same = [&](const auto& one) { return own->root() == one->root(); };
    if (own != nullptr && std::any_of(repositories_.begin(), repositories_.end(), is_within) &&
        std::none_of(repositories_.begin(), repositories_.end(), is_same)) {
      repositories_.push_back(std::move(own));
    }
    const git::GitTreeReader* repository = repository_of(path);
    if (repository == nullptr) {
      rule_files_.push_back(path);
      continue;
    }
    const std::vector<std::string> names = repository->names_in(path);
    if (names.empty() && repository->has(path)) {
      rule_files_.push_back(path);
      continue;
    }
    const std::size_t before = rule_files_.size();
    for (const std::string& name : names) {
      const std::filesystem::path file = std::filesystem::path(path) / name;
      if (file.extension() == ".xml") rule_files_.push_back(file.string());
    }
    if (rule_files_.size() == before) {
      notes_.push_back(
          calc::say<calc::Sentence::rules_are_new>(calc::Message::path(path), revision_));
    }
  }
}

// Of several, one inside the other, the innermost.
const git::GitTreeReader* OldState::repository_of(const std::string& path) const {
  const git::GitTreeReader* innermost = nullptr;
  for (const auto& repository : repositories_) {
    if (!repository->path_in_repository(path)) continue;
    if (innermost == nullptr || repository->root().size() > innermost->root().size()) {
      innermost = repository.get();
    }
  }
  return innermost;
}

// "main:designs/a.xml", as git has it.
std::string OldState::shown(const std::string& file, const git::GitTreeReader* files) const {
  const auto inside = files != nullptr ? files->path_in_repository(file) : std::nullopt;
  return inside ? fmt::format("{}:{}", revision_, *inside) : file;
}

void OldState::print_errors(const std::vector<calc::Diagnostic>& diagnostics) const {
  std::vector<calc::Diagnostic> renamed = diagnostics;
  for (calc::Diagnostic& diagnostic : renamed) {
    std::string& file = diagnostic.where.file;
    file = file.empty() ? revision_ : shown(file, repository_of(file));
  }
  print_diagnostics(renamed, true);
}

std::optional<std::vector<report::ProjectPart>> OldState::check(
    const check::Run& run, const CheckOne& check_one, const std::function<bool()>& go_on) const {
  const std::size_t failures_before = failures();
  const RuleReader rules([this](const std::string& path) { return repository_of(path); });
  calc::Diagnostics diagnostics;
  const check::Run then = run.with_packs(check::load_rule_packs(rule_files_, rules, diagnostics));
  print_errors(diagnostics.all());
  std::vector<report::ProjectPart> parts;
  std::vector<report::ProjectPart> begun(projects_.size());
  const auto work = [&](std::size_t k) {
    const Project& project = projects_[k];
    if (!project.is_checked()) return;
    begun[k] = check_one(project.path_then, then.with_files(*project.files),
                         shown(project.path_then, project.files));
  };
  const auto deliver = [&](std::size_t k) {
    if (!projects_[k].was_there) return;
    begun[k].path = projects_[k].path;
    parts.push_back(std::move(begun[k]));
  };
  check::in_order(projects_.size(), run.concurrency(), work, deliver, go_on);
  for (const report::ProjectPart& part : parts) print_errors(part.diagnostics);
  if (!go_on()) return parts;
  if (failures() == failures_before) return parts;
  print_error(calc::DiagnosticId::revision_not_available, revision_,
              "the files named above cannot be read in this revision: nothing was compared");
  return std::nullopt;
}

bool OldState::is_unchanged_head(const calc::FileReader& now) const {
  const auto is_same = [&](const std::string& path) {
    const git::GitTreeReader* repository = repository_of(path);
    if (repository == nullptr) return true;
    const calc::FileContent then = repository->read(path), today = now.read(path);
    return then.ok() && today.ok() && then.bytes == today.bytes;
  };
  return std::all_of(repositories_.begin(), repositories_.end(),
                     [](const auto& repository) { return repository->is_unchanged_head(); }) &&
         std::all_of(rule_files_.begin(), rule_files_.end(), is_same);
}

std::size_t OldState::project_count() const {
  return static_cast<std::size_t>(
      std::count_if(projects_.begin(), projects_.end(),
                    [](const Project& project) { return project.is_checked(); }));
}

std::size_t OldState::failures() const {
  std::size_t sum = 0;
  for (const auto& repository : repositories_) sum += repository->failures();
  return sum;
}

std::vector<std::string> OldState::commits() const {
  std::vector<std::string> ids;
  for (const auto& repository : repositories_) ids.push_back(repository->commit());
  return ids;
}

}  // namespace cli
