#include "report/stream/spill.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace report {
namespace {

[[noreturn]] void fail(int error) { throw WriteFailure(std::generic_category().message(error)); }

// Not every file system has files that never had a name.
int open_nameless(const std::string& folder) {
  constexpr mode_t kOwnerOnly = 0600;
  const int nameless = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, kOwnerOnly);
  if (nameless >= 0) return nameless;
  std::string name = folder + "/.luxgate-XXXXXX";
  const int named = ::mkostemp(name.data(), O_CLOEXEC);
  if (named < 0) fail(errno);
  ::unlink(name.c_str());
  return named;
}

}  // namespace

SpillFiles::SpillFiles(const std::string& folder, std::size_t count) {
  try {
    while (descriptors_.size() < count) descriptors_.push_back(open_nameless(folder));
  } catch (const WriteFailure&) {
  }
}

SpillFiles::~SpillFiles() {
  for (const int descriptor : descriptors_) ::close(descriptor);
}

int SpillFiles::take() {
  if (descriptors_.empty()) return -1;
  const int descriptor = descriptors_.back();
  descriptors_.pop_back();
  return descriptor;
}

void SpillFiles::give_back(int descriptor) {
  if (::ftruncate(descriptor, 0) == 0) {
    descriptors_.push_back(descriptor);
  } else {
    ::close(descriptor);
  }
}

Spill::~Spill() { close_file(); }

void Spill::write(std::string_view bytes) {
  fail_beyond(static_cast<double>(size() + bytes.size()), place_.most_bytes);
  memory_ += bytes;
  if (memory_.size() > place_.most_in_memory) move_to_file();
}

void Spill::move_to_file() {
  if (descriptor_ < 0) {
    descriptor_ = place_.files ? place_.files->take() : open_nameless(place_.folder);
  }
  if (descriptor_ < 0) {
    place_.most_in_memory = std::numeric_limits<std::size_t>::max();
    return;
  }
  std::string_view rest = memory_;
  while (!rest.empty()) {
    const ssize_t count = ::pwrite(descriptor_, rest.data(), rest.size(),
                                   static_cast<off_t>(in_file_ + (memory_.size() - rest.size())));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(errno);
    rest.remove_prefix(static_cast<std::size_t>(count));
  }
  in_file_ += memory_.size();
  memory_.clear();
}

void Spill::read_file(std::uint64_t begin, char* bytes, std::size_t count) const {
  while (count > 0) {
    const ssize_t got = ::pread(descriptor_, bytes, count, static_cast<off_t>(begin));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(errno);
    if (got == 0) throw WriteFailure("a temporary file was cut off");
    begin += static_cast<std::uint64_t>(got);
    bytes += got;
    count -= static_cast<std::size_t>(got);
  }
}

std::string Spill::read(std::uint64_t begin, std::size_t count) const {
  std::string bytes;
  if (begin < in_file_) {
    bytes.resize(static_cast<std::size_t>(std::min<std::uint64_t>(count, in_file_ - begin)));
    read_file(begin, bytes.data(), bytes.size());
  }
  const std::size_t rest = count - bytes.size();
  if (rest > 0) {
    bytes += std::string_view(memory_).substr(
        static_cast<std::size_t>(begin + bytes.size() - in_file_), rest);
  }
  return bytes;
}

void Spill::copy_to(Sink& sink) const {
  constexpr std::uint64_t kPiece = std::uint64_t{1} << 18;
  for (std::uint64_t at = 0; at < in_file_; at += kPiece) {
    sink.write(read(at, static_cast<std::size_t>(std::min(kPiece, in_file_ - at))));
  }
  sink.write(memory_);
}

void Spill::close_file() {
  if (descriptor_ < 0) return;
  if (place_.files) {
    place_.files->give_back(descriptor_);
  } else {
    ::close(descriptor_);
  }
  descriptor_ = -1;
}

void Spill::clear() {
  close_file();
  in_file_ = 0;
  memory_.clear();
  memory_.shrink_to_fit();
}

}  // namespace report
