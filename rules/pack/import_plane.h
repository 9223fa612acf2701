#pragma once
// Reads where the task of a row lies, from the column `plane` of an imported table.

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

// Returns the plane for "floor", "vertical", "1.1 m", "board 0.8 to 2 m", ...; empty if the text is
// not understood.
std::optional<TaskPlane> parse_task_plane(std::string_view text);

// Returns the most usual texts that are understood, for messages.
std::string task_plane_choices();

// Returns all texts that are understood, for the help.
std::string task_plane_words();

}  // namespace rules
