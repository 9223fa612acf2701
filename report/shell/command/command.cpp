#include "report/shell/command/command.h"

#include <iterator>
#include <utility>

namespace cli {

void add(std::vector<Option>& options, std::vector<Option> more) {
  std::move(more.begin(), more.end(), std::back_inserter(options));
}

}  // namespace cli
