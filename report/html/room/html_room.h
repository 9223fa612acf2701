#pragma once
// Pictures of a room.

#include "report/document/document.h"
#include "report/text/texts.h"

#include <string>

namespace report {

// A <figure> with the pictures and their legend, a sentence where there could be none, or "" where
// none were asked for.
std::string html_room(const Texts& t, const SpacePart& space);

// "Office seen from above, illuminance in false colours"; no markup.
std::string picture_words(const Texts& t, const SpacePart& space, const RoomPicture& picture);

// An <img>, seen on paper alone: the first picture of the first room that has one. "" = none has.
std::string html_cover_picture(const Texts& t, const ProjectPart& project);

}  // namespace report
