#pragma once
// How result_fields.h describes the result file, and to whom.
//
// describe(v, part) tells the visitor v what the part holds. A visitor has, besides the members of
// Visitor,
//
//   constant(key, value): a text or number that is always the same.
//   field(key, value, about): a value that is written and read again: a text, a flag, a number, an
//     enum with names, a vector, a part that is described itself, a list of all these.
//   items(key, list, start): a list; start(item) prepares a new item before it is read.
//   coded(key, part, name, take, choices, about): a name; name(part) is written, take(part, text)
//     reads it and is false if nothing has that name. Without choices the schema takes any text.
//   object(key, fields, about): fields(v) describes the keys of an object that is no part by
//   itself. if_true(key, flag, fields): keys that are there only if the flag above, `key`, is true.
//   either(is_first, first, second): two sets of keys of which an object has one.
//   rows(key, list, cells): a table; cells(row, item) calls row(cell, cell, ...) once.
//   made(optional): its value; where it is read there is one afterwards.
//
// What hangs on more than one value stays code: conditions are plain C++ beside the keys.

#include "calc/base/names.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

namespace report {

// Whether a key is there.
struct Presence {
  bool may_lack = false;  // readers take a file without it
  bool is_there = true;   // the writer writes it
};
inline constexpr Presence kAlways{};
inline constexpr Presence kSinceLater{true, true};  // results of earlier versions lack it
constexpr Presence only_if(bool is_there) { return {true, is_there}; }

// What a text tells of the machine. file: named by the user; own_file: named by the project; prose:
// paths may stand in it.
enum class Holds { text, file, own_file, prose };

// What is said of a key beside its type.
struct About {
  const char* words = "";  // for the schema
  Presence presence = kAlways;
  std::optional<bool> null_if = {};  // true: null is written, and whatever is there is not read
  Holds holds = Holds::text;
  // Range of a number: least and most, or above and below. Of whole numbers `least` alone, else 0.
  std::optional<double> least = {}, most = {}, above = {}, below = {};
  bool is_mark = false;      // a flag that is written only where it is true
  std::size_t names = 99;    // so many of an enum's names, from the first
  const char* unknown = "";  // how a name that is none is refused; "": with the choices
};

// What visitors have in common; those that do something there hide it.
struct Visitor {
  // The part is the definition `name` of the schema; "": it is described where it is used.
  void is(const char* /*name*/, const char* /*words*/ = "") {}
  // What types do not say: readers refuse the value of `key`, which was described before.
  void refuse_if(bool /*is_bad*/, const char* /*key*/, const char* /*words*/) {}
  // What follows from the rest: written as make() gives it, and passed over by readers. choices:
  // all that it can be.
  template <class Make, class Choices = int>
  void written(const char* /*key*/, const Make& /*make*/, const About& /*about*/ = {},
               const Choices& /*choices*/ = {}) {}
};

// A part that a visitor may change, or only look at.
template <class T, class Part>
concept Is = std::same_as<std::remove_const_t<T>, Part>;

// A number that is null in the file where it is `none` or not finite.
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

// From one point to another, seen from above: four numbers.
using Line = std::array<glm::dvec2, 2>;

// An enum whose values have names.
template <class T>
concept Named = std::is_enum_v<T> && requires {
  calc::EnumNames<T>::list;
};

// Those that are allowed.
template <Named T>
std::vector<std::string_view> names_of(const About& about) {
  std::vector<std::string_view> names = calc::names_of<T>();
  names.resize(std::min(names.size(), about.names));
  return names;
}

}  // namespace report
