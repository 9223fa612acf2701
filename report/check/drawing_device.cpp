#include "report/check/drawing_device.h"

#include "calc/forecast/cost_model.h"

#include <fmt/format.h>

#include <optional>

namespace check {

DrawingChoice choose_to_draw(Hardware& hardware, const std::function<calc::DrawingWork()>& work) {
  if (!hardware.may_exist())
    return {-1, false, false, false, "this machine has no graphics device"};
  const calc::DrawingWork amount = work();
  const int threads = calc::thread_count({});
  calc::DrawingCost ideal = calc::weigh_ideal_drawing(amount, threads);
  if (!hardware.is_found()) ideal.hardware_s += ideal.open_s;  // to find it is to open it
  if (!calc::is_hardware_to_draw(amount, ideal)) {
    return {
        gpu::kPreferSoftware, false, true, false,
        fmt::format("too little to draw for a GPU: some {:.2g} s, and to {}open one takes "
                    "{:.2g} s or more",
                    ideal.software_s, hardware.is_found() ? "" : "find and ", ideal.hardware_s)};
  }
  const gpu::DeviceList& list = hardware.list();
  const int device = gpu::hardware_device(list);
  if (device < 0) return {-1, false, false, false, why_no_hardware(list, "is software")};
  const gpu::Device& found = list.devices[static_cast<std::size_t>(device)];
  if (gpu::software_device(list) < 0) {
    return {device, true, false, false,
            fmt::format("nothing but {} can draw here", found.renderer)};
  }
  std::string problem;  // what is kept is only read
  const calc::DeviceRates known =
      hardware.rates_of()(found, false, problem).value_or(calc::DeviceRates{});
  const calc::DrawingCost cost =
      calc::weigh_drawing(amount, calc::with_assumptions(known), threads);
  const bool is_hardware = calc::is_hardware_to_draw(amount, cost);
  const std::string times =
      amount.rooms > calc::kMostRoomsOnSoftware
          ? fmt::format("software OpenGL draws {} rooms at most, and there are {}",
                        calc::kMostRoomsOnSoftware, amount.rooms)
          : fmt::format("some {:.2g} s by software OpenGL, {:.2g} s by {}", cost.software_s,
                        cost.hardware_s, found.renderer);
  const std::string why =
      fmt::format("{}; {:.2g} s of these to open it are {}; how fast a GPU draws is assumed", times,
                  cost.open_s, known.open_s > 0.0 ? "measured" : "assumed, too");
  return {is_hardware ? device : gpu::kPreferSoftware, is_hardware, true, false, why};
}

DrawingChoice choose_for_pictures(const gpu::Device* open, bool is_asked_for, Hardware& hardware,
                                  const std::function<calc::DrawingWork()>& work) {
  if (open != nullptr && (is_asked_for || !open->is_software)) {
    return {open->index, !open->is_software, false, true,
            fmt::format("the calculation has opened {}", open->renderer)};
  }
  DrawingChoice choice = choose_to_draw(hardware, work);
  choice.is_open = open != nullptr && !choice.is_hardware;
  return choice;
}

std::string pictures_line(const DrawingChoice& choice) {
  return fmt::format("pictures: {}: {}\n", choice.is_hardware ? "gpu" : "software OpenGL",
                     choice.why);
}

gpu::DeviceThread* PictureDevice::get(std::string& problem) {
  if (!device_ && problem_.empty()) {
    device_ =
        request_.choice.is_open
            ? request_.open
            : gpu::DeviceThread::open(
                  {request_.choice.device, request_.fault, request_.program_folder}, problem_);
    if (!device_ && falls_back(problem_)) return get(problem);
  }
  problem = problem_;
  return device_.get();
}

bool PictureDevice::falls_back(const std::string& failure) {
  DrawingChoice& choice = request_.choice;
  if (!choice.is_hardware || !choice.is_by_cost || choice.is_open) return false;
  if (request_.warn) request_.warn(failure);
  choice = {gpu::kPreferSoftware, false, false, false, "the GPU failed"};
  device_.reset();
  problem_.clear();
  return true;
}

}  // namespace check
