#pragma once
// What may be chosen of the look of pages.

#include "report/html/print_pages.h"
#include "report/html/shared_scale.h"

namespace report {

struct PageStyle {
  Paper paper = Paper::a4;                     // when it is printed
  ScaleSharing scale = ScaleSharing::project;  // among whom planes share their colours
};

}  // namespace report
