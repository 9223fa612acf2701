#pragma once
// Pictures of a room.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// Returns a <figure> with the pictures and their legend, a sentence if there could be none, or ""
// if none were requested. is_brief: contents and accuracy in a line, not why there are none;
// html_method() has the rest.
std::string html_room(const Texts& t, const SpacePart& space, bool is_brief = false);

// Returns "Office seen from above, illuminance in false colours"; no markup.
std::string picture_words(const Texts& t, const SpacePart& space, const RoomPicture& picture);

// Returns an <img> for paper only: a picture of the first room that has one, a rendered one if
// possible. "" = none has.
std::string html_cover_picture(const Texts& t, const ProjectPart& project);

}  // namespace report
