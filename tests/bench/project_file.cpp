// A benchmark room as a project that luxgate can check.
#include "tests/bench/room_model.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>

namespace bench {
namespace {

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw std::runtime_error(fmt::format("cannot write '{}'", path.string()));
}

std::string material_id(double reflectance) {
  return fmt::format("rho-{:03.0f}", 1000.0 * reflectance);
}

std::string triple(const glm::dvec3& p) {
  return fmt::format("{:.10g} {:.10g} {:.10g}", p.x, p.y, p.z);
}

std::string materials(const RoomModel& model) {
  std::set<double> values{model.floor, model.walls, model.ceiling};
  for (const Block& block : model.blocks) values.insert(block.reflectance);
  std::string text;
  for (const double rho : values) {
    text += fmt::format("  <material id=\"{}\" reflectance=\"{:.10g}\"/>\n", material_id(rho), rho);
  }
  return text;
}

std::string luminaires(const RoomModel& model) {
  std::string text;
  for (std::size_t i = 0; i < model.lamps.size(); ++i) {
    const Lamp& lamp = model.lamps[i];
    text += fmt::format("    <luminaire id=\"L{}\" type=\"{}\" position=\"{}\"{}{}/>\n", i + 1,
                        model.webs[lamp.web].name, triple(lamp.position_m),
                        lamp.shines_up ? " axis=\"0 0 1\"" : "",
                        lamp.group.empty() ? "" : fmt::format(" group=\"{}\"", lamp.group));
  }
  return text;
}

}  // namespace

void write_project(const RoomModel& model, const std::string& folder) {
  if (!model.balls.empty() || model.grid.columns == 0 || !(model.size_m.x > 0.0)) {
    throw std::runtime_error(fmt::format("scene '{}' has no form as a project", model.name));
  }
  const std::filesystem::path base(folder);
  std::filesystem::create_directories(base / "photometry");
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<luxgate version=\"1\" name=\"Benchmark: "
      "{}\">\n",
      model.name);
  text += materials(model);
  for (const WebTable& web : model.webs) {
    write_text(base / "photometry" / (web.name + ".ies"), ies_text(web));
    text += fmt::format(
        "  <luminaire-type id=\"{0}\" photometry=\"photometry/{0}.ies\" "
        "maintenance-factor=\"0.8\"/>\n",
        web.name);
  }
  text += fmt::format("  <room id=\"room\" size=\"{}\" floor=\"{}\" ceiling=\"{}\" walls=\"{}\">\n",
                      triple(model.size_m), material_id(model.floor), material_id(model.ceiling),
                      material_id(model.walls));
  text += luminaires(model);
  for (const Block& block : model.blocks) {
    text +=
        fmt::format("    <box id=\"{}\" size=\"{}\" position=\"{}\" material=\"{}\"/>\n", block.id,
                    triple(block.size_m), triple(block.low_m), material_id(block.reflectance));
  }
  const Grid& grid = model.grid;
  text += fmt::format(
      "    <plane id=\"plane\" origin=\"{}\" u=\"{:.10g} 0 0\" v=\"0 {:.10g} 0\" count=\"{} {}\">\n"
      "      <require quantity=\"average\" at-least=\"300\"/>\n"
      "      <require quantity=\"Uo\" at-least=\"0.4\"/>\n"
      "    </plane>\n  </room>\n</luxgate>\n",
      triple(grid.low_m), grid.along_x_m, grid.along_y_m, grid.columns, grid.rows);
  write_text(base / "project.xml", text);
}

}  // namespace bench
