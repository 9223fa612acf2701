#include "report/stream/text_list.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace report {

void TextList::add(std::string_view text) {
  const std::uint64_t length = text.size();
  std::array<char, sizeof length> bytes{};
  std::memcpy(bytes.data(), &length, sizeof length);
  spill_.write({bytes.data(), bytes.size()});
  spill_.write(text);
}

std::string TextListReader::next() {
  std::uint64_t length = 0;
  std::memcpy(&length, take(sizeof length).data(), sizeof length);
  return take(static_cast<std::size_t>(length));
}

// Most texts are short: many are read at once.
std::string TextListReader::take(std::size_t count) {
  constexpr std::size_t kAhead = std::size_t{1} << 16;
  if (ahead_.size() - taken_ < count) {
    const std::uint64_t left = spill_.size() - at_;
    ahead_ = spill_.read(
        at_, static_cast<std::size_t>(std::min<std::uint64_t>(std::max(count, kAhead), left)));
    taken_ = 0;
  }
  std::string bytes = ahead_.substr(taken_, count);
  taken_ += count;
  at_ += count;
  return bytes;
}

}  // namespace report
