#pragma once
// The interface by which result_fields.h describes the result file to visitors.
//
// describe(v, part) tells the visitor v what the part holds. A visitor has, besides what Visitor
// has,
//   constant(key, value): a text or number that is always the same;
//   field(key, value, about): a value that is written and read again: a text, a flag, a number, an
//     enum with names, a vector, a part that is described itself, a list of all these;
//   object(key, fields, about): an object that is not a part, whose keys fields(v) describes;
//   rows(key, list, cells): a table; cells(row, item) calls row(cell, cell, ...) once.
//
// Keys that depend on several values stay code: conditions are plain C++ beside the keys, and a
// value that is not a member of a part is a local value, which is described and then assigned.

#include "calc/base/names.h"

#include <glm/glm.hpp>

#include <array>
#include <concepts>
#include <limits>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

namespace report {

// Whether a key is present.
struct Presence {
  bool may_lack = false;  // readers take a file without it
  bool is_there = true;   // the writer writes it
};
inline constexpr Presence kAlways{};
inline constexpr Presence kSinceLater{true, true};  // results of earlier versions lack it
constexpr Presence only_if(bool is_there) { return {true, is_there}; }

// The machine-specific details of a text. file: named by the user; own_file: named by the project;
// prose: it may contain paths.
enum class Holds { text, file, own_file, prose };

// Facts about a key beside its type.
struct About {
  const char* words = "";  // for the schema
  Presence presence = kAlways;
  std::optional<bool> null_if = {};  // true: null is written and needed, since nothing is judged
  Holds holds = Holds::text;
  // Range of a number: least and most, or above and below. Whole numbers only have `least`, else 0.
  std::optional<double> least = {}, most = {}, above = {}, below = {};
  bool is_mark = false;                        // a flag that is written only where it is true
  std::vector<std::string_view> choices = {};  // of a text or an enum; empty: any text, any name
  const char* unknown = "";  // how what is no choice is refused; "": with the choices
};

// Default members of visitors; visitors that need another behaviour hide them.
struct Visitor {
  // Makes the part the definition `name` of the schema; "": it is described where it is used.
  void is(const char* /*name*/, const char* /*words*/ = "") {}
  // States a rule that types cannot: readers refuse the value of `key`, which was described before.
  void refuse_if(bool /*is_bad*/, const char* /*key*/, const char* /*words*/) {}
  // A key that follows from the rest: written as make() returns it, and skipped by readers.
  // choices: all possible values.
  template <class Make, class Choices = int>
  void written(const char* /*key*/, const Make& /*make*/, const About& /*about*/ = {},
               const Choices& /*choices*/ = {}) {}
  // Keys that are present only if the flag `key`, described before, is true.
  template <class Fields>
  void if_true(const char* /*key*/, bool flag, const Fields& fields) {
    if (flag) fields();
  }
  // Two sets of keys; an object has one of them.
  template <class First, class Second>
  void either(bool is_first, const First& first, const Second& second) {
    is_first ? first() : second();
  }
};

// A part that a visitor may change, or only read.
template <class T, class Part>
concept Is = std::same_as<std::remove_const_t<T>, Part>;

// Assigns a local value that was described; visitors that only read parts change nothing.
template <class T>
void assign(T& to, const std::remove_const_t<T>& value) {
  if constexpr (!std::is_const_v<T>) to = value;
}

// A number that is null in the file if it is `none` or not finite.
template <class Double>
struct OrNull {
  Double& value;
  double none;
};
template <class Double>
OrNull<Double> or_null(Double& value, double none = std::numeric_limits<double>::quiet_NaN()) {
  return {value, none};
}

// Kinds of values, for visitors that treat each in its own way.
template <class T>
inline constexpr bool kIsOrNull = false;
template <class T>
inline constexpr bool kIsOrNull<OrNull<T>> = true;

template <class T>
inline constexpr bool kIsOptional = false;
template <class T>
inline constexpr bool kIsOptional<std::optional<T>> = true;

template <class T>
inline constexpr bool kIsList = false;
template <class T>
inline constexpr bool kIsList<std::vector<T>> = true;

template <class T>
concept Vector = std::same_as<T, glm::dvec2> || std::same_as<T, glm::dvec3>;

// A line between two points, seen from above: four numbers.
using Line = std::array<glm::dvec2, 2>;

// An enum whose values have names.
template <class T>
concept Named = std::is_enum_v<T> && requires {
  calc::EnumNames<T>::list;
};

// Returns the allowed names.
template <Named T>
std::vector<std::string_view> choices_of(const About& about) {
  return about.choices.empty() ? calc::names_of<T>() : about.choices;
}

}  // namespace report
