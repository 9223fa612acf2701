#pragma once
// The words that every format uses for the project data.

#include "calc/scene/about_project.h"
#include "report/text/texts.h"

#include <string>
#include <vector>

namespace report {

struct AboutWords {
  const char* name;
  std::string words;  // on one line, printable; not escaped
};

// Returns the data that the project states.
std::vector<AboutWords> about_words(const Texts& t, const calc::AboutProject& about);

// Returns all of it on one line: "Client: A. Meier · Revision: b"; "" = nothing is stated.
std::string about_line(const Texts& t, const calc::AboutProject& about);

}  // namespace report
