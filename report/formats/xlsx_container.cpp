#include "report/formats/xlsx_container.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

namespace report {
namespace {

constexpr std::uint64_t kMostZipBytes = std::numeric_limits<std::uint32_t>::max();

// Numbers of ZIP are little-endian.
void add_16(std::uint32_t value, std::string& bytes) {
  bytes += static_cast<char>(value & 0xFFu);
  bytes += static_cast<char>((value >> 8u) & 0xFFu);
}
void add_32(std::uint32_t value, std::string& bytes) {
  add_16(value & 0xFFFFu, bytes);
  add_16(value >> 16u, bytes);
}

std::uint32_t fits_32(std::uint64_t bytes) {
  if (bytes >= kMostZipBytes)
    throw WriteFailure("a spreadsheet of 4 GiB or more; points-csv has no such limit");
  return static_cast<std::uint32_t>(bytes);
}

}  // namespace

struct PackedFile::Packer {
  z_stream stream{};
  std::array<unsigned char, std::size_t{1} << 16> out{};
};

PackedFile::PackedFile(const SpillPlace& place)
    : packer_(std::make_unique<Packer>()), packed_(place) {
  // Fast: tables pack well at any level.
  constexpr int kLevel = 2, kMemory = 8, kWithoutHead = -15;
  if (deflateInit2(&packer_->stream, kLevel, Z_DEFLATED, kWithoutHead, kMemory,
                   Z_DEFAULT_STRATEGY) != Z_OK) {
    packer_.reset();
    throw WriteFailure("not enough memory to pack a spreadsheet");
  }
}

PackedFile::~PackedFile() {
  if (packer_) deflateEnd(&packer_->stream);
}

void PackedFile::write(std::string_view bytes) {
  while (!bytes.empty()) {  // zlib counts in 32 bits
    constexpr std::size_t kMost = std::size_t{1} << 30;
    const std::string_view piece = bytes.substr(0, kMost);
    pack(piece, false);
    bytes.remove_prefix(piece.size());
  }
}

void PackedFile::finish() {
  pack({}, true);
  deflateEnd(&packer_->stream);
  packer_.reset();
}

void PackedFile::pack(std::string_view bytes, bool is_last) {
  z_stream& stream = packer_->stream;
  std::string copy(bytes);  // zlib takes no pointer to const
  auto* begin = reinterpret_cast<unsigned char*>(copy.data());
  checksum_ =
      static_cast<std::uint32_t>(crc32(checksum_, begin, static_cast<unsigned int>(copy.size())));
  size_ += copy.size();
  stream.next_in = begin;
  stream.avail_in = static_cast<unsigned int>(copy.size());
  do {
    stream.next_out = packer_->out.data();
    stream.avail_out = static_cast<unsigned int>(packer_->out.size());
    if (deflate(&stream, is_last ? Z_FINISH : Z_NO_FLUSH) == Z_STREAM_ERROR)
      throw WriteFailure("a spreadsheet could not be packed");
    const std::size_t count = packer_->out.size() - stream.avail_out;
    if (count > 0) packed_.write({reinterpret_cast<const char*>(packer_->out.data()), count});
  } while (stream.avail_out == 0);
}

namespace {

constexpr std::uint32_t kZipVersion = 20, kNoFlags = 0, kDeflated = 8;
constexpr std::uint32_t kMidnight = 0, kFirstDay = 0x21;  // 1980-01-01

}  // namespace

// What stands before a file and in the list at the end, from the version that is needed on.
void ZipFile::add_facts(const Entry& entry, std::string& head) {
  add_16(kZipVersion, head);
  add_16(kNoFlags, head);
  add_16(kDeflated, head);
  add_16(kMidnight, head);
  add_16(kFirstDay, head);
  add_32(entry.checksum, head);
  add_32(entry.packed, head);
  add_32(entry.size, head);
  add_16(static_cast<std::uint32_t>(entry.name.size()), head);
}

void ZipFile::write(std::string_view bytes) {
  sink_.write(bytes);
  written_ += bytes.size();
}

void ZipFile::add(const std::string& name, const PackedFile& file) {
  const Entry entry{name, file.checksum_, fits_32(file.packed_.size()), fits_32(file.size_),
                    fits_32(written_)};
  std::string head("PK\x03\x04");
  add_facts(entry, head);
  add_16(0, head);  // nothing extra
  write(head + entry.name);
  fits_32(written_ + entry.packed);
  file.packed_.copy_to(sink_);
  written_ += entry.packed;
  entries_.push_back(entry);
}

void ZipFile::finish() {
  const std::uint32_t begin = fits_32(written_);
  for (const Entry& entry : entries_) {
    std::string head("PK\x01\x02");
    add_16(kZipVersion, head);  // that wrote it
    add_facts(entry, head);
    for (int i = 0; i < 4; ++i) add_16(0, head);  // extra, comment, disk, kind
    add_32(0, head);                              // of the file system
    add_32(entry.offset, head);
    write(head + entry.name);
  }
  const std::uint32_t size = fits_32(written_) - begin;
  const auto count = static_cast<std::uint32_t>(entries_.size());
  std::string end("PK\x05\x06");
  add_16(0, end);
  add_16(0, end);
  add_16(count, end);
  add_16(count, end);
  add_32(size, end);
  add_32(begin, end);
  add_16(0, end);  // no comment
  write(end);
}

}  // namespace report
