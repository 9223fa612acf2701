#include "report/git/repository_places.h"

#include "report/git/git_handles.h"
#include "report/git/open_repository.h"

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

// Files that are there, what they include, and what else they name.
void add_settings(git_repository* repository, std::vector<std::string>& places) {
  const std::string common = git_repository_commondir(repository);
  Included included{home_of_settings(), {fs::path(common)}, &places};
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
  git_config* config = nullptr;
  if (git_repository_config_snapshot(&config, repository) != 0) return;
  const Config owned(config);
  git_config_foreach_match(config, "^include(if\\..*)?\\.path$", note_included, &included);
  git_config_foreach_match(config, "^core\\.attributesfile$", note_included, &included);
  const char* storage = nullptr;
  if (git_config_get_string(&storage, config, "lfs.storage") == 0) {
    places.push_back((fs::path(common) / storage).string());
  }
}

}  // namespace

std::vector<std::string> repository_places(const std::string& file, const GitPlaces& places) {
  const Library library;
  std::string problem;
  const std::optional<OpenedRepository> opened = open_repository(file, places, problem);
  if (!opened) return {};
  git_repository* const repository = opened->repository.get();
  const std::string common = git_repository_commondir(repository);
  std::vector<std::string> all{git_repository_path(repository), common,
                               (fs::path(opened->root) / ".git").string()};
  const std::set<std::string> objects = object_folders((fs::path(common) / "objects").string());
  all.insert(all.end(), objects.begin(), objects.end());
  add_settings(repository, all);
  return all;
}

}  // namespace git
