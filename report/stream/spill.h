#pragma once
// Text that must stand later in a file than something that is not known yet, however much it is.

#include "report/stream/sink.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace report {

// Temporary files without a name that were opened beforehand, for who may not open any later. Of
// one thread at a time.
class SpillFiles {
 public:
  // Fewer, or none, where the folder does not allow it.
  SpillFiles(const std::string& folder, std::size_t count);
  SpillFiles(const SpillFiles&) = delete;
  SpillFiles& operator=(const SpillFiles&) = delete;
  ~SpillFiles();

  // An empty one, or -1: none is left.
  int take();
  void give_back(int descriptor);

 private:
  std::vector<int> descriptors_;
};

// Where spills lie once they are too large for the memory.
struct SpillPlace {
  std::string folder;  // that of the file to be written has room for it, or else for nothing
  std::size_t most_in_memory = std::size_t{1} << 20;
  double most_bytes = std::numeric_limits<double>::infinity();  // see LimitedSink
  // If there are any, in place of the folder; where they do not suffice memory must do.
  std::shared_ptr<SpillFiles> files = nullptr;

  static SpillPlace memory() {
    return {"", std::numeric_limits<std::size_t>::max(), std::numeric_limits<double>::infinity()};
  }
};

// A little of it is kept in memory, all that goes beyond in a temporary file. It has no name, so
// that nothing stays behind, even if the process is killed. All members throw WriteFailure.
class Spill {
 public:
  explicit Spill(const SpillPlace& place) : place_(place) {}
  Spill(const Spill&) = delete;
  Spill& operator=(const Spill&) = delete;
  ~Spill();

  void write(std::string_view bytes);
  std::uint64_t size() const { return in_file_ + memory_.size(); }
  bool is_empty() const { return size() == 0; }
  // Of what was written; begin + count <= size().
  std::string read(std::uint64_t begin, std::size_t count) const;
  void copy_to(Sink& sink) const;
  // Forgets it all, and gives back what it took.
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
