#include "report/check/scene_levels.h"

#include "calc/base/xml_encoding.h"
#include "calc/project/reading/project_elements.h"
#include "report/check/project_places.h"
#include "report/check/text_change.h"
#include "rules/catalogue/metric.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace check {
namespace {

bool takes(const Place& place, std::string_view attribute) {
  const calc::Names names = calc::attribute_names(*place.row);
  return std::find(names.begin(), names.end(), attribute) != names.end();
}

std::string_view value_of(const XmlElement& element, std::string_view name) {
  const XmlAttribute* attribute = element.find(name);
  return attribute == nullptr ? std::string_view() : std::string_view(attribute->value);
}

// Power, energy and places of luminaires do not hang on a scene, and take none.
bool hangs_on_levels(const XmlElement& element) {
  const std::string_view quantity = value_of(element, "quantity");
  return std::none_of(rules::kMetrics.begin(), rules::kMetrics.end(),
                      [&](const rules::MetricRow& row) {
                        return row.name == quantity && rules::is_of_space(row.metric) &&
                               !rules::is_of_space_in_scene(row.metric);
                      });
}

bool is_luminaire(const XmlElement& element) {
  return element.name.starts_with("luminaire") && element.name != "luminaire-type";
}

std::string dim(const std::string& group, double level) {
  return fmt::format("<dim group=\"{}\" level=\"{}\"/>", escaped_attribute(group), level);
}

}  // namespace

std::optional<TextWithLevels> with_scene_levels(const std::string& bytes, const std::string& file,
                                                const SceneLevels& levels,
                                                calc::Diagnostics& diagnostics) {
  std::optional<std::string> text = calc::decoded_xml(bytes, file, diagnostics);
  if (!text) return std::nullopt;
  const std::optional<XmlElement> root = calc::parse_xml(bytes, file, diagnostics);
  if (!root) return std::nullopt;
  const Places places(*root);
  TextChange change(*std::move(text));
  const auto named = [&](const std::string& group) {
    return group.empty() ? levels.group_of_others : group;
  };
  const XmlElement* scene = nullptr;
  std::size_t grouped = 0;
  for (const Place& place : places.all()) {
    const XmlElement& element = *place.element;
    if (element.name == "scene" && value_of(element, "id") == levels.scene) scene = &element;
    if (levels.takes_full_output && takes(place, "scene") && value_of(element, "scene").empty() &&
        hangs_on_levels(element)) {
      change.set(element, "scene", levels.scene);
    }
    if (!levels.group_of_others.empty() && is_luminaire(element) && takes(place, "group") &&
        value_of(element, "group").empty()) {
      change.set(element, "group", levels.group_of_others);
      ++grouped;
    }
  }
  std::string more;
  for (const auto& [group, level] : levels.level_of_group) {
    const auto is_of_group = [&, &group = group](const XmlElement& child) {
      return child.name == "dim" && value_of(child, "group") == named(group);
    };
    const XmlElement* old = nullptr;
    if (scene != nullptr) {
      const auto found = std::find_if(scene->children.begin(), scene->children.end(), is_of_group);
      if (found != scene->children.end()) old = &*found;
    }
    if (old != nullptr) {
      change.set(*old, "level", fmt::format("{}", level));
    } else {
      more += dim(named(group), level);
    }
  }
  if (scene == nullptr) {
    change.add_children(
        *root, fmt::format("<scene id=\"{}\">{}</scene>", escaped_attribute(levels.scene), more));
  } else if (!more.empty()) {
    change.add_children(*scene, more);
  }
  return TextWithLevels{change.apply(), grouped};
}

}  // namespace check
