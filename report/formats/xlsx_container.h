#pragma once
// A ZIP file that is written piece by piece. The only owner of zlib's deflate.

#include "report/stream/sink.h"
#include "report/stream/spill.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>

namespace report {

// One file of it, packed as it comes. All members throw WriteFailure.
class PackedFile {
 public:
  explicit PackedFile(const SpillPlace& place);
  PackedFile(const PackedFile&) = delete;
  PackedFile& operator=(const PackedFile&) = delete;
  ~PackedFile();

  void write(std::string_view bytes);
  // Once, after all is written; gives back the memory of packing.
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

// Files have the date 1980-01-01, so that the same content gives the same bytes.
class ZipFile {
 public:
  explicit ZipFile(Sink& sink) : sink_(sink) {}

  // In the order of the calls; file: finished; name: ASCII. Throws WriteFailure, also where the
  // archive would have 4 GiB, which this kind of ZIP file cannot hold.
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
