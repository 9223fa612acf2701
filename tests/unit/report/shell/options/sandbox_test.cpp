#include "report/shell/options/sandbox.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <sched.h>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <thread>

#include "tests/support/scratch_folder.h"

namespace sandbox_test {
namespace {

namespace fs = std::filesystem;

// "" where it went well.
std::string words(bool is_good) { return is_good ? "" : std::strerror(errno); }

std::string opened(const fs::path& path, int flags = O_RDONLY) {
  const int number = open(path.c_str(), flags | O_CLOEXEC, 0666);
  const std::string told = words(number >= 0);
  if (number >= 0) close(number);
  return told;
}

// What a process of its own finds, in which the rules hold.
std::string found_inside(const cli::SandboxRules& rules, const std::function<std::string()>& find) {
  int pipe_ends[2];
  if (pipe(pipe_ends) != 0) return "no pipe";
  const pid_t child = fork();
  if (child == 0) {
    std::string told = cli::enter_sandbox(rules, {});
    told = told.empty() ? find() : "not entered: " + told;
    const ssize_t written = write(pipe_ends[1], told.data(), told.size());
    _exit(written == static_cast<ssize_t>(told.size()) ? 0 : 1);
  }
  close(pipe_ends[1]);
  std::string told;
  char part[4096];
  for (ssize_t got = 0; (got = read(pipe_ends[0], part, sizeof part)) > 0;) {
    told.append(part, static_cast<std::size_t>(got));
  }
  close(pipe_ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status)) told += "ended by signal " + std::to_string(WTERMSIG(status));
  return told;
}

const std::string kRefusedFile = std::strerror(EACCES);
const std::string kRefusedCall = std::strerror(EPERM);

class Sandbox : public ::testing::Test {
 protected:
  void SetUp() override {
    if (const std::string problem = found_inside({}, [] { return std::string(); });
        !problem.empty()) {
      GTEST_SKIP() << problem;
    }
    for (const char* folder : {"design", "design/below", "out", "out/below", "secret"}) {
      fs::create_directories(root_ / folder);
      std::ofstream(root_ / folder / "file") << "text";
    }
    rules_ = {{(root_ / "design").string()}, {(root_ / "out").string()}};
  }

  const test_support::ScratchFolder scratch_;
  const fs::path root_ = scratch_.path();
  cli::SandboxRules rules_;
};

TEST_F(Sandbox, ReadsWhatItMay) {
  EXPECT_EQ(found_inside(rules_, [&] { return opened(root_ / "design/below/file"); }), "");
  EXPECT_EQ(found_inside(rules_, [&] { return opened(root_ / "design"); }), "");
  EXPECT_EQ(found_inside(rules_, [&] { return opened(root_ / "out/below/file"); }), "");
}

TEST_F(Sandbox, ReadsNothingElse) {
  for (const fs::path& path :
       {root_ / "secret/file", root_ / "secret", root_, root_ / "design/../secret/file",
        fs::path("/etc/shadow"), fs::path("/etc/ssl"), fs::path("/proc/1/status"),
        fs::path("/home"), fs::path("/root"), fs::path("/tmp"), fs::path("/dev/tty")}) {
    if (!fs::exists(path)) continue;
    EXPECT_EQ(found_inside(rules_, [&] { return opened(path); }), kRefusedFile) << path;
  }
  fs::create_symlink(root_ / "secret/file", root_ / "design/link");
  EXPECT_EQ(found_inside(rules_, [&] { return opened(root_ / "design/link"); }), kRefusedFile);
}

TEST_F(Sandbox, AFileThatIsNamedIsThatFileAlone) {
  rules_.read = {(root_ / "design/file").string()};
  EXPECT_EQ(found_inside(rules_, [&] { return opened(root_ / "design/file"); }), "");
  EXPECT_EQ(found_inside(rules_, [&] { return opened(root_ / "design/below/file"); }),
            kRefusedFile);
  fs::create_symlink(root_ / "secret/file", root_ / "link");
  rules_.read = {(root_ / "link").string()};
  EXPECT_EQ(found_inside(rules_, [&] { return opened(root_ / "secret/file"); }), "");
}

TEST_F(Sandbox, WritesNothingThatIsOnlyRead) {
  const auto design = root_ / "design";
  const auto moved = [](const fs::path& from, const fs::path& to) {
    return words(std::rename(from.c_str(), to.c_str()) == 0);
  };
  EXPECT_EQ(found_inside(rules_, [&] { return opened(design / "file", O_WRONLY); }), kRefusedFile);
  EXPECT_EQ(found_inside(rules_, [&] { return opened(design / "new", O_WRONLY | O_CREAT); }),
            kRefusedFile);
  EXPECT_EQ(found_inside(rules_, [&] { return words(unlink((design / "file").c_str()) == 0); }),
            kRefusedFile);
  EXPECT_EQ(found_inside(rules_, [&] { return words(mkdir((design / "a").c_str(), 0777) == 0); }),
            kRefusedFile);
  EXPECT_EQ(found_inside(rules_, [&] { return words(chmod((design / "file").c_str(), 0) == 0); }),
            kRefusedCall);
  EXPECT_NE(found_inside(rules_, [&] { return moved(design / "file", design / "other"); }), "");
  EXPECT_NE(found_inside(rules_, [&] { return moved(design / "file", root_ / "out/file"); }), "");
  EXPECT_NE(found_inside(rules_, [&] { return moved(root_ / "out/file", design / "other"); }), "");
  const auto truncated = [&] { return words(truncate((design / "file").c_str(), 0) == 0); };
  EXPECT_EQ(found_inside(rules_, truncated), kRefusedCall);
  EXPECT_TRUE(fs::is_regular_file(design / "file"));
}

TEST_F(Sandbox, WritesAndRenamesInTheFolderOfOutputs) {
  const auto write_whole = [&] {
    const fs::path part = root_ / "out/new/.part", whole = root_ / "out/new/file";
    std::error_code failure;
    fs::create_directories(part.parent_path(), failure);
    if (failure) return failure.message();
    for (int once = 0; once < 2; ++once) {
      if (!(std::ofstream(part) << "text")) return std::string("not written");
      if (std::rename(part.c_str(), whole.c_str()) != 0) return words(false);
    }
    const std::string nameless = opened(root_ / "out", O_TMPFILE | O_RDWR);
    if (!nameless.empty() && nameless != std::strerror(EOPNOTSUPP)) return nameless;
    fs::remove_all(root_ / "out/below", failure);
    return failure ? failure.message() : "";
  };
  EXPECT_EQ(found_inside(rules_, write_whole), "");
  EXPECT_TRUE(fs::exists(root_ / "out/new/file"));
  EXPECT_FALSE(fs::exists(root_ / "out/below"));
}

TEST_F(Sandbox, WhatIsToBeMadeIsMadeInTheClosestFolder) {
  rules_.write = {(root_ / "out/a/b/c").string()};
  const auto made = [&] {
    std::error_code failure;
    fs::create_directories(root_ / "out/a/b/c", failure);
    return failure ? failure.message() : opened(root_ / "out/a/b/c/file", O_WRONLY | O_CREAT);
  };
  EXPECT_EQ(found_inside(rules_, made), "");
  EXPECT_EQ(found_inside(rules_, [&] { return opened(root_ / "new", O_WRONLY | O_CREAT); }),
            kRefusedFile);
  // ".." is that of where a link leads.
  fs::create_directory_symlink(root_ / "out/below", root_ / "link");
  rules_.write = {(root_ / "link/../file").string()};
  EXPECT_EQ(found_inside(rules_, [&] { return opened(root_ / "out/file", O_WRONLY); }), "");
  EXPECT_EQ(found_inside(rules_, [&] { return opened(root_ / "secret/file", O_WRONLY); }),
            kRefusedFile);
}

TEST_F(Sandbox, APipeAndADeviceForOutputs) {
  const std::string fifo = (root_ / "fifo").string();
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  rules_.write = {fifo};
  EXPECT_EQ(found_inside(rules_, [&] { return opened(fifo, O_RDWR); }), "");
  EXPECT_EQ(found_inside(rules_, [&] { return opened("/dev/null", O_WRONLY); }), "");
  EXPECT_EQ(found_inside(rules_, [&] { return opened(root_ / "out/file", O_WRONLY); }),
            kRefusedFile);
}

TEST_F(Sandbox, StartsNoProgram) {
  const auto started = [](const char* program) {
    char* const none[] = {nullptr};
    execve(program, none, none);
    return words(false);
  };
  EXPECT_EQ(found_inside(rules_, [&] { return started("/bin/true"); }), kRefusedCall);
  const auto started_from_memory = [] {
    const int file = memfd_create("program", 0);
    char* const none[] = {nullptr};
    fexecve(file, none, none);
    return words(false);
  };
  EXPECT_EQ(found_inside(rules_, started_from_memory), kRefusedCall);
}

TEST_F(Sandbox, MakesNoSocket) {
  for (const int family : {AF_INET, AF_INET6, AF_UNIX, AF_NETLINK}) {
    EXPECT_EQ(found_inside(rules_, [&] { return words(socket(family, SOCK_DGRAM, 0) >= 0); }),
              kRefusedCall);
  }
}

TEST_F(Sandbox, TouchesNoOtherProcess) {
  EXPECT_EQ(found_inside(rules_, [] { return words(kill(getppid(), 0) == 0); }), kRefusedCall);
  EXPECT_EQ(found_inside(rules_, [] { return words(kill(getpid(), 0) == 0); }), "");
  EXPECT_EQ(found_inside(rules_, [] { return words(raise(SIGCHLD) == 0); }), "");
}

TEST_F(Sandbox, CallsThatHaveNoPlaceInACalculation) {
  for (const long call : {SYS_mount, SYS_bpf, SYS_perf_event_open, SYS_keyctl, SYS_setns,
                          SYS_io_uring_setup, SYS_userfaultfd, SYS_process_vm_readv,
                          SYS_init_module, SYS_kexec_load, SYS_open_by_handle_at}) {
    EXPECT_EQ(found_inside(rules_, [&] { return words(syscall(call, 0, 0, 0, 0, 0, 0) >= 0); }),
              kRefusedCall)
        << call;
  }
  EXPECT_EQ(found_inside(rules_, [] { return words(unshare(CLONE_NEWUSER) == 0); }), kRefusedCall);
  const auto namespaces = [] {
    return words(syscall(SYS_clone, CLONE_NEWUSER | SIGCHLD, 0, 0, 0, 0) >= 0);
  };
  EXPECT_EQ(found_inside(rules_, namespaces), kRefusedCall);
  // The same calls by their other numbers.
  constexpr long kX32Bit = 0x40000000;
  EXPECT_EQ(found_inside(rules_, [] { return words(syscall(kX32Bit | SYS_getpid) >= 0); }),
            kRefusedCall);
  const auto typed = [] { return words(ioctl(STDIN_FILENO, TIOCSTI, "x") == 0); };
  EXPECT_EQ(found_inside(rules_, typed), kRefusedCall);
  const auto bound = [] { return words(prctl(PR_GET_NO_NEW_PRIVS, 0, 0, 0, 0) == 1); };
  EXPECT_EQ(found_inside(rules_, bound), "");
  // What no filter sees through is not there, so that libraries take clone() instead.
  EXPECT_EQ(found_inside(rules_, [] { return words(syscall(SYS_clone3, nullptr, 0) >= 0); }),
            std::strerror(ENOSYS));
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  const auto traced = [] { return words(ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) == 0); };
  EXPECT_EQ(found_inside(rules_, traced), kRefusedCall);
#endif
}

// The 32-bit interface has other numbers: 1 would be exit, 20 getpid. Where the kernel has none,
// the instruction ends the process.
TEST_F(Sandbox, NoCallOfTheThirtyTwoBitInterface) {
#ifdef __x86_64__
  const auto old_getpid = [] {
    long result = 20;
    asm volatile("int $0x80" : "+a"(result) : : "memory", "r8", "r9", "r10", "r11");
    return result == -EPERM ? kRefusedCall : std::to_string(result);
  };
  const std::string told = found_inside(rules_, old_getpid);
  EXPECT_TRUE(told == kRefusedCall || told == "ended by signal " + std::to_string(SIGSEGV)) << told;
#endif
}

TEST_F(Sandbox, ThreadsWorkAndAreBound) {
  const auto in_thread = [&] {
    std::string told;
    std::thread([&] {
      told = words(socket(AF_INET, SOCK_STREAM, 0) >= 0) + opened(root_ / "secret/file") +
             opened(root_ / "design/file");
    }).join();
    return told;
  };
  EXPECT_EQ(found_inside(rules_, in_thread), kRefusedCall + kRefusedFile);
  EXPECT_EQ(found_inside(rules_,
                         [] {
                           const pid_t child = fork();
                           if (child == 0) _exit(0);
                           return words(child > 0 && waitpid(child, nullptr, 0) == child);
                         }),
            "");
}

TEST_F(Sandbox, AThreadThatRanBeforeMakesNoSocketEither) {
  const pid_t child = fork();
  if (child == 0) {
    std::atomic<bool> is_entered{false};
    std::string told;
    std::thread earlier([&] {
      while (!is_entered) std::this_thread::yield();
      told = words(socket(AF_INET, SOCK_STREAM, 0) >= 0);
    });
    const std::string problem = cli::enter_sandbox(rules_, {});
    is_entered = true;
    earlier.join();
    _exit(problem.empty() && told == kRefusedCall ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

}  // namespace
}  // namespace sandbox_test
