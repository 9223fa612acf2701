#include "report/shell/options/sandbox.h"

#include "calc/base/diagnostic_ids.h"
#include "report/shell/command/option_values.h"
#include "report/shell/process/print.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace cli {
namespace {

namespace fs = std::filesystem;

std::string words_of(int error) { return std::generic_category().message(error); }

// --- files: Landlock ---------------------------------------------------------------------------
// Numbers of the kernel's interface. The header of Debian 12 knows the first of its versions only,
// while the program may run on any kernel.

constexpr long kCreateRuleset = 444, kAddRule = 445, kRestrictSelf = 446;
constexpr unsigned kAskVersion = 1u;
constexpr int kPathBeneath = 1;

constexpr std::uint64_t bit(int number) { return std::uint64_t{1} << number; }
constexpr std::uint64_t kWriteFile = bit(1), kReadFile = bit(2), kReadFolder = bit(3),
                        kRemoveFolder = bit(4), kRemoveFile = bit(5), kMakeFolder = bit(7),
                        kMakeFile = bit(8), kTruncate = bit(14), kDevice = bit(15);
// Rights that a version can take away. Renaming stays within a folder, which no right is for.
constexpr std::uint64_t kOfFirst = bit(13) - 1, kOfSecond = bit(14) - 1, kOfThird = bit(15) - 1,
                        kOfFifth = bit(16) - 1;
constexpr std::uint64_t kTcp = bit(0) | bit(1);  // to bind, to connect
constexpr std::uint64_t kAbstractSocketsAndSignals = bit(0) | bit(1);

constexpr std::uint64_t kToRead = kReadFile | kReadFolder;
constexpr std::uint64_t kToWrite =
    kToRead | kWriteFile | kTruncate | kMakeFile | kMakeFolder | kRemoveFile | kRemoveFolder;
constexpr std::uint64_t kOfFiles = kReadFile | kWriteFile | kTruncate | kDevice;

struct RulesetAttributes {
  std::uint64_t files, network, scopes;
};
struct [[gnu::packed]] PathAttributes {
  std::uint64_t allowed;
  std::int32_t path;
};

std::uint64_t rights_of(long version) {
  if (version < 2) return kOfFirst;
  if (version < 3) return kOfSecond;
  return version < 5 ? kOfThird : kOfFifth;
}

class Descriptor {
 public:
  explicit Descriptor(long number) : number_(static_cast<int>(number)) {}
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }

 private:
  int number_;
};

class Ruleset {
 public:
  // version: of the kernel's Landlock.
  explicit Ruleset(long version)
      : handled_(rights_of(version)), number_(create(version, handled_)) {}

  bool is_there() const { return number_.number() >= 0; }

  // What cannot be opened is nothing that a rule could allow.
  void allow(const std::string& path, std::uint64_t rights) {
    const Descriptor place(open(path.c_str(), O_PATH | O_CLOEXEC));
    struct stat state {};
    if (place.number() < 0 || fstat(place.number(), &state) != 0) return;
    if (!S_ISDIR(state.st_mode)) rights &= kOfFiles;
    const PathAttributes attributes{rights & handled_, place.number()};
    // Pipes and sockets are refused here: Landlock does not close them.
    syscall(kAddRule, number_.number(), kPathBeneath, &attributes, 0);
  }

  bool restrict_self() const { return syscall(kRestrictSelf, number_.number(), 0) == 0; }

 private:
  static long create(long version, std::uint64_t handled) {
    const RulesetAttributes attributes{handled, version < 4 ? 0 : kTcp,
                                       version < 6 ? 0 : kAbstractSocketsAndSignals};
    return syscall(kCreateRuleset, &attributes, sizeof attributes, 0);
  }

  std::uint64_t handled_;
  Descriptor number_;
};

// Libraries and drivers that are loaded late, and tables of the system. Of /etc only what these
// read: there are secrets beside it. No other process's folder in /proc.
constexpr const char* kSystemRead[] = {
    // programs' libraries and what drivers are installed with
    "/usr", "/lib", "/lib32", "/lib64", "/libx32", "/opt/amdgpu", "/nix/store", "/gnu/store",
    "/run/opengl-driver",
    // processors, memory, devices, this process
    "/sys", "/proc/self", "/proc/cpuinfo", "/proc/meminfo", "/proc/stat", "/proc/filesystems",
    "/proc/version", "/proc/devices", "/proc/modules", "/proc/driver", "/proc/sys", "/dev/random",
    "/dev/urandom",
    // settings of the linker, the clock and OpenGL; Mesa asks for the user's folder
    "/etc/ld.so.cache", "/etc/ld.so.conf", "/etc/ld.so.conf.d", "/etc/alternatives",
    "/etc/localtime", "/etc/timezone", "/etc/locale.alias", "/etc/drirc", "/etc/glvnd", "/etc/egl",
    "/etc/nvidia", "/etc/nsswitch.conf", "/etc/passwd"};
constexpr const char* kSystemWrite[] = {
    // of graphics processors: drivers find out which there are
    "/dev/null", "/dev/zero", "/dev/full",    "/dev/dri",
    "/dev/kfd",  "/dev/dxg",  "/dev/udmabuf", "/dev/dma_heap"};

void allow_system(Ruleset& rules, const Environment& environment) {
  for (const char* path : kSystemRead) rules.allow(path, kToRead);
  for (const std::string& path : environment.library_places) rules.allow(path, kToRead);
  constexpr std::uint64_t kDevices = kToRead | kWriteFile | kDevice;
  for (const char* path : kSystemWrite) rules.allow(path, kDevices);
  std::error_code failure;
  for (fs::directory_iterator it("/dev", failure), end; !failure && it != end;
       it.increment(failure)) {
    if (it->path().filename().string().starts_with("nvidia")) rules.allow(it->path(), kDevices);
  }
}

// Drivers complain where they cannot write, and Mesa then gives out no compiled program either.
void keep_driver_files_in(const std::string& folder) {
  if (folder.empty()) {
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    setenv("__GL_SHADER_DISK_CACHE", "0", 1);
    return;
  }
  setenv("MESA_SHADER_CACHE_DIR", folder.c_str(), 1);
  setenv("__GL_SHADER_DISK_CACHE_PATH", folder.c_str(), 1);
}

std::string closest_existing(const std::string& path) {
  std::error_code failure;
  fs::path place = fs::weakly_canonical(fs::absolute(path, failure), failure);
  while (!fs::exists(place, failure) && place.has_relative_path()) place = place.parent_path();
  return place.string();
}

std::string close_files(const SandboxRules& rules, const Environment& environment) {
  const long version = syscall(kCreateRuleset, nullptr, 0, kAskVersion);
  if (version < 1) return words_of(errno);
  Ruleset ruleset(version);
  if (!ruleset.is_there()) return words_of(errno);
  allow_system(ruleset, environment);
  for (const std::string& path : rules.read) ruleset.allow(path, kToRead);
  for (const std::string& path : rules.write) ruleset.allow(closest_existing(path), kToWrite);
  if (!rules.driver_folder.empty()) ruleset.allow(rules.driver_folder, kToWrite);
  keep_driver_files_in(rules.driver_folder);
  return ruleset.restrict_self() ? "" : words_of(errno);
}

// --- calls of the kernel: seccomp ----------------------------------------------------------------

#ifdef __x86_64__

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;
#elif defined(__has_feature)
constexpr bool kIsSanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool kIsSanitized = false;
#endif

// Newer than the headers of Debian 12, or than older ones.
constexpr int kFchmodat2 = 452;

// What a batch of calculations never does. A closed list of what it does would break with the next
// version of a driver.
constexpr int kRefused[] = {
    // programs, also from memory
    SYS_execve, SYS_execveat,
    // sockets; what stands open, as standard output may, stays
    SYS_socket, SYS_connect, SYS_bind, SYS_listen, SYS_accept, SYS_accept4,
    // other processes
    SYS_process_vm_readv, SYS_process_vm_writev, SYS_process_madvise, SYS_process_mrelease,
    SYS_kcmp, SYS_pidfd_open, SYS_pidfd_getfd, SYS_pidfd_send_signal, SYS_tkill,
    SYS_rt_sigqueueinfo, SYS_rt_tgsigqueueinfo,
    // file systems and namespaces
    SYS_mount, SYS_umount2, SYS_pivot_root, SYS_chroot, SYS_move_mount, SYS_open_tree, SYS_fsopen,
    SYS_fsconfig, SYS_fsmount, SYS_fspick, SYS_mount_setattr, SYS_swapon, SYS_swapoff, SYS_quotactl,
    SYS_quotactl_fd, SYS_unshare, SYS_setns,
    // files around Landlock, or an old one: cutting off, owners, rights and attributes, and what is
    // opened without a path
    SYS_truncate, SYS_chmod, SYS_fchmod, SYS_fchmodat, kFchmodat2, SYS_chown, SYS_fchown,
    SYS_lchown, SYS_fchownat, SYS_setxattr, SYS_lsetxattr, SYS_fsetxattr, SYS_removexattr,
    SYS_lremovexattr, SYS_fremovexattr, SYS_open_by_handle_at,
    // the kernel itself, and parts of it in which mistakes are often found
    SYS_bpf, SYS_perf_event_open, SYS_userfaultfd, SYS_io_uring_setup, SYS_io_uring_enter,
    SYS_io_uring_register, SYS_keyctl, SYS_add_key, SYS_request_key, SYS_kexec_load,
    SYS_kexec_file_load, SYS_init_module, SYS_finit_module, SYS_delete_module, SYS_reboot, SYS_acct,
    SYS_settimeofday, SYS_clock_settime, SYS_adjtimex, SYS_clock_adjtime, SYS_sethostname,
    SYS_setdomainname, SYS_iopl, SYS_ioperm, SYS_syslog, SYS_vhangup, SYS_fanotify_init};

// The flags of clone() that make namespaces.
constexpr std::uint32_t kNewNamespaces = 0x7e020000;
constexpr std::uint32_t kX32Bit = 0x40000000;

class Filter {
 public:
  Filter() {
    load(offsetof(seccomp_data, arch));
    refuse_unless(AUDIT_ARCH_X86_64);
    load(offsetof(seccomp_data, nr));
    add(BPF_JMP | BPF_JGE | BPF_K, kX32Bit, 0, 1);
    refuse();
    for (const int call : kRefused) refuse_if(static_cast<std::uint32_t>(call));
    // The sanitizers look for leaks with it.
    if (!kIsSanitized) refuse_if(SYS_ptrace);
    // Its flags lie in memory, where no filter sees them: libraries fall back on clone.
    refuse_if(SYS_clone3, ENOSYS);
    for_argument(SYS_clone, 0, [this] {
      add(BPF_JMP | BPF_JSET | BPF_K, kNewNamespaces, 0, 1);
      refuse();
    });
    // Words that a terminal would take as typed, after the program's end.
    for_argument(SYS_ioctl, 1, [this] {
      refuse_if(TIOCSTI);
      refuse_if(TIOCLINUX);
    });
    const auto own = static_cast<std::uint32_t>(getpid());
    for (const int call : {SYS_kill, SYS_tgkill}) {
      for_argument(call, 0, [this, own] { refuse_unless(own); });
    }
    allow();
  }

  // On all threads, also those that run already. "" or what failed.
  std::string install() {
    const sock_fprog program{static_cast<unsigned short>(lines_.size()), lines_.data()};
    const long result =
        syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_TSYNC, &program);
    if (result == 0) return "";
    return result < 0 ? words_of(errno) : fmt::format("thread {} has another filter", result);
  }

 private:
  void add(int code, std::uint32_t value, std::uint8_t if_so = 0, std::uint8_t if_not = 0) {
    lines_.push_back({static_cast<std::uint16_t>(code), if_so, if_not, value});
  }
  void load(std::size_t offset) {
    add(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset));
  }
  void refuse(int error = EPERM) {
    add(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error));
  }
  void allow() { add(BPF_RET | BPF_K, SECCOMP_RET_ALLOW); }
  void refuse_if(std::uint32_t value, int error = EPERM) {
    add(BPF_JMP | BPF_JEQ | BPF_K, value, 0, 1);
    refuse(error);
  }
  void refuse_unless(std::uint32_t value) {
    add(BPF_JMP | BPF_JEQ | BPF_K, value, 1, 0);
    refuse();
  }
  // Of that call alone: what `check` does not refuse by the lower half of the argument is allowed.
  template <class Check>
  void for_argument(int call, std::size_t argument, const Check& check) {
    const std::size_t jump = lines_.size();
    add(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(call));
    load(offsetof(seccomp_data, args) + argument * sizeof(std::uint64_t));
    check();
    allow();
    lines_[jump].jf = static_cast<std::uint8_t>(lines_.size() - jump - 1);
  }

  std::vector<sock_filter> lines_;
};

std::string close_calls() { return Filter().install(); }

#else

std::string close_calls() { return "it is known for x86-64 processors alone"; }

#endif

}  // namespace

Option sandbox_option(SandboxMode& target) {
  return {"--sandbox", "WHEN",
          "Give up rights that are not needed, before projects are read: auto, on or off; default "
          "auto. The program can then not use other files, other programs or the network. auto "
          "does what the kernel can. on is an error where the kernel cannot",
          choice<SandboxMode>(target, {{"auto", SandboxMode::automatic},
                                       {"on", SandboxMode::on},
                                       {"off", SandboxMode::off}})};
}

std::string enter_sandbox(const SandboxRules& rules, const Environment& environment) {
  // Without it neither is allowed to those who are not root.
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return "no_new_privs: " + words_of(errno);
  const std::string files = close_files(rules, environment);
  const std::string calls = close_calls();
  if (!files.empty()) return "Landlock, which closes files: " + files;
  return calls.empty() ? "" : "seccomp, which closes calls of the kernel: " + calls;
}

bool enter_sandbox_or_print(SandboxMode mode, const SandboxRules& rules,
                            const Environment& environment) {
  if (mode == SandboxMode::off) return true;
  const std::string problem = enter_sandbox(rules, environment);
  if (problem.empty() || mode == SandboxMode::automatic) return true;
  print_error(calc::DiagnosticId::sandbox_not_possible, problem);
  return false;
}

}  // namespace cli
