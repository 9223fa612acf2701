#include "report/git/open_repository.h"

#include "report/text/shell_words.h"

#include <fmt/format.h>
#include <git2/sys/repository.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace git {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSinceItLeft = "...";  // as 'git diff main...' has it
constexpr const char* kAllowed =
    "a branch, a tag, the id of a commit, one of these followed by ~1, or 'main...', the commit "
    "at which HEAD has left main";

// The closest folder at or above the one of `file` that exists: files and their folders may be
// gone.
std::string existing_folder_of(const std::string& file) {
  std::error_code ignored;
  fs::path folder = fs::path(absolute_path(file)).parent_path();
  while (!fs::is_directory(folder, ignored) && folder.has_relative_path()) {
    folder = folder.parent_path();
  }
  return folder.string();
}

// libgit2 1.5 may say of a foreign repository that the setting which would allow it was not found.
bool is_about_owner(int error) {
  return error == GIT_EOWNER || (error != 0 && said().find("safe.directory") != std::string::npos);
}

int note_safe_folder(const git_config_entry* entry, void* all) {
  *static_cast<bool*>(all) = std::string_view(entry->value) == "*";  // an empty one starts anew
  return 0;
}

// safe.directory = *: libgit2 1.5 knows single folders only.
bool are_all_folders_safe() {
  git_config* config = nullptr;
  if (git_config_open_default(&config) != 0) return false;
  const Config owned(config);
  bool all = false;
  git_config_get_multivar_foreach(config, "safe.directory", "^(\\*|)$", note_safe_folder, &all);
  return all;
}

// For somebody who has been asked already. The switch is one for the whole process.
class WithoutOwnerCheck {
 public:
  WithoutOwnerCheck() { git_libgit2_opts(GIT_OPT_SET_OWNER_VALIDATION, 0); }
  ~WithoutOwnerCheck() { git_libgit2_opts(GIT_OPT_SET_OWNER_VALIDATION, 1); }
  WithoutOwnerCheck(const WithoutOwnerCheck&) = delete;
  WithoutOwnerCheck& operator=(const WithoutOwnerCheck&) = delete;
};

int open_at(const std::string& place, bool is_named, Repository& opened) {
  git_repository* repository = nullptr;
  const int error = is_named ? git_repository_open(&repository, place.c_str())
                             : git_repository_open_ext(&repository, place.c_str(),
                                                       GIT_REPOSITORY_OPEN_CROSS_FS, nullptr);
  opened.reset(repository);
  return error;
}

// What git wants to be named as safe.
std::string folder_of_repository(const std::string& place) {
  std::error_code ignored;
  const fs::path whole = absolute_path(place);
  if (whole.filename() == ".git") return whole.parent_path().string();
  for (fs::path folder = whole; folder.has_relative_path(); folder = folder.parent_path()) {
    if (fs::exists(folder / ".git", ignored)) return folder.string();
  }
  return whole.string();
}

std::string repository_problem(int error, const std::string& place, bool is_named) {
  const std::string words = said();
  const std::string whose = (is_named ? "GIT_DIR, '" : "the git repository of '") + place + "',";
  if (is_about_owner(error)) {
    return fmt::format(
        "{} belongs to another user and is not read; if you trust it: git config --global --add "
        "safe.directory {}",
        whose, report::shell_quoted(folder_of_repository(place)));
  }
  if (error == GIT_ENOTFOUND) {
    return fmt::format("'{}' is not in a git repository{}", place,
                       is_named ? ": GIT_DIR names it and must name a repository" : "");
  }
  // libgit2 has no code for it; 1.5 speaks of the extension, 1.9 of the object format.
  if (words.find("extension") != std::string::npos || words.find("version") != std::string::npos ||
      words.find("object format") != std::string::npos) {
    return fmt::format(
        "{} has a format that luxgate does not read, for example SHA-256 ids; allowed: SHA-1 "
        "ids{}",
        whose, words);
  }
  return fmt::format("{} cannot be read{}", whose, words);
}

std::string unknown_revision(git_repository* repository, int error, const std::string& revision,
                             const std::string& root) {
  if (error == GIT_EAMBIGUOUS) {
    return fmt::format("'{}' is ambiguous in {}; give more digits", revision, root);
  }
  const std::string words = said();
  const std::string remote = "refs/remotes/origin/" + revision;
  git_object* found = nullptr;
  if (git_revparse_single(&found, repository, remote.c_str()) == 0) {
    const Object owned(found);
    return fmt::format("{} has no '{}', but it has '{}'; use --against {}", root, revision, remote,
                       remote);
  }
  return fmt::format("{} has no commit '{}'; allowed: {}{}{}", root, revision, kAllowed,
                     shallow_advice(repository), words);
}

std::optional<git_oid> commit_of(git_object* object) {
  git_object* commit = nullptr;
  if (git_object_peel(&commit, object, GIT_OBJECT_COMMIT) != 0) return std::nullopt;
  return *git_object_id(Object(commit).get());
}

std::optional<git_oid> commit_of_reference(git_repository* repository, const std::string& name) {
  git_reference* reference = nullptr;
  if (git_reference_lookup(&reference, repository, name.c_str()) != 0) return std::nullopt;
  const Reference owned(reference);
  git_object* object = nullptr;
  if (git_reference_peel(&object, reference, GIT_OBJECT_COMMIT) != 0) return std::nullopt;
  return commit_of(Object(object).get());
}

bool is_hexadecimal(std::string_view text) {
  return text.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
}

// Git takes the first of several that have a name, a tag before a remote's branch: who may push
// tags could choose what a design is compared with. "" or why the name is refused.
std::string problem_with_name(git_repository* repository, const std::string& revision,
                              const std::string& root) {
  std::size_t end = std::min(revision.find_first_of("~^:"), revision.find("@{"));
  const std::string name = revision.substr(0, end);
  if (name.empty() || name == "HEAD" || name == "@") return "";
  const bool is_id = name.size() == GIT_OID_HEXSZ && is_hexadecimal(name);
  std::vector<std::pair<std::string, git_oid>> found;
  if (name.size() >= GIT_OID_MINPREFIXLEN && name.size() <= GIT_OID_HEXSZ && is_hexadecimal(name)) {
    git_oid prefix;
    git_object* object = nullptr;
    if (git_oid_fromstrn(&prefix, name.c_str(), name.size()) == 0 &&
        git_object_lookup_prefix(&object, repository, &prefix, name.size(), GIT_OBJECT_ANY) == 0) {
      const Object owned(object);
      if (const auto id = commit_of(object)) found.emplace_back("the commit " + hex_of(*id), *id);
    }
    if (is_id && found.empty()) return fmt::format("{} has no commit {}", root, name);
  }
  const bool is_full = name.starts_with("refs/");
  const auto own = commit_of_reference(repository, name);
  if (is_full && own) return "";
  if (is_full) return fmt::format("{} has no '{}'", root, name);
  if (is_id) return "";
  for (const std::string& full : {"refs/" + name, "refs/tags/" + name, "refs/heads/" + name,
                                  "refs/remotes/" + name, "refs/remotes/" + name + "/HEAD"}) {
    if (const auto id = commit_of_reference(repository, full)) {
      found.emplace_back(fmt::format("'{}' ({:.10})", full, hex_of(*id)), *id);
    }
  }
  const auto is_other = [&](const auto& one) {
    return git_oid_equal(&one.second, &found.front().second) == 0;
  };
  const auto other = std::find_if(found.begin(), found.end(), is_other);
  if (other == found.end()) return "";
  return fmt::format("'{}' is the name of several commits of {}: {} and {}; write the full name",
                     name, root, found.front().first, other->first);
}

std::optional<git_oid> find_named(git_repository* repository, const std::string& revision,
                                  const std::string& root, std::string& problem) {
  problem = problem_with_name(repository, revision, root);
  if (!problem.empty()) {
    problem += shallow_advice(repository);
    return std::nullopt;
  }
  git_object* found = nullptr;
  if (const int error = git_revparse_single(&found, repository, revision.c_str()); error != 0) {
    problem = unknown_revision(repository, error, revision, root);
    return std::nullopt;
  }
  const Object named(found);
  const auto commit = commit_of(found);
  if (!commit) {
    problem = fmt::format("'{}' is a {}, not a commit; allowed: {}", revision,
                          git_object_type2string(git_object_type(found)), kAllowed);
  }
  return commit;
}

}  // namespace

std::string absolute_path(const std::string& path) {
  std::error_code ignored;
  const fs::path whole = fs::absolute(path.empty() ? "." : path, ignored).lexically_normal();
  const std::string text = whole.string();
  return text.size() > 1 && text.back() == '/' ? text.substr(0, text.size() - 1) : text;
}

std::string canonical_folder(const std::string& path) {
  std::error_code error;
  const fs::path canonical = fs::canonical(path, error);
  return error ? absolute_path(path) : absolute_path(canonical.string());
}

std::string shallow_advice(git_repository* repository) {
  if (git_repository_is_shallow(repository) != 1) return "";
  return "; this is a shallow clone, which lacks older commits and other branches: 'git fetch "
         "--unshallow' brings them, in CI 'fetch-depth: 0' of actions/checkout (GitHub) or the "
         "variable GIT_DEPTH: \"0\" (GitLab)";
}

std::optional<OpenedRepository> open_repository(const std::string& file, const GitPlaces& places,
                                                std::string& problem) {
  const bool is_named = !places.git_dir.empty();
  const std::string place = is_named ? places.git_dir : existing_folder_of(file);
  OpenedRepository opened;
  int error = open_at(place, is_named, opened.repository);
  if (is_about_owner(error) && are_all_folders_safe()) {
    const WithoutOwnerCheck trusted;
    error = open_at(place, is_named, opened.repository);
  }
  if (error != 0) {
    problem = repository_problem(error, place, is_named);
    return std::nullopt;
  }
  const char* work_tree = git_repository_workdir(opened.repository.get());
  if (is_named && !places.work_tree.empty()) {
    opened.root = canonical_folder(places.work_tree);
  } else if (work_tree != nullptr) {
    opened.root = canonical_folder(work_tree);
  } else if (is_named) {
    opened.root = canonical_folder(".");
  } else {
    problem = fmt::format(
        "'{}' is in a bare git repository, which has no work tree. Check files of a 'git "
        "worktree' of it, or set GIT_DIR and GIT_WORK_TREE",
        file);
    return std::nullopt;
  }
  return opened;
}

Repository open_without_work_tree(git_repository* repository) {
  const WithoutOwnerCheck checked_when_it_was_opened;
  git_repository* found = nullptr;
  git_repository_open_ext(&found, git_repository_commondir(repository),
                          GIT_REPOSITORY_OPEN_BARE | GIT_REPOSITORY_OPEN_NO_SEARCH, nullptr);
  Repository bare(found);
  git_index* index = nullptr;
  if (bare == nullptr || git_index_new(&index) != 0) return nullptr;
  const Index empty(index);
  if (git_repository_set_index(bare.get(), index) != 0) return nullptr;
  return bare;
}

std::optional<git_oid> find_commit(git_repository* repository, const std::string& revision,
                                   const std::string& root, std::string& problem) {
  if (!revision.ends_with(kSinceItLeft)) return find_named(repository, revision, root, problem);
  const std::string other = revision.substr(0, revision.size() - kSinceItLeft.size());
  const auto theirs = find_named(repository, other, root, problem);
  if (!theirs) return std::nullopt;
  const auto ours = find_named(repository, "HEAD", root, problem);
  if (!ours) return std::nullopt;
  git_oid base;
  if (git_merge_base(&base, repository, &*ours, &*theirs) != 0) {
    problem = fmt::format("HEAD and '{}' of {} have no commit in common{}", other, root,
                          shallow_advice(repository));
    return std::nullopt;
  }
  return base;
}

}  // namespace git
