#include "calc/photometry/read/zip_archive.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/photometry/read/photometry_options.h"
#include "calc/photometry/read/text_encoding.h"

#include <zip.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace calc {

struct CloseArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
using ArchiveHandle = std::unique_ptr<zip_t, CloseArchive>;

namespace {

struct CloseFile {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};

using FileHandle = std::unique_ptr<zip_file_t, CloseFile>;

// Null, and the reason in words, if the bytes are no archive.
ArchiveHandle open_in_memory(std::string_view bytes, std::string& reason) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  zip_t* archive = source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error);
  if (archive == nullptr) {
    reason = zip_error_strerror(&error);
    if (source != nullptr) zip_source_free(source);
  }
  zip_error_fini(&error);
  return ArchiveHandle(archive);
}

std::string in_bytes(std::size_t bytes) {
  return bytes >= (1u << 20) ? fmt::format("{} MiB", bytes >> 20) : fmt::format("{} bytes", bytes);
}

}  // namespace

struct ZipArchive::Contents {
  std::string name;
  std::size_t archive_bytes = 0;
  ZipLimits limits;
  Diagnostics* diagnostics = nullptr;
  ArchiveHandle handle;
  std::vector<std::string> names;
  std::map<std::string, zip_uint64_t, std::less<>> index_of;
  std::size_t bytes_read = 0;

  SourceLocation where() const { return {name, 0, 0}; }

  // Every name once and safe.
  bool list_entries() {
    const zip_int64_t count = zip_get_num_entries(handle.get(), 0);
    if (count < 0 || static_cast<std::size_t>(count) > limits.entries) {
      diagnostics->report(DiagnosticId::archive_size, where(),
                          fmt::format("the archive has {} entries", count), limits.entries);
      return false;
    }
    for (zip_uint64_t i = 0; i < static_cast<zip_uint64_t>(count); ++i) {
      const char* text = zip_get_name(handle.get(), i, ZIP_FL_ENC_GUESS);
      const std::string entry = text == nullptr ? "" : text;
      std::string_view reason = unsafe_name_reason(entry);
      if (reason.empty() && !index_of.try_emplace(entry, i).second) reason = "occurs twice";
      if (!reason.empty()) {
        diagnostics->report(DiagnosticId::archive_name, where(), quotable(entry), reason);
        return false;
      }
      names.push_back(entry);
    }
    return true;
  }

  std::size_t most_bytes() const {
    const std::size_t by_ratio =
        std::max(limits.free_bytes, archive_bytes > limits.file_bytes / limits.ratio
                                        ? limits.file_bytes
                                        : archive_bytes * limits.ratio);
    return std::min({limits.file_bytes, by_ratio, limits.total_bytes - bytes_read});
  }

  bool too_large(const std::string& entry, std::size_t most) {
    diagnostics->report(
        DiagnosticId::archive_size, where(),
        fmt::format("'{}' unpacks to more than {}", quotable(entry), in_bytes(most)),
        fmt::format("{} for each file, {} in all, {} times the size of the archive",
                    in_bytes(limits.file_bytes), in_bytes(limits.total_bytes), limits.ratio));
    return false;
  }

  bool damaged(const std::string& entry, const char* reason) {
    diagnostics->report(DiagnosticId::archive_entry, where(), quotable(entry), reason);
    return false;
  }

  bool unpack(const std::string& entry, zip_uint64_t index, std::string& bytes) {
    const FileHandle file(zip_fopen_index(handle.get(), index, 0));
    if (!file) return damaged(entry, zip_strerror(handle.get()));
    const std::size_t most = most_bytes();
    std::vector<char> piece(1u << 16);
    for (;;) {
      const zip_int64_t got = zip_fread(file.get(), piece.data(), piece.size());
      if (got < 0) return damaged(entry, zip_file_strerror(file.get()));
      if (got == 0) break;
      if (static_cast<std::size_t>(got) > most - bytes.size()) return too_large(entry, most);
      bytes.append(piece.data(), static_cast<std::size_t>(got));
    }
    bytes_read += bytes.size();
    return true;
  }
};

ZipArchive::ZipArchive(std::unique_ptr<Contents> contents) : contents_(std::move(contents)) {}
ZipArchive::ZipArchive(ZipArchive&&) noexcept = default;
ZipArchive& ZipArchive::operator=(ZipArchive&&) noexcept = default;
ZipArchive::~ZipArchive() = default;

std::optional<ZipArchive> ZipArchive::open(std::string_view bytes, const std::string& name,
                                           Diagnostics& diagnostics, const ZipLimits& limits) {
  std::string reason;
  auto contents = std::make_unique<Contents>();
  contents->handle = open_in_memory(bytes, reason);
  if (!contents->handle) {
    diagnostics.report(DiagnosticId::archive_unreadable, SourceLocation{name}, reason);
    return std::nullopt;
  }
  contents->name = name;
  contents->archive_bytes = bytes.size();
  contents->limits = limits;
  contents->diagnostics = &diagnostics;
  if (!contents->list_entries()) return std::nullopt;
  return ZipArchive(std::move(contents));
}

const std::vector<std::string>& ZipArchive::names() const { return contents_->names; }

bool ZipArchive::has(std::string_view name) const { return contents_->index_of.contains(name); }

std::optional<std::string> ZipArchive::read(const std::string& name) {
  const auto found = contents_->index_of.find(name);
  if (found == contents_->index_of.end()) {
    std::vector<PhotometryChoice> present;
    for (const std::string& entry : contents_->names) present.push_back({entry, ""});
    contents_->diagnostics->report(DiagnosticId::archive_missing, contents_->where(),
                                   quotable(name), list_choices(present));
    return std::nullopt;
  }
  std::string bytes;
  if (!contents_->unpack(name, found->second, bytes)) return std::nullopt;
  return bytes;
}

std::string_view unsafe_name_reason(std::string_view name) {
  if (name.empty()) return "is empty";
  if (name.find('\\') != std::string_view::npos) return "has a backslash";
  if (name.front() == '/') return "is absolute";
  if (name.size() >= 2 && name[1] == ':') return "has a drive letter";
  for (const char c : name) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) return "has a control character";
  }
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    if (name.substr(begin, end - begin) == "..") return "leaves the archive";
    begin = end + 1;
  }
  return "";
}

bool looks_like_zip(std::string_view bytes) {
  // The first file, or the end of an archive without files.
  return bytes.starts_with("PK\x03\x04") || bytes.starts_with("PK\x05\x06");
}

}  // namespace calc
