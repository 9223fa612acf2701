#include "calc/photometry/ies_opening.h"

#include <gtest/gtest.h>

namespace calc {
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

TEST(Lm63Opening, FlatShapesOfAllVersions) {
  for (const Lm63Version version :
       {Lm63Version::v1986, Lm63Version::v1995, Lm63Version::v2002, Lm63Version::v2019}) {
    expect({0, 0, 0, version, kPoint, 0, 0, 0, false});
    expect({0.3, 1.2, 0, version, kRectangle, 1.2, 0.3, 0, false});
    expect({0.3, 1.2, 0.1, version, kRectangle, 1.2, 0.3, 0.1, false});
    expect({-0.2, 0, 0, version, kDisk, 0.2, 0.2, 0, false});
    expect({0, -0.2, 0, version, kDisk, 0.2, 0.2, 0, false});
    expect({-0.2, -0.2, 0, version, kDisk, 0.2, 0.2, 0, false});
    expect({-0.2, -0.2, 0.5, version, kDisk, 0.2, 0.2, 0.5, false});
    expect({-0.2, -0.4, 0, version, kDisk, 0.4, 0.2, 0, false});
    expect({-0.2, 0.4, 0, version, kDisk, 0.4, 0.2, 0, false});
    expect({0.2, -0.4, 0.3, version, kDisk, 0.4, 0.2, 0.3, false});
  }
}

TEST(Lm63Opening, RoundBodiesKeepTheirBoundingSizeAndSaySo) {
  expect({-0.3, -0.3, -0.3, Lm63Version::v2002, kDisk, 0.3, 0.3, 0.3, true});
  expect({-0.3, 0, -0.3, Lm63Version::v1995, kDisk, 0.3, 0.3, 0.3, true});      // sphere
  expect({-0.3, 0, -0.3, Lm63Version::v2002, kRectangle, 0, 0.3, 0.3, true});   // vertical circle
  expect({0, 1.5, -0.1, Lm63Version::v1995, kRectangle, 1.5, 0.1, 0.1, true});  // cylinder along C0
  expect({-0.1, 1.5, -0.1, Lm63Version::v2002, kRectangle, 1.5, 0.1, 0.1, true});
  expect({-0.1, 1.5, -0.1, Lm63Version::v1995, kDisk, 1.5, 0.1, 0.1, true});  // ellipsoid
  expect(
      {1.5, 0, -0.1, Lm63Version::v1995, kRectangle, 0.1, 1.5, 0.1, true});  // cylinder along C90
  expect({1.5, -0.1, -0.1, Lm63Version::v2002, kRectangle, 0.1, 1.5, 0.1, true});
}

TEST(Lm63Opening, UnknownCodesKeepTheirSize) {
  expect({0.4, 0.5, -0.6, Lm63Version::v2002, kRectangle, 0.5, 0.4, 0.6, true});
}

}  // namespace
}  // namespace calc
