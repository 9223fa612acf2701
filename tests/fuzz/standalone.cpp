// Runs a fuzz target without libFuzzer: standalone NAME LIST MUTATIONS
// All files that LIST names (one path a line), then so many mutations of them, always the same.
// An input that crashes, takes a minute or asks for too much memory is written to crash-NAME in the
// current folder, and the program ends as the crash does. One that takes a second is written to
// slow-NAME, which is no failure: machines are slow or busy.
#include "calc/base/text.h"
#include "tests/fuzz/checks.h"
#include "tests/fuzz/mutate.h"
#include "tests/fuzz/target.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define LUXGATE_FUZZ_SANITIZED 1
#include <sanitizer/common_interface_defs.h>
#else
#define LUXGATE_FUZZ_SANITIZED 0
#endif

namespace {

constexpr unsigned kMostSeconds = 60;  // for one input, on a busy machine
constexpr double kSlow_s = 1.0;
constexpr rlim_t kMostMemory = rlim_t{1} << 30;  // bytes of address space
constexpr std::uint64_t kRandomSeed = 0x6C75786761746501;

// What the signal handler needs; it may not allocate.
std::string crash_file;
const std::string* current_input = nullptr;

void save_input() {
  if (current_input == nullptr) return;
  const int file = open(crash_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file < 0) return;
  const ssize_t written = write(file, current_input->data(), current_input->size());
  const std::string_view words = written < 0 ? "cannot write " : "the input is in ";
  for (const std::string_view text : {words, std::string_view(crash_file), std::string_view("\n")})
    if (write(STDERR_FILENO, text.data(), text.size()) < 0) break;
  close(file);
}

extern "C" void on_crash(int signal_number) {
  save_input();
  std::signal(signal_number, SIG_DFL);
  std::raise(signal_number);
}

void watch_for_crashes() {
  for (const int number : {SIGABRT, SIGALRM, SIGFPE, SIGILL}) std::signal(number, on_crash);
#if LUXGATE_FUZZ_SANITIZED
  __sanitizer_set_death_callback(save_input);  // SIGSEGV is the sanitizer's
#else
  for (const int number : {SIGSEGV, SIGBUS}) std::signal(number, on_crash);
  const rlimit limit{kMostMemory, kMostMemory};
  if (setrlimit(RLIMIT_AS, &limit) != 0) std::perror("setrlimit");
#endif
}

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    std::fprintf(stderr, "cannot read %s\n", path.c_str());
    std::exit(2);
  }
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> read_seeds(const std::string& list) {
  std::ifstream lines(list);
  std::vector<std::string> seeds;
  for (std::string path; std::getline(lines, path);) {
    if (!path.empty()) seeds.push_back(read_file(path));
  }
  return seeds;
}

std::string slow_file;
double slowest_s = 0.0;

void run_input(const std::string& input) {
  const auto start = std::chrono::steady_clock::now();
  // A copy without room at its end, so that a sanitizer sees reads behind it.
  const std::vector<std::uint8_t> bytes(input.begin(), input.end());
  current_input = &input;
  alarm(kMostSeconds);
  LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  alarm(0);
  current_input = nullptr;
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  if (taken.count() > std::max(slowest_s, kSlow_s)) std::ofstream(slow_file) << input;
  slowest_s = std::max(slowest_s, taken.count());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: %s NAME LIST MUTATIONS\n", argv[0]);
    return 2;
  }
  crash_file = std::string("crash-") + argv[1];
  slow_file = std::string("slow-") + argv[1];
  const std::vector<std::string> seeds = read_seeds(argv[2]);
  const int mutations = calc::parse_integer(argv[3]).value_or(0);
  if (seeds.empty()) {
    std::fprintf(stderr, "no seeds in %s\n", argv[2]);
    return 2;
  }
  watch_for_crashes();
  for (const std::string& seed : seeds) run_input(seed);
  const std::size_t read = fuzz::results();
  fuzz::Mutator mutator(seeds, kRandomSeed);
  for (int i = 0; i < mutations; ++i) run_input(mutator.next());
  std::printf("%s: %zu seeds, %d mutations, %zu of them read; slowest input %.3f s\n", argv[1],
              seeds.size(), mutations, fuzz::results() - read, slowest_s);
  if (read == 0) std::fprintf(stderr, "none of the seeds is a file that can be read\n");
  return read > 0 ? 0 : 1;
}
