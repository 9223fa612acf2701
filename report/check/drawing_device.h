#pragma once
// Chooses the OpenGL device that draws pictures of rooms and shadow maps, and says why.

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

// Returns the faster device, if there are both kinds. Hardware is only opened if it could be
// faster, and work is only called if there may be hardware. The choice does not depend on --jobs.
DrawingChoice choose_to_draw(Hardware& hardware, const std::function<calc::DrawingWork()>& work);

// Returns the device for pictures. open: the calculation's device, null = none. It is used if it is
// hardware or requested; software that shadow maps chose by cost is compared again. is_asked_for:
// requested by --gl-device.
DrawingChoice choose_for_pictures(const gpu::Device* open, bool is_asked_for, Hardware& hardware,
                                  const std::function<calc::DrawingWork()>& work);

// Returns "pictures: software OpenGL: this machine has no graphics device\n".
std::string pictures_line(const DrawingChoice& choice);

// The device that draws pictures; it is opened at the first request.
class PictureDevice {
 public:
  struct Request {
    DrawingChoice choice;
    gpu::Fault fault = gpu::Fault::none;
    std::string program_folder;
    std::shared_ptr<gpu::DeviceThread> open;  // of the calculation; null = none
    // Called once if hardware that was chosen by cost fails, with the failure: software draws then.
    std::function<void(const std::string& failure)> warn;
  };
  explicit PictureDevice(Request request) : request_(std::move(request)) {}

  // Returns the device; null: `problem` says why.
  gpu::DeviceThread* get(std::string& problem);
  // Returns, after a failure while drawing, whether there is another device to try.
  bool falls_back(const std::string& failure);

 private:
  Request request_;
  std::shared_ptr<gpu::DeviceThread> device_;
  std::string problem_;
};

}  // namespace check
