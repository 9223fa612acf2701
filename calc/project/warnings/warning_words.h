#pragma once
// Combines warnings about many things into few: by element of the file, or the first few.

#include "calc/base/diagnostics.h"
#include "calc/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace calc {

// Returns " (and 3 more of this element)"; "" for 0.
inline std::string and_others(std::size_t others) {
  return others == 0 ? std::string() : fmt::format(" ({})", and_more(others, "of this element"));
}

// Gives a single warning for all things from one element of the file: the first id, and how many
// more.
struct FirstOfElement {
  std::string id;
  SourceLocation where;
  std::size_t others = 0;
};

class PerElement {
 public:
  void add(const std::string& id, const SourceLocation& where) {
    const auto [entry, is_new] =
        found_.try_emplace({where.line, where.column}, FirstOfElement{id, where, 0});
    if (!is_new) ++entry->second.others;
  }
  void report(const std::function<void(const FirstOfElement&)>& warn) const {
    for (const auto& [place, first] : found_) warn(first);
  }

 private:
  std::map<std::pair<int, int>, FirstOfElement> found_;
};

// Warns of things from different elements: names the first few, and the last of these tells how
// many more there are.
template <class Thing>
void warn_of_first_few(const std::vector<Thing>& things, const char* kind,
                       const std::function<void(const Thing&, const std::string& more)>& warn) {
  constexpr std::size_t kNamed = 3;
  for (std::size_t i = 0; i < std::min(things.size(), kNamed); ++i) {
    const bool has_more = i + 1 == kNamed && things.size() > kNamed;
    warn(things[i], has_more ? fmt::format(" ({})", and_more(things.size() - kNamed, kind)) : "");
  }
}

}  // namespace calc
