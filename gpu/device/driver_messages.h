#pragma once
// What a driver says about speed, such as buffers that it moves to host memory. Asked for by a
// debug context alone: drivers say nothing, or not all, without one.

#include <cstddef>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace gpu {

// For all threads: drivers call from their own.
class DriverMessages {
 public:
  enum class Kind {
    performance,
    other  // where it puts buffers, for one
  };
  struct Message {
    Kind kind;
    std::string text;
    std::size_t count = 0;
  };

  void add(Kind kind, const std::string& text);
  // Messages name buffers by OpenGL's numbers; those are used again.
  void name_buffer(unsigned name, const std::string& what);

  // All of this kind, repeated ones too.
  std::size_t count(Kind kind) const;
  // Each text once, the first first, at most kMostTexts: of the others only count() knows.
  std::vector<Message> messages() const;
  // "buffer 3: results, sums"
  std::vector<std::string> buffers() const;

  static constexpr std::size_t kMostTexts = 200;

 private:
  mutable std::mutex mutex_;
  std::size_t performance_ = 0, other_ = 0;
  std::vector<Message> messages_;
  std::map<std::pair<Kind, std::string>, std::size_t> place_;  // in messages_
  std::map<unsigned, std::vector<std::string>> buffers_;
};

}  // namespace gpu
