#pragma once
// Where the task of a row lies, as the column `plane` of an imported table says it.

#include <optional>
#include <string>
#include <string_view>

namespace rules {

struct TaskPlane {
  struct Heights {
    double lowest_m, highest_m;  // above the floor
  };
  bool is_upright = false;
  std::optional<Heights> heights_m;  // empty: those of the role
};

// "floor", "vertical", "1.1 m", "board 0.8 to 2 m", ... Empty: nobody knows what is meant.
std::optional<TaskPlane> parse_task_plane(std::string_view text);

// The most usual of what it understands, for messages.
std::string task_plane_choices();

// All of it, for the help.
std::string task_plane_words();

}  // namespace rules
