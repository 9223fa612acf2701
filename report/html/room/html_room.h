#pragma once
// Pictures of a room.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// A <figure> with the pictures and their legend, a sentence where there could be none, or "" where
// none were asked for. is_brief: what they show and how exactly in a line, not why there are none;
// html_method() has the rest.
std::string html_room(const Texts& t, const SpacePart& space, bool is_brief = false);

// "Office seen from above, illuminance in false colours"; no markup.
std::string picture_words(const Texts& t, const SpacePart& space, const RoomPicture& picture);

// An <img>, seen on paper alone: a picture of the first room that has one, rendered if
// there is such. "" = none has.
std::string html_cover_picture(const Texts& t, const ProjectPart& project);

}  // namespace report
