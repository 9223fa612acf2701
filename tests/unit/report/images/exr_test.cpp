#include "report/images/exr.h"

#include "report/formats/write.h"
#include "tests/support/sample_document.h"

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "tests/support/scratch_folder.h"

namespace report::exr_test {
namespace {

std::string rendered(const Document& document) {
  const ProjectPart& project = document.projects[0];
  return render_exr(document.provenance, project, project.spaces[0], project.spaces[0].planes[0]);
}

TEST(Exr, ReadsBackValuesAndAttributes) {
  Document document = small_document();
  PlanePart& plane = document.projects[0].spaces[0].planes[0];
  plane.kernel = calc::ReceiverKernel::scalar;
  plane.grid.rows = 2;
  plane.points[1].row = 1;  // now (0, 0) and (1, 1)
  const test_support::ScratchFolder folder;
  const std::string path = folder.path() / "plane.exr";
  ASSERT_EQ(write_file_atomically(path, rendered(document)), "");
  {
    Imf::InputFile file(path.c_str());
    EXPECT_EQ(file.header().dataWindow().max.x, 1);
    EXPECT_EQ(file.header().dataWindow().max.y, 1);
    EXPECT_EQ(file.header().typedAttribute<Imf::StringAttribute>("luxgate.plane").value(), "work");
    EXPECT_EQ(file.header().typedAttribute<Imf::StringAttribute>("luxgate.project").value(),
              "office.xml");
    EXPECT_EQ(file.header().typedAttribute<Imf::StringAttribute>("luxgate.quantity").value(),
              "scalar");
    EXPECT_EQ(file.header().typedAttribute<Imf::StringAttribute>("luxgate.unit").value(), "lx");
    std::array<std::vector<float>, 3> read;
    Imf::FrameBuffer frame;
    const std::array<const char*, 3> names{"illuminance_lx", "high_lx", "valid"};
    for (std::size_t i = 0; i < names.size(); ++i) {
      read[i].assign(4, -1.0F);
      frame.insert(names[i], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(read[i].data()),
                                        sizeof(float), 2 * sizeof(float)));
    }
    file.setFrameBuffer(frame);
    file.readPixels(0, 1);
    EXPECT_EQ(read[0], (std::vector<float>{0.0F, 424.5F, 600.5F, 0.0F}));
    EXPECT_EQ(read[1], (std::vector<float>{0.0F, 428.75F, 606.75F, 0.0F}));
    EXPECT_EQ(read[2], (std::vector<float>{0.0F, 1.0F, 1.0F, 0.0F}));
  }
}

TEST(Exr, SameDocumentSameBytes) {
  EXPECT_EQ(rendered(small_document()), rendered(small_document()));
}

TEST(Exr, PlaneWithoutCellsIsRefused) {
  Document document = small_document();
  document.projects[0].spaces[0].planes[0].grid.columns = 0;
  EXPECT_THROW(rendered(document), std::runtime_error);
}

TEST(ColourExr, HoldsLinearLightTimesOpacity) {
  const Raster raster{2, 1, {255, 188, 0, 255, 255, 255, 255, 51}};
  const test_support::ScratchFolder folder;
  const std::string path = folder.path() / "picture.exr";
  ASSERT_EQ(write_file_atomically(path, render_colour_exr("a.xml", "s", "vertices", raster)), "");
  {
    Imf::InputFile file(path.c_str());
    EXPECT_EQ(file.header().typedAttribute<Imf::StringAttribute>("luxgate.picture").value(),
              "vertices");
    std::array<std::array<float, 2>, 4> values{};
    Imf::FrameBuffer frame;
    constexpr std::array<const char*, 4> kColours{"R", "G", "B", "A"};
    for (std::size_t c = 0; c < 4; ++c) {
      frame.insert(kColours[c], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values[c].data()),
                                           sizeof(float), 2 * sizeof(float)));
    }
    file.setFrameBuffer(frame);
    file.readPixels(0);
    EXPECT_EQ(values[0][0], 1.0F);
    EXPECT_NEAR(values[1][0], 0.5, 0.005);  // 188 of sRGB is half of the light
    EXPECT_EQ(values[2][0], 0.0F);
    EXPECT_NEAR(values[0][1], 0.2, 1e-6);
    EXPECT_NEAR(values[3][1], 0.2, 1e-6);
  }
  EXPECT_THROW(render_colour_exr("a.xml", "s", "vertices", {}), std::runtime_error);
}

}  // namespace
}  // namespace report::exr_test
