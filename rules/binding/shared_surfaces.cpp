#include "rules/binding/shared_surfaces.h"

#include "calc/base/sentences.h"
#include "calc/base/text.h"
#include "rules/binding/requirement_attributes.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <variant>

namespace rules {
namespace {

bool is_surface(const calc::CalcPlane& plane, const RulePack& pack) {
  const RulePlane* rule = pack.find_plane(plane.requirements.front().role);
  return rule != nullptr && (rule->area == ZoneArea::walls || rule->area == ZoneArea::ceiling);
}

bool has_same_points(const calc::CalcPlane& a, const calc::CalcPlane& b) {
  return std::get<calc::PlanarArea>(a.area) == std::get<calc::PlanarArea>(b.area) &&
         a.kernel == b.kernel && a.derived == b.derived && a.direction == b.direction &&
         a.own_margin_m == b.own_margin_m && a.changed == b.changed;
}

std::string_view attribute_of(const calc::XmlElement& element, std::string_view name) {
  const calc::XmlAttribute* found = element.find(name);
  return found == nullptr ? std::string_view() : std::string_view(found->value);
}

bool has_same_attributes(const calc::XmlElement& a, const calc::XmlElement& b) {
  return a.attributes.size() == b.attributes.size() &&
         std::all_of(a.attributes.begin(), a.attributes.end(),
                     [&](const calc::XmlAttribute& attribute) {
                       const calc::XmlAttribute* other = b.find(attribute.name);
                       return other != nullptr && other->value == attribute.value;
                     });
}

// Returns the children with requirements: all except <zone> and <without>, which define the planes.
std::vector<const calc::XmlElement*> children_that_ask(const calc::XmlElement& workplace) {
  std::vector<const calc::XmlElement*> children;
  for (const calc::XmlElement& child : workplace.children) {
    if (child.name != "zone" && child.name != "without") children.push_back(&child);
  }
  return children;
}

bool asks_the_same(const calc::XmlElement& a, const calc::XmlElement& b) {
  for (const RequirementAttribute& attribute : requirement_attributes()) {
    if (!attribute.of_workplace) continue;
    if (attribute_of(a, attribute.name) != attribute_of(b, attribute.name)) return false;
  }
  const auto ours = children_that_ask(a), theirs = children_that_ask(b);
  return std::equal(ours.begin(), ours.end(), theirs.begin(), theirs.end(),
                    [](const calc::XmlElement* one, const calc::XmlElement* other) {
                      return one->name == other->name && has_same_attributes(*one, *other);
                    });
}

// Returns the workplaces that share a plane, without the first.
calc::Message shared_with(const calc::CalcPlane& plane) {
  std::vector<std::string> ids;
  const std::string& role = plane.requirements.front().role;
  for (const calc::RequirementText& text : plane.requirements) {
    if (text.role != role) continue;  // about the room, see ask_of_space()
    ids.insert(ids.end(), text.workplaces.begin(), text.workplaces.end());
  }
  ids.erase(ids.begin());  // who has made it
  return calc::names_message(ids, 3);
}

}  // namespace

std::optional<std::size_t> same_surface(const calc::CalcPlane& made, const RulePack& pack,
                                        const calc::Space& space) {
  if (!is_surface(made, pack)) return std::nullopt;
  const auto twin =
      std::find_if(space.planes.begin(), space.planes.end(), [&](const calc::CalcPlane& plane) {
        return !plane.made_by.empty() && has_same_points(plane, made);
      });
  if (twin == space.planes.end()) return std::nullopt;
  return static_cast<std::size_t>(std::distance(space.planes.begin(), twin));
}

void ask_also(calc::CalcPlane& plane, const calc::CalcPlane& made) {
  for (const calc::RequirementText& text : made.requirements) {
    const auto same = std::find_if(plane.requirements.begin(), plane.requirements.end(),
                                   [&](const calc::RequirementText& other) {
                                     return other.role == text.role &&
                                            other.special == text.special &&
                                            asks_the_same(other.element, text.element);
                                   });
    if (same == plane.requirements.end()) {
      plane.requirements.push_back(text);
    } else {
      same->workplaces.insert(same->workplaces.end(), text.workplaces.begin(),
                              text.workplaces.end());
    }
  }
}

void ask_of_space(const calc::RequirementText& text, calc::Space& space, std::size_t own) {
  for (calc::CalcPlane& plane : space.planes) {
    for (calc::RequirementText& other : plane.requirements) {
      if (other.role != text.role || other.workplaces.empty()) continue;
      if (!asks_the_same(other.element, text.element)) continue;
      other.workplaces.insert(other.workplaces.end(), text.workplaces.begin(),
                              text.workplaces.end());
      return;
    }
  }
  if (own < space.planes.size()) space.planes[own].requirements.push_back(text);
}

void name_shared_planes(calc::Space& space) {
  for (calc::CalcPlane& plane : space.planes) {
    if (plane.made_by.empty()) continue;
    const calc::Message words = shared_with(plane);
    if (words.empty()) continue;
    plane.made_by += "; " + calc::say<calc::Sentence::made_also>(words);
    const std::string& maker = plane.requirements.front().workplaces.front();
    plane.name = plane.id.substr(maker.size() + 1);  // "wall.1": of the room, not of one workplace
    std::replace(plane.name.begin(), plane.name.end(), '.', ' ');
  }
}

}  // namespace rules
