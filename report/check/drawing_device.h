#pragma once
// Which OpenGL device draws pictures of rooms and shadow maps, and why.

#include "calc/forecast/drawing_cost.h"
#include "gpu/device/device_thread.h"
#include "report/check/hardware.h"

#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace check {

struct DrawingChoice {
  int device = -1;           // of gpu::DeviceRequest
  bool is_hardware = false;  // as far as is known before it is opened
  bool is_by_cost = false;   // hardware and software can both draw, as far as is known
  bool is_open = false;      // the calculation's
  std::string why;
};

// The one that draws sooner, where there are both. Not even hardware is opened for it where no
// hardware could be sooner. work is only asked for if there may be hardware. What is chosen does
// not depend on --jobs.
DrawingChoice choose_to_draw(Hardware& hardware, const std::function<calc::DrawingWork()>& work);

// The same for pictures. open: of the calculation, null = none; then nothing else is opened, but
// where it is software that shadow maps took by cost. is_asked_for: by --gl-device.
DrawingChoice choose_for_pictures(const gpu::Device* open, bool is_asked_for, Hardware& hardware,
                                  const std::function<calc::DrawingWork()>& work);

// "pictures: software OpenGL: this machine has no graphics device\n"
std::string pictures_line(const DrawingChoice& choice);

// Who draws pictures, opened when first asked for.
class PictureDevice {
 public:
  struct Request {
    DrawingChoice choice;
    gpu::Fault fault = gpu::Fault::none;
    std::string program_folder;
    std::shared_ptr<gpu::DeviceThread> open;  // of the calculation; null = none
    // Told once if hardware that was chosen by cost failed, and how: software draws then.
    std::function<void(const std::string& failure)> warn;
  };
  explicit PictureDevice(Request request) : request_(std::move(request)) {}

  // Null: `problem` says why.
  gpu::DeviceThread* get(std::string& problem);
  // After a failure while drawing: whether another device is there to try.
  bool falls_back(const std::string& failure);

 private:
  Request request_;
  std::shared_ptr<gpu::DeviceThread> device_;
  std::string problem_;
};

}  // namespace check
