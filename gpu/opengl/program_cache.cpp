#include "gpu/opengl/program_cache.h"

#include "calc/base/file_hash.h"

#include <fmt/format.h>

#include <unistd.h>

#include <cstring>
#include <fstream>
#include <random>
#include <span>
#include <system_error>
#include <utility>

namespace gpu {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMagic = "luxgate program 1\n";
constexpr std::size_t kHashLength = 64;
constexpr std::size_t kMostBytes = std::size_t{64} << 20;

std::string_view text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string head_of(const std::string& key, const ProgramBinary& binary) {
  return fmt::format("{}{}{}{:08x}", kMagic, key, calc::sha256_hex(text_of(binary.bytes)),
                     binary.format);
}

}  // namespace

ProgramCache::ProgramCache(fs::path folder, std::string driver)
    : folder_(std::move(folder)), driver_(std::move(driver)) {}

std::string ProgramCache::key(std::string_view source) const {
  return calc::sha256_hex(fmt::format("{}\n{}\n{}", driver_.size(), driver_, source));
}

// The hash of the program inside tells a damaged file from a sound one: drivers may not.
std::optional<ProgramBinary> ProgramCache::find(std::string_view source) const {
  if (!is_on()) return std::nullopt;
  const std::string name = key(source);
  std::ifstream file(folder_ / name, std::ios::binary);
  std::error_code error;
  const std::uintmax_t size = fs::file_size(folder_ / name, error);
  const std::size_t head_size = kMagic.size() + 2 * kHashLength + 8;
  if (!file || error || size <= head_size || size > kMostBytes) return std::nullopt;
  std::string head(head_size, '\0');
  ProgramBinary binary;
  binary.bytes.resize(static_cast<std::size_t>(size) - head_size);
  if (!file.read(head.data(), static_cast<std::streamsize>(head.size())) ||
      !file.read(reinterpret_cast<char*>(binary.bytes.data()),
                 static_cast<std::streamsize>(binary.bytes.size()))) {
    return std::nullopt;
  }
  unsigned format = 0;
  if (std::sscanf(head.c_str() + head.size() - 8, "%8x", &format) != 1) return std::nullopt;
  binary.format = format;
  if (head != head_of(name, binary)) return std::nullopt;
  return binary;
}

void ProgramCache::keep(std::string_view source, const ProgramBinary& binary) const {
  if (!is_on() || binary.bytes.empty()) return;
  const std::string name = key(source);
  std::error_code error;
  fs::create_directories(folder_, error);
  const fs::path whole = folder_ / name;
  const fs::path part =
      folder_ / fmt::format("{}.{}.{:08x}", name, getpid(), std::random_device{}());
  {
    std::ofstream file(part, std::ios::binary);
    const std::string head = head_of(name, binary);
    file.write(head.data(), static_cast<std::streamsize>(head.size()));
    file.write(reinterpret_cast<const char*>(binary.bytes.data()),
               static_cast<std::streamsize>(binary.bytes.size()));
    file.close();
    if (file) fs::rename(part, whole, error);
    if (file && !error) return;
  }
  fs::remove(part, error);
}

}  // namespace gpu
