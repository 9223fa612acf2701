#pragma once
// Parts of a terminal report for a project of several rooms: a line for each room, why rooms do not
// pass, notes to be read with the results, and the important names for the end of the report.

#include "report/document/document.h"
#include "report/formats/console.h"
#include "report/text/texts.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace report {

// Returns the overview; "" = of a single room. On a narrow terminal names and uses are shortened,
// then columns are dropped; the last to stay are verdict, room, average, uniformity and glare.
std::string overview_text(const Texts& t, const ProjectPart& project, const TextOptions& options);

// Returns what keeps rooms from passing, room by room; rooms with the same reasons together. "" =
// nothing.
std::string causes_text(const Texts& t, const ProjectPart& project, const TextOptions& options);

struct RoomNotesText {
  std::string text;
  std::size_t hidden = 0;  // notes on method, which --notes shows
  bool is_folded = false;  // of some the first of their kind is here, and --notes shows each
};
RoomNotesText notes_text(const Texts& t, const ProjectPart& project, const TextOptions& options);

// Names of rooms by their outcome.
class RoomsToName {
 public:
  // Adds the rooms. path: of the project if there are several; else "".
  void add(const ProjectPart& project, const std::string& path);

  // Returns "1 room fails: Office · 2 rooms not judged: Hall, Store · 1 project not judged: a.xml";
  // "" if there is one room only, or none to name. A room that is not judged and fails in what is
  // judged is named twice.
  std::string text(const Texts& t, int terminal_width) const;

 private:
  struct List {
    std::vector<std::string> names;  // the first ones
    std::size_t count = 0;
  };
  static void add_name(const std::string& name, List& list);
  static std::string names(const Texts& t, const List& list);

  std::size_t rooms_ = 0;  // and projects that could not be read
  std::map<rules::Outcome, List> lists_;
  List unread_;  // projects
};

}  // namespace report
