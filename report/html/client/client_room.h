#pragma once
// A room of the document for clients: its description, whether it meets its requirements, and its
// light.

#include "report/document/room_summary.h"
#include "report/html/drawings/shared_scale.h"
#include "report/html/page/html_footnotes.h"
#include "report/html/page/html_markup.h"
#include "report/html/page/print_pages.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// Returns the room. room: the place of its first plane. title: see room_titles(). summary: null if
// nothing is required of it.
std::string client_room(const Texts& t, const ProjectPart& project, PlaneIndex room,
                        const std::string& title, const RoomSummary* summary,
                        const ColourScales& scales, Paper paper, const Footnotes& footnotes);

// Returns remarks on rooms that weaken nothing: the source of quantities, rows that are met as a
// whole, parts judged otherwise. Each once, with its rooms; "" = none.
std::string client_notes(const Texts& t, const ProjectPart& project, const Footnotes& footnotes);

// Returns the causes for a room that does not pass, one list item each; "" if there are none.
std::string client_causes(const Texts& t, const RoomSummary& room);

}  // namespace report
