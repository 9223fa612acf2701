#include "calc/photometry/read/tm33_opening.h"

#include "calc/base/diagnostic_ids.h"
#include "calc/base/units.h"
#include "calc/photometry/read/xml_query.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace calc {
namespace {

constexpr double kLargest_mm = 1.0e7;

// Grows around the areas added to it.
struct Bounds {
  double low_length = 0.0, high_length = 0.0, low_width = 0.0, high_width = 0.0, height = 0.0;
  std::size_t flat_areas = 0, sides = 0, circles = 0;

  void add(double length, double length_at, double width, double width_at) {
    const bool first = flat_areas++ == 0;
    const auto grow = [first](double& low, double& high, double size, double at) {
      low = first ? at - 0.5 * size : std::min(low, at - 0.5 * size);
      high = first ? at + 0.5 * size : std::max(high, at + 0.5 * size);
    };
    grow(low_length, high_length, length, length_at);
    grow(low_width, high_width, width, width_at);
  }
};

class OpeningReader {
 public:
  explicit OpeningReader(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  std::optional<LuminousOpening> read(const XmlElement& root,
                                      const std::vector<const XmlElement*>& emitters) {
    const std::size_t errors = diagnostics_.error_count();
    for (const XmlElement* emitter : emitters) {
      if (const XmlElement* areas = child_of(*emitter, "EmissionAreas")) add_faces(*areas);
    }
    const XmlElement* luminaire = child_of(root, "Luminaire");
    if (luminaire != nullptr && bounds_.flat_areas + bounds_.sides == 0) {
      for (const XmlElement* opening : children_of(*luminaire, "LuminousOpening"))
        add_opening(*opening);
    }
    const LuminousOpening opening =
        bounds_.flat_areas > 0 || is_point_ ? from_bounds() : from_dimensions(root, luminaire);
    if (diagnostics_.error_count() != errors) return std::nullopt;
    return opening;
  }

 private:
  double size_mm(const XmlElement& parent, std::string_view name, double lowest) {
    const XmlElement* element = child_of(parent, name);
    const double mm = number_in(element, diagnostics_).value_or(0.0);
    if (mm >= lowest && mm <= kLargest_mm) return mm;
    diagnostics_.report(DiagnosticId::photometry_value, element->where,
                        fmt::format("<{}> (mm)", name), fmt::format("{}", mm),
                        fmt::format("{} to {}", lowest, kLargest_mm));
    return 0.0;
  }
  double size_mm(const XmlElement& parent, std::string_view name) {
    return size_mm(parent, name, 0.0);
  }
  double offset_mm(const XmlElement& parent, std::string_view name) {
    return size_mm(parent, name, -kLargest_mm);
  }

  void add_faces(const XmlElement& areas) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kFaces{
        {{"BottomFace", "BottomArea"},
         {"TopFace", "TopArea"},
         {"C0Face", "C0Area"},
         {"C90Face", "C90Area"},
         {"C180Face", "C180Area"},
         {"C270Face", "C270Area"}}};
    for (std::size_t i = 0; i < kFaces.size(); ++i) {
      const XmlElement* face = child_of(areas, kFaces[i].first);
      if (face == nullptr) continue;
      for (const XmlElement* area : children_of(*face, kFaces[i].second)) {
        where_ = area->where;
        if (i >= 2) {
          bounds_.height = std::max(bounds_.height, size_mm(*area, "Height"));
          ++bounds_.sides;
          continue;
        }
        if (flag_in(child_of(*area, "Circular")).value_or(false)) ++bounds_.circles;
        bounds_.add(size_mm(*area, "Length"), offset_mm(*area, "LengthOffset"),
                    size_mm(*area, "Width"), offset_mm(*area, "WidthOffset"));
      }
    }
  }

  void add_opening(const XmlElement& opening) {
    where_ = opening.where;
    const std::string shape = letters_of(text_of(child_of(opening, "Shape")));
    is_point_ = is_point_ || shape == "point";
    if (shape == "point") return;
    const XmlElement* nested = child_of(opening, "Dimensions");
    const XmlElement& sizes = nested == nullptr ? opening : *nested;
    double length = size_mm(sizes, "Length");
    double width = size_mm(sizes, "Width");
    const double diameter = size_mm(sizes, "Diameter");
    const bool is_round = shape == "circular" || shape == "elliptical" || diameter > 0.0;
    if (diameter > 0.0) length = width = diameter;
    if (shape == "circular" && width == 0.0) width = length;
    if (is_round) ++bounds_.circles;
    bounds_.add(length, 0.0, width, 0.0);
  }

  LuminousOpening from_bounds() {
    LuminousOpening opening;
    opening.along_c90_m = (bounds_.high_length - bounds_.low_length) * kMetresPerMillimetre;
    opening.along_c0_m = (bounds_.high_width - bounds_.low_width) * kMetresPerMillimetre;
    opening.height_m = bounds_.height * kMetresPerMillimetre;
    if (bounds_.flat_areas + bounds_.sides > 1) {
      diagnostics_.report(DiagnosticId::photometry_opening_shape, where_, "emission areas",
                          fmt::format("{} areas, {} of these on the sides",
                                      bounds_.flat_areas + bounds_.sides, bounds_.sides));
    }
    const bool is_disk = bounds_.circles == 1 && bounds_.flat_areas == 1;
    return shaped(opening, is_disk);
  }

  LuminousOpening shaped(LuminousOpening opening, bool is_disk) {
    if (opening.along_c0_m > 0.0 || opening.along_c90_m > 0.0) {
      opening.shape = is_disk ? OpeningShape::disk : OpeningShape::rectangle;
    } else if (!is_point_) {
      diagnostics_.report(DiagnosticId::photometry_no_area, where_);
    }
    return opening;
  }

  // The whole luminaire, of which its light leaves some part.
  LuminousOpening from_dimensions(const XmlElement& root, const XmlElement* luminaire) {
    where_ = luminaire == nullptr ? root.where : luminaire->where;
    LuminousOpening opening;
    const XmlElement* sizes = luminaire == nullptr ? nullptr : child_of(*luminaire, "Dimensions");
    if (sizes == nullptr) return shaped(opening, false);
    where_ = sizes->where;
    opening.along_c90_m = size_mm(*sizes, "Length") * kMetresPerMillimetre;
    opening.along_c0_m = size_mm(*sizes, "Width") * kMetresPerMillimetre;
    opening.height_m = bounds_.height * kMetresPerMillimetre;
    if (opening.along_c90_m > 0.0 || opening.along_c0_m > 0.0)
      diagnostics_.report(DiagnosticId::photometry_outer_size, where_);
    return shaped(opening, letters_of(text_of(child_of(*luminaire, "Shape"))) == "alignz");
  }

  Diagnostics& diagnostics_;
  Bounds bounds_;
  bool is_point_ = false;
  SourceLocation where_;
};

}  // namespace

std::optional<LuminousOpening> read_tm33_opening(const XmlElement& root,
                                                 const std::vector<const XmlElement*>& emitters,
                                                 Diagnostics& diagnostics) {
  return OpeningReader(diagnostics).read(root, emitters);
}

}  // namespace calc
