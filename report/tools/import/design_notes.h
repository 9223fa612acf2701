#pragma once
// Notes of an import: equal notes appear once, with their number.

#include "report/tools/import/design.h"

#include <cstddef>
#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace cli {

class DesignNotes {
 public:
  explicit DesignNotes(Design& design) : design_(design) {}

  void add(DesignNote::Kind kind, const std::string& what, const std::string& why,
           const std::string& place, std::size_t count = 1) {
    const auto [at, is_new] = index_.try_emplace({kind, what, why}, design_.note.size());
    if (is_new) {
      design_.note.push_back({kind, what, why, place, count});
    } else {
      design_.note[at->second].count += count;
    }
  }
  void left_out(const std::string& what, const std::string& why, const std::string& place = "",
                std::size_t count = 1) {
    add(DesignNote::Kind::left_out, what, why, place, count);
  }
  void doubt(const std::string& what, const std::string& why, const std::string& place = "",
             std::size_t count = 1) {
    add(DesignNote::Kind::doubt, what, why, place, count);
  }

 private:
  Design& design_;
  std::map<std::tuple<DesignNote::Kind, std::string, std::string>, std::size_t> index_;
};

}  // namespace cli
