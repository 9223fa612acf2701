#include "report/text/notices.h"

#include "report/text/clause_words.h"
#include "report/text/plain_text.h"
#include "report/text/plane_names.h"
#include "report/text/sentences.h"
#include "report/text/words.h"
#include "rules/verdict/waiver.h"

#include <fmt/format.h>

namespace report {
namespace {

void add_rows(const SpacePart& space, std::vector<Notice>& notices) {
  for (const rules::RowCoverage& row : space.coverage) {
    notices.push_back(
        {row.asks_all() ? NoticeKind::row : NoticeKind::in_part, &space, nullptr, nullptr, &row});
    for (const rules::RoleCoverage& role : row.roles) {
      for (const rules::LeftOutZone& zone : role.left_out) {
        if (zone.has_ended) continue;  // told by its plane, which is not judged
        notices.push_back({NoticeKind::left_out, &space, nullptr, nullptr, &row, &zone});
      }
    }
  }
}

void add_plane(const SpacePart& space, const PlanePart& plane, std::vector<Notice>& notices) {
  if (!plane.changed.empty())
    notices.push_back({NoticeKind::changed, &space, &plane, &plane.changed});
  for (const calc::Message& remark : plane.remarks)
    notices.push_back({NoticeKind::remark, &space, &plane, &remark});
  if (!doubt_words(plane).empty()) notices.push_back({NoticeKind::doubt, &space, &plane});
}

}  // namespace

std::vector<Notice> notices_of(const SpacePart& space) {
  std::vector<Notice> notices;
  for (const calc::Message& note : space.notes)
    notices.push_back({NoticeKind::note, &space, nullptr, &note});
  add_rows(space, notices);
  for (const PlanePart& plane : space.planes) add_plane(space, plane, notices);
  return notices;
}

std::vector<Notice> notices_of(const ProjectPart& project) {
  std::vector<Notice> notices;
  for (const SpacePart& space : project.spaces) {
    const std::vector<Notice> own = notices_of(space);
    notices.insert(notices.end(), own.begin(), own.end());
  }
  return notices;
}

std::string notice_words(const Texts& t, const Notice& notice) {
  switch (notice.kind) {
    case NoticeKind::note:
    case NoticeKind::changed:
    case NoticeKind::remark:
      return printable(sentence(t, *notice.message));
    case NoticeKind::row:
    case NoticeKind::in_part:
      return coverage_words(t, *notice.row);
    case NoticeKind::left_out:
      return printable(fmt::format(
          "{}, {}{}{} ({})", notice.row->workplace,
          clause_words(t, notice.row->clause, rules::source_of_pack(notice.row->is_user_supplied)),
          t[Text::colon], t.say<Text::roles_left_out>(role_words(t, notice.left_out->zone)),
          sentence(t, rules::waiver_words(notice.left_out->by))));
    case NoticeKind::doubt:
      break;
  }
  return doubt_words(t, *notice.plane);
}

std::string notice_place(const Texts& t, const Notice& notice) {
  const std::string room = printable(title_of(notice.space->name, notice.space->id));
  return notice.plane == nullptr
             ? room
             : room + " / " + printable(plane_in_room(t, *notice.space, *notice.plane));
}

std::string notice_line(const Texts& t, const Notice& notice) {
  const std::string place = notice_place(t, notice), words = notice_words(t, notice);
  if (notice.kind == NoticeKind::changed) return t.say<Text::changed_note>(place, words);
  return place + t[Text::colon] + words;
}

}  // namespace report
