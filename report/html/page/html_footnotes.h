#pragma once
// Remarks shared by several values appear once, at the end of the page; a small number beside each
// value refers to them.

#include "calc/base/message.h"
#include "report/document/document.h"
#include "report/text/texts.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace report {

// A plane with its room; both outlive it.
struct RoomPlane {
  const SpacePart* space = nullptr;
  const PlanePart* plane = nullptr;
};
std::vector<RoomPlane> planes_of(const ProjectPart& project);

// A remark to be read with a value. html: finished, a part of a sentence.
struct NoteItem {
  std::string html;
  // How well a number of a standard is founded: one_source, of grids alone, since the report says
  // it once of requirements, or unverified.
  std::optional<calc::Sentence> source = {};
};
// Returns the items of a finding: the parts of note_parts(), a mask without the number of its
// points.
std::vector<NoteItem> note_items(const Texts& t, const rules::Finding& finding);
// Returns the parts of a message, which "; " separates.
std::vector<NoteItem> note_items(const Texts& t, const calc::Message& message);

// Returns names without the words about their source, which a footnote has: "EN 12464-1:2021" for
// "EN 12464-1:2021 [one public source]".
calc::Message without_source(const calc::Message& message);
// Returns these words as items.
std::vector<NoteItem> source_items(const Texts& t, const calc::Message& message);

class Footnotes {
 public:
  explicit Footnotes(const Texts& t) : t_(t) {}

  // Numbers the remarks that two or more of these findings or planes share, unless they have a
  // number. To be called before any of them is rendered.
  void add(const std::vector<RoomPlane>& planes);

  // Returns the items without a number, with "; " between them.
  std::string inline_html(const std::vector<NoteItem>& items) const;
  // Returns the numbers of all others, as links to the list; "" = none.
  std::string marks(const std::vector<NoteItem>& items) const;
  bool has(const NoteItem& item) const { return numbers_.contains(item.html); }

  // Returns a heading and the list; "" = nothing has a number.
  std::string list() const;

 private:
  struct Note {
    NoteItem item;
    std::vector<std::string> places;  // rooms; of a source the rows of the standard; escaped
  };
  struct Use {
    std::size_t times = 0;
    Note note;
  };
  using Uses = std::map<std::string, Use>;

  void use(const NoteItem& item, const std::string& place, Uses& uses,
           std::vector<std::string>& order) const;

  Texts t_;
  std::map<std::string, std::size_t> numbers_;  // index in notes_, by HTML
  std::vector<Note> notes_;
};

}  // namespace report
