#include "calc/base/file_reader.h"

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

namespace calc {
namespace {

constexpr std::uintmax_t kLargestFileBytes = std::uintmax_t{512} << 20;

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

FileContent failure(std::string reason) { return {{}, std::move(reason)}; }

}  // namespace

FileContent DiskFileReader::read(const std::string& path) const {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (error) return failure(error.message());
  if (std::filesystem::is_directory(status)) return failure("it is a folder");
  if (!std::filesystem::is_regular_file(status)) return failure("it is not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) return failure(error.message());
  if (size > kLargestFileBytes) return failure("it is larger than 512 MiB");

  const std::unique_ptr<std::FILE, FileCloser> file(std::fopen(path.c_str(), "rb"));
  if (!file) return failure(std::strerror(errno));
  FileContent content;
  content.bytes.resize(size);
  const std::size_t got = std::fread(content.bytes.data(), 1, content.bytes.size(), file.get());
  if (got != content.bytes.size()) return failure("it became shorter while being read");
  return content;
}

}  // namespace calc
