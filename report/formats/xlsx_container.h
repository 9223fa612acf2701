#pragma once
// Writes a ZIP file piece by piece. The only user of zlib's deflate.

#include "report/stream/sink.h"
#include "report/stream/spill.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>

namespace report {

// A file in the archive, packed while it is written. All members throw WriteFailure.
class PackedFile {
 public:
  explicit PackedFile(const SpillPlace& place);
  PackedFile(const PackedFile&) = delete;
  PackedFile& operator=(const PackedFile&) = delete;
  ~PackedFile();

  void write(std::string_view bytes);
  // Ends the file, once, after all is written; frees the memory for packing.
  void finish();

 private:
  friend class ZipFile;
  struct Packer;
  void pack(std::string_view bytes, bool is_last);

  std::unique_ptr<Packer> packer_;  // null after finish()
  Spill packed_;
  std::uint64_t size_ = 0;  // unpacked
  std::uint32_t checksum_ = 0;
};

// A ZIP file. Its files have the date 1980-01-01, so that the same content gives the same bytes.
class ZipFile {
 public:
  explicit ZipFile(Sink& sink) : sink_(sink) {}

  // Adds a file, in the order of the calls; file: finished; name: ASCII. Throws WriteFailure, also
  // if the archive would reach 4 GiB, which this kind of ZIP file cannot hold.
  void add(const std::string& name, const PackedFile& file);
  void finish();  // once

 private:
  struct Entry {
    std::string name;
    std::uint32_t checksum, packed, size, offset;
  };
  static void add_facts(const Entry& entry, std::string& head);
  void write(std::string_view bytes);

  Sink& sink_;
  std::deque<Entry> entries_;
  std::uint64_t written_ = 0;
};

}  // namespace report
