#pragma once
// Reads the lines of an LM-63 file up to and including TILT=.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace calc {

enum class Lm63Version { v1986, v1991, v1995, v2002, v2019 };

struct Lm63Header {
  Lm63Version version = Lm63Version::v2002;
  bool version_known = true;
  std::string tag;  // as written, UTF-8; "LM-63-1986" for files without one
  std::vector<std::pair<std::string, std::string>>
      keywords;      // upper-case name and text, in file order
  std::string tilt;  // what follows "TILT=", trimmed
  int tilt_line = 0;
  std::string_view numbers;  // the text after the TILT= line

  // Returns the first such keyword's text, "[MORE]" lines joined with blanks; "" if there is none.
  std::string keyword(std::string_view name) const;
};

// Returns the header; empty if there is no TILT= line.
std::optional<Lm63Header> read_lm63_header(std::string_view text);

// Returns the names of keywords that this version requires and the file lacks.
std::vector<std::string_view> missing_keywords(const Lm63Header& header);

}  // namespace calc
