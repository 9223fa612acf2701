#include "calc/project/reading/project_context.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/text.h"
#include "calc/base/units.h"
#include "calc/base/utf8.h"
#include "calc/project/reading/object_set.h"
#include "calc/project/reading/project_elements.h"

#include <fmt/format.h>

namespace calc {
namespace {

constexpr std::size_t kNamesShown = 12;
constexpr std::size_t kNamesCompared = 1000;
constexpr std::size_t kLongestIdCompared = 100;
constexpr double kShortestDirection = 1.0e-9;
constexpr std::string_view kXyz = "3 numbers (x y z)";

glm::dvec3 to_vector(const std::vector<double>& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

}  // namespace

void IdTable::add(ElementReader& reader, const std::string& id, std::size_t index) {
  if (id.empty()) return;
  const auto [entry, is_new] = entries_.try_emplace(id, Entry{index, reader.where().line});
  if (is_new) return;
  reader.report(DiagnosticId::duplicate_id, reader.where("id"), kind_, id, entry->second.line);
}

std::size_t IdTable::find(ElementReader& reader, std::string_view attribute) const {
  return find(reader, attribute, reader.text(attribute));
}

std::size_t IdTable::find(ElementReader& reader, std::string_view attribute,
                          const std::string& id) const {
  if (id.empty()) return 0;
  if (const auto found = entries_.find(id); found != entries_.end()) return found->second.index;
  report_unknown_reference(reader, attribute, kind_, id, ids());
  return 0;
}

std::optional<std::size_t> IdTable::look_up(std::string_view id) const {
  const auto found = entries_.find(id);
  if (found == entries_.end()) return std::nullopt;
  return found->second.index;
}

Names IdTable::ids() const {
  Names known;
  for (const auto& [name, entry] : entries_) known.push_back(name);
  return known;
}

void report_unknown_reference(ElementReader& reader, std::string_view attribute,
                              std::string_view kind, const std::string& id, const Names& known) {
  std::string list = "none is defined";
  if (known.size() > kNamesShown) {
    list = fmt::format("{} others are defined", known.size());
  } else if (!known.empty()) {
    list = fmt::format("defined: {}", fmt::join(known, ", "));
  }
  // Both limits keep a hostile file from buying much time with little text.
  const bool can_suggest = known.size() <= kNamesCompared && id.size() <= kLongestIdCompared;
  reader.report(DiagnosticId::unknown_reference, reader.where(attribute), attribute,
                reader.element().name, kind, shorten_utf8(id, kLongestIdCompared), list,
                can_suggest ? suggestion(id, known) : std::string());
}

double metres_per_unit(std::size_t unit_index) { return kLengthUnits.at(unit_index).metres; }

glm::dvec3 read_vector(ElementReader& reader, std::string_view name) {
  return to_vector(reader.numbers(name, 3, kXyz));
}

glm::dvec3 read_direction(ElementReader& reader, std::string_view name) {
  const std::size_t errors = reader.diagnostics().error_count();
  const glm::dvec3 direction = read_vector(reader, name);
  if (glm::length(direction) >= kShortestDirection) return glm::normalize(direction);
  if (reader.diagnostics().error_count() == errors) {
    reader.report(DiagnosticId::zero_vector, reader.where(name), name, reader.element().name);
  }
  return {0, 0, -1};
}

glm::dvec3 read_point_m(const ProjectContext& context, ElementReader& reader,
                        std::string_view name) {
  return read_vector(reader, name) * context.metres_per_unit;
}

glm::dvec3 read_point_m_or_zero(const ProjectContext& context, ElementReader& reader,
                                std::string_view name) {
  return reader.has(name) ? read_point_m(context, reader, name) : glm::dvec3(0.0);
}

glm::dvec3 read_size_m(const ProjectContext& context, ElementReader& reader,
                       std::string_view name) {
  return to_vector(reader.numbers(name, 3, kXyz, kPositive)) * context.metres_per_unit;
}

void warn_of_mending(ElementReader& reader, std::string_view attribute, const Mending& mending,
                     std::string_view also) {
  if (!mending.is_any()) return;
  reader.report(DiagnosticId::outline_mended, reader.where(attribute), attribute,
                reader.element().name, mending.words(), mending.longest, mending.at.x, mending.at.y,
                mending.at.z, also);
}

namespace {

template <class Point>
std::vector<Point> mended_corners(ElementReader& reader, std::string_view attribute,
                                  const std::vector<Point>& corners, std::string_view also) {
  const std::optional<MendedPolygon> mended = mend_polygon(corners);
  std::vector<Point> outline;
  if (!mended || mended->mending.joints > 0) return outline;
  for (const std::uint32_t c : mended->ring[0]) outline.push_back(corners[c]);
  warn_of_mending(reader, attribute, mended->mending, also);
  return outline;
}

}  // namespace

std::vector<glm::dvec2> mended_outline(ElementReader& reader, std::string_view attribute,
                                       const std::vector<glm::dvec2>& corners,
                                       std::string_view also) {
  return mended_corners(reader, attribute, corners, also);
}

std::vector<glm::dvec3> mended_outline(ElementReader& reader, std::string_view attribute,
                                       const std::vector<glm::dvec3>& corners,
                                       std::string_view also) {
  return mended_corners(reader, attribute, corners, also);
}

std::vector<glm::dvec3> read_corners_m(const ProjectContext& context, ElementReader& reader,
                                       std::string_view name) {
  const std::vector<double> numbers = reader.number_groups(
      name, 3, 3, kCornerLimit, fmt::format("3 to {} corners of 3 numbers (x y z)", kCornerLimit));
  std::vector<glm::dvec3> corners;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    corners.push_back(glm::dvec3(numbers[i], numbers[i + 1], numbers[i + 2]) *
                      context.metres_per_unit);
  }
  return corners;
}

double read_angle_rad(ElementReader& reader, std::string_view name) {
  return radians_from_degrees(reader.number_or(name, kCoordinate, 0.0));
}

std::vector<std::string> read_tags(ElementReader& reader) {
  return reader.has("tags") ? reader.ids("tags", kMostTags) : std::vector<std::string>();
}

std::uint32_t read_material(const ProjectContext& context, ElementReader& reader,
                            std::string_view name) {
  return static_cast<std::uint32_t>(context.materials.find(reader, name));
}

bool check_room_for(ProjectContext& context, ElementReader& reader, double instances,
                    double triangles) {
  const auto id = reader.element().find("id");
  const std::string name = id != nullptr ? id->value : reader.element().name;
  const std::string what = fmt::format("'{}' brings the model to", name);
  const auto fits = [&](BudgetOf of, double amount) {
    if (amount <= context.budget[of]) return true;
    report_beyond(context.diagnostics, reader.where(), what, of, amount, context.budget);
    return false;
  };
  const double all = context.instances + instances;
  const double all_triangles = context.triangles + triangles;
  // Copies keep the words of their element.
  double words = 0.0;
  for (const std::string_view attribute : {"id", "name", "group"}) {
    const XmlAttribute* found = reader.element().find(attribute);
    if (found != nullptr) words += 2.0 * static_cast<double>(found->value.size());
  }
  return fits(BudgetOf::objects, all) && fits(BudgetOf::triangles, all_triangles) &&
         fits(BudgetOf::memory, context.files.taken_bytes() + held_bytes(all, all_triangles)) &&
         context.files.take(instances * words, reader.where(), what);
}

}  // namespace calc
