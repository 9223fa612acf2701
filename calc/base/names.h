#pragma once
// Names of enum values in files and messages. One list per enum gives the name of a value, the
// value of a name and the choices that a message offers.

#include <optional>
#include <string_view>
#include <vector>

namespace calc {

template <class Enum>
struct EnumName {
  Enum value;
  std::string_view name;
};

// Specialised beside each enum, in this namespace: `static constexpr EnumName<Rounding> list[] =
// {{Rounding::half_up, "half-up"}, ...};` every value once, in the order that messages name them.
template <class Enum>
struct EnumNames;

// Returns the name of a value; "" if it is not in the list.
template <class Enum>
constexpr std::string_view name_of(Enum value) {
  for (const EnumName<Enum>& entry : EnumNames<Enum>::list) {
    if (entry.value == value) return entry.name;
  }
  return {};
}

// Returns the value with exactly this name; empty if there is none.
template <class Enum>
constexpr std::optional<Enum> find_value(std::string_view name) {
  for (const EnumName<Enum>& entry : EnumNames<Enum>::list) {
    if (entry.name == name) return entry.value;
  }
  return std::nullopt;
}

// Returns the names in the order of the list, for messages with choices.
template <class Enum>
std::vector<std::string_view> names_of() {
  std::vector<std::string_view> names;
  for (const EnumName<Enum>& entry : EnumNames<Enum>::list) names.push_back(entry.name);
  return names;
}

}  // namespace calc
