#include "report/check/drawing_device.h"

#include "report/check/backend.h"
#include "tests/support/opengl.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace drawing_device_test {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

gpu::Device device(int index, const std::string& renderer, bool is_software,
                   const std::string& problem = "") {
  gpu::Device result;
  result.index = index;
  result.renderer = renderer;
  result.is_software = is_software;
  result.problem = problem;
  return result;
}

// As gpu::list_hardware() gives them.
const gpu::Device kCard = device(0, "Card A", false);
const gpu::Device kSoftware = device(1, "", true, gpu::kNotOpened);

// Of so much detail that threads in any number leave 20 of them to hardware, and one to software.
calc::DrawingWork rooms(double count) {
  calc::DrawingWork work;
  work.rooms = count;
  work.pixels = 4e6 * count;
  work.triangles = 2e5 * count;
  return work;
}

struct Machine {
  bool has_node = true;
  gpu::DeviceList list{{kCard, kSoftware}, ""};
  std::optional<calc::DeviceRates> kept;
  int searches = 0, asked_for_rates = 0, asked_for_work = 0;

  check::Hardware hardware() {
    return {has_node,
            [this] {
              ++searches;
              return list;
            },
            [this](const gpu::Device& card, bool may_measure, std::string&) {
              EXPECT_EQ(card.renderer, "Card A");
              EXPECT_FALSE(may_measure);
              ++asked_for_rates;
              return kept;
            }};
  }
  check::DrawingChoice choose(check::Hardware found, double count) {
    return check::choose_to_draw(found, [&] {
      ++asked_for_work;
      return rooms(count);
    });
  }
  check::DrawingChoice choose(double count) { return choose(hardware(), count); }
  check::DrawingChoice choose_for_pictures(const gpu::Device* open, bool is_asked_for,
                                           double count) {
    check::Hardware found = hardware();
    return check::choose_for_pictures(open, is_asked_for, found, [&] { return rooms(count); });
  }
};

TEST(DrawingDevice, HardwareDrawsManyRooms) {
  const check::DrawingChoice many = Machine().choose(20);
  EXPECT_EQ(many.device, 0);
  EXPECT_TRUE(many.is_hardware);
  EXPECT_TRUE(many.is_by_cost);
  EXPECT_THAT(check::pictures_line(many), StartsWith("pictures: gpu: some "));
  EXPECT_THAT(many.why, HasSubstr(" s by Card A; 0.4 s of these to open it are assumed, too; "));
  EXPECT_THAT(many.why, HasSubstr("how fast a GPU draws is assumed"));
}

// Nothing is opened for what no hardware could do sooner: to find it is to open it.
TEST(DrawingDevice, HardwareIsNotLookedForToDrawLittle) {
  Machine machine;
  const check::DrawingChoice few = machine.choose(1);
  EXPECT_EQ(few.device, gpu::kPreferSoftware);
  EXPECT_FALSE(few.is_hardware);
  EXPECT_THAT(check::pictures_line(few),
              StartsWith("pictures: software OpenGL: too little to draw for a GPU: some "));
  EXPECT_THAT(few.why, EndsWith(" and to find and open one takes 0.3 s or more"));
  EXPECT_EQ(machine.searches, 0);
  check::Hardware found = machine.hardware();
  found.list();
  EXPECT_THAT(machine.choose(found, 0).why, EndsWith(" and to open one takes 0.15 s or more"));
  EXPECT_EQ(machine.searches, 1);
  machine.choose(20);
  EXPECT_EQ(machine.searches, 2);
}

// The border is where the costs say, and at what was measured.
TEST(DrawingDevice, IsChosenByWhatIsKept) {
  Machine machine;
  check::Hardware found = machine.hardware();
  found.list();
  for (const double open_s : {0.2, 0.4, 0.9}) {
    machine.kept = calc::DeviceRates{};
    machine.kept->open_s = open_s;
    calc::DeviceRates rates = calc::kAssumedRates;
    rates.open_s = open_s;
    for (double count = 1.0; count <= calc::kMostRoomsOnSoftware; ++count) {
      const calc::DrawingCost cost =
          calc::weigh_drawing(rooms(count), rates, calc::thread_count({}));
      const check::DrawingChoice choice = machine.choose(found, count);
      EXPECT_EQ(choice.is_hardware, cost.hardware_s < cost.software_s) << open_s << " " << count;
      EXPECT_EQ(choice.device, choice.is_hardware ? 0 : gpu::kPreferSoftware);
    }
    EXPECT_THAT(machine.choose(found, 20).why,
                HasSubstr(" s of these to open it are measured; how fast"));
  }
  EXPECT_GT(machine.asked_for_rates, 0);
}

TEST(DrawingDevice, HardwareDrawsWhatSoftwareWouldLeaveOut) {
  Machine machine;
  machine.kept = calc::DeviceRates{};
  machine.kept->open_s = 1000.0;
  EXPECT_FALSE(machine.choose(calc::kMostRoomsOnSoftware).is_hardware);
  const check::DrawingChoice more = machine.choose(calc::kMostRoomsOnSoftware + 1);
  EXPECT_TRUE(more.is_hardware);
  EXPECT_THAT(more.why, StartsWith("software OpenGL draws 24 rooms at most, and there are 25; "));
}

TEST(DrawingDevice, WithoutHardwareNothingIsWeighed) {
  Machine machine;
  machine.has_node = false;
  const check::DrawingChoice none = machine.choose(1000);
  EXPECT_EQ(none.device, -1);
  EXPECT_FALSE(none.is_hardware || none.is_by_cost);
  EXPECT_EQ(check::pictures_line(none),
            "pictures: software OpenGL: this machine has no graphics device\n");
  EXPECT_EQ(machine.asked_for_work, 0);
  EXPECT_EQ(machine.searches, 0);
  machine.has_node = true;
  machine.list = {{device(0, "Old", false, "too old"), kSoftware}, "", "get a new one"};
  const check::DrawingChoice old = machine.choose(1000);
  EXPECT_EQ(old.device, -1);
  EXPECT_FALSE(old.is_hardware);
  EXPECT_EQ(old.why,
            "OpenGL device 0 cannot be used: too old; OpenGL device 1 is software; get a new one");
  EXPECT_EQ(machine.asked_for_rates, 0);
}

TEST(DrawingDevice, TheOnlyOneDraws) {
  Machine machine;
  machine.kept = calc::DeviceRates{};
  machine.kept->open_s = 1000.0;
  machine.list = {{kCard, device(1, "", true, "EGL cannot start it")}, ""};
  const check::DrawingChoice choice = machine.choose(20);
  EXPECT_EQ(choice.device, 0);
  EXPECT_TRUE(choice.is_hardware);
  EXPECT_FALSE(choice.is_by_cost);
  EXPECT_EQ(choice.why, "nothing but Card A can draw here");
}

TEST(DrawingDevice, PicturesTakeWhatTheCalculationHasOpened) {
  const gpu::Device software = device(1, "soft", true);
  for (const double count : {1.0, 20.0}) {
    const check::DrawingChoice card = Machine().choose_for_pictures(&kCard, false, count);
    EXPECT_TRUE(card.is_open && card.is_hardware);
    EXPECT_FALSE(card.is_by_cost);
    EXPECT_EQ(check::pictures_line(card), "pictures: gpu: the calculation has opened Card A\n");
    // --gl-device
    const check::DrawingChoice asked = Machine().choose_for_pictures(&software, true, count);
    EXPECT_TRUE(asked.is_open);
    EXPECT_FALSE(asked.is_hardware);
    EXPECT_EQ(asked.device, 1);
  }
  // Software that shadow maps took by cost.
  EXPECT_TRUE(Machine().choose_for_pictures(&software, false, 1).is_open);
  const check::DrawingChoice many = Machine().choose_for_pictures(&software, false, 20);
  EXPECT_FALSE(many.is_open);
  EXPECT_EQ(many.device, 0);
  EXPECT_FALSE(Machine().choose_for_pictures(nullptr, false, 1).is_open);
}

// 30 vertices or three million, of a room of 200 triangles.
check::BackendChoice choose_for_maps(const check::BackendRequest& request, double paths) {
  Machine machine;
  check::Hardware hardware = machine.hardware();
  return check::choose_backend(request, 64, hardware, [&] {
    calc::DeviceWork work;
    work.drawing.map_triangles = 5.0 * 200.0 * paths;
    work.drawing.map_texels = 5.0 * 64.0 * 64.0 * paths;
    return work;
  });
}

TEST(DrawingDevice, ShadowMapsAreDrawnByTheSoonerOne) {
  const check::BackendChoice few = choose_for_maps({}, 30.0);
  EXPECT_EQ(few.backend, check::Backend::gpu);
  EXPECT_EQ(few.device, gpu::kPreferSoftware);
  EXPECT_THAT(few.why, StartsWith("--visibility shadow-map draws with OpenGL; software: too lit"));
  const check::BackendChoice many = choose_for_maps({}, 3e6);
  EXPECT_EQ(many.backend, check::Backend::gpu);
  EXPECT_EQ(many.device, 0);
  EXPECT_EQ(many.shadow_map_texels, 64u);
  EXPECT_THAT(many.why, StartsWith("--visibility shadow-map draws with OpenGL; a GPU: some "));
}

TEST(DrawingDevice, ShadowMapsAreDrawnOnTheDeviceThatIsNamed) {
  check::BackendRequest request;
  request.backend = check::Backend::gpu;
  EXPECT_EQ(choose_for_maps(request, 30.0).device, -1);  // hardware, as always with it
  request.gl_device = 7;
  for (const double paths : {30.0, 3e6}) {
    EXPECT_EQ(choose_for_maps(request, paths).device, 7);
    EXPECT_EQ(choose_for_maps(request, paths).why, "--visibility shadow-map draws with OpenGL");
  }
}

struct Opened {
  std::vector<std::string> warnings;
  std::string problem;
  gpu::DeviceThread* device = nullptr;
  std::optional<check::PictureDevice> pictures;

  explicit Opened(const check::DrawingChoice& choice, gpu::Fault fault = gpu::Fault::none) {
    pictures.emplace(check::PictureDevice::Request{
        choice, fault, "", nullptr, [this](const std::string& why) { warnings.push_back(why); }});
    device = pictures->get(problem);
  }
};

TEST(DrawingDevice, SoftwareStandsInForHardwareThatFails) {
  LUXGATE_NEEDS_OPENGL();
  Opened opened({1000, true, true, false, ""});
  ASSERT_NE(opened.device, nullptr) << opened.problem;
  EXPECT_EQ(opened.problem, "");
  ASSERT_EQ(opened.warnings.size(), 1u);
  EXPECT_THAT(opened.warnings[0], HasSubstr("there is no OpenGL device 1000"));
  std::string problem;
  EXPECT_EQ(opened.pictures->get(problem), opened.device);
  EXPECT_FALSE(opened.pictures->falls_back("again"));
  EXPECT_EQ(opened.warnings.size(), 1u);
}

TEST(DrawingDevice, NothingStandsInForWhatWasAskedFor) {
  LUXGATE_NEEDS_OPENGL();
  Opened opened({1000, true, false, false, ""});
  EXPECT_EQ(opened.device, nullptr);
  EXPECT_THAT(opened.problem, HasSubstr("there is no OpenGL device 1000"));
  EXPECT_TRUE(opened.warnings.empty());
}

TEST(DrawingDevice, SaysWhyNeitherWorks) {
  Opened opened({0, true, true, false, ""}, gpu::Fault::no_egl);
  EXPECT_EQ(opened.device, nullptr);
  EXPECT_THAT(opened.problem, HasSubstr("there is no EGL library"));
  EXPECT_EQ(opened.warnings.size(), 1u);
}

TEST(DrawingDevice, SoftwareIsOpenedWhereItIsPreferred) {
  LUXGATE_NEEDS_OPENGL();
  const gpu::DeviceList list = gpu::list_devices();
  Opened opened({gpu::kPreferSoftware, false, true, false, ""});
  ASSERT_NE(opened.device, nullptr) << opened.problem;
  const int software = gpu::software_device(list);
  EXPECT_EQ(opened.device->device().index, software >= 0 ? software : gpu::preferred_device(list));
}

}  // namespace
}  // namespace drawing_device_test
