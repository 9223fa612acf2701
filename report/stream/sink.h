#pragma once
// Where the bytes of a format go, piece by piece.

#include <stdexcept>
#include <string>
#include <string_view>

namespace report {

// They could not be written or kept; what(): why, "No space left on device".
class WriteFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Sink {
 public:
  Sink() = default;
  Sink(const Sink&) = delete;
  Sink& operator=(const Sink&) = delete;
  virtual ~Sink() = default;
  virtual void write(std::string_view bytes) = 0;  // throws WriteFailure
};

class TextSink : public Sink {
 public:
  void write(std::string_view bytes) override { text += bytes; }

  std::string text;
};

}  // namespace report
