#include "report/git/repository_places.h"

#include "report/git/git_handles.h"
#include "report/git/open_repository.h"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <utility>

namespace git {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostLenders = 100;

// Of folders with objects: those and the ones that lend them more.
std::set<std::string> object_folders(const std::string& first) {
  std::set<std::string> known;
  std::vector<std::string> rest{first};
  while (!rest.empty() && known.size() < kMostLenders) {
    const std::string folder = std::move(rest.back());
    rest.pop_back();
    if (!known.insert(folder).second) continue;
    std::ifstream lenders(fs::path(folder) / "info" / "alternates");
    for (std::string line; std::getline(lenders, line);) {
      if (!line.empty() && line.front() != '#') rest.push_back((fs::path(folder) / line).string());
    }
  }
  return known;
}

std::string home_of_settings() {
  git_buf folders = GIT_BUF_INIT;
  std::string first;
  if (git_libgit2_opts(GIT_OPT_GET_SEARCH_PATH, GIT_CONFIG_LEVEL_GLOBAL, &folders) == 0) {
    first = folders.ptr;
    first = first.substr(0, first.find(GIT_PATH_LIST_SEPARATOR));
  }
  git_buf_dispose(&folders);
  return first;
}

struct Included {
  std::string home;
  std::vector<fs::path> folders;  // of the files that include
  std::vector<std::string>* places;
};

int note_included(const git_config_entry* entry, void* all) {
  const auto& included = *static_cast<Included*>(all);
  const std::string named = entry->value == nullptr ? "" : entry->value;
  if (named.starts_with("~/")) {
    included.places->push_back(included.home + named.substr(1));
    return 0;
  }
  for (const fs::path& folder : included.folders) {
    if (!named.empty()) included.places->push_back((folder / named).string());
  }
  return 0;
}

// Files that are there, what they include, and what else they name. common: the repository's
// folder; "" = it could not be opened. config: then the user's.
void add_settings(git_config* config, const std::string& common, std::vector<std::string>& places) {
  Included included{home_of_settings(), {}, &places};
  if (!common.empty()) included.folders.emplace_back(common);
  for (const auto find : {git_config_find_programdata, git_config_find_system, git_config_find_xdg,
                          git_config_find_global}) {
    git_buf path = GIT_BUF_INIT;
    if (find(&path) == 0) {
      places.emplace_back(path.ptr);
      included.folders.push_back(fs::path(path.ptr).parent_path());
    }
    git_buf_dispose(&path);
  }
  // The user's attributes lie there.
  if (!included.home.empty()) {
    places.push_back((fs::path(included.home) / ".config" / "git").string());
  }
  if (config == nullptr) return;
  git_config_foreach_match(config, "^include(if\\..*)?\\.path$", note_included, &included);
  git_config_foreach_match(config, "^core\\.attributesfile$", note_included, &included);
  const char* storage = nullptr;
  if (!common.empty() && git_config_get_string(&storage, config, "lfs.storage") == 0) {
    places.push_back((fs::path(common) / storage).string());
  }
}

// Of a repository that cannot be opened: it is asked again later, and must give the same reason.
std::string found_folder(const std::string& file) {
  std::string found;
  for (fs::path folder = absolute_path(file); found.empty() && folder.has_relative_path();) {
    folder = folder.parent_path();
    git_buf path = GIT_BUF_INIT;
    if (git_repository_discover(&path, folder.c_str(), 1, nullptr) == 0) found = path.ptr;
    git_buf_dispose(&path);
  }
  return found;
}

}  // namespace

std::vector<std::string> repository_places(const std::string& file, const GitPlaces& places) {
  const Library library;
  std::vector<std::string> all;
  git_config* config = nullptr;
  std::string problem;
  const std::optional<OpenedRepository> opened = open_repository(file, places, problem);
  if (!opened) {
    const int failure = git_config_open_default(&config);
    const Config owned(failure == 0 ? config : nullptr);
    add_settings(owned.get(), "", all);
    all.push_back(places.git_dir.empty() ? found_folder(file) : places.git_dir);
    return all;
  }
  git_repository* const repository = opened->repository.get();
  const std::string common = git_repository_commondir(repository);
  all = {git_repository_path(repository), common, (fs::path(opened->root) / ".git").string()};
  const std::set<std::string> objects = object_folders((fs::path(common) / "objects").string());
  all.insert(all.end(), objects.begin(), objects.end());
  const int failure = git_repository_config_snapshot(&config, repository);
  const Config owned(failure == 0 ? config : nullptr);
  add_settings(owned.get(), common, all);
  // Of a submodule the repository around it says which commit it was.
  std::optional<OpenedRepository> around;
  if (places.git_dir.empty()) around = open_repository(opened->root, places, problem);
  if (around && around->root != opened->root) {
    for (std::string& place : repository_places(opened->root, places)) {
      all.push_back(std::move(place));
    }
  }
  return all;
}

}  // namespace git
