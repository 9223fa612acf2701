#pragma once
// Small DXF files for tests, made pair by pair.

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace test_support {

class DxfText {
 public:
  DxfText& add(int code, std::string_view value) {
    text_ += fmt::format("{:3}\n{}\n", code, value);
    return *this;
  }
  DxfText& add(int code, double value) { return add(code, fmt::format("{}", value)); }
  DxfText& add(int code, int value) { return add(code, fmt::format("{}", value)); }
  DxfText& header(std::string_view version, int unit) {
    return section("HEADER")
        .add(9, "$ACADVER")
        .add(1, version)
        .add(9, "$INSUNITS")
        .add(70, unit)
        .end();
  }
  DxfText& section(std::string_view name) { return add(0, "SECTION").add(2, name); }
  DxfText& end() { return add(0, "ENDSEC"); }
  DxfText& layer(std::string_view name, int colour, int flags) {
    return add(0, "LAYER").add(2, name).add(70, flags).add(62, colour);
  }
  DxfText& entity(std::string_view kind, std::string_view layer, std::string_view handle = "") {
    add(0, kind);
    if (!handle.empty()) add(5, handle);
    return add(8, layer);
  }
  DxfText& at(double x, double y, double z = 0.0) { return add(10, x).add(20, y).add(30, z); }
  DxfText& block(std::string_view name, double x = 0.0, double y = 0.0) {
    return add(0, "BLOCK").add(8, "0").add(2, name).at(x, y);
  }
  DxfText& insert(std::string_view name, std::string_view layer, double x, double y, double z = 0.0,
                  std::string_view handle = "") {
    return entity("INSERT", layer, handle).add(2, name).at(x, y, z);
  }
  DxfText& line(std::string_view layer, double x0, double y0, double x1, double y1) {
    return entity("LINE", layer).at(x0, y0).add(11, x1).add(21, y1).add(31, 0.0);
  }
  // A closed rectangle from (x, y).
  DxfText& rectangle(std::string_view layer, double x, double y, double width, double depth,
                     std::string_view handle = "") {
    entity("LWPOLYLINE", layer, handle).add(90, 4).add(70, 1);
    add(10, x).add(20, y).add(10, x + width).add(20, y);
    return add(10, x + width).add(20, y + depth).add(10, x).add(20, y + depth);
  }
  std::string whole() const { return text_ + "  0\nEOF\n"; }
  std::string without_end() const { return text_; }

 private:
  std::string text_;
};

}  // namespace test_support
