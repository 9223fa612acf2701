#include "calc/store/memory_store.h"

#include "calc/base/file_hash.h"

namespace calc {

std::optional<std::string> MemoryStore::read(std::string_view key, std::size_t most_bytes) {
  const std::string hash = sha256(key);
  const std::lock_guard lock(mutex_);
  const auto found = entries_.find(hash);
  if (found == entries_.end() || found->second.size() > most_bytes) return std::nullopt;
  return found->second;
}

void MemoryStore::write(std::string_view key, std::string_view bytes) {
  const std::string hash = sha256(key);
  const std::lock_guard lock(mutex_);
  if (bytes.size() > most_bytes_ - bytes_) return;
  if (entries_.emplace(hash, bytes).second) bytes_ += bytes.size();
}

void MemoryStore::refuse(std::string_view key, std::string_view /*why*/) {
  const std::string hash = sha256(key);
  const std::lock_guard lock(mutex_);
  const auto found = entries_.find(hash);
  if (found == entries_.end()) return;
  bytes_ -= found->second.size();
  entries_.erase(found);
}

void MemoryStore::clear_above(std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  if (bytes_ <= bytes) return;
  entries_.clear();
  bytes_ = 0;
}

}  // namespace calc
