#pragma once
// Holds text of any size that follows a part of a file that is not known yet.

#include "report/stream/sink.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace report {

// Unnamed temporary files that were opened beforehand, for processes that cannot open any later.
// For one thread at a time.
class SpillFiles {
 public:
  // Opens fewer files, or none, if the folder does not allow it.
  SpillFiles(const std::string& folder, std::size_t count);
  SpillFiles(const SpillFiles&) = delete;
  SpillFiles& operator=(const SpillFiles&) = delete;
  ~SpillFiles();

  // Returns an empty file, or -1: none is left.
  int take();
  void give_back(int descriptor);

 private:
  std::vector<int> descriptors_;
};

// The place of spills that are too large for the memory.
struct SpillPlace {
  std::string folder;  // that of the file to be written has room for it, or else for nothing
  std::size_t most_in_memory = std::size_t{1} << 20;
  double most_bytes = std::numeric_limits<double>::infinity();  // see LimitedSink
  // Files to use instead of the folder, if set; if there are too few, memory is used.
  std::shared_ptr<SpillFiles> files = nullptr;

  static SpillPlace memory() {
    return {"", std::numeric_limits<std::size_t>::max(), std::numeric_limits<double>::infinity()};
  }
};

// Keeps a little in memory, and the rest in a temporary file without a name, so that nothing
// remains even if the process is killed. All members throw WriteFailure.
class Spill {
 public:
  explicit Spill(const SpillPlace& place) : place_(place) {}
  Spill(const Spill&) = delete;
  Spill& operator=(const Spill&) = delete;
  ~Spill();

  void write(std::string_view bytes);
  std::uint64_t size() const { return in_file_ + memory_.size(); }
  bool is_empty() const { return size() == 0; }
  // Returns a part of the text; begin + count <= size().
  std::string read(std::uint64_t begin, std::size_t count) const;
  void copy_to(Sink& sink) const;
  // Removes all text, and frees its memory and disk space.
  void clear();

 private:
  void move_to_file();
  void close_file();
  void read_file(std::uint64_t begin, char* bytes, std::size_t count) const;

  SpillPlace place_;
  std::string memory_;  // what comes after the file's bytes
  std::uint64_t in_file_ = 0;
  int descriptor_ = -1;
};

}  // namespace report
