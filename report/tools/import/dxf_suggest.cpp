// The map to start from: see suggest_map() in dxf_design.h.
#include "calc/base/utf8.h"
#include "report/tools/import/dxf_design.h"
#include "report/tools/import/map_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

namespace cli {
namespace {

constexpr std::size_t kMostExamples = 3;

struct LayerFacts {
  std::map<std::string, std::size_t> kinds;
  std::size_t closed = 0;
  glm::dvec3 low{0.0}, high{0.0};
  bool is_any = false;
};
struct BlockFacts {
  std::size_t count = 0;
  std::set<std::string> layers;
  std::set<double> heights;
  std::vector<std::pair<std::string, std::set<std::string>>> attributes;
  std::string in_file;
};

std::string kind_words(DxfEntity::Kind kind) {
  using Kind = DxfEntity::Kind;
  switch (kind) {
    case Kind::line:
      return "lines";
    case Kind::polyline:
      return "polylines";
    case Kind::outline:
      return "hatch outlines";
    case Kind::insert:
      return "block references";
    case Kind::text:
      return "texts";
    case Kind::circle:
      return "circles";
    case Kind::arc:
      return "arcs";
    case Kind::curve:
      return "curves";
    case Kind::face:
      return "faces";
    case Kind::mesh:
      return "meshes";
    case Kind::point:
      return "points";
  }
  return "";
}

std::string size_words(const glm::dvec3& low, const glm::dvec3& high) {
  return fmt::format("{:.6g} x {:.6g} x {:.6g} units", high.x - low.x, high.y - low.y,
                     high.z - low.z);
}

}  // namespace

std::string suggest_map(const DxfDrawing& drawing, const std::string& file) {
  std::map<std::string, LayerFacts> layers;
  std::map<std::string, BlockFacts> blocks;
  DxfSkipped skipped;
  const std::string problem = visit_dxf(
      drawing,
      [&](const DxfPlaced& placed) {
        const DxfEntity& entity = *placed.entity;
        LayerFacts& layer = layers[placed.layer];
        ++layer.kinds[kind_words(entity.kind)];
        if (entity.is_closed) ++layer.closed;
        for (std::size_t i = 0; i < entity.vertex.size(); ++i) {
          const glm::dvec3 at = placed.at(i);
          layer.low = layer.is_any ? glm::min(layer.low, at) : at;
          layer.high = layer.is_any ? glm::max(layer.high, at) : at;
          layer.is_any = true;
        }
        if (entity.kind != DxfEntity::Kind::insert) return true;
        BlockFacts& block = blocks[entity.block];
        ++block.count;
        block.in_file = entity.block_in_file;
        block.layers.insert(placed.layer);
        if (block.heights.size() <= kMostExamples) block.heights.insert(placed.at(0).z);
        for (const auto& [tag, value] : entity.attribute) {
          const auto known =
              std::find_if(block.attributes.begin(), block.attributes.end(),
                           [&tag = tag](const auto& one) { return one.first == tag; });
          auto& values = known != block.attributes.end()
                             ? known->second
                             : block.attributes.emplace_back(tag, std::set<std::string>()).second;
          if (values.size() <= kMostExamples) values.insert(value);
        }
        return true;
      },
      skipped);

  std::string text = fmt::format(
      "# A map for 'luxgate import {0}': remove the # from the parts that you need, and fill in\n"
      "# facts that no drawing has. Patterns: * and ? match any characters.\n\n",
      calc::printable(std::filesystem::path(file).filename().string()));
  if (!problem.empty()) text += fmt::format("# Not all of it was read: {}.\n", problem);
  text += fmt::format("# The drawing's unit; its header ($INSUNITS) has {}.\n# unit = \"mm\"\n",
                      drawing.unit
                          ? fmt::format("number {} (1 in, 2 ft, 4 mm, 5 cm, 6 m)", *drawing.unit)
                          : "none");
  text += "\n# Layers\n";
  for (const auto& [name, facts] : layers) {
    std::string kinds;
    for (const auto& [kind, count] : facts.kinds) {
      kinds += fmt::format("{}{} {}", kinds.empty() ? "" : ", ", count, kind);
    }
    text += fmt::format("#   {}: {}{}; {}\n", quoted_for_map(name), kinds,
                        facts.closed == 0 ? "" : fmt::format(" ({} closed)", facts.closed),
                        size_words(facts.low, facts.high));
  }
  for (const auto& [what, count] : skipped) {
    text += fmt::format("#   {}: {} passed over, {}\n", quoted_for_map(what[1]), count, what[2]);
  }
  for (const auto& [what, count] : drawing.skipped) {
    text += fmt::format("#   {}: {} x {} not read, {}\n", quoted_for_map(what[1]), count,
                        calc::printable(what[0]), what[2]);
  }
  text += "\n# Rooms: closed outlines, or lines that meet.\n";
  std::string names;
  for (const auto& [name, facts] : layers) {
    if (facts.kinds.count("texts") == 0) continue;
    names += fmt::format("# {}names = {}\n", names.empty() ? "" : "# or ", quoted_for_map(name));
  }
  for (const auto& [name, facts] : layers) {
    const bool has_lines = facts.kinds.count("polylines") + facts.kinds.count("lines") > 0;
    if (facts.closed == 0 && !has_lines) continue;
    text += fmt::format(
        "# [[room]]\n# layer = {}\n{}# height = 2.8  # metres\n# reflectances = [0.7, 0.5, 0.2]  "
        "# ceiling, walls, floor\n\n",
        quoted_for_map(name), names);
  }
  text += "# Blocks: luminaires or furniture.\n";
  std::size_t work = kMostDxfWork;
  for (const auto& [name, facts] : blocks) {
    const DxfExtent extent = extent_of_block(drawing, facts.in_file, work);
    text += fmt::format("# {}: {} times, on", quoted_for_map(name), facts.count);
    for (const std::string& layer : facts.layers) text += " " + quoted_for_map(layer);
    if (extent.is_any) text += "; " + size_words(extent.low, extent.high) + " before scaling";
    if (!extent.problem.empty()) text += "; of unknown size: " + extent.problem;
    text += "; z";
    std::size_t shown = 0;
    for (const double z : facts.heights) {
      text += shown++ == kMostExamples ? " ..." : fmt::format(" {:.6g}", z);
    }
    text += "\n";
    for (const auto& [tag, values] : facts.attributes) {
      text += fmt::format("#   attribute {}:", calc::printable(tag));
      shown = 0;
      for (const std::string& value : values) {
        text += shown++ == kMostExamples ? " ..." : " " + quoted_for_map(value);
      }
      text += "\n";
    }
    text += fmt::format(
        "# [[luminaire]]\n# type = {0}\n# photometry = \"photometry/FILE.ldt\"\n# height = "
        "[\"z\", 2.8]  # or \"attribute:NAME\"\n#\n# [[furniture]]\n# type = {0}\n# height = 0.75\n"
        "# reflectance = 0.5\n\n",
        quoted_for_map(name));
  }
  return text;
}

}  // namespace cli
