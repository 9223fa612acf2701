#include "report/document/luminaire_labels.h"

#include "report/document/luminaire_totals.h"
#include "report/document/storeys.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>

namespace report {
namespace {

// Letters of the types and how many of each have a mark.
class MarkCounts {
 public:
  // Of several types with one id the first counts, as in the schedule.
  explicit MarkCounts(const ProjectPart& project) {
    for (std::size_t i = 0; i < project.luminaires.size(); ++i)
      types_.try_emplace(project.luminaires[i].type_id, Type{position_letter(i)});
  }

  std::string next(const std::string& type_id) {
    const auto found = types_.find(type_id);
    Type& type = found == types_.end() ? unknown_ : found->second;
    return fmt::format("{}{}", type.letter, ++type.count);
  }

 private:
  struct Type {
    std::string letter;
    std::int64_t count = 0;
  };

  std::unordered_map<std::string_view, Type> types_;  // the ids are the project's
  Type unknown_;
};

}  // namespace

void label_luminaires(ProjectPart& project) {
  MarkCounts counts(project);
  for (const std::size_t s : spaces_in_order(project)) {
    for (LuminaireMark& mark : project.spaces[s].luminaires) mark.label = counts.next(mark.type_id);
  }
}

}  // namespace report
