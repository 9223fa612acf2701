#include "report/formats/luminaires_csv.h"

#include "report/text/csv_field.h"
#include "report/text/luminaire_aim.h"
#include "report/text/number_format.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace report {
namespace {

constexpr const char* kLuminairesHeader =
    "project,space,number,id,type,maker,article,group,x_m,y_m,z_m,height_m,tilt_deg,heading_deg,"
    "turn_deg,flux_lm,power_w,maintenance_factor\r\n";

std::string known(const std::optional<double>& value) {
  return value ? format_shortest(*value) : "";
}

std::string row_of_luminaire(const ProjectPart& project, const SpacePart& space,
                             std::size_t index) {
  const LuminaireMark& mark = space.luminaires[index];
  const auto type =
      std::find_if(project.luminaires.begin(), project.luminaires.end(),
                   [&](const LuminaireRow& row) { return row.type_id == mark.type_id; });
  const bool is_known = type != project.luminaires.end();
  const LuminaireAim aim = aim_of(mark);
  const bool has_floor = !space.footprint_m.empty();
  const std::array<std::string, 18> cells{
      csv_field(project.path),
      csv_field(space.id),
      fmt::format("{}", index + 1),
      csv_field(mark.id),
      csv_field(mark.type_id),
      is_known ? csv_field(type->maker) : "",
      is_known ? csv_field(type->article_number) : "",
      csv_field(mark.group),
      format_shortest(mark.position_m.x),
      format_shortest(mark.position_m.y),
      format_shortest(mark.position_m.z),
      has_floor ? format_shortest(mark.position_m.z - space.floor_z_m) : "",
      known(aim.tilt_deg),
      known(aim.heading_deg),
      known(aim.turn_deg),
      is_known ? format_shortest(type->flux_lm) : "",
      is_known && type->power_w > 0.0 ? format_shortest(type->power_w) : "",
      is_known ? format_shortest(type->maintenance_factor) : ""};
  return fmt::format("{}\r\n", fmt::join(cells, ","));
}

class LuminairesWriter : public FormatWriter {
 public:
  explicit LuminairesWriter(const SpillPlace& place) : csv_(place) {
    csv_.write(kLuminairesHeader);
  }

  void add(const ProjectPart& project) override {
    for (const SpacePart& space : project.spaces) {
      std::string rows;
      for (std::size_t i = 0; i < space.luminaires.size(); ++i)
        rows += row_of_luminaire(project, space, i);
      csv_.write(rows);
    }
  }
  void finish(const DocumentEnd& /*end*/, Sink& sink) override { csv_.copy_to(sink); }

 private:
  Spill csv_;
};

}  // namespace

std::unique_ptr<FormatWriter> luminaires_csv_writer(const DocumentFrame& /*frame*/,
                                                    const SpillPlace& place) {
  return std::make_unique<LuminairesWriter>(place);
}

std::string render_luminaires_csv(const Document& document) {
  return render_whole(document, luminaires_csv_writer);
}

}  // namespace report
