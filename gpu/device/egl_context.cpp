#include "gpu/device/egl_context.h"

#include "gpu/device/missing_device.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace gpu {
namespace {

// One way to a display. Without a device it is Mesa's "surfaceless" platform, which chooses itself.
struct Candidate {
  EGLDeviceEXT device = EGL_NO_DEVICE_EXT;
  bool is_software = false;  // EGL says so before a context exists
};

struct Candidates {
  std::vector<Candidate> list;
  std::string problem;
};

// epoxy ends the program when a library that it needs is missing.
bool can_load(const char* library) {
  void* const handle = dlopen(library, RTLD_LAZY | RTLD_LOCAL);
  return handle != nullptr;  // stays loaded: it is needed at once
}

bool has_word(const char* words, std::string_view word) {
  const std::string_view text = words == nullptr ? "" : words;
  for (std::size_t at = text.find(word); at != std::string_view::npos;
       at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || text[at - 1] == ' ') && (end == text.size() || text[end] == ' ')) return true;
  }
  return false;
}

bool has_client_extension(std::string_view name) {
  return has_word(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), name);
}

std::string egl_error() {
  const EGLint code = eglGetError();
  switch (code) {
    case EGL_SUCCESS:
      return "no reason given";
    case EGL_NOT_INITIALIZED:
      return "EGL_NOT_INITIALIZED: its driver did not start";
    case EGL_BAD_ACCESS:
      return "EGL_BAD_ACCESS";
    case EGL_BAD_ALLOC:
      return "EGL_BAD_ALLOC: out of memory, or no permission for the device";
    case EGL_BAD_ATTRIBUTE:
      return "EGL_BAD_ATTRIBUTE";
    case EGL_BAD_CONFIG:
      return "EGL_BAD_CONFIG";
    case EGL_BAD_MATCH:
      return "EGL_BAD_MATCH: this version is not offered";
    default:
      return fmt::format("EGL error {:#x}", code);
  }
}

std::vector<Candidate> enumerate_devices() {
  std::vector<Candidate> list;
  const bool has_enumeration = has_client_extension("EGL_EXT_device_base") ||
                               (has_client_extension("EGL_EXT_device_enumeration") &&
                                has_client_extension("EGL_EXT_device_query"));
  if (!has_enumeration || !has_client_extension("EGL_EXT_platform_device")) return list;
  EGLint count = 0;
  if (eglQueryDevicesEXT(0, nullptr, &count) != EGL_TRUE || count <= 0) return list;
  std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
  if (eglQueryDevicesEXT(count, devices.data(), &count) != EGL_TRUE) return list;
  devices.resize(static_cast<std::size_t>(count));
  for (EGLDeviceEXT device : devices) {
    const char* extensions = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
    list.push_back({device, has_word(extensions, "EGL_MESA_device_software")});
  }
  std::stable_partition(list.begin(), list.end(),
                        [](const Candidate& candidate) { return !candidate.is_software; });
  return list;
}

Candidates find_candidates(Fault fault) {
  Candidates result;
  if (fault == Fault::no_egl || !can_load("libEGL.so.1") || !epoxy_has_egl()) {
    result.problem = "there is no EGL library (libEGL.so.1)";
    return result;
  }
  if (!can_load("libOpenGL.so.0") && !can_load("libGL.so.1")) {
    result.problem = "there is no OpenGL library (libOpenGL.so.0 or libGL.so.1)";
    return result;
  }
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const bool has_driver = extensions != nullptr && *extensions != 0;
  if (has_driver && !has_client_extension("EGL_EXT_platform_base")) {
    result.problem = "EGL offers no device without a window (EGL_EXT_platform_base)";
    return result;
  }
  if (has_driver) result.list = enumerate_devices();
  if (result.list.empty() && has_client_extension("EGL_MESA_platform_surfaceless")) {
    result.list.push_back({});
  }
  if (result.list.empty()) {
    result.problem =
        "EGL knows no device: " + no_egl_device_reason(read_device_facts(this_machine()));
  }
  return result;
}

EGLDisplay display_of(const Candidate& candidate) {
  if (candidate.device == EGL_NO_DEVICE_EXT) {
    return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  }
  return eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, candidate.device, nullptr);
}

// Contexts that draw nowhere need no configuration, or any that knows OpenGL.
bool choose_config(EGLDisplay display, EGLConfig& config) {
  config = EGL_NO_CONFIG_KHR;
  if (epoxy_has_egl_extension(display, "EGL_KHR_no_config_context")) return true;
  const std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                     EGL_OPENGL_BIT, EGL_NONE};
  EGLint count = 0;
  return eglChooseConfig(display, wanted.data(), &config, 1, &count) == EGL_TRUE && count > 0;
}

// With reset notification where it is offered, so that a lost device is told from a slow one.
EGLContext create_context(EGLDisplay display, EGLConfig config, int major, int minor,
                          bool has_messages) {
  std::vector<EGLint> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                 major,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 minor,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
  const bool is_core = epoxy_egl_version(display) >= 15;  // older: the extension's own token
  if (has_messages) {
    attributes.pop_back();
    if (is_core) {
      attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE, EGL_NONE});
    } else {
      attributes.insert(attributes.end(),
                        {EGL_CONTEXT_FLAGS_KHR, EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR, EGL_NONE});
    }
  }
  if (is_core || epoxy_has_egl_extension(display, "EGL_EXT_create_context_robustness")) {
    static_assert(EGL_LOSE_CONTEXT_ON_RESET == EGL_LOSE_CONTEXT_ON_RESET_EXT);
    std::vector<EGLint> robust = attributes;
    robust.pop_back();
    robust.insert(robust.end(), {is_core ? EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY
                                         : EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_EXT,
                                 EGL_LOSE_CONTEXT_ON_RESET, EGL_NONE});
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, robust.data());
    if (context != EGL_NO_CONTEXT) return context;
  }
  return eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
}

std::string gl_string(GLenum name) {
  const GLubyte* text = glGetString(name);
  if (text == nullptr) return "";
  std::string result;
  for (const GLubyte* c = text; *c != 0; ++c) result += static_cast<char>(*c);
  return result;
}

}  // namespace

// Displays are EGL's own singletons, one per device: they are never terminated, because other
// contexts of this process may use them.
struct EglHandles {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  EGLSurface surface = EGL_NO_SURFACE;

  EglHandles() = default;
  EglHandles(const EglHandles&) = delete;
  EglHandles& operator=(const EglHandles&) = delete;
  ~EglHandles() {
    if (context == EGL_NO_CONTEXT) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (surface != EGL_NO_SURFACE) eglDestroySurface(display, surface);
    eglDestroyContext(display, context);
    eglReleaseThread();
  }

  // "" or why it cannot be made current.
  std::string make_current(EGLConfig config) {
    if (!epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context") &&
        config != EGL_NO_CONFIG_KHR) {
      const std::array<EGLint, 5> one_pixel{EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
      surface = eglCreatePbufferSurface(display, config, one_pixel.data());
    }
    if (eglMakeCurrent(display, surface, surface, context) == EGL_TRUE) return "";
    return "its context cannot be used: " + egl_error();
  }

  // "" or why there is no context. Any version: what it lacks is seen later.
  std::string open(const Candidate& candidate, bool has_messages) {
    display = display_of(candidate);
    if (display == EGL_NO_DISPLAY) return "EGL gives no display: " + egl_error();
    EGLint major = 0, minor = 0;
    if (eglInitialize(display, &major, &minor) != EGL_TRUE) {
      return "EGL cannot start it: " + egl_error();
    }
    if (major == 1 && minor < 5 && !epoxy_has_egl_extension(display, "EGL_KHR_create_context")) {
      return "its EGL cannot make contexts of a chosen version (EGL_KHR_create_context)";
    }
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) return "it has no desktop OpenGL";
    EGLConfig config = EGL_NO_CONFIG_KHR;
    if (!choose_config(display, config)) return "it offers no configuration for OpenGL";
    context = create_context(display, config, kLeastMajor, kLeastMinor, has_messages);
    if (context == EGL_NO_CONTEXT) context = create_context(display, config, 3, 2, has_messages);
    if (context == EGL_NO_CONTEXT) return "it gives no OpenGL context: " + egl_error();
    return make_current(config);
  }
};

namespace {

// Of the context that is current.
void describe(Device& device) {
  device.renderer = gl_string(GL_RENDERER);
  device.vendor = gl_string(GL_VENDOR);
  device.version = gl_string(GL_VERSION);
  device.is_software = device.is_software || is_software_renderer(device.renderer);
  const int version = epoxy_gl_version();
  if (version < 10 * kLeastMajor + kLeastMinor) {
    device.problem = fmt::format("OpenGL {}.{} has no compute shaders: {}.{} is needed",
                                 version / 10, version % 10, kLeastMajor, kLeastMinor);
  }
}

// Leaves the context current; device.problem is "" if it can be used.
std::unique_ptr<EglHandles> open_device(const Candidate& candidate, int index, Device& device,
                                        bool has_messages = false) {
  auto handles = std::make_unique<EglHandles>();
  device = Device{};
  device.index = index;
  device.is_software = candidate.is_software;
  device.problem = handles->open(candidate, has_messages);
  if (device.problem.empty()) describe(device);
  return handles;
}

DeviceList list_candidates(Fault fault, bool opens_software) {
  const Candidates candidates = find_candidates(fault);
  DeviceList result;
  result.problem = candidates.problem;
  for (const Candidate& candidate : candidates.list) {
    Device& device = result.devices.emplace_back();
    const int index = static_cast<int>(result.devices.size()) - 1;
    if (candidate.is_software && !opens_software) {
      device.index = index;
      device.is_software = true;
      device.problem = kNotOpened;
    } else {
      open_device(candidate, index, device);
    }
  }
  if (hardware_device(result) < 0) result.advice = missing_hardware_advice(fault);
  return result;
}

// Hardware is not opened for it where EGL says which candidate is software.
int first_software(const Candidates& candidates, Fault fault) {
  for (std::size_t k = 0; k < candidates.list.size(); ++k) {
    if (candidates.list[k].is_software) return static_cast<int>(k);
  }
  return software_device(list_candidates(fault, true));
}

std::string joined(const std::string& problem, const std::string& advice) {
  return advice.empty() ? problem : problem + "; " + advice;
}

std::string no_such_device(int index, std::size_t count) {
  return fmt::format("there is no OpenGL device {}: 'luxgate devices' lists {}", index,
                     count == 1 ? "only 0" : fmt::format("0 to {}", count - 1));
}

}  // namespace

DeviceList list_devices(Fault fault) { return list_candidates(fault, true); }

bool may_have_hardware() { return read_device_facts(this_machine()).has_graphics_node; }

DeviceList list_hardware(Fault fault) {
  const DeviceFacts facts = read_device_facts(this_machine());
  if (!facts.has_graphics_node) {
    return {{}, "this machine has no graphics device", missing_device_advice(facts)};
  }
  return list_candidates(fault, false);
}

// A fault that a test asks for is not the machine's.
std::string missing_hardware_advice(Fault fault) {
  return fault == Fault::none ? missing_device_advice(read_device_facts(this_machine())) : "";
}

namespace {

thread_local const EglContext* current_context = nullptr;

// Drivers may call it from threads of their own.
void GLAPIENTRY take_message(GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* text,
                             const void* messages) {
  auto& taken = *static_cast<DriverMessages*>(const_cast<void*>(messages));
  if (type == GL_DEBUG_TYPE_PERFORMANCE) taken.add(DriverMessages::Kind::performance, text);
  if (type == GL_DEBUG_TYPE_OTHER) taken.add(DriverMessages::Kind::other, text);
}

}  // namespace

EglContext::EglContext(std::unique_ptr<EglHandles> handles, Device device, Fault fault,
                       DriverMessages* messages)
    : handles_(std::move(handles)),
      device_(std::move(device)),
      fault_(fault),
      messages_(messages),
      has_buffer_storage_(
          fault != Fault::no_buffer_storage &&
          (epoxy_gl_version() >= 44 || epoxy_has_gl_extension("GL_ARB_buffer_storage"))) {
  current_context = this;
  if (messages_ == nullptr) return;
  glEnable(GL_DEBUG_OUTPUT);
  glDebugMessageCallback(take_message, messages_);
}

EglContext::~EglContext() {
  if (messages_ != nullptr) glDebugMessageCallback(nullptr, nullptr);
  if (current_context == this) current_context = nullptr;
}

const EglContext& EglContext::current() {
  if (current_context == nullptr) throw std::logic_error("no OpenGL context is current");
  return *current_context;
}

std::unique_ptr<EglContext> EglContext::open(int index, Fault fault, std::string& problem,
                                             DriverMessages* messages) {
  const Candidates candidates = find_candidates(fault);
  if (!candidates.problem.empty()) {
    problem = joined(candidates.problem, missing_hardware_advice(fault));
    return nullptr;
  }
  problem = "";
  if (index == kPreferSoftware) index = first_software(candidates, fault);
  if (index < 0) {
    const DeviceList list = list_devices(fault);
    index = preferred_device(list);
    if (index < 0) {
      problem = why_none_is_usable(list);
      return nullptr;
    }
  }
  if (static_cast<std::size_t>(index) >= candidates.list.size()) {
    problem = no_such_device(index, candidates.list.size());
    return nullptr;
  }
  Device device;
  std::unique_ptr<EglHandles> handles = open_device(
      candidates.list[static_cast<std::size_t>(index)], index, device, messages != nullptr);
  if (!device.is_usable()) {
    problem = fmt::format("OpenGL device {}: {}", index, device.problem);
    if (!device.is_software) problem = joined(problem, missing_hardware_advice(fault));
    return nullptr;
  }
  return std::unique_ptr<EglContext>(
      new EglContext(std::move(handles), std::move(device), fault, messages));
}

std::string EglContext::loss() const {
  if (epoxy_gl_version() < 45 && !epoxy_has_gl_extension("GL_ARB_robustness")) return "";
  const GLenum status =
      epoxy_gl_version() < 45 ? glGetGraphicsResetStatusARB() : glGetGraphicsResetStatus();
  switch (status) {
    case GL_NO_ERROR:
      return "";
    case GL_GUILTY_CONTEXT_RESET:
      return "the device was reset because of this calculation";
    case GL_INNOCENT_CONTEXT_RESET:
      return "the device was reset because of another program";
    default:
      return "the device was reset";
  }
}

}  // namespace gpu
