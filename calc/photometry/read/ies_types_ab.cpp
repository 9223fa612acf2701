#include "calc/photometry/read/ies_types_ab.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace calc {
namespace {

constexpr double kEdge_deg = 1.0e-5;  // from the last angle to darkness

// One angle of a list after its mirror image was added.
struct TableEntry {
  double deg;
  std::size_t index;  // in the file's list
};

std::vector<TableEntry> with_mirror_image(const std::vector<double>& deg) {
  std::vector<TableEntry> entries;
  if (deg.front() == 0.0 && deg.size() > 1) {
    for (std::size_t i = deg.size() - 1; i > 0; --i) entries.push_back({-deg[i], i});
  }
  for (std::size_t i = 0; i < deg.size(); ++i) entries.push_back({deg[i], i});
  return entries;
}

// Rows around a circle: [c][gamma].
class CircleTable {
 public:
  explicit CircleTable(std::vector<double> gamma_deg) { table_.gamma_deg = std::move(gamma_deg); }

  void add(double c_deg, const std::vector<double>& row) {
    table_.c_deg.push_back(c_deg);
    table_.intensity_cd.insert(table_.intensity_cd.end(), row.begin(), row.end());
  }
  FileTable take() {
    table_.lists_c360 = true;
    return std::move(table_);
  }

 private:
  FileTable table_;
};

bool is_dark(const std::vector<double>& row) {
  return std::all_of(row.begin(), row.end(), [](double cd) { return cd == 0.0; });
}

std::vector<double> between(const std::vector<double>& a, const std::vector<double>& b,
                            double share) {
  std::vector<double> row(a.size());
  for (std::size_t i = 0; i < row.size(); ++i) row[i] = std::lerp(a[i], b[i], share);
  return row;
}

// Rows at ascending longitudes within [-90, 90], at least one on each side of 0 or at it, as a full
// circle from 0 to 360.
FileTable close_circle(const std::vector<double>& longitude_deg,
                       const std::vector<std::vector<double>>& row, std::vector<double> gamma_deg) {
  CircleTable circle(std::move(gamma_deg));
  const std::size_t count = longitude_deg.size();
  const auto after = std::lower_bound(longitude_deg.begin(), longitude_deg.end(), 0.0);
  const auto first = static_cast<std::size_t>(after - longitude_deg.begin());  // >= 0
  const bool has_zero = longitude_deg[first] == 0.0;
  const std::vector<double> at_zero =
      has_zero
          ? row[first]
          : between(row[first - 1], row[first],
                    -longitude_deg[first - 1] / (longitude_deg[first] - longitude_deg[first - 1]));
  const std::vector<double> dark(at_zero.size(), 0.0);
  circle.add(0.0, at_zero);
  for (std::size_t i = first + (has_zero ? 1 : 0); i < count; ++i) {
    circle.add(longitude_deg[i], row[i]);
  }
  if (!is_dark(row.back())) circle.add(longitude_deg.back() + kEdge_deg, dark);
  if (!is_dark(row.front())) circle.add(360.0 + longitude_deg.front() - kEdge_deg, dark);
  for (std::size_t i = 0; i < first; ++i) circle.add(360.0 + longitude_deg[i], row[i]);
  circle.add(360.0, at_zero);
  return circle.take();
}

// Type B with one horizontal angle.
FileTable around_nadir(const TypeAbTable& file, std::string& problem) {
  FileTable table;
  table.symmetry = PlaneSymmetry::axial;
  table.c_deg = {0.0};
  const std::size_t count = file.vertical_deg.size();
  constexpr double kRounding = 1.0e-6;  // of the maximum: files are printed
  const double most_cd = *std::max_element(file.intensity_cd.begin(), file.intensity_cd.end());
  for (std::size_t i = 0; i < count; ++i) {
    const bool has_twin =
        file.vertical_deg[i] == -file.vertical_deg[count - 1 - i] &&
        std::abs(file.intensity_cd[i] - file.intensity_cd[count - 1 - i]) <= kRounding * most_cd;
    if (file.vertical_deg.front() < 0.0 && !has_twin) {
      problem = "a single horizontal angle with vertical angles that differ on both sides of 0";
    }
    if (file.vertical_deg[i] < 0.0) continue;
    table.gamma_deg.push_back(file.vertical_deg[i]);
    table.intensity_cd.push_back(file.intensity_cd[i]);
  }
  if (table.gamma_deg.size() < 2) problem = "fewer than two vertical angles from 0 upwards";
  return table;
}

// The greatest intensity at ends of the lists that are not at 90 degrees. A list that begins at 0
// goes on as its mirror image, so that this is no end.
double at_open_ends_cd(const TypeAbTable& file) {
  const std::vector<double>&v = file.vertical_deg, &h = file.horizontal_deg;
  const auto begins_open = [](const std::vector<double>& deg) {
    return deg.front() > -90.0 && deg.front() != 0.0;
  };
  const auto ends_open = [](const std::vector<double>& deg) {
    return deg.size() > 1 && deg.back() < 90.0;
  };
  double greatest_cd = 0.0;
  for (std::size_t i = 0; i < h.size(); ++i) {
    for (std::size_t k = 0; k < v.size(); ++k) {
      const bool is_open = (i == 0 && h.size() > 1 && begins_open(h)) ||
                           (i + 1 == h.size() && ends_open(h)) || (k == 0 && begins_open(v)) ||
                           (k + 1 == v.size() && ends_open(v));
      if (is_open) greatest_cd = std::max(greatest_cd, file.intensity_cd[i * v.size() + k]);
    }
  }
  return greatest_cd;
}

bool reaches_zero(const std::vector<double>& deg) {
  return deg.front() <= 0.0 && deg.back() >= 0.0;
}

}  // namespace

FileTable table_of_type_ab(const TypeAbTable& file, std::string& problem) {
  const bool is_b = file.type == Lm63Type::b;
  if (!reaches_zero(file.vertical_deg) || !reaches_zero(file.horizontal_deg)) {
    problem = "angles that do not include 0";
    return {};
  }
  if (file.horizontal_deg.size() == 1) {
    if (is_b) {
      FileTable table = around_nadir(file, problem);
      table.at_open_ends_cd = at_open_ends_cd(file);
      return table;
    }
    problem = "type A with a single horizontal angle";
    return {};
  }
  // Longitudes go round the table's axis, latitudes from pole to pole.
  std::vector<TableEntry> longitude =
      with_mirror_image(is_b ? file.vertical_deg : file.horizontal_deg);
  const std::vector<TableEntry> latitude =
      with_mirror_image(is_b ? file.horizontal_deg : file.vertical_deg);
  if (!is_b) {  // C = -H
    std::reverse(longitude.begin(), longitude.end());
    for (TableEntry& entry : longitude) entry.deg = entry.deg == 0.0 ? 0.0 : -entry.deg;
  }
  std::vector<double> longitude_deg, gamma_deg;
  std::vector<std::vector<double>> rows;
  for (const TableEntry& l : latitude) gamma_deg.push_back(l.deg + 90.0);
  for (const TableEntry& o : longitude) {
    longitude_deg.push_back(o.deg);
    std::vector<double>& row = rows.emplace_back();
    for (const TableEntry& l : latitude) {
      const std::size_t h = is_b ? l.index : o.index, v = is_b ? o.index : l.index;
      row.push_back(file.intensity_cd[h * file.vertical_deg.size() + v]);
    }
  }
  FileTable table = close_circle(longitude_deg, rows, std::move(gamma_deg));
  table.axis = is_b ? TableAxis::lateral : TableAxis::vertical;
  table.at_open_ends_cd = at_open_ends_cd(file);
  return table;
}

}  // namespace calc
