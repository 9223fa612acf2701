#pragma once
// A thread that owns an OpenGL context and does the device work of all other threads.

#include "gpu/device/egl_context.h"
#include "gpu/opengl/program_cache.h"
#include "gpu/raster/picture_tools.h"
#include "gpu/scene/device_points.h"
#include "gpu/scene/device_pool.h"
#include "gpu/scene/device_scene.h"

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace gpu {

struct DeviceRequest {
  int device = -1;  // as in list_devices(); -1 = preferred_device(), or kPreferSoftware
  Fault fault = Fault::none;
  std::filesystem::path program_folder = {};  // of ProgramCache, "" = none
  DriverMessages* messages = nullptr;         // as in EglContext::open(), outlives the thread
};

// The state that work on the context's thread may use.
struct DeviceState {
  const EglContext& context;
  Fault fault;
  ProgramCache programs;
  DevicePools& pools;                    // of the thread
  PlaneBlocks<DrawPoints>& draw_points;  // of the thread
  PlaneBlocks<NearPoints>& near_points;  // of the thread
  DeviceScenes scenes;
  PictureTools pictures;

  // Clears data kept for later, which may use the missing memory.
  void clear();

  // Throws the failure of the request's fault, or that the context is lost.
  void check(const std::string& doing) const;
};

class DeviceThread {
 public:
  using Work = std::function<void(DeviceState&)>;
  using AtEnd = std::function<void(const std::string& problem)>;

  // Returns null if the device gives no context; `problem` then says why in words, for the user.
  static std::shared_ptr<DeviceThread> open(const DeviceRequest& request, std::string& problem);
  ~DeviceThread();
  DeviceThread(const DeviceThread&) = delete;
  DeviceThread& operator=(const DeviceThread&) = delete;

  const Device& device() const { return device_; }
  // Data uploaded once for all stages. Functions that need the context are for its thread.
  DevicePools& pools() { return pools_; }
  PlaneBlocks<DrawPoints>& draw_points() { return draw_points_; }
  PlaneBlocks<NearPoints>& near_points() { return near_points_; }

  // Runs the work on the context's thread and waits; any thread may call it, pieces run in the
  // order of calls. Throws calc::BackendFailure with the text of what the work threw. After
  // OutOfMemory the device may be used again; after anything else it is lost, and every further
  // run() throws the same text.
  void run(const Work& work);
  // Does the same without waiting. at_end, which must not throw, is called on the context's thread
  // after the work, or instead of it on a lost device: with the text that run() would throw, or "".
  void start(Work work, AtEnd at_end);
  // Runs work that frees earlier results, on a lost device too; `work` must not throw.
  void clean_up(const Work& work);

 private:
  struct Piece {
    Work work;
    AtEnd at_end;
    bool is_clean_up;
  };

  explicit DeviceThread(const DeviceRequest& request);
  void live();
  std::optional<Piece> next();
  // Returns the error, or "".
  std::string run_piece(DeviceState& state, const Piece& piece);
  void add(Piece piece);
  std::string wait_for(const Work& work, bool is_clean_up);

  const DeviceRequest request_;
  std::mutex mutex_;
  std::condition_variable wanted_, changed_;
  std::deque<Piece> queue_;
  bool is_open_ = false, is_ending_ = false;
  std::string problem_;  // why there is no context
  std::string loss_;     // of the context's thread alone
  Device device_;
  DevicePools pools_;
  PlaneBlocks<DrawPoints> draw_points_;
  PlaneBlocks<NearPoints> near_points_;
  std::thread thread_;  // last: it uses all the others
};

}  // namespace gpu
