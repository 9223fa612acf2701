#include "report/git/git_tree_reader.h"

#include "calc/base/file_hash.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "tests/support/scratch_folder.h"

namespace git_tree_reader_test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Optional;

// A repository in a folder of its own, made by git without anybody's settings.
class GitTreeReaderTest : public testing::Test {
 protected:
  GitTreeReaderTest() {
    fs::create_directories(base_ / "home");
    setenv("HOME", (base_ / "home").c_str(), 1);
    setenv("GIT_CONFIG_NOSYSTEM", "1", 1);
    unsetenv("XDG_CONFIG_HOME");
    root_ = fs::canonical(base_) / "work";
    sh(fmt::format("git init -q -b main '{}'", root_.string()));
  }

  void sh(const std::string& command) const {
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
  }
  void git(const std::string& arguments) const {
    sh(
        fmt::format("git -C '{}' -c user.name=A -c user.email=a@b.c -c protocol.file.allow=always "
                    "{} 2>/dev/null >/dev/null",
                    root_.string(), arguments));
  }
  void write(const std::string& name, const std::string& bytes) const {
    fs::create_directories((root_ / name).parent_path());
    std::ofstream(root_ / name, std::ios::binary) << bytes;
  }
  void commit() const {
    git("add -A");
    git("commit --allow-empty -m change");
  }
  std::string path(const std::string& name) const { return (root_ / name).string(); }

  std::unique_ptr<git::GitTreeReader> open(const std::string& revision) {
    return git::GitTreeReader::open(path("a.xml"), revision, {}, problem_);
  }
  // Of a file at a revision: its bytes, or "error: ...".
  std::string read(const std::string& revision, const std::string& name) {
    const auto reader = open(revision);
    if (reader == nullptr) return "no revision: " + problem_;
    const calc::FileContent content = reader->read(path(name));
    failures_ = reader->failures();
    return content.ok() ? content.bytes : "error: " + content.error;
  }

  const test_support::ScratchFolder scratch_;
  const fs::path base_ = scratch_.path();
  fs::path root_;
  std::string problem_;
  std::size_t failures_ = 0;
};

TEST_F(GitTreeReaderTest, ReadsWhatWasThere) {
  write("a.xml", "one");
  write("sub/deep/b.ies", "light");
  commit();
  write("a.xml", "two");
  fs::remove_all(root_ / "sub");
  commit();
  write("a.xml", "three");
  EXPECT_EQ(read("HEAD", "a.xml"), "two");
  EXPECT_EQ(read("HEAD~1", "a.xml"), "one");
  EXPECT_EQ(read("HEAD~1", "sub/deep/b.ies"), "light");
  EXPECT_EQ(read("HEAD~1", "sub/../a.xml"), "one");
  EXPECT_EQ(read("HEAD", "sub/deep/b.ies"), "error: No such file in this revision");
  EXPECT_EQ(read("HEAD~1", "sub"), "error: it is a folder");
  EXPECT_EQ(read("HEAD~1", "a.xml/b"), "error: No such file in this revision");
  EXPECT_EQ(failures_, 0u);
  EXPECT_EQ(read("HEAD", "../a.xml"), "error: it is outside the git repository");
}

TEST_F(GitTreeReaderTest, ListsFiles) {
  write("a.xml", "");
  write("sub/b.xml", "");
  write("sub/c.ies", "");
  commit();
  const auto reader = open("main");
  ASSERT_NE(reader, nullptr) << problem_;
  EXPECT_THAT(reader->names_in(path("sub")), ElementsAre("b.xml", "c.ies"));
  EXPECT_THAT(reader->names_in(path("none")), IsEmpty());
  const auto is_xml = [](const std::string& name) { return name.ends_with(".xml"); };
  const auto any = [](const std::string&) { return true; };
  EXPECT_THAT(reader->files_in(root_.string(), is_xml, any),
              Optional(ElementsAre("a.xml", "sub/b.xml")));
  EXPECT_THAT(reader->files_in(path("sub"), any, any),
              Optional(ElementsAre("sub/b.xml", "sub/c.ies")));
  EXPECT_THAT(reader->files_in(root_.string(), is_xml, [](const auto& n) { return n != "sub"; }),
              Optional(ElementsAre("a.xml")));
  EXPECT_THAT(reader->files_in(path("none"), any, any), Optional(IsEmpty()));
  EXPECT_TRUE(reader->has(path("sub")));
  EXPECT_FALSE(reader->has(path("c.ies")));
  EXPECT_EQ(reader->root(), root_.string());
  EXPECT_EQ(reader->commit().size(), 40u);
}

TEST_F(GitTreeReaderTest, TakesEveryNameOfACommit) {
  write("a.xml", "one");
  commit();
  git("tag -a -m text v1");
  git("branch other/branch");
  write("a.xml", "two");
  commit();
  const std::string id = open("v1")->commit();
  for (const std::string& name : {std::string("v1"), std::string("other/branch"), id,
                                  id.substr(0, 8), std::string("HEAD^")}) {
    EXPECT_EQ(read(name, "a.xml"), "one") << name;
  }
}

// Git would take the tag: whoever can push one could choose what a design is compared with.
TEST_F(GitTreeReaderTest, RefusesNamesThatSeveralCommitsHave) {
  write("a.xml", "one");
  commit();
  git("update-ref refs/remotes/origin/main HEAD");
  const std::string old = open("HEAD")->commit();
  write("a.xml", "two");
  commit();
  git("update-ref refs/tags/origin/main HEAD");
  git("update-ref refs/tags/" + old.substr(0, 8) + " HEAD");
  git("update-ref refs/tags/refs/remotes/origin/gone HEAD");
  git("update-ref refs/tags/main HEAD");
  EXPECT_THAT(read("origin/main", "a.xml"),
              HasSubstr("'origin/main' is the name of several commits of"));
  EXPECT_THAT(problem_, HasSubstr("'refs/tags/origin/main' ("));
  EXPECT_THAT(problem_, HasSubstr("write the full name"));
  EXPECT_THAT(read("origin/main...", "a.xml"), HasSubstr("several commits"));
  EXPECT_THAT(read("origin/main~0^{commit}", "a.xml"), HasSubstr("several commits"));
  EXPECT_THAT(read(old.substr(0, 8), "a.xml"), HasSubstr("several commits"));
  EXPECT_THAT(read("refs/remotes/origin/gone", "a.xml"), HasSubstr("has no 'refs/remotes/origin"));
  EXPECT_EQ(read("refs/remotes/origin/main", "a.xml"), "one");
  EXPECT_EQ(read("refs/remotes/origin/main...", "a.xml"), "one");
  EXPECT_EQ(read(old, "a.xml"), "one");
  EXPECT_EQ(read("main", "a.xml"), "two") << "both lead to one commit";
}

TEST_F(GitTreeReaderTest, KnowsHeadWithNothingStaged) {
  write("a.xml", "one");
  commit();
  EXPECT_TRUE(open("HEAD")->is_unchanged_head());
  EXPECT_TRUE(open("main...")->is_unchanged_head());
  write("a.xml", "two");
  EXPECT_TRUE(open("HEAD")->is_unchanged_head()) << "what is read is compared elsewhere";
  git("add a.xml");
  EXPECT_FALSE(open("HEAD")->is_unchanged_head());
  commit();
  EXPECT_FALSE(open("HEAD~1")->is_unchanged_head());
}

TEST_F(GitTreeReaderTest, FindsWhereHeadLeftABranch) {
  write("a.xml", "base");
  commit();
  git("checkout -b work");
  write("a.xml", "work");
  commit();
  git("checkout main");
  write("a.xml", "main");
  commit();
  git("checkout work");
  EXPECT_EQ(read("main", "a.xml"), "main");
  EXPECT_EQ(read("main...", "a.xml"), "base");
  EXPECT_THAT(read("none...", "a.xml"), HasSubstr("has no commit 'none'"));
  git("checkout --orphan alone");
  commit();
  EXPECT_THAT(read("main...", "a.xml"), HasSubstr("have no commit in common"));
}

TEST_F(GitTreeReaderTest, SaysWhatIsNoCommit) {
  write("a.xml", "one");
  commit();
  git("update-ref refs/remotes/origin/topic HEAD");
  EXPECT_THAT(read("none", "a.xml"), HasSubstr("has no commit 'none'; allowed: a branch, a tag"));
  EXPECT_THAT(read("topic", "a.xml"), HasSubstr("use --against refs/remotes/origin/topic"));
  EXPECT_THAT(read("HEAD:a.xml", "a.xml"), HasSubstr("is a blob, not a commit; allowed"));
  EXPECT_THAT(read("HEAD^{tree}", "a.xml"), HasSubstr("is a tree, not a commit"));
}

TEST_F(GitTreeReaderTest, NamesRepositoriesThatItCannotRead) {
  EXPECT_EQ(git::GitTreeReader::open(base_ / "x.xml", "main", {}, problem_), nullptr);
  EXPECT_THAT(problem_, HasSubstr("is not in a git repository"));
  EXPECT_EQ(git::GitTreeReader::open(path("x.xml"), "main", {base_ / "none.git", ""}, problem_),
            nullptr);
  EXPECT_THAT(problem_, HasSubstr("GIT_DIR"));
  root_ = fs::canonical(base_) / "sha256";
  sh(fmt::format("git init -q --object-format=sha256 '{}'", root_.string()));
  EXPECT_THAT(read("main", "a.xml"), HasSubstr("SHA-256"));
}

TEST_F(GitTreeReaderTest, ReadsABareRepositoryThroughItsName) {
  write("a.xml", "one");
  commit();
  git("clone --bare . ../bare.git");
  const std::string bare = base_ / "bare.git", elsewhere = base_ / "elsewhere";
  fs::create_directories(elsewhere);
  const auto reader =
      git::GitTreeReader::open(elsewhere + "/a.xml", "main", {bare, elsewhere}, problem_);
  ASSERT_NE(reader, nullptr) << problem_;
  EXPECT_EQ(reader->read(elsewhere + "/a.xml").bytes, "one");
  EXPECT_EQ(git::GitTreeReader::open(path("a.xml"), "main", {bare, elsewhere}, problem_), nullptr);
  EXPECT_THAT(problem_, HasSubstr("is outside the work tree"));
  EXPECT_EQ(git::GitTreeReader::open(bare + "/a.xml", "main", {}, problem_), nullptr);
  EXPECT_THAT(problem_, HasSubstr("bare git repository"));
}

TEST_F(GitTreeReaderTest, ReadsALinkedWorkTree) {
  write(".gitattributes", "*.xml eol=crlf\n");
  write("a.xml", "one\n");
  commit();
  git("worktree add ../linked -b linked");
  root_ = root_.parent_path() / "linked";
  EXPECT_EQ(read("HEAD", "a.xml"), "one\r\n");
}

TEST_F(GitTreeReaderTest, FollowsLinksInsideTheRepositoryOnly) {
  write("shared/b.ies", "light");
  write("sub/c.ies", "other");
  fs::create_symlink("../shared/b.ies", root_ / "sub/b.ies");
  fs::create_symlink("shared", root_ / "folder");
  fs::create_symlink("folder/../sub/b.ies", root_ / "twice");
  fs::create_symlink("../../passwd", root_ / "sub/out");
  fs::create_symlink("/etc/passwd", root_ / "whole");
  fs::create_symlink("circle", root_ / "circle");
  commit();
  EXPECT_EQ(read("HEAD", "sub/b.ies"), "light");
  EXPECT_EQ(read("HEAD", "folder/b.ies"), "light");
  EXPECT_EQ(read("HEAD", "twice"), "light");
  EXPECT_EQ(failures_, 0u);
  EXPECT_THAT(read("HEAD", "sub/out"), HasSubstr("'sub/out' leads out of the repository"));
  EXPECT_EQ(failures_, 1u);
  EXPECT_THAT(read("HEAD", "whole"), HasSubstr("absolute path"));
  EXPECT_THAT(read("HEAD", "circle"), HasSubstr("circle"));
  // What is a link today was none then.
  fs::remove_all(root_ / "sub");
  fs::create_symlink("shared", root_ / "sub");
  EXPECT_EQ(read("HEAD", "sub/c.ies"), "other");
}

TEST_F(GitTreeReaderTest, SaysThatAFileLiesInASubmodule) {
  write("a.xml", "one");
  commit();
  git("clone . ../lib");
  git("submodule add ../lib lib");
  commit();
  EXPECT_THAT(read("HEAD", "lib/a.xml"), HasSubstr("it is in the submodule 'lib'"));
  EXPECT_EQ(failures_, 1u);
  // A project in it is one of the submodule's own repository.
  const auto reader = git::GitTreeReader::open(path("lib/a.xml"), "HEAD", {}, problem_);
  ASSERT_NE(reader, nullptr) << problem_;
  EXPECT_EQ(reader->read(path("lib/a.xml")).bytes, "one");
}

TEST_F(GitTreeReaderTest, WritesLineEndsAsACheckoutOfThatRevision) {
  write(".gitattributes", "*.ies eol=crlf\n");
  write("a.ies", "a\nb\n");
  write("sub/b.ies", "a\nb\n");
  write("w.txt", "a\nb\n");
  commit();
  write(".gitattributes", "");
  write("sub/.gitattributes", "*.ies text eol=crlf\n");
  commit();
  EXPECT_EQ(read("HEAD~1", "a.ies"), "a\r\nb\r\n");
  EXPECT_EQ(read("HEAD", "a.ies"), "a\nb\n");
  EXPECT_EQ(read("HEAD", "sub/b.ies"), "a\r\nb\r\n");
  // Attributes of today's work tree and index say nothing about then.
  write(".gitattributes", "*.txt eol=crlf\n*.ies eol=crlf\n");
  EXPECT_EQ(read("HEAD~1", "w.txt"), "a\nb\n");
  EXPECT_EQ(read("HEAD", "a.ies"), "a\nb\n");
  git("add .gitattributes");
  EXPECT_EQ(read("HEAD~1", "w.txt"), "a\nb\n");
  EXPECT_EQ(read("HEAD", "a.ies"), "a\nb\n");
  // Settings of the repository do.
  git("config core.autocrlf true");
  EXPECT_EQ(read("HEAD~1", "w.txt"), "a\r\nb\r\n");
}

TEST_F(GitTreeReaderTest, NamesWhatACheckoutHasOthersWrite) {
  write(".gitattributes", "*.crypt filter=crypt\n*.utf16 working-tree-encoding=UTF-16\n");
  write("a.crypt", "secret");
  commit();
  EXPECT_EQ(read("HEAD", "a.crypt"), "secret");  // the filter is not set up: nor would git run it
  git("config filter.crypt.smudge cat");
  EXPECT_THAT(read("HEAD", "a.crypt"), HasSubstr("sets the filter 'crypt'"));
  sh(fmt::format("printf 'a' | iconv -f UTF-8 -t UTF-16 > '{}'", path("b.utf16")));
  commit();
  EXPECT_THAT(read("HEAD", "b.utf16"), HasSubstr("sets working-tree-encoding to UTF-16"));
}

TEST_F(GitTreeReaderTest, TakesLfsContentsOnlyIfTheirHashIsRight) {
  const std::string light = "contents of a large file";
  const std::string hash = calc::sha256_hex(light);
  write("big.ies",
        fmt::format("version https://git-lfs.github.com/spec/v1\noid sha256:{}\nsize {}\n", hash,
                    light.size()));
  write("broken.ies", "version https://git-lfs.github.com/spec/v1\noid sha256:12\nsize 1\n");
  commit();
  EXPECT_THAT(read("HEAD", "big.ies"),
              AllOf(HasSubstr("Git LFS pointer"), HasSubstr("'git lfs fetch origin ")));
  EXPECT_EQ(failures_, 1u);
  const std::string object =
      fmt::format(".git/lfs/objects/{}/{}/{}", hash.substr(0, 2), hash.substr(2, 2), hash);
  write(object, light);
  EXPECT_EQ(read("HEAD", "big.ies"), light);
  EXPECT_EQ(failures_, 0u);
  write(object, "Contents of a large file");
  EXPECT_THAT(read("HEAD", "big.ies"), HasSubstr("hash of its contents differs"));
  write(object, "short");
  EXPECT_THAT(read("HEAD", "big.ies"), HasSubstr("size of its contents differs"));
  EXPECT_THAT(read("HEAD", "broken.ies"), HasSubstr("without a SHA-256 and a size"));
  fs::create_directories(base_ / "media");
  fs::rename(root_ / ".git/lfs/objects", base_ / "media/objects");
  std::ofstream(base_ / "media/objects" / object.substr(17), std::ios::binary) << light;
  git("config lfs.storage " + (base_ / "media").string());
  EXPECT_EQ(read("HEAD", "big.ies"), light);
}

TEST_F(GitTreeReaderTest, SaysWhatAShallowCloneLacks) {
  write("a.xml", "one");
  commit();
  write("a.xml", "two");
  commit();
  git(fmt::format("clone --depth 1 'file://{}' ../shallow", root_.string()));
  root_ = root_.parent_path() / "shallow";
  EXPECT_EQ(read("HEAD", "a.xml"), "two");
  EXPECT_THAT(read("HEAD~1", "a.xml"), AllOf(HasSubstr("shallow clone"),
                                             HasSubstr("fetch-depth: 0"), HasSubstr("GIT_DEPTH")));
}

TEST_F(GitTreeReaderTest, TellsDamagedObjectsFromMissingOnes) {
  write("a.xml", "a text that is there");
  commit();
  sh(fmt::format("cd '{}' && git rev-parse HEAD:a.xml > ../id", root_.string()));
  std::string id;
  std::ifstream(base_ / "id") >> id;
  const fs::path object = root_ / ".git/objects" / id.substr(0, 2) / id.substr(2);
  fs::permissions(object, fs::perms::owner_write, fs::perm_options::add);
  std::ofstream(object, std::ios::binary) << "no object";
  EXPECT_THAT(read("HEAD", "a.xml"), HasSubstr("is damaged"));
  EXPECT_EQ(failures_, 1u);
  fs::remove(object);
  EXPECT_THAT(read("HEAD", "a.xml"), HasSubstr("not among the repository's objects"));
}

TEST_F(GitTreeReaderTest, AsksWhoseRepositoryItIs) {
  write("a.xml", "one");
  commit();
  if (std::system(fmt::format("chown -R 12345 '{}' 2>/dev/null", root_.string()).c_str()) != 0) {
    GTEST_SKIP() << "only root can give a folder to somebody else";
  }
  const std::string told = "git config --global --add safe.directory " + root_.string();
  EXPECT_THAT(read("HEAD", "a.xml"), AllOf(HasSubstr("another user"), HasSubstr(told)));
  sh("git config --global --add safe.directory /elsewhere");
  EXPECT_THAT(read("HEAD", "a.xml"), AllOf(HasSubstr("another user"), HasSubstr(told)));
  sh(told);
  EXPECT_EQ(read("HEAD", "a.xml"), "one");
  sh("git config --global --unset-all safe.directory; git config --global safe.directory '*'");
  EXPECT_EQ(read("HEAD", "a.xml"), "one");
  sh("git config --global --add safe.directory ''");
  EXPECT_THAT(read("HEAD", "a.xml"), HasSubstr("another user"));
}

}  // namespace
}  // namespace git_tree_reader_test
