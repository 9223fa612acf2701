#include "report/shell/output/pdf_printer.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/utf8.h"
#include "report/shell/output/pdf_places.h"
#include "report/shell/process/print.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace cli {
namespace {

namespace fs = std::filesystem;

// A page of 8 MiB, 200 sheets, takes 8 s of a machine that has nothing else to do. A busy one may
// take a hundred times that.
constexpr double kLeastLimit_s = 300.0, kLimitByMebibyte_s = 100.0;
constexpr double kMebibyte = 1024.0 * 1024.0;
constexpr std::uint64_t kMostPdfBytes = std::uint64_t{1} << 31;

std::string error_words(int error) { return std::generic_category().message(error); }

bool is_program(const std::string& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored) && access(path.c_str(), X_OK) == 0;
}

// "" = there is none.
std::string program_in(std::string_view search_path, const std::string& name) {
  while (!search_path.empty()) {
    const std::size_t end = std::min(search_path.find(':'), search_path.size());
    const std::string folder(search_path.substr(0, end));
    if (folder.starts_with('/') && is_program(folder + "/" + name)) return folder + "/" + name;
    search_path.remove_prefix(std::min(end + 1, search_path.size()));
  }
  return "";
}

// --- what goes through the socket: sizes and bytes
// -------------------------------------------------

bool send_all(int socket, const void* bytes, std::size_t size) {
  const char* next = static_cast<const char*>(bytes);
  while (size > 0) {
    const ssize_t sent = send(socket, next, size, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    next += sent;
    size -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool receive_all(int socket, void* bytes, std::size_t size) {
  char* next = static_cast<char*>(bytes);
  while (size > 0) {
    const ssize_t received = recv(socket, next, size, 0);
    if (received < 0 && errno == EINTR) continue;
    if (received <= 0) return false;
    next += received;
    size -= static_cast<std::size_t>(received);
  }
  return true;
}

bool send_block(int socket, std::string_view bytes) {
  const std::uint64_t size = bytes.size();
  return send_all(socket, &size, sizeof size) && send_all(socket, bytes.data(), bytes.size());
}

std::optional<std::string> receive_block(int socket) {
  std::uint64_t size = 0;
  if (!receive_all(socket, &size, sizeof size) || size > kMostPdfBytes) return std::nullopt;
  std::string bytes(size, '\0');
  if (!receive_all(socket, bytes.data(), size)) return std::nullopt;
  return bytes;
}

// A page is blocks up to an empty one.
class SocketSink : public report::Sink {
 public:
  explicit SocketSink(int socket) : socket_(socket) {}

  void write(std::string_view bytes) override {
    if (bytes.empty()) return;
    if (!send_block(socket_, bytes)) throw report::WriteFailure("the printing process has ended");
  }

 private:
  int socket_;
};

// --- the printing process
// --------------------------------------------------------------------------

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (fs::temp_directory_path() / "luxgate-pdf-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) {
      throw std::system_error(
          errno, std::generic_category(),
          "cannot make a folder in " + fs::path(pattern).parent_path().string());
    }
    path_ = pattern;
  }
  ~TemporaryFolder() {
    // Chromium's last processes may still write there.
    std::error_code failure;
    for (int i = 0; i < 50; ++i) {
      fs::remove_all(path_, failure);
      if (!failure) return;
      usleep(20'000);
    }
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string file(const char* name) const { return path_ + "/" + name; }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

// Chromium's own sandbox needs one of both; to root it is not given.
bool has_namespaces() {
  if (geteuid() == 0) return false;
  const pid_t child = fork();
  if (child == 0) _exit(unshare(CLONE_NEWUSER) == 0 ? 0 : 1);
  int status = 1;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  std::error_code ignored;
  const fs::perms helper = fs::status("/usr/lib/chromium/chrome-sandbox", ignored).permissions();
  return (child > 0 && status == 0) ||
         (!ignored && (helper & fs::perms::set_uid) != fs::perms::none);
}

std::vector<std::string> words_for(const std::string& chromium, const TemporaryFolder& folder) {
  std::vector<std::string> words{
      chromium, "--headless", "--no-pdf-header-footer", "--generate-pdf-document-outline",
      "--print-to-pdf=" + folder.file("page.pdf"), "--user-data-dir=" + folder.file("profile"),
      // The same glyph widths everywhere; nobody to ask. Scripts cannot be switched off, since
      // Chromium prints by one: the page's own policy keeps others out.
      "--font-render-hinting=none", "--disable-gpu", "--host-resolver-rules=MAP * ~NOTFOUND",
      "--disable-background-networking", "--disable-component-update", "--disable-sync",
      "--disable-extensions", "--disable-breakpad", "--disable-crash-reporter",
      "--disable-dev-shm-usage", "--no-first-run", "--no-default-browser-check",
      "--password-store=basic", "--use-mock-keychain"};
  if (!has_namespaces()) words.push_back("--no-sandbox");
  words.push_back("file://" + folder.file("page.html"));
  return words;
}

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> list;
  for (std::string& word : words) list.push_back(word.data());
  list.push_back(nullptr);
  return list;
}

void point_to(int descriptor, const char* path, int flags) {
  const int file = open(path, flags | O_CLOEXEC, 0600);
  if (file >= 0) dup2(file, descriptor);
}

// Never returns. Nothing of ours goes along but these words. Chromium makes a socket in TMPDIR, and
// the path of a socket has at most 107 characters: the folder's own path can be longer.
[[noreturn]] void become_chromium(const std::string& chromium, const TemporaryFolder& folder,
                                  const std::string& search_path) {
  std::vector<std::string> words = words_for(chromium, folder);
  const std::string& home = folder.path();
  std::vector<std::string> settings{"PATH=" + search_path,
                                    "HOME=" + home,
                                    "TMPDIR=.",
                                    "XDG_CONFIG_HOME=" + home,
                                    "XDG_CACHE_HOME=" + home,
                                    "XDG_RUNTIME_DIR=" + home,
                                    "LANG=C.UTF-8",
                                    "TZ=UTC"};
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int signal_number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
    std::signal(signal_number, SIG_DFL);
  }
  point_to(STDERR_FILENO, folder.file("log").c_str(), O_WRONLY | O_CREAT);
  close_range(STDERR_FILENO + 1, ~0U, 0);  // what stood open before luxgate began
  if (chdir(home.c_str()) != 0) _exit(127);
  execve(chromium.c_str(), pointers(words).data(), pointers(settings).data());
  _exit(127);
}

std::string contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return std::move(bytes).str();
}

// The last words of a log, or those that Chromium itself calls fatal: more may follow them.
std::string last_line(std::string log) {
  constexpr std::size_t kMost = 300;
  if (const std::size_t fatal = log.find(":FATAL:"); fatal != log.npos) {
    log.resize(std::min(log.find('\n', fatal), log.size()));
  }
  while (!log.empty() && (log.back() == '\n' || log.back() == ' ')) log.pop_back();
  log.erase(0, log.rfind('\n') + 1);
  return log.empty() ? "" : ": " + calc::shorten_utf8(calc::printable(log), kMost);
}

class PrintingProcess {
 public:
  PrintingProcess(int socket, std::string chromium)
      : socket_(socket), chromium_(std::move(chromium)) {
    const char* path = std::getenv("PATH");
    search_path_ = path == nullptr ? "/usr/bin:/bin" : path;
  }

  // Until the socket is closed on the other side.
  void serve() {
    for (;;) {
      std::string result, problem;
      try {
        const TemporaryFolder folder;
        if (!take_page(folder.file("page.html"))) return;
        problem = print(folder);
        if (problem.empty()) result = contents(folder.file("page.pdf"));
        if (problem.empty() && !result.starts_with("%PDF-")) {
          problem = "it made no PDF" + last_line(contents(folder.file("log")));
        }
      } catch (const std::exception& error) {
        problem = error.what();
      }
      if (is_left_) return;
      if (!send_block(socket_, problem) || !send_block(socket_, result)) return;
    }
  }

 private:
  bool take_page(const std::string& path) {
    std::ofstream file(path, std::ios::binary);
    page_bytes_ = 0.0;
    for (;;) {
      const std::optional<std::string> block = receive_block(socket_);
      if (!block) return false;
      if (block->empty()) break;
      file << *block;
      page_bytes_ += static_cast<double>(block->size());
    }
    file.flush();
    if (!file) throw std::runtime_error("cannot write '" + path + "'");
    return true;
  }

  // "" or why there is no PDF.
  std::string print(const TemporaryFolder& folder) {
    const auto begin = std::chrono::steady_clock::now();
    const pid_t child = fork();
    if (child < 0) return error_words(errno);
    if (child == 0) become_chromium(chromium_, folder, search_path_);
    setpgid(child, child);
    int status = 0;
    std::string problem;
    while (waitpid(child, &status, WNOHANG) == 0) {
      pollfd other{socket_, POLLIN | POLLRDHUP, 0};
      is_left_ = poll(&other, 1, 10) > 0;  // it says nothing now, unless it has ended
      const std::chrono::duration<double> past = std::chrono::steady_clock::now() - begin;
      const double mebibytes = page_bytes_ / kMebibyte;
      const double limit_s = kLeastLimit_s + kLimitByMebibyte_s * mebibytes;
      if (past.count() > limit_s) {
        problem = fmt::format(
            "it was not done after {:.0f} s, the limit for a page of {:.1f} MiB; print when the "
            "machine is less busy, or fewer rooms at a time",
            limit_s, mebibytes);
      }
      if (!is_left_ && problem.empty()) continue;
      kill(-child, SIGKILL);
      waitpid(child, &status, 0);
      return problem;
    }
    kill(-child, SIGKILL);  // what it has left
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
    const std::string how = WIFEXITED(status) ? fmt::format("with code {}", WEXITSTATUS(status))
                                              : fmt::format("by signal {}", WTERMSIG(status));
    return "it ended " + how + last_line(contents(folder.file("log")));
  }

  int socket_;
  std::string chromium_, search_path_;
  double page_bytes_ = 0.0;
  bool is_left_ = false;  // by who asked
};

}  // namespace

namespace {

// open: makes a printer of that Chromium.
bool open_or_print(const std::function<void(const std::string&)>& open,
                   const Environment& environment) {
  FoundChromium found = find_chromium(environment);
  try {
    if (found.problem.empty()) open(found.path);
  } catch (const std::system_error& error) {
    found.problem = error.code().message();
  }
  if (found.problem.empty()) return true;
  print_error(calc::DiagnosticId::pdf_not_possible, found.problem);
  return false;
}

}  // namespace

FoundChromium find_chromium(const Environment& environment) {
  constexpr std::array<const char*, 4> kNames{"chromium", "chromium-browser", "google-chrome",
                                              "google-chrome-stable"};
  const std::string& asked = environment.chromium;
  if (!asked.empty()) {
    const bool is_path = asked.find('/') != asked.npos;
    const std::string path = is_path ? asked : program_in(environment.search_path, asked);
    if (is_program(path)) return {path, ""};
    return {"", fmt::format("LUXGATE_CHROMIUM is '{}', which is not a program on this machine",
                            calc::printable(asked))};
  }
  for (const char* name : kNames) {
    if (const std::string path = program_in(environment.search_path, name); !path.empty()) {
      return {path, ""};
    }
  }
  return {
      "",
      "Chromium, which prints it, was not found; install it (Debian and Ubuntu: 'apt install "
      "chromium'), or name a Chromium or Chrome by LUXGATE_CHROMIUM. '--format html' needs none"};
}

PdfPrinter::PdfPrinter(const std::string& chromium) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    throw std::system_error(errno, std::generic_category());
  }
  process_ = fork();
  if (process_ == 0) {
    close(ends[0]);
    // Who ends the other process by a signal to all ends this one by closing the socket.
    for (const int signal_number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
      std::signal(signal_number, SIG_IGN);
    }
    // Readers of our streams do not wait for it.
    point_to(STDIN_FILENO, "/dev/null", O_RDONLY);
    point_to(STDOUT_FILENO, "/dev/null", O_WRONLY);
    point_to(STDERR_FILENO, "/dev/null", O_WRONLY);
    PrintingProcess(ends[1], chromium).serve();
    _exit(0);
  }
  const int error = errno;
  close(ends[1]);
  socket_ = ends[0];
  if (process_ > 0) return;
  close(socket_);
  throw std::system_error(error, std::generic_category());
}

PdfPrinter::~PdfPrinter() {
  close(socket_);
  while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

std::string PdfPrinter::print(const std::function<void(report::Sink&)>& write_page) {
  SocketSink sink(socket_);
  try {
    write_page(sink);
  } catch (...) {  // half a page has gone through
    shutdown(socket_, SHUT_RDWR);
    throw;
  }
  if (send_block(socket_, "")) {
    const std::optional<std::string> problem = receive_block(socket_);
    std::optional<std::string> pdf = receive_block(socket_);
    if (problem && pdf && problem->empty()) return *std::move(pdf);
    if (problem && !problem->empty()) {
      throw report::WriteFailure("Chromium did not print it: " + *problem);
    }
  }
  throw report::WriteFailure("the printing process has ended");
}

report::PageNumbers PdfPrinter::places_in(const std::string& pdf) { return places_in_pdf(pdf); }

bool open_printer_or_print(OutputOptions& options, const Environment& environment) {
  const std::vector<OutputFormat>& asked = options.formats;
  if (std::none_of(asked.begin(), asked.end(),
                   [](const OutputFormat& item) { return item.format->is_printed; })) {
    return true;
  }
  return open_or_print(
      [&](const std::string& chromium) {
        options.printer = std::make_shared<PdfPrinter>(chromium);
      },
      environment);
}

bool open_printer_or_print(std::optional<PdfPrinter>& printer, const Environment& environment) {
  return open_or_print([&](const std::string& chromium) { printer.emplace(chromium); },
                       environment);
}

}  // namespace cli
