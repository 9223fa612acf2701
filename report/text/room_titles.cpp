#include "report/text/room_titles.h"

#include "report/text/words.h"

#include <fmt/format.h>

#include <map>
#include <string_view>

namespace report {

std::vector<std::string> room_titles(const ProjectPart& project) {
  std::map<std::string_view, int> count;
  for (const SpacePart& space : project.spaces) ++count[title_of(space.name, space.id)];
  std::vector<std::string> titles;
  for (const SpacePart& space : project.spaces) {
    const std::string_view title = title_of(space.name, space.id);
    const bool is_shared = count[title] > 1 && title != space.id;
    titles.push_back(is_shared ? fmt::format("{} ({})", title, space.id) : std::string(title));
  }
  return titles;
}

}  // namespace report
