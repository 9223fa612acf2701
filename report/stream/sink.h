#pragma once
// Receives the bytes of a format, piece by piece.

#include <stdexcept>
#include <string>
#include <string_view>

namespace report {

// Thrown if bytes could not be written or kept; what(): the reason, "No space left on device".
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

// Throws WriteFailure if there are more bytes than allowed.
void fail_beyond(double bytes, double most_bytes);

// Passes on this many bytes, and throws WriteFailure at the first byte beyond.
class LimitedSink : public Sink {
 public:
  LimitedSink(Sink& sink, double most_bytes) : sink_(sink), most_bytes_(most_bytes) {}

  void write(std::string_view bytes) override {
    bytes_ += static_cast<double>(bytes.size());
    fail_beyond(bytes_, most_bytes_);
    sink_.write(bytes);
  }

 private:
  Sink& sink_;
  double most_bytes_, bytes_ = 0.0;
};

}  // namespace report
