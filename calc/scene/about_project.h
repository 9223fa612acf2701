#pragma once
// The client and authors of a design, as its project states them; they affect no light or verdict.

#include "calc/base/names.h"

#include <algorithm>
#include <array>
#include <string>

namespace calc {

enum class LogoFormat { png, svg };

template <>
struct EnumNames<LogoFormat> {
  static constexpr EnumName<LogoFormat> list[] = {{LogoFormat::png, "png"},
                                                  {LogoFormat::svg, "svg"}};
};

// A picture for a page, already checked: see project/reading/logo.h.
struct Logo {
  std::string file;  // as the project names it
  LogoFormat format = LogoFormat::png;
  std::string bytes;  // "" = there is none
};

struct AboutProject {
  // Each is "" if not stated. date: YYYY-MM-DD.
  std::string client, number, revision, date, author, company, address, note;
  Logo logo;

  inline bool is_empty() const;
};

// The texts with their names in files, in the order in which reports show them.
struct AboutText {
  const char* name;
  std::string AboutProject::*text;
};
inline constexpr std::array kAboutTexts{
    AboutText{"client", &AboutProject::client},     AboutText{"number", &AboutProject::number},
    AboutText{"revision", &AboutProject::revision}, AboutText{"date", &AboutProject::date},
    AboutText{"author", &AboutProject::author},     AboutText{"company", &AboutProject::company},
    AboutText{"address", &AboutProject::address},   AboutText{"note", &AboutProject::note}};

bool AboutProject::is_empty() const {
  return logo.bytes.empty() &&
         std::all_of(kAboutTexts.begin(), kAboutTexts.end(),
                     [&](const AboutText& one) { return (this->*one.text).empty(); });
}

}  // namespace calc
