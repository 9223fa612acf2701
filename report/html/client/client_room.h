#pragma once
// A room of the document that people send: what it is, whether it meets its requirements, and its
// light.

#include "report/document/room_summary.h"
#include "report/html/drawings/shared_scale.h"
#include "report/html/page/html_footnotes.h"
#include "report/html/page/html_markup.h"
#include "report/html/page/print_pages.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// room: the place of its first plane. title: see room_titles(). summary: null where nothing is
// asked of it.
std::string client_room(const Texts& t, const ProjectPart& project, PlaneIndex room,
                        const std::string& title, const RoomSummary* summary,
                        const ColourScales& scales, Paper paper, const Footnotes& footnotes);

// What is to be known of rooms and weakens nothing there: how quantities were come by, which rows
// are met as a whole, what of them is judged otherwise. Each once, with its rooms; "" = nothing.
std::string client_notes(const Texts& t, const ProjectPart& project, const Footnotes& footnotes);

// Causes of a room that does not pass, a list item each; "" where there are none.
std::string client_causes(const Texts& t, const RoomSummary& room);

}  // namespace report
