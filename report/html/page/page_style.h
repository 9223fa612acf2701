#pragma once
// Choices for the appearance of pages.

#include "report/html/drawings/shared_scale.h"
#include "report/html/page/print_pages.h"

#include <cstddef>
#include <map>
#include <memory>
#include <string>

namespace report {

class SheetSource;  // data_sheets.h

// Tables of all values at the end of printed pages. automatic: if there are at most
// kMostAnnexValues.
enum class Annex { automatic, always, never };
inline constexpr std::size_t kMostAnnexValues = 2500;

// A separate first page on paper. automatic: if the only project names a client, author, company or
// logo.
enum class Cover { automatic, always, never };

// The unit of lengths in a drawing for CAD.
enum class DrawingUnit { m, cm, mm, in, ft };

struct DrawingStyle {
  int scale = 0;  // 1:scale, at which texts have their height on paper; 0: chosen by the drawing
  DrawingUnit unit = DrawingUnit::m;
};

// Pages on paper, from 1, by the names of places in a page ("luminaires1").
using PageNumbers = std::map<std::string, int>;

// The purpose of a document. client: for sending, room by room, without details for checkers; full:
// everything. automatic: client for PDF, full for HTML.
enum class Detail { automatic, client, full };

struct PageStyle {
  Detail detail = Detail::automatic;
  Paper paper = Paper::a4;                  // when it is printed
  ScaleSharing scale = ScaleSharing::room;  // among whom planes share their colours
  ColourMap palette = ColourMap::cividis;
  Annex annex = Annex::automatic;
  Cover cover = Cover::automatic;
  std::shared_ptr<SheetSource> sheets = nullptr;  // of luminaires; null: no data sheets
  DrawingStyle drawing = {};
};

}  // namespace report
