#include "gpu/device_thread.h"

#include "calc/radiosity/gatherer.h"
#include "gpu/gl_error.h"

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
  Piece piece{&work, false, false, ""};
  wait_for(piece);
  if (!piece.problem.empty()) throw calc::BackendFailure(piece.problem);
}

void DeviceThread::clean_up(const Work& work) {
  Piece piece{&work, true, false, ""};
  wait_for(piece);
}

void DeviceThread::wait_for(Piece& piece) {
  std::unique_lock lock(mutex_);
  queue_.push_back(&piece);
  wanted_.notify_one();
  changed_.wait(lock, [&] { return piece.is_done; });
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
                    {},
                    {}};
  while (Piece* piece = next()) {
    run_piece(state, *piece);
    {
      const std::scoped_lock lock(mutex_);
      piece->is_done = true;
    }
    changed_.notify_all();
  }
  pools_.clear();  // while the context is there
}

// Null: the end.
DeviceThread::Piece* DeviceThread::next() {
  std::unique_lock lock(mutex_);
  wanted_.wait(lock, [this] { return is_ending_ || !queue_.empty(); });
  if (queue_.empty()) return nullptr;
  Piece* piece = queue_.front();
  queue_.pop_front();
  return piece;
}

void DeviceThread::run_piece(DeviceState& state, Piece& piece) {
  if (!loss_.empty() && !piece.is_clean_up) {
    piece.problem = loss_;
    return;
  }
  try {
    (*piece.work)(state);
  } catch (const OutOfMemory& error) {
    // What is kept for later may be what leaves no room.
    state.scenes.clear();
    state.pools.clear();
    state.pictures.clear();
    piece.problem = error.what();
  } catch (const std::bad_alloc&) {
    piece.problem = "the program is out of memory";
  } catch (const std::exception& error) {
    piece.problem = loss_ = error.what();
  }
}

}  // namespace gpu
