#include "calc/photometry/read/ies_opening.h"

#include <gtest/gtest.h>

namespace calc::ies_opening_test {
namespace {

struct Case {
  double width, length, height;
  Lm63Version version;
  OpeningShape shape;
  double along_c0, along_c90, kept_height;
  bool simplified;
};

void expect(const Case& c) {
  const Lm63Opening decoded = decode_opening(c.width, c.length, c.height, c.version);
  const auto label = ::testing::Message() << c.width << " " << c.length << " " << c.height;
  EXPECT_EQ(decoded.opening.shape, c.shape) << label;
  EXPECT_DOUBLE_EQ(decoded.opening.along_c0_m, c.along_c0) << label;
  EXPECT_DOUBLE_EQ(decoded.opening.along_c90_m, c.along_c90) << label;
  EXPECT_DOUBLE_EQ(decoded.opening.height_m, c.kept_height) << label;
  EXPECT_EQ(!decoded.simplified_from.empty(), c.simplified) << label;
}

constexpr OpeningShape kPoint = OpeningShape::point;
constexpr OpeningShape kRectangle = OpeningShape::rectangle;
constexpr OpeningShape kDisk = OpeningShape::disk;
constexpr OpeningShape kBox = OpeningShape::box;
constexpr OpeningShape kCylinder = OpeningShape::cylinder;
constexpr OpeningShape kAlongC0 = OpeningShape::cylinder_c0;
constexpr OpeningShape kAlongC90 = OpeningShape::cylinder_c90;
constexpr OpeningShape kEllipsoid = OpeningShape::ellipsoid;

TEST(Lm63Opening, ShapesOfAllVersions) {
  for (const Lm63Version version :
       {Lm63Version::v1986, Lm63Version::v1995, Lm63Version::v2002, Lm63Version::v2019}) {
    expect({0, 0, 0, version, kPoint, 0, 0, 0, false});
    expect({0.3, 1.2, 0, version, kRectangle, 1.2, 0.3, 0, false});
    expect({0.3, 1.2, 0.1, version, kRectangle, 1.2, 0.3, 0.1, false});  // thin
    expect({0.3, 1.2, 0.2, version, kBox, 1.2, 0.3, 0.2, false});
    expect({0, 1.2, 0, version, kRectangle, 1.2, 0, 0, false});  // line
    expect({-0.2, 0, 0, version, kDisk, 0.2, 0.2, 0, false});
    expect({0, -0.2, 0, version, kDisk, 0.2, 0.2, 0, false});
    expect({-0.2, -0.2, 0, version, kDisk, 0.2, 0.2, 0, false});
    expect({-0.2, -0.2, 0.5, version, kCylinder, 0.2, 0.2, 0.5, false});
    expect({-0.2, 0, 0.5, version, kCylinder, 0.2, 0.2, 0.5, false});
    expect({-0.2, -0.4, 0, version, kDisk, 0.4, 0.2, 0, false});
    expect({-0.2, 0.4, 0, version, kDisk, 0.4, 0.2, 0, false});
    expect({0.2, -0.4, 0.3, version, kCylinder, 0.4, 0.2, 0.3, false});
    expect({0, 0, 0.3, version, kCylinder, 0.003, 0.003, 0.3, false});  // an upright line
  }
}

TEST(Lm63Opening, RoundBodiesByVersion) {
  expect({-0.3, -0.3, -0.3, Lm63Version::v2002, kEllipsoid, 0.3, 0.3, 0.3, false});
  expect({-0.3, 0, -0.3, Lm63Version::v1995, kEllipsoid, 0.3, 0.3, 0.3, false});  // sphere
  expect({-0.3, 0, -0.3, Lm63Version::v2002, kAlongC0, 0, 0.3, 0.3, false});      // vertical circle
  expect({0, 1.5, -0.1, Lm63Version::v1995, kAlongC0, 1.5, 0.1, 0.1, false});
  expect({-0.1, 1.5, -0.1, Lm63Version::v2002, kAlongC0, 1.5, 0.1, 0.1, false});
  expect({-0.1, 1.5, -0.1, Lm63Version::v1995, kEllipsoid, 1.5, 0.1, 0.1, false});
  expect({1.5, 0, -0.1, Lm63Version::v1995, kAlongC90, 0.1, 1.5, 0.1, false});
  expect({1.5, -0.1, -0.1, Lm63Version::v2002, kAlongC90, 0.1, 1.5, 0.1, false});
}

TEST(Lm63Opening, UnknownCodesKeepTheirSizeAndSaySo) {
  expect({0.4, 0.5, -0.6, Lm63Version::v2002, kBox, 0.5, 0.4, 0.6, true});
}

}  // namespace
}  // namespace calc::ies_opening_test
