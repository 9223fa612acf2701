#include "calc/project/reading/logo.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace calc::logo_test {
namespace {

using ::testing::HasSubstr;

std::string big_endian(unsigned value) {
  return {static_cast<char>(value >> 24U), static_cast<char>((value >> 16U) & 255U),
          static_cast<char>((value >> 8U) & 255U), static_cast<char>(value & 255U)};
}

std::string chunk(const std::string& name, const std::string& bytes) {
  return big_endian(static_cast<unsigned>(bytes.size())) + name + bytes + "sum.";
}

// depth, colour, compression, filter, interlacing.
std::string png(unsigned width, unsigned height, const std::string& rest = {8, 6, 0, 0, 0}) {
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", big_endian(width) + big_endian(height) + rest) +
         chunk("IDAT", "x") + chunk("IEND", "");
}

std::string svg(const std::string& contents, const std::string& attributes = "") {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attributes + ">" + contents + "</svg>";
}

TEST(Logo, NamesTellTheFormat) {
  LogoFormat format{};
  EXPECT_TRUE(is_logo_name("a/Logo.SVG", format));
  EXPECT_EQ(format, LogoFormat::svg);
  EXPECT_TRUE(is_logo_name("x.png", format));
  EXPECT_EQ(format, LogoFormat::png);
  EXPECT_FALSE(is_logo_name("x.jpg", format));
  EXPECT_FALSE(is_logo_name("png", format));
}

TEST(Logo, APngIsWhole) {
  const auto problem = [](const std::string& bytes) {
    return logo_problem(bytes, LogoFormat::png);
  };
  EXPECT_EQ(problem(png(1, 4096)), "");
  EXPECT_EQ(problem(png(4097, 1)), "it has 4097 x 1 pixels; allowed: 1 to 4096 each way");
  EXPECT_EQ(problem(png(0, 1)), "it has 0 x 1 pixels; allowed: 1 to 4096 each way");
  EXPECT_EQ(problem(png(1, 1, {3, 6, 0, 0, 0})), "its PNG header is not valid");
  EXPECT_EQ(problem(png(1, 1, {16, 3, 0, 0, 0})), "its PNG header is not valid");
  const std::string good = png(9, 9);
  EXPECT_EQ(problem(good + "x"), "it is not a complete PNG file");
  for (std::size_t size = 8; size < good.size(); ++size) {
    EXPECT_EQ(problem(good.substr(0, size)), "it is not a complete PNG file") << size;
  }
  EXPECT_EQ(problem("\x89PNG\r\n\x1a\n" + chunk("IDAT", "x") + chunk("IEND", "")),
            "it is not a complete PNG file");
  EXPECT_EQ(problem("<svg/>"), "its name ends with .png, but it is not a PNG file");
  EXPECT_EQ(problem(std::string(kMostLogoBytes + 1, 'x')),
            "it has 1048577 bytes; at most 1048576 are allowed");
}

// As editors write them.
TEST(Logo, AnSvgOfShapesIsTaken) {
  const std::string drawings[] = {
      svg("<path d='M0 0h9v9z' fill='#c00'/>", " viewBox='0 0 9 9'"),
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- by an editor -->\n" +
          svg("<sodipodi:namedview id='n' pagecolor='#fff'/><metadata><rdf:RDF><cc:Work/></rdf:RDF>"
              "</metadata><defs><linearGradient id='g'><stop offset='0'/></linearGradient>"
              "<linearGradient id='h' xlink:href='#g'/></defs>"
              "<rect style=\"fill:url(#h);stroke:none\" width='1' height='1'/>",
              " xmlns:svg='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' "
              "xmlns:sodipodi='http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd' "
              "xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#' "
              "xmlns:cc='http://creativecommons.org/ns#'"),
      svg("<style>.a{fill:red}</style><title>T</title><text class='a'>Ä<tspan>b</tspan></text>"),
      svg("<symbol id='s'><circle r='1'/></symbol><use href='#s'/><use href='#s' x='3'/>")};
  for (const std::string& drawing : drawings) {
    EXPECT_EQ(logo_problem(drawing, LogoFormat::svg), "") << drawing;
  }
}

TEST(Logo, WhatActsOrFetchesIsRefused) {
  const std::vector<std::pair<std::string, std::string>> attacks{
      {svg("<script>alert(1)</script>"), "<script> is not allowed"},
      {svg("<foreignObject/>"), "<foreignObject> is not allowed"},
      {svg("<image href='data:image/png;base64,AA=='/>"), "to the same file only"},
      {svg("<a href='#x'/>"), "<a> is not allowed"},
      {svg("<animate attributeName='x'/>"), "<animate> is not allowed"},
      {svg("<filter id='f'/>"), "<filter> is not allowed"},
      {svg("<SCRIPT/>"), "<SCRIPT> is not allowed"},
      {svg("", " onload='x()'"), "'onload' is not allowed: a logo must not react to events"},
      {svg("<path ONCLICK='x()'/>"), "a logo must not react to events"},
      {svg("<path ev:onclick='x()'/>"), "a logo must not react to events"},
      {svg("<use href='http://x/y.svg#z'/>"), "'href' may refer to the same file only"},
      {svg("<use xl:href='//x'/>", " xmlns:xl='http://www.w3.org/1999/xlink'"), "'xl:href' may"},
      {svg("<g xml:base='http://x/'/>"), "'xml:base' may refer"},
      {svg("<path fill='url(http://x)'/>"), "'url(' may refer to the same file"},
      {svg("<path style='fill: URL( \"//x\" )'/>"), "'url(' may refer to the same file"},
      {svg("<style>@import 'http://x';</style>"), "'@' is not allowed in a style"},
      {svg("<style><![CDATA[@import 'x';]]></style>"), "'@' is not allowed in a style"},
      {svg("<path style='fill:u\\72l(//x)'/>"), "'\\' is not allowed in a style"},
      {svg("<h:script/>", " xmlns:h='http://www.w3.org/1999/xhtml'"), "<h:script> is not allowed"},
      {svg("<s:script/>", " xmlns:s='http://www.w3.org/2000/svg'"), "<s:script> is not allowed"},
      {svg("<g xmlns='http://www.w3.org/1999/xhtml'/>"),
       "'xmlns' must be \"http://www.w3.org/2000/svg\""},
      {"<svg/>", "its first element must be <svg xmlns="},
      {"<html xmlns=\"http://www.w3.org/1999/xhtml\"/>", "its first element must be"},
      {"<?xml version=\"1.0\"?><?xml-stylesheet href=\"x.css\"?>" + svg(""), "'<?' is allowed"},
      {"<?xml-stylesheet href=\"x.css\"?>" + svg(""), "'<?' is allowed"},
      {"<!DOCTYPE svg [<!ENTITY a \"b\">]>" + svg("&a;"), "a DOCTYPE is not allowed"},
      {svg("&x;"), "line 1"},
      {svg("<g>"), "not well-formed"},
      {"", "line"},
      {svg("\xFF"), "it is not UTF-8"},
      {std::string("<\0s\0v\0g\0", 8), "it is not UTF-8"}};
  for (const auto& [bytes, words] : attacks) {
    EXPECT_THAT(logo_problem(bytes, LogoFormat::svg), HasSubstr(words)) << bytes;
  }
}

// A thousand laughs, of use, of patterns and of what uses itself.
TEST(Logo, PartsThatUseEachOtherHaveAnEnd) {
  std::string uses = "<path id='a0' d='M0 0'/>", patterns = "<pattern id='b0'/>";
  for (int i = 1; i < 40; ++i) {
    const std::string before = std::to_string(i - 1), own = std::to_string(i);
    const std::string use = "<use href='#a" + before + "'/>";
    uses += "<g id='a" + own + "'>" + use + use + "</g>";
    const std::string fill = "<path fill='url(#b" + before + ")'/>";
    patterns += "<pattern id='b" + own + "'>" + fill + fill + "</pattern>";
  }
  for (const std::string& contents :
       {uses, patterns, std::string("<g id='c'><use href='#c'/></g>")}) {
    EXPECT_THAT(logo_problem(svg(contents), LogoFormat::svg), HasSubstr("more than 200000 shapes"));
  }
}

}  // namespace
}  // namespace calc::logo_test
