#include "gpu/device/driver_messages.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace gpu {

void DriverMessages::add(Kind kind, const std::string& text) {
  const std::scoped_lock lock(mutex_);
  ++(kind == Kind::performance ? performance_ : other_);
  const auto [found, is_new] = place_.try_emplace({kind, text}, messages_.size());
  if (is_new && messages_.size() == kMostTexts) {
    place_.erase(found);
    return;
  }
  if (is_new) messages_.push_back({kind, text});
  ++messages_[found->second].count;
}

void DriverMessages::name_buffer(unsigned name, const std::string& what) {
  const std::scoped_lock lock(mutex_);
  std::vector<std::string>& names = buffers_[name];
  if (std::find(names.begin(), names.end(), what) == names.end()) names.push_back(what);
}

std::size_t DriverMessages::count(Kind kind) const {
  const std::scoped_lock lock(mutex_);
  return kind == Kind::performance ? performance_ : other_;
}

std::vector<DriverMessages::Message> DriverMessages::messages() const {
  const std::scoped_lock lock(mutex_);
  return messages_;
}

std::vector<std::string> DriverMessages::buffers() const {
  const std::scoped_lock lock(mutex_);
  std::vector<std::string> lines;
  for (const auto& [name, what] : buffers_) {
    lines.push_back(fmt::format("buffer {}: {}", name, fmt::join(what, ", ")));
  }
  return lines;
}

}  // namespace gpu
