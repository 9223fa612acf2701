#pragma once
// Parts of whole pages: names of landmarks, and contents.

#include "report/html/page/page_style.h"
#include "report/text/texts.h"

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace report {

// Makes names of regions unique, because landmarks must differ in name and planes of several rooms
// may share a name. Repeats of "name" are "name (2)", "name (3)" ..., unless another region has
// that name.
class RegionNames {
 public:
  // html: made by our own renderers, so that no name from a file can hold a quote.
  std::string with_unique_regions(std::string_view html);

 private:
  std::string unique(const std::string& label);
  bool is_taken(const std::string& name) const;

  std::set<std::string> plain_;      // as they were labelled
  std::map<std::string, int> next_;  // by label: the number of its next repeat
};

struct ContentsEntry {
  std::string address, words;  // words: escaped
  bool is_on_paper = false;    // alone
};

// Returns a <nav> with the page numbers of the entries, if known. numbers: null = not known.
std::string html_contents(const Texts& t, const std::vector<ContentsEntry>& entries,
                          const PageNumbers* numbers);

}  // namespace report
