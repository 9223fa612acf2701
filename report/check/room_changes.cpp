#include "report/check/room_changes.h"

#include "calc/base/xml_encoding.h"
#include "calc/base/xml_reader.h"
#include "calc/project/reading/project_context.h"
#include "calc/project/reading/project_elements.h"
#include "report/check/text_change.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace check {
namespace {

using calc::XmlElement;

// No "-0".
std::string vector_words(const glm::dvec3& v) {
  return fmt::format("{} {} {}", v.x + 0.0, v.y + 0.0, v.z + 0.0);
}

// A file that has been read before, so that what is wrong with it is a surprise.
struct RoomOfText {
  std::string text, problem;
  std::optional<XmlElement> root;
  const XmlElement* room = nullptr;
  double metres_per_unit = 1.0;
  glm::dvec3 origin_m{0.0};

  RoomOfText(const std::string& bytes, const std::string& file, const std::string& id) {
    calc::Diagnostics diagnostics;
    std::optional<std::string> decoded = calc::decoded_xml(bytes, file, diagnostics);
    if (decoded) root = calc::parse_xml(bytes, file, diagnostics);
    if (!root) {
      problem = diagnostics.all().empty() ? "the project cannot be read"
                                          : diagnostics.all().front().message;
      return;
    }
    text = *std::move(decoded);
    for (const XmlElement& child : root->children) {
      const calc::XmlAttribute* name = child.find("id");
      if (child.name == "room" && name != nullptr && name->value == id) room = &child;
    }
    if (room == nullptr || room->find("file") != nullptr) {
      problem = fmt::format("'{}' is not a room whose walls are in the project file", id);
      return;
    }
    calc::ElementReader units(*root, diagnostics);
    metres_per_unit = calc::metres_per_unit(units.choice_or("units", calc::kUnitsType.words, 0));
    if (room->find("origin") == nullptr) return;
    calc::ElementReader reader(*room, diagnostics);
    origin_m = metres_per_unit * calc::read_vector(reader, "origin");
  }
};

}  // namespace

ChangedText with_luminaires(const std::string& bytes, const std::string& file,
                            const std::string& room,
                            const std::vector<AddedLuminaire>& luminaires) {
  return with_luminaires_instead(bytes, file, room, {}, luminaires);
}

ChangedText with_luminaires_instead(const std::string& bytes, const std::string& file,
                                    const std::string& room,
                                    const std::vector<calc::SourceLocation>& elements,
                                    const std::vector<AddedLuminaire>& luminaires) {
  RoomOfText found(bytes, file, room);
  if (!found.problem.empty()) return {std::nullopt, found.problem};
  TextChange change(std::move(found.text));
  for (const calc::SourceLocation& where : elements) {
    const auto& children = found.room->children;
    const auto element =
        std::find_if(children.begin(), children.end(), [&](const XmlElement& child) {
          return where.file == file && child.where.line == where.line &&
                 child.where.column == where.column;
        });
    if (element == children.end() || !element->name.starts_with("luminaire")) {
      return {std::nullopt, "a luminaire is placed by an assembly or a list"};
    }
    change.remove(*element);
  }
  std::string xml;
  for (const AddedLuminaire& one : luminaires) {
    const glm::dvec3 position = (one.position_m - found.origin_m) / found.metres_per_unit;
    const std::string group =
        one.group.empty() ? "" : fmt::format(" group=\"{}\"", escaped_attribute(one.group));
    xml += fmt::format("<luminaire id=\"{}\" type=\"{}\" position=\"{}\" axis=\"{}\" c0=\"{}\"{}/>",
                       escaped_attribute(one.id), escaped_attribute(one.type),
                       vector_words(position), vector_words(one.axis), vector_words(one.c0), group);
  }
  if (!xml.empty()) change.add_children(*found.room, xml);
  return {change.apply(), ""};
}

ChangedText with_reflectance(const std::string& bytes, const std::string& file,
                             const std::string& room, std::string_view surface,
                             double reflectance) {
  RoomOfText found(bytes, file, room);
  if (!found.problem.empty()) return {std::nullopt, found.problem};
  if (surface == "walls" && found.room->find("wall-materials") != nullptr) {
    return {std::nullopt, "single walls have their own materials"};
  }
  const auto is_taken = [&](const std::string& id) {
    return std::any_of(found.root->children.begin(), found.root->children.end(),
                       [&](const XmlElement& child) {
                         const calc::XmlAttribute* name = child.find("id");
                         return child.name == "material" && name != nullptr && name->value == id;
                       });
  };
  std::string id = "lighter";
  for (int i = 2; is_taken(id); ++i) id = fmt::format("lighter-{}", i);
  TextChange change(std::move(found.text));
  change.add_children(*found.root,
                      fmt::format("<material id=\"{}\" reflectance=\"{}\"/>", id, reflectance));
  change.set(*found.room, surface, id);
  return {change.apply(), ""};
}

}  // namespace check
