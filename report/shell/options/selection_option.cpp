#include "report/shell/options/selection_option.h"

#include "calc/base/diagnostic_ids.h"
#include "report/shell/command/option_values.h"
#include "report/shell/process/print.h"

namespace cli {

std::vector<Option> selection_options(check::Selection& selection) {
  return {
      {"--space", "PATTERN",
       "Judge only spaces of this id or name, a pattern as of a shell: 'office-*'; repeatable.\n"
       "The rest is neither calculated nor judged, which every report says",
       one_more(selection.spaces), true},
      {"--plane", "PATTERN", "The same of planes", one_more(selection.planes), true},
      {"--tag", "PATTERN", "The same of planes by their tags, and by those of their spaces",
       one_more(selection.tags), true},
      {"--require", "PATTERN",
       "The same of requirements: their ids, or what they are of (Uo, minimum, UGR-table, ...)",
       one_more(selection.requirements), true}};
}

void print_nothing_chosen(const check::Selection& selection) {
  print_error(calc::DiagnosticId::selection_empty, check::selection_words(selection));
}

}  // namespace cli
