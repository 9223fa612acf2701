#include "gpu/device/device_thread.h"

#include "calc/radiosity/gather/gatherer.h"
#include "gpu/opengl/gl_error.h"

#include <exception>
#include <new>
#include <utility>

namespace gpu {

void DeviceState::check(const std::string& doing) const {
  if (fault == Fault::out_of_memory) throw OutOfMemory("the device is out of memory (a test)");
  if (fault == Fault::context_lost) throw GlError("the device was reset (a test)");
  check_gl(doing);
  if (const std::string loss = context.loss(); !loss.empty()) throw GlError(loss);
}

void DeviceState::clear() {
  scenes.clear();
  pools.clear();
  draw_points.clear();
  near_points.clear();
  pictures.clear();
}

std::shared_ptr<DeviceThread> DeviceThread::open(const DeviceRequest& request,
                                                 std::string& problem) {
  std::shared_ptr<DeviceThread> thread(new DeviceThread(request));
  problem = thread->problem_;
  return problem.empty() ? thread : nullptr;
}

DeviceThread::DeviceThread(const DeviceRequest& request)
    : request_(request), thread_([this] { live(); }) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return is_open_ || !problem_.empty(); });
}

DeviceThread::~DeviceThread() {
  {
    const std::scoped_lock lock(mutex_);
    is_ending_ = true;
  }
  wanted_.notify_one();
  thread_.join();
}

void DeviceThread::run(const Work& work) {
  const std::string problem = wait_for(work, false);
  if (!problem.empty()) throw calc::BackendFailure(problem);
}

void DeviceThread::start(Work work, AtEnd at_end) {
  add({std::move(work), std::move(at_end), false});
}

void DeviceThread::clean_up(const Work& work) { wait_for(work, true); }

std::string DeviceThread::wait_for(const Work& work, bool is_clean_up) {
  std::string problem;
  bool is_done = false;
  add({work,
       [&](const std::string& what) {
         const std::scoped_lock lock(mutex_);
         problem = what;
         is_done = true;
         changed_.notify_all();
       },
       is_clean_up});
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return is_done; });
  return problem;
}

void DeviceThread::add(Piece piece) {
  const std::scoped_lock lock(mutex_);
  queue_.push_back(std::move(piece));
  wanted_.notify_one();
}

void DeviceThread::live() {
  std::string problem;
  std::unique_ptr<EglContext> context;
  try {
    context = EglContext::open(request_.device, request_.fault, problem, request_.messages);
  } catch (const std::exception& error) {  // would end the program: no one above catches it
    problem = std::string("it cannot be opened: ") + error.what();
  }
  {
    const std::scoped_lock lock(mutex_);
    problem_ = std::move(problem);
    if (context) device_ = context->device();
    is_open_ = context != nullptr;
  }
  changed_.notify_all();
  if (!context) return;
  DeviceState state{*context,
                    request_.fault,
                    {request_.program_folder, context->device().driver_key()},
                    pools_,
                    draw_points_,
                    near_points_,
                    {},
                    {}};
  while (const std::optional<Piece> piece = next()) piece->at_end(run_piece(state, *piece));
  state.clear();  // while the context is there
}

// Nothing: the end.
std::optional<DeviceThread::Piece> DeviceThread::next() {
  std::unique_lock lock(mutex_);
  wanted_.wait(lock, [this] { return is_ending_ || !queue_.empty(); });
  if (queue_.empty()) return std::nullopt;
  std::optional<Piece> piece = std::move(queue_.front());
  queue_.pop_front();
  return piece;
}

std::string DeviceThread::run_piece(DeviceState& state, const Piece& piece) {
  if (!loss_.empty() && !piece.is_clean_up) return loss_;
  try {
    piece.work(state);
  } catch (const OutOfMemory& error) {
    state.clear();
    return error.what();
  } catch (const std::bad_alloc&) {
    return "the program is out of memory";
  } catch (const std::exception& error) {
    loss_ = error.what();
    return loss_;
  }
  return "";
}

}  // namespace gpu
