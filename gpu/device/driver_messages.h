#pragma once
// Collects a driver's messages about speed, such as buffers that it moves to host memory. Only a
// debug context requests them, because drivers give few or none without one.

#include <cstddef>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace gpu {

// For all threads, because drivers call from their own.
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
  // Names a buffer; messages name buffers by OpenGL's numbers, which are used again.
  void name_buffer(unsigned name, const std::string& what);

  // Returns the number of this kind, repeated ones too.
  std::size_t count(Kind kind) const;
  // Returns each text once, in order, at most kMostTexts; count() also counts the others.
  std::vector<Message> messages() const;
  // Returns texts like "buffer 3: results, sums".
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
