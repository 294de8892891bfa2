#include "rendering/egl.hh"

#include <GL/glcorearb.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "base/shared_library.hh"
#include "pongsim/outcome.hh"

namespace pongsim::rendering {

namespace {

constexpr EGLint kMostDevices = 64;

/// @param list Words with spaces between them, or null.
bool hasWord(const char* list, std::string_view word) {
  if (list == nullptr) return false;
  const std::string padded = ' ' + std::string(list) + ' ';
  return padded.find(' ' + std::string(word) + ' ') != std::string::npos;
}

class EglContext final : public Context {
 public:
  EglContext(const EglFunctions& egl, EglDevices devices) : egl_(egl), devices_(devices) {}
  ~EglContext() override { drop(); }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void bind() override {
    if (context_ == EGL_NO_CONTEXT) create();
    if (!makeCurrent()) throw std::runtime_error(name_ + " can't be used any more" + error());
  }

  void release() override { egl_.makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }

  Function function(const char* name) const override { return egl_.getAddress(name); }

 private:
  /// @throws std::runtime_error with the reason of each device that can't draw.
  void create() {
    std::string reasons;
    int number = 0;
    for (const EGLDeviceEXT device : candidates()) {
      name_ = nameOf(device, ++number);
      const Outcome<void> made = createOn(device);
      if (made) return;
      drop();
      reasons += (reasons.empty() ? "" : "; ") + name_ + " " + made.error;
    }
    throw std::runtime_error(reasons.empty() ? "EGL has nothing to draw with" : reasons);
  }

  /// @return All cards; without any, the software devices if they may be used.
  std::vector<EGLDeviceEXT> candidates() const {
    std::vector<EGLDeviceEXT> devices(kMostDevices);
    EGLint count = 0;
    if (egl_.queryDevices(kMostDevices, devices.data(), &count) == EGL_FALSE) count = 0;
    devices.resize(static_cast<std::size_t>(count));
    const auto others =
        std::ranges::stable_partition(devices, [this](EGLDeviceEXT device) { return !isSoftware(device); });
    const bool hasCards = others.begin() != devices.begin();
    if (hasCards) {
      devices.erase(others.begin(), devices.end());
    } else if (devices_ == EglDevices::kCards) {
      throw NoCard("there is no graphics card");
    }
    return devices;
  }

  bool isSoftware(EGLDeviceEXT device) const {
    return hasWord(egl_.queryDeviceString(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
  }

  /// @return The device's file, such as "/dev/dri/card0", if it has one.
  std::string nameOf(EGLDeviceEXT device, int number) const {
    if (isSoftware(device)) return "the software device";
    const bool hasFile = hasWord(egl_.queryDeviceString(device, EGL_EXTENSIONS), "EGL_EXT_device_drm");
    const char* const file = hasFile ? egl_.queryDeviceString(device, EGL_DRM_DEVICE_FILE_EXT) : nullptr;
    return "graphics card " + (file != nullptr ? std::string(file) : std::to_string(number));
  }

  Outcome<void> createOn(EGLDeviceEXT device) {
    display_ = egl_.getDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
    // never ended, because it would end for all that use the device in this process
    if (display_ == EGL_NO_DISPLAY || egl_.initialize(display_, nullptr, nullptr) == EGL_FALSE) {
      return {"does not start" + error()};
    }
    const char* const extensions = egl_.queryString(display_, EGL_EXTENSIONS);
    for (const char* const needed : {"EGL_KHR_no_config_context", "EGL_KHR_surfaceless_context"}) {
      if (!hasWord(extensions, needed)) return {"has no " + std::string(needed)};
    }
    constexpr std::array<EGLint, 7> kWanted{
        EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    egl_.bindApi(EGL_OPENGL_API);
    context_ = egl_.createContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kWanted.data());
    if (context_ == EGL_NO_CONTEXT) return {"makes no context of OpenGL 4.5" + error()};
    return devices_ == EglDevices::kCards ? checkCard() : Outcome<void>{};
  }

  /// What calls itself a card may draw in software, as in a virtual machine.
  Outcome<void> checkCard() {
    if (!makeCurrent()) return {"can't be used" + error()};
    const auto getString = reinterpret_cast<PFNGLGETSTRINGPROC>(function("glGetString"));
    const auto* const text = getString == nullptr ? nullptr : reinterpret_cast<const char*>(getString(GL_RENDERER));
    const std::string drawer = text == nullptr ? "" : text;
    release();
    const bool isSoft = drawer.starts_with("llvmpipe") || drawer.starts_with("softpipe");
    return isSoft ? Outcome<void>{"draws in software itself, with " + drawer} : Outcome<void>{};
  }

  bool makeCurrent() {
    // each thread has its own
    egl_.bindApi(EGL_OPENGL_API);
    return egl_.makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
  }

  void drop() {
    if (context_ != EGL_NO_CONTEXT) egl_.destroyContext(display_, context_);
    context_ = EGL_NO_CONTEXT;
  }

  /// @return The last call's error, to end a sentence with.
  std::string error() const {
    const EGLint code = egl_.getError();
    return code == EGL_BAD_ALLOC ? ": it has no memory left" : " (EGL error " + std::to_string(code) + ")";
  }

  EglFunctions egl_;
  EglDevices devices_;
  std::string name_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

EglFunctions loadEgl() {
  const auto library = base::SharedLibrary::require(PONGSIM_EGL, "libegl1");
  EglFunctions egl;
  library.bind(egl.bindApi, "eglBindAPI");
  library.bind(egl.createContext, "eglCreateContext");
  library.bind(egl.destroyContext, "eglDestroyContext");
  library.bind(egl.getError, "eglGetError");
  library.bind(egl.getDisplay, "eglGetPlatformDisplay");
  library.bind(egl.getAddress, "eglGetProcAddress");
  library.bind(egl.initialize, "eglInitialize");
  library.bind(egl.makeCurrent, "eglMakeCurrent");
  library.bind(egl.queryString, "eglQueryString");
  egl.queryDevices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(egl.getAddress("eglQueryDevicesEXT"));
  egl.queryDeviceString = reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(egl.getAddress("eglQueryDeviceStringEXT"));
  if (egl.queryDevices == nullptr || egl.queryDeviceString == nullptr) {
    throw std::runtime_error("EGL has no driver that lists devices (EGL_EXT_device_enumeration)");
  }
  return egl;
}

std::unique_ptr<Context> eglContext(const EglFunctions& egl, EglDevices devices) {
  return std::make_unique<EglContext>(egl, devices);
}

}  // namespace pongsim::rendering
