#include "report/git/git_tree_reader.h"

#include "report/git/lfs_pointer.h"
#include "report/git/open_repository.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <mutex>
#include <string_view>
#include <system_error>
#include <utility>

namespace git {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostBlobBytes = std::uintmax_t{512} << 20;  // as DiskFileReader
constexpr int kMostLinks = 40;                                        // as Linux
constexpr std::size_t kMostPathBytes = 4096;

// What stands behind a path of the tree.
struct Found {
  enum class Kind { none, file, folder } kind = Kind::none;
  git_oid id{};
  std::string path;   // links followed
  std::string error;  // it is there and cannot be had: why, in words; else ""
};

// Of a path of the tree, the last one first.
std::vector<std::string> parts_reversed(const std::string& path) {
  std::vector<std::string> parts;
  for (const fs::path& part : fs::path(path)) {
    if (!part.empty() && part != ".") parts.push_back(part.string());
  }
  std::reverse(parts.begin(), parts.end());
  return parts;
}

}  // namespace

struct GitTreeReader::State {
  using Wanted = GitTreeReader::Wanted;

  std::mutex mutex;  // of read()
  Library library;   // before all that is freed by it
  Repository repository;
  Repository bare;  // the same without work tree and index
  git_oid commit_id{};
  git_oid tree_id{};
  std::string root, commit, index_file;
  mutable std::size_t failures = 0;

  // Null: the caller says unreadable().
  Tree tree_of(const git_oid& id) const {
    git_tree* tree = nullptr;
    return Tree(git_tree_lookup(&tree, repository.get(), &id) == 0 ? tree : nullptr);
  }
  Blob blob_of(const git_oid& id) const {
    git_blob* blob = nullptr;
    return Blob(git_blob_lookup(&blob, bare.get(), &id) == 0 ? blob : nullptr);
  }

  // Why there is no object of `path`: at once after the attempt.
  std::string unreadable(const git_oid& id, const std::string& path) const {
    const std::string words = said();
    git_odb* store = nullptr;
    if (git_repository_odb(&store, repository.get()) == 0 &&
        git_odb_exists(ObjectStore(store).get(), &id) == 1) {
      return fmt::format("its object {} is damaged; 'git fsck' says more{}", hex_of(id), words);
    }
    const std::string advice =
        is_partial()
            ? fmt::format("; this is a partial clone: 'git show {}:{}' fetches it", commit, path)
            : shallow_advice(repository.get());
    return fmt::format("it is not among the repository's objects{}{}", advice, words);
  }

  // By the extension, or by a remote that promises what is lacking: git 2.39 writes this alone.
  bool is_partial() const {
    if (!setting("extensions.partialclone").empty()) return true;
    git_config* config = nullptr;
    if (git_repository_config_snapshot(&config, repository.get()) != 0) return false;
    const Config owned(config);
    bool found = false;
    const auto note = [](const git_config_entry* entry, void* is_found) {
      *static_cast<bool*>(is_found) = std::string_view(entry->value) == "true";
      return *static_cast<bool*>(is_found) ? 1 : 0;
    };
    git_config_foreach_match(config, "^remote\\..*\\.promisor$", note, &found);
    return found;
  }

  bool is_too_large(const git_oid& id) const {
    git_odb* store = nullptr;
    if (git_repository_odb(&store, repository.get()) != 0) return false;
    const ObjectStore owned(store);
    std::size_t size = 0;
    git_object_t type = GIT_OBJECT_INVALID;
    return git_odb_read_header(&size, &type, store, &id) == 0 && size > kMostBlobBytes;
  }

  static Found failure(std::string path, std::string words) {
    Found found;
    found.path = std::move(path);
    found.error = std::move(words);
    return found;
  }

  // path: from the root. Links are followed inside the tree.
  Found find(const std::string& path) const {
    std::vector<std::string> rest = parts_reversed(path), done;
    std::vector<git_oid> folders{tree_id};
    std::string link;  // the last one
    int links = 0;
    while (!rest.empty()) {
      const std::string part = rest.back();
      rest.pop_back();
      if (part == "..") {
        if (done.empty()) {
          return failure(
              path,
              fmt::format("the symbolic link '{}' leads out of the repository and is not followed",
                          link));
        }
        done.pop_back();
        folders.pop_back();
        continue;
      }
      done.push_back(part);
      const std::string place = fmt::format("{}", fmt::join(done, "/"));
      const Tree tree = tree_of(folders.back());
      if (tree == nullptr) return failure(place, unreadable(folders.back(), place));
      const git_tree_entry* entry = git_tree_entry_byname(tree.get(), part.c_str());
      if (entry == nullptr) return {};
      const git_oid id = *git_tree_entry_id(entry);
      switch (git_tree_entry_filemode(entry)) {
        case GIT_FILEMODE_TREE:
          folders.push_back(id);
          break;
        case GIT_FILEMODE_COMMIT:
          return failure(place,
                         fmt::format("it is in the submodule '{}', whose files are not among "
                                     "the repository's objects",
                                     place));
        case GIT_FILEMODE_LINK: {
          if (++links > kMostLinks) {
            return failure(place, "symbolic links lead to each other in a circle");
          }
          const Blob blob = blob_of(id);
          if (blob == nullptr) return failure(place, unreadable(id, place));
          const std::string target(static_cast<const char*>(git_blob_rawcontent(blob.get())),
                                   static_cast<std::size_t>(git_blob_rawsize(blob.get())));
          if (target.starts_with('/')) {
            return failure(
                place,
                fmt::format("the symbolic link '{}' has an absolute path and is not followed",
                            place));
          }
          link = place;
          done.pop_back();
          const std::vector<std::string> more = parts_reversed(target);
          rest.insert(rest.end(), more.begin(), more.end());
          break;
        }
        default:
          if (!rest.empty()) return {};
          return {Found::Kind::file, id, place, ""};
      }
    }
    return {Found::Kind::folder, folders.back(), fmt::format("{}", fmt::join(done, "/")), ""};
  }

  calc::FileContent failed(std::string words) const {
    ++failures;
    return {{}, std::move(words)};
  }

  calc::FileContent read(const Found& file) const {
    if (is_too_large(file.id)) return {{}, "it is larger than 512 MiB"};
    const Blob blob = blob_of(file.id);
    if (blob == nullptr) return failed(unreadable(file.id, file.path));
    if (std::string why = needs_program(file.path); !why.empty()) return failed(std::move(why));
    git_blob_filter_options options{};
    options.version = GIT_BLOB_FILTER_OPTIONS_VERSION;
    options.flags = GIT_BLOB_FILTER_ATTRIBUTES_FROM_COMMIT;  // binary ones, too, if they say so
    options.attr_commit_id = commit_id;
    git_buf bytes = GIT_BUF_INIT;
    if (git_blob_filter(&bytes, blob.get(), file.path.c_str(), &options) != 0) {
      return failed("its line endings cannot be converted to those of a checkout" + said());
    }
    calc::FileContent content{std::string(bytes.ptr, bytes.size), ""};
    git_buf_dispose(&bytes);
    if (!is_lfs_pointer(content.bytes)) return content;
    const std::optional<LfsPointer> pointer = parse_lfs_pointer(content.bytes);
    if (!pointer) return failed("it is a Git LFS pointer without a SHA-256 and a size");
    content = read_lfs_object(*pointer, lfs_storage(), commit);
    if (!content.ok()) ++failures;
    return content;
  }

  // A checkout has some files written by programs, or in another encoding: none is started here,
  // and what git holds is not what was checked then. "" of others.
  std::string needs_program(const std::string& path) const {
    git_attr_options options{};
    options.version = GIT_ATTR_OPTIONS_VERSION;
    options.flags = GIT_ATTR_CHECK_INCLUDE_COMMIT;
    options.attr_commit_id = commit_id;
    const char* names[] = {"working-tree-encoding", "filter"};
    const char* values[] = {nullptr, nullptr};
    if (git_attr_get_many_ext(values, bare.get(), &options, path.c_str(), std::size(names),
                              names) != 0) {
      return "its .gitattributes cannot be read" + said();
    }
    if (git_attr_value(values[0]) == GIT_ATTR_VALUE_STRING) {
      return fmt::format(
          ".gitattributes sets working-tree-encoding to {}, which luxgate does "
          "not support",
          values[0]);
    }
    if (git_attr_value(values[1]) != GIT_ATTR_VALUE_STRING) return "";
    const std::string filter = values[1];
    if (filter == "lfs" || setting("filter." + filter + ".smudge").empty()) return "";
    return fmt::format(
        ".gitattributes sets the filter '{}', a program that luxgate does not start; allowed: "
        "Git LFS",
        filter);
  }

  // Of git's configuration; "" = not set.
  std::string setting(const std::string& name) const {
    git_config* config = nullptr;
    if (git_repository_config_snapshot(&config, repository.get()) != 0) return "";
    const Config owned(config);
    const char* value = nullptr;
    return git_config_get_string(&value, config, name.c_str()) == 0 ? value : "";
  }

  // As lfs.storage says it; all work trees of a repository share it.
  std::string lfs_storage() const {
    const std::string common = git_repository_commondir(repository.get());
    const std::string named = setting("lfs.storage");
    if (named.empty()) return common + "lfs";
    return (fs::path(common) / named).string();
  }

  bool is_unchanged_head() const {
    std::string no_head;
    const auto head = find_commit(repository.get(), "HEAD", root, no_head);
    if (!head || git_oid_equal(&*head, &commit_id) == 0) return false;
    const Tree tree = tree_of(tree_id);
    git_index* index = nullptr;
    // Git names the index of the repository whose hook it is, not of submodules.
    const bool is_own = !index_file.empty() &&
                        canonical_folder(fs::path(absolute_path(index_file)).parent_path()) ==
                            canonical_folder(git_repository_path(repository.get()));
    const int error = is_own ? git_index_open(&index, index_file.c_str())
                             : git_repository_index(&index, repository.get());
    const Index staged(index);
    git_diff* diff = nullptr;
    if (tree == nullptr || error != 0 || git_index_entrycount(index) == 0 ||
        git_diff_tree_to_index(&diff, repository.get(), tree.get(), index, nullptr) != 0) {
      return true;
    }
    return git_diff_num_deltas(Diff(diff).get()) == 0;
  }

  // false: there is more than may be listed, or an object is not at hand.
  bool add_files(const git_oid& folder, const std::string& path, const Wanted& is_file_wanted,
                 const Wanted& is_folder_wanted, std::size_t& listed,
                 std::vector<std::string>& files) const {
    if (path.size() > kMostPathBytes) return true;
    const Tree tree = tree_of(folder);
    if (tree == nullptr) return false;
    for (std::size_t k = 0; k < git_tree_entrycount(tree.get()); ++k) {
      if (++listed > kMostListed) return false;
      const git_tree_entry* entry = git_tree_entry_byindex(tree.get(), k);
      const std::string name = git_tree_entry_name(entry);
      switch (git_tree_entry_filemode(entry)) {
        case GIT_FILEMODE_TREE:
          if (is_folder_wanted(name) &&
              !add_files(*git_tree_entry_id(entry), path + name + "/", is_file_wanted,
                         is_folder_wanted, listed, files)) {
            return false;
          }
          break;
        case GIT_FILEMODE_BLOB:
        case GIT_FILEMODE_BLOB_EXECUTABLE:
        case GIT_FILEMODE_LINK:  // to a project, or to nothing
          if (is_file_wanted(name)) files.push_back(path + name);
          break;
        default:
          break;
      }
    }
    return true;
  }
};

// Which commit the repository of `inner`, which is a submodule of this one now, was at in this
// revision: at its path, or at one where no submodule is any more. "" = it was not there.
std::string GitTreeReader::former_commit(const GitTreeReader& inner) const {
  const std::string at_path = submodule_commit(inner.root());
  if (!at_path.empty()) return at_path;
  const auto submodules = submodules_in(root());
  for (const std::string& path : submodules.value_or(std::vector<std::string>())) {
    const std::string whole = root() + "/" + path;
    if (!staged_submodule_commit(whole).empty()) continue;
    git_oid id;
    git_object* object = nullptr;
    const std::string commit = submodule_commit(whole);
    if (git_oid_fromstr(&id, commit.c_str()) == 0 &&
        git_object_lookup(&object, inner.state_->repository.get(), &id, GIT_OBJECT_COMMIT) == 0) {
      const Object owned(object);
      return commit;
    }
  }
  return "";
}

std::unique_ptr<GitTreeReader> GitTreeReader::open(const std::string& file,
                                                   const std::string& revision,
                                                   const GitPlaces& places, std::string& problem) {
  if (!places.git_dir.empty()) return open_alone(file, revision, places, problem);
  std::string ignored;
  const auto inner = open_alone(file, "HEAD", places, ignored);
  const auto around =
      inner == nullptr ? nullptr : open_alone(inner->root(), "HEAD", places, ignored);
  if (around == nullptr || around->root() == inner->root()) {
    return open_alone(file, revision, places, problem);
  }
  const bool is_submodule = !around->staged_submodule_commit(inner->root()).empty() ||
                            !around->submodule_commit(inner->root()).empty();
  if (!is_submodule) return open_alone(file, revision, places, problem);
  auto outer = open(inner->root(), revision, places, problem);
  if (outer == nullptr) return nullptr;
  const std::string commit = outer->former_commit(*inner);
  return commit.empty() ? std::move(outer) : open_alone(file, commit, places, problem);
}

std::unique_ptr<GitTreeReader> GitTreeReader::open_alone(const std::string& file,
                                                         const std::string& revision,
                                                         const GitPlaces& places,
                                                         std::string& problem) {
  auto state = std::make_unique<State>();
  std::optional<OpenedRepository> opened = open_repository(file, places, problem);
  if (!opened) return nullptr;
  state->repository = std::move(opened->repository);
  state->root = std::move(opened->root);
  state->index_file = places.index_file;
  const auto id = find_commit(state->repository.get(), revision, state->root, problem);
  if (!id) return nullptr;
  state->commit_id = *id;
  state->commit = hex_of(*id);
  git_commit* commit = nullptr;
  if (git_commit_lookup(&commit, state->repository.get(), &*id) != 0) {
    problem = fmt::format("the commit '{}': {}", revision, state->unreadable(*id, ""));
    return nullptr;
  }
  state->tree_id = *git_commit_tree_id(Commit(commit).get());
  if (state->tree_of(state->tree_id) == nullptr) {
    problem = fmt::format("the files of the commit '{}': {}", revision,
                          state->unreadable(state->tree_id, ""));
    return nullptr;
  }
  state->bare = open_without_work_tree(state->repository.get());
  if (state->bare == nullptr) {
    problem = fmt::format("the git repository in '{}' cannot be read{}", state->root, said());
    return nullptr;
  }

  std::unique_ptr<GitTreeReader> reader(new GitTreeReader(std::move(state)));
  if (!reader->path_in_repository(file)) {
    problem = fmt::format("'{}' is outside the work tree of its git repository, {}", file,
                          reader->root());
    return nullptr;
  }
  return reader;
}

GitTreeReader::GitTreeReader(std::unique_ptr<State> state) : state_(std::move(state)) {}
GitTreeReader::~GitTreeReader() = default;

calc::FileContent GitTreeReader::read_within(const std::string&, const std::string& path) const {
  const std::scoped_lock lock(state_->mutex);
  const std::optional<std::string> inside = path_in_repository(path);
  if (!inside) return state_->failed("it is outside the git repository");
  const Found found = state_->find(*inside);
  if (!found.error.empty()) return state_->failed(found.error);
  switch (found.kind) {
    case Found::Kind::folder:
      return {{}, "it is a folder"};
    case Found::Kind::file:
      return state_->read(found);
    case Found::Kind::none:
      break;
  }
  return {{}, "No such file in this revision"};
}

bool GitTreeReader::has(const std::string& path) const {
  const std::optional<std::string> inside = path_in_repository(path);
  if (!inside) return false;
  const Found found = state_->find(*inside);
  return found.kind != Found::Kind::none || !found.error.empty();
}

bool GitTreeReader::has_file(const std::string& path) const {
  const std::optional<std::string> inside = path_in_repository(path);
  return inside && state_->find(*inside).kind == Found::Kind::file;
}

std::vector<std::string> GitTreeReader::names_in(const std::string& folder) const {
  std::vector<std::string> names;
  const std::optional<std::string> inside = path_in_repository(folder);
  if (!inside) return names;
  const Found found = state_->find(*inside);
  if (found.kind != Found::Kind::folder) return names;
  const Tree tree = state_->tree_of(found.id);
  for (std::size_t k = 0; tree != nullptr && k < git_tree_entrycount(tree.get()); ++k) {
    names.emplace_back(git_tree_entry_name(git_tree_entry_byindex(tree.get(), k)));
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::optional<std::vector<std::string>> GitTreeReader::files_in(
    const std::string& folder, const Wanted& is_file_wanted, const Wanted& is_folder_wanted) const {
  std::vector<std::string> files;
  const std::optional<std::string> inside = path_in_repository(folder);
  if (!inside) return files;
  const Found found = state_->find(*inside);
  if (found.kind != Found::Kind::folder) return files;
  std::size_t listed = 0;
  // As it was asked for: a link may lead to it.
  const std::string start = inside->empty() ? "" : *inside + "/";
  if (!state_->add_files(found.id, start, is_file_wanted, is_folder_wanted, listed, files)) {
    return std::nullopt;
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string GitTreeReader::submodule_commit(const std::string& path) const {
  const std::optional<std::string> inside = path_in_repository(path);
  git_tree_entry* entry = nullptr;
  const Tree tree = state_->tree_of(state_->tree_id);
  if (!inside || tree == nullptr ||
      git_tree_entry_bypath(&entry, tree.get(), inside->c_str()) != 0) {
    return "";
  }
  const TreeEntry owned(entry);
  return git_tree_entry_filemode(entry) == GIT_FILEMODE_COMMIT ? hex_of(*git_tree_entry_id(entry))
                                                               : "";
}

std::optional<std::vector<std::string>> GitTreeReader::submodules_in(
    const std::string& folder) const {
  std::vector<std::string> paths;
  const std::optional<std::string> inside = path_in_repository(folder);
  const Tree tree = state_->tree_of(state_->tree_id);
  if (!inside || tree == nullptr) return paths;
  struct Walk {
    std::string start;
    std::vector<std::string>& paths;
    std::size_t looked = 0;
  };
  const Found found = state_->find(*inside);  // a link may lead to it
  const std::string& folder_then = found.kind == Found::Kind::folder ? found.path : *inside;
  Walk walk{folder_then.empty() ? "" : folder_then + "/", paths};
  const auto visit = [](const char* above, const git_tree_entry* entry, void* given) {
    Walk& own = *static_cast<Walk*>(given);
    const std::string path = std::string(above) + git_tree_entry_name(entry);
    if (++own.looked > kMostListed) return -1;
    if (git_tree_entry_filemode(entry) == GIT_FILEMODE_COMMIT && path.starts_with(own.start)) {
      own.paths.push_back(path);
    }
    // 1: not into what lies beside.
    const std::string as_folder = path + "/";
    const bool is_near = as_folder.starts_with(own.start) || own.start.starts_with(as_folder);
    return is_near ? 0 : 1;
  };
  if (git_tree_walk(tree.get(), GIT_TREEWALK_PRE, visit, &walk) != 0) return std::nullopt;
  return paths;
}

std::string GitTreeReader::staged_submodule_commit(const std::string& path) const {
  const std::optional<std::string> inside = path_in_repository(path);
  git_index* index = nullptr;
  if (!inside || git_repository_index(&index, state_->repository.get()) != 0) return "";
  const Index staged(index);
  const git_index_entry* entry = git_index_get_bypath(index, inside->c_str(), 0);
  return entry != nullptr && entry->mode == GIT_FILEMODE_COMMIT ? hex_of(entry->id) : "";
}

std::optional<std::string> GitTreeReader::path_in_repository(const std::string& path) const {
  // By names as far as that goes, for a link of today need not be one then; above the root it may
  // be.
  const std::string whole = absolute_path(path);
  const auto inside = [](const fs::path& below) {
    const std::string text = below.string();
    return text == "." ? std::string() : text;
  };
  std::error_code error;
  for (fs::path above = whole; above.has_relative_path();) {
    above = above.parent_path();
    if (fs::equivalent(above, state_->root, error))
      return inside(fs::path(whole).lexically_relative(above));
  }
  const fs::path file(whole);
  const fs::path real = fs::path(canonical_folder(file.parent_path().string())) / file.filename();
  const fs::path below = real.lexically_relative(state_->root);
  if (below.empty() || *below.begin() == "..") return std::nullopt;
  return inside(below);
}

const std::string& GitTreeReader::root() const { return state_->root; }
const std::string& GitTreeReader::commit() const { return state_->commit; }
bool GitTreeReader::is_unchanged_head() const { return state_->is_unchanged_head(); }
std::size_t GitTreeReader::failures() const { return state_->failures; }

}  // namespace git
