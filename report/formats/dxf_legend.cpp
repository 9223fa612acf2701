#include "report/formats/dxf_legend.h"

#include "report/formats/dxf_text.h"
#include "report/text/plain_text.h"

#include <algorithm>
#include <cmath>

namespace report {
namespace {

constexpr std::size_t kMostOfCell = 40, kBetweenCells = 2;  // characters

// Of a long one the end stays, too: rooms of one name have their ids there.
std::string cell_text(std::string_view utf8) {
  constexpr std::size_t kMark = 2;  // columns that "..." takes more than "…"
  const std::string whole = printable(utf8);
  std::vector<std::string> lines = dxf_lines(dxf_signs(whole), kMostOfCell);
  if (lines.size() == 1) return lines.front();
  lines = dxf_lines(dxf_signs(shorten_middle(dxf_signs(whole), kMostOfCell - kMark)), kMostOfCell);
  // Characters that take no column in a terminal do so here.
  return lines.size() == 1 ? lines.front() : lines.front() + "...";
}

// Where each column begins.
std::vector<std::size_t> column_starts(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> starts;
  std::size_t start = 0;
  for (std::size_t c = 0; c < rows.front().size(); ++c) {
    starts.push_back(start);
    std::size_t width = 0;
    for (const std::vector<std::string>& row : rows) width = std::max(width, row[c].size());
    start += width + kBetweenCells;
  }
  return starts;
}

std::size_t width_of(const DxfLine& line) {
  return line.pieces.empty() ? 0 : line.pieces.back().first + line.pieces.back().second.size();
}

}  // namespace

void DxfColumns::add(std::string_view utf8, DxfColour colour) {
  for (std::string& words : dxf_lines(dxf_signs(utf8), columns_))
    lines_.push_back({{{0, std::move(words)}}, colour});
}

void DxfColumns::add_table(const std::vector<std::string>& head,
                           const std::vector<std::vector<std::string>>& rows,
                           const std::vector<DxfColour>& colours) {
  std::vector<std::vector<std::string>> texts{head};
  texts.insert(texts.end(), rows.begin(), rows.end());
  for (std::vector<std::string>& row : texts) {
    for (std::string& cell : row) cell = cell_text(cell);
  }
  const std::vector<std::size_t> starts = column_starts(texts);
  for (std::size_t k = 0; k < texts.size(); ++k) {
    DxfLine line{{}, k == 0 ? DxfColour::by_layer : colours[k - 1]};
    for (std::size_t c = 0; c < starts.size(); ++c)
      line.pieces.emplace_back(starts[c], std::move(texts[k][c]));
    lines_.push_back(std::move(line));
  }
}

FlatBox DxfColumns::draw(std::string_view layer, const glm::dvec2& corner_m, double height_m,
                         double text_m, DxfText& dxf) const {
  const double line_m = kDxfLine * text_m;
  // Half a line is free above and below. A plan may be as high as numbers go.
  const double fitting = std::floor(height_m / line_m - 1.0);
  const auto most = static_cast<double>(lines_.size() + 1);
  const std::size_t in_column =
      fitting > 1.0 ? static_cast<std::size_t>(std::min(fitting, most)) : 1;
  std::size_t width = 1;
  for (const DxfLine& line : lines_) width = std::max(width, width_of(line));
  const double column_m = static_cast<double>(width + kBetweenCells) * text_m;
  for (std::size_t k = 0; k < lines_.size(); ++k) {
    const glm::dvec2 at =
        corner_m + glm::dvec2(text_m + static_cast<double>(k / in_column) * column_m,
                              -line_m * (static_cast<double>(k % in_column) + 1.25));
    for (const auto& [start, words] : lines_[k].pieces) {
      dxf_words(layer, {at.x + static_cast<double>(start) * text_m, at.y, 0.0}, text_m, words,
                DxfAlign::start, lines_[k].colour, dxf);
    }
  }
  FlatBox box;
  if (lines_.empty()) return box;
  const std::size_t columns = (lines_.size() + in_column - 1) / in_column;
  box.add(corner_m);
  box.add(corner_m +
          glm::dvec2(static_cast<double>(columns) * column_m,
                     -line_m * static_cast<double>(std::min(lines_.size(), in_column) + 1)));
  dxf_polyline(
      layer,
      {{box.low, 0.0}, {box.high.x, box.low.y, 0.0}, {box.high, 0.0}, {box.low.x, box.high.y, 0.0}},
      true, DxfColour::by_layer, dxf);
  return box;
}

}  // namespace report
