#include "report/git/git_tree_reader.h"

#include "report/git/lfs_pointer.h"

#include <fmt/format.h>
#include <git2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <system_error>
#include <utility>

namespace git {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostBlobBytes = std::uintmax_t{512} << 20;  // as DiskFileReader
constexpr int kMostLinks = 40;                                        // as Linux

template <class T, void (*Free)(T*)>
struct Freeing {
  void operator()(T* object) const { Free(object); }
};
using Repository = std::unique_ptr<git_repository, Freeing<git_repository, git_repository_free>>;
using Object = std::unique_ptr<git_object, Freeing<git_object, git_object_free>>;
using Tree = std::unique_ptr<git_tree, Freeing<git_tree, git_tree_free>>;
using Blob = std::unique_ptr<git_blob, Freeing<git_blob, git_blob_free>>;
using Entry = std::unique_ptr<git_tree_entry, Freeing<git_tree_entry, git_tree_entry_free>>;
using Config = std::unique_ptr<git_config, Freeing<git_config, git_config_free>>;
using ObjectStore = std::unique_ptr<git_odb, Freeing<git_odb, git_odb_free>>;

class Library {
 public:
  Library() {
    git_libgit2_init();
    // What these ask of a program that only reads is kept: to ask nobody for missing objects, to
    // delete nothing; sparse checkouts keep their settings in a file of their own.
    const char* harmless[] = {"partialclone", "preciousobjects", "worktreeconfig"};
    git_libgit2_opts(GIT_OPT_SET_EXTENSIONS, harmless, std::size(harmless));
  }
  ~Library() { git_libgit2_shutdown(); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
};

// What libgit2 said last, as a clause in brackets.
std::string said() {
  const git_error* error = git_error_last();
  if (error == nullptr || error->message == nullptr) return "";
  return fmt::format(" ({})", error->message);
}

std::string hex_of(const git_oid& id) {
  std::string hex(GIT_OID_HEXSZ, '0');
  git_oid_fmt(hex.data(), &id);
  return hex;
}

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

std::string repository_problem(int error, const std::string& place) {
  if (error == GIT_ENOTFOUND) {
    return fmt::format("'{}' lies in no git repository", place);
  }
  if (error == GIT_EOWNER) {
    return fmt::format(
        "the git repository of '{0}' belongs to another user; if you trust it: git config --global "
        "--add safe.directory FOLDER, the folder that .git lies in{1}",
        place, said());
  }
  const std::string words = said();
  if (words.find("extension") != std::string::npos || words.find("version") != std::string::npos) {
    return fmt::format(
        "the git repository of '{}' is of a kind that luxgate cannot read, such as one with "
        "SHA-256 ids{}",
        place, words);
  }
  return fmt::format("the git repository of '{}' cannot be read{}", place, words);
}

constexpr const char* kAllowed = "a branch, a tag, the id of a commit, or one of these with ~1";

bool is_partial(git_repository* repository) {
  git_config* config = nullptr;
  if (git_repository_config_snapshot(&config, repository) != 0) return false;
  const Config owned(config);
  const char* ignored = nullptr;
  return git_config_get_string(&ignored, config, "extensions.partialclone") == 0;
}

std::string shallow_advice(git_repository* repository) {
  if (git_repository_is_shallow(repository) != 1) return "";
  return "; this is a shallow clone, which lacks older commits and other branches: 'git fetch "
         "--deepen=100', 'git fetch origin BRANCH' or 'git fetch --unshallow' brings them";
}

std::string revision_problem(git_repository* repository, int error, const std::string& revision,
                             const std::string& root) {
  if (error == GIT_EAMBIGUOUS) {
    return fmt::format("'{}' is short for several objects of {}: give more digits", revision, root);
  }
  const std::string words = said();
  const std::string remote = "origin/" + revision;
  git_object* found = nullptr;
  if (git_revparse_single(&found, repository, remote.c_str()) == 0) {
    const Object owned(found);
    return fmt::format("{} knows no '{}', but '{}': say --against {}", root, revision, remote,
                       remote);
  }
  return fmt::format("{} knows no commit '{}'; allowed is {}{}{}", root, revision, kAllowed,
                     shallow_advice(repository), words);
}

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
  Library library;  // before all that is freed by it
  Repository repository;
  git_oid commit_id{};
  git_oid tree_id{};
  std::string root, commit;
  mutable std::size_t failures = 0;

  Tree tree_of(const git_oid& id) const {
    git_tree* tree = nullptr;
    return Tree(git_tree_lookup(&tree, repository.get(), &id) == 0 ? tree : nullptr);
  }
  Blob blob_of(const git_oid& id) const {
    git_blob* blob = nullptr;
    return Blob(git_blob_lookup(&blob, repository.get(), &id) == 0 ? blob : nullptr);
  }

  std::string missing(const std::string& path) const {
    const std::string words = said();
    const std::string advice =
        is_partial(repository.get())
            ? fmt::format("; this is a partial clone: 'git show {}:{}' brings it", commit, path)
            : shallow_advice(repository.get());
    return fmt::format("the repository's objects do not hold it{}{}", advice, words);
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
          return failure(path, fmt::format("the symbolic link '{}' leads out of the repository, "
                                           "and is not followed",
                                           link));
        }
        done.pop_back();
        folders.pop_back();
        continue;
      }
      done.push_back(part);
      const std::string place = fmt::format("{}", fmt::join(done, "/"));
      const Tree tree = tree_of(folders.back());
      if (tree == nullptr) return failure(place, missing(place));
      const git_tree_entry* entry = git_tree_entry_byname(tree.get(), part.c_str());
      if (entry == nullptr) return {};
      const git_oid id = *git_tree_entry_id(entry);
      switch (git_tree_entry_filemode(entry)) {
        case GIT_FILEMODE_TREE:
          folders.push_back(id);
          break;
        case GIT_FILEMODE_COMMIT:
          return failure(place, fmt::format("it lies in the submodule '{}', whose files are not "
                                            "among the repository's objects",
                                            place));
        case GIT_FILEMODE_LINK: {
          if (++links > kMostLinks) {
            return failure(place, "symbolic links lead to each other in a circle");
          }
          const Blob blob = blob_of(id);
          if (blob == nullptr) return failure(place, missing(place));
          const std::string target(static_cast<const char*>(git_blob_rawcontent(blob.get())),
                                   static_cast<std::size_t>(git_blob_rawsize(blob.get())));
          if (target.starts_with('/')) {
            return failure(place, fmt::format("the symbolic link '{}' has an absolute path, and is "
                                              "not followed",
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
    if (blob == nullptr) return failed(missing(file.path));
    git_blob_filter_options options = GIT_BLOB_FILTER_OPTIONS_INIT;
    options.flags = GIT_BLOB_FILTER_ATTRIBUTES_FROM_COMMIT;
    options.attr_commit_id = commit_id;
    git_buf bytes = GIT_BUF_INIT;
    if (git_blob_filter(&bytes, blob.get(), file.path.c_str(), &options) != 0) {
      return failed("its line ends cannot be made those of a checkout" + said());
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

  // As lfs.storage says it; all work trees of a repository share it.
  std::string lfs_storage() const {
    const std::string common = git_repository_commondir(repository.get());
    git_config* config = nullptr;
    if (git_repository_config_snapshot(&config, repository.get()) != 0) return common + "lfs";
    const Config owned(config);
    const char* named = nullptr;
    if (git_config_get_string(&named, config, "lfs.storage") != 0 || *named == '\0') {
      return common + "lfs";
    }
    return (fs::path(common) / named).string();
  }

  void add_files(const git_oid& folder, const std::string& path, const std::string& end,
                 std::vector<std::string>& files) const {
    const Tree tree = tree_of(folder);
    for (std::size_t k = 0; tree != nullptr && k < git_tree_entrycount(tree.get()); ++k) {
      const git_tree_entry* entry = git_tree_entry_byindex(tree.get(), k);
      const std::string name = path + git_tree_entry_name(entry);
      const git_filemode_t mode = git_tree_entry_filemode(entry);
      if (mode == GIT_FILEMODE_TREE) add_files(*git_tree_entry_id(entry), name + "/", end, files);
      const bool is_file = mode == GIT_FILEMODE_BLOB || mode == GIT_FILEMODE_BLOB_EXECUTABLE;
      if (is_file && name.ends_with(end)) files.push_back(name);
    }
  }
};

std::unique_ptr<GitTreeReader> GitTreeReader::open(const std::string& file,
                                                   const std::string& revision,
                                                   const GitPlaces& places, std::string& problem) {
  auto state = std::make_unique<State>();
  const std::string folder = existing_folder_of(file);
  git_repository* repository = nullptr;
  const bool is_named = !places.git_dir.empty();
  const std::string& place = is_named ? places.git_dir : folder;
  const int opened = is_named ? git_repository_open(&repository, place.c_str())
                              : git_repository_open_ext(&repository, place.c_str(),
                                                        GIT_REPOSITORY_OPEN_CROSS_FS, nullptr);
  if (opened != 0) {
    problem = repository_problem(opened, place);
    return nullptr;
  }
  state->repository.reset(repository);
  const char* work_tree = git_repository_workdir(repository);
  if (is_named && !places.work_tree.empty()) {
    state->root = canonical_folder(places.work_tree);
  } else if (work_tree != nullptr) {
    state->root = canonical_folder(work_tree);
  } else if (is_named) {
    state->root = canonical_folder(".");
  } else {
    problem = fmt::format(
        "'{}' lies in a bare git repository, which has no work tree: check files of a 'git "
        "worktree' of it, or set GIT_DIR and GIT_WORK_TREE",
        file);
    return nullptr;
  }

  git_object* found = nullptr;
  if (const int error = git_revparse_single(&found, repository, revision.c_str()); error != 0) {
    problem = revision_problem(repository, error, revision, state->root);
    return nullptr;
  }
  const Object named(found);
  git_object* commit = nullptr;
  if (git_object_peel(&commit, found, GIT_OBJECT_COMMIT) != 0) {
    problem = fmt::format("'{}' is no commit but a {}; allowed is {}", revision,
                          git_object_type2string(git_object_type(found)), kAllowed);
    return nullptr;
  }
  const Object owned(commit);
  state->commit_id = *git_object_id(commit);
  state->commit = hex_of(state->commit_id);
  git_object* tree = nullptr;
  if (git_object_peel(&tree, commit, GIT_OBJECT_TREE) != 0) {
    problem = fmt::format("of the commit '{}' {}", revision, state->missing(""));
    return nullptr;
  }
  state->tree_id = *git_object_id(Object(tree).get());

  std::unique_ptr<GitTreeReader> reader(new GitTreeReader(std::move(state)));
  if (!reader->path_in_repository(file)) {
    problem = fmt::format("'{}' lies outside of the work tree of its git repository, {}", file,
                          reader->root());
    return nullptr;
  }
  return reader;
}

GitTreeReader::GitTreeReader(std::unique_ptr<State> state) : state_(std::move(state)) {}
GitTreeReader::~GitTreeReader() = default;

calc::FileContent GitTreeReader::read(const std::string& path) const {
  const std::optional<std::string> inside = path_in_repository(path);
  if (!inside) return state_->failed("it lies outside of the git repository");
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

std::vector<std::string> GitTreeReader::files_ending(const std::string& end) const {
  std::vector<std::string> files;
  state_->add_files(state_->tree_id, "", end, files);
  std::sort(files.begin(), files.end());
  return files;
}

std::optional<std::string> GitTreeReader::path_in_repository(const std::string& path) const {
  // By names as far as that goes, for a link is one at another revision only by its name. [Folders
  // on the way to the root may be links.]
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
std::size_t GitTreeReader::failures() const { return state_->failures; }

}  // namespace git
