#pragma once
// What a project says of itself, as every format for people words it.

#include "calc/scene/about_project.h"
#include "report/text/texts.h"

#include <string>
#include <vector>

namespace report {

struct AboutWords {
  const char* name;
  std::string words;  // on one line, printable; not escaped
};

// Those that are said.
std::vector<AboutWords> about_words(const Texts& t, const calc::AboutProject& about);

// All on one line: "Client: A. Meier · Revision: b". "" = nothing is said.
std::string about_line(const Texts& t, const calc::AboutProject& about);

}  // namespace report
