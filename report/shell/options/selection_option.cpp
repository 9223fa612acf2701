#include "report/shell/options/selection_option.h"

#include "calc/base/diagnostic_ids.h"
#include "report/shell/command/option_values.h"
#include "report/shell/process/print.h"

namespace cli {

std::vector<Option> selection_options(check::Selection& selection) {
  return {
      {"--space", "PATTERN",
       "Judge only spaces whose id or name matches, as 'office-*'; repeatable. Nothing else is "
       "calculated or judged, and every report says so",
       one_more(selection.spaces), true},
      {"--plane", "PATTERN", "Judge only planes whose id or name matches; repeatable",
       one_more(selection.planes), true},
      {"--tag", "PATTERN",
       "Judge only planes with a tag that matches, their own or of their space; repeatable",
       one_more(selection.tags), true},
      {"--require", "PATTERN",
       "Judge only requirements whose id or quantity matches (Uo, minimum, UGR-table); repeatable",
       one_more(selection.requirements), true}};
}

void print_nothing_chosen(const check::Selection& selection) {
  print_error(calc::DiagnosticId::selection_empty, check::selection_words(selection));
}

}  // namespace cli
