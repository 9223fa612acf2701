#include "rules/binding/project_schema.h"

#include "calc/base/xml_reference.h"
#include "calc/base/xml_schema.h"
#include "calc/project/reading/project_elements.h"
#include "rules/binding/deviation_xml.h"
#include "rules/binding/requirement_attributes.h"
#include "rules/binding/waiver_xml.h"

namespace rules {

const std::vector<calc::ElementRow>& rows_about_rules() {
  static const std::vector<calc::ElementRow> kRows{require_element(), workplace_element(),
                                                   workplace_grid_element(), deviation_element(),
                                                   waiver_element()};
  return kRows;
}

std::string project_schema() {
  return calc::xml_schema(
      {"'luxgate schema'", calc::kProjectMeaning, calc::kProjectRoot, rows_about_rules()});
}

std::string project_reference() {
  return calc::xml_reference("luxgate project files, version 1",
                             {"'luxgate schema --markdown'", calc::kProjectMeaning,
                              calc::kProjectRoot, rows_about_rules()});
}

}  // namespace rules
