#pragma once
// What must be read with a project's numbers, beside its findings: one list, so that no format
// leaves anything out. A new kind is a line here, one in notices_of() and one in notice_words().
// What a report says once of all its projects is in one_source_note.h.

#include "calc/base/names.h"
#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>
#include <vector>

namespace report {

enum class NoticeKind {
  note,      // of a room: what workplaces leave out or could not make, how it was come by
  row,       // of a row of a rule pack: all of it is asked
  in_part,   // not all of it is, or can be
  left_out,  // a zone of a row, by the project, up to a day that is not over
  changed,   // of a plane that a workplace has made: by the project
  remark,    // of a plane: how its quantity was come by
  doubt      // of a plane: points whose samples do not tell enough
};

// A notice, valid as long as the project.
struct Notice {
  NoticeKind kind = NoticeKind::note;
  const SpacePart* space = nullptr;              // never null
  const PlanePart* plane = nullptr;              // null: of the room
  const calc::Message* message = nullptr;        // of note, changed and remark
  const rules::RowCoverage* row = nullptr;       // of row, in_part and left_out
  const rules::LeftOutZone* left_out = nullptr;  // of left_out
};

// Returns the notices in document order: room by room, each with its own first.
std::vector<Notice> notices_of(const ProjectPart& project);
std::vector<Notice> notices_of(const SpacePart& space);

// Returns the notice without its place; printable().
std::string notice_words(const Texts& t, const Notice& notice);
// Returns "Room" or "Room / Plane"; printable().
std::string notice_place(const Texts& t, const Notice& notice);
// Returns both: "Room / Plane: words".
std::string notice_line(const Texts& t, const Notice& notice);

}  // namespace report

namespace calc {

// Names in tables beside verdicts.
template <>
struct EnumNames<report::NoticeKind> {
  static constexpr EnumName<report::NoticeKind> list[] = {
      {report::NoticeKind::note, "note"},       {report::NoticeKind::row, "row"},
      {report::NoticeKind::in_part, "in part"}, {report::NoticeKind::left_out, "left out"},
      {report::NoticeKind::changed, "changed"}, {report::NoticeKind::remark, "note"},
      {report::NoticeKind::doubt, "doubt"}};
};

}  // namespace calc
