#pragma once
// Of a project of several rooms on a terminal: a line for each room, why rooms do not pass, what
// must be read with the results, and the names that matter for the end of the report.

#include "report/document/document.h"
#include "report/formats/console.h"
#include "report/text/texts.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace report {

// "" = of a single room. On a narrow terminal names and uses give way, then columns go: what stays
// longest is the verdict, the room, average, uniformity and glare.
std::string overview_text(const Texts& t, const ProjectPart& project, const TextOptions& options);

// What keeps rooms from passing, room by room; rooms with the same reasons together. "" = nothing.
std::string causes_text(const Texts& t, const ProjectPart& project, const TextOptions& options);

struct RoomNotesText {
  std::string text;
  std::size_t hidden = 0;  // notes on method, which --notes shows
  bool is_folded = false;  // of some the first of their kind is here, and --notes shows each
};
RoomNotesText notes_text(const Texts& t, const ProjectPart& project, const TextOptions& options);

// Names of rooms by what they came to.
class RoomsToName {
 public:
  // path: of the project, where there are several; else "".
  void add(const ProjectPart& project, const std::string& path);

  // "1 room fails: Office · 2 rooms not judged: Hall, Store"; "" where a single room is all there
  // is, or none is to be named. A room that is not judged, and fails in what is, is named twice.
  std::string text(const Texts& t, int terminal_width) const;

 private:
  struct List {
    std::vector<std::string> names;  // the first ones
    std::size_t count = 0;
  };
  void add_name(rules::Outcome outcome, const std::string& name);

  std::size_t rooms_ = 0;
  std::map<rules::Outcome, List> lists_;
};

}  // namespace report
