#include "rendering/egl.hh"

#include <GL/glcorearb.h>
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace pongsim::rendering {
namespace {

constexpr const char* kAllNeeded = "EGL_KHR_no_config_context EGL_KHR_surfaceless_context";

/// A device of a made-up driver, for what machines without a card don't have.
struct Device {
  std::string kind = "EGL_EXT_device_drm EGL_EXT_device_drm_render_node";
  const char* file = nullptr;
  EGLint startError = EGL_SUCCESS;
  const char* extensions = kAllNeeded;
  EGLint contextError = EGL_SUCCESS;
  EGLint bindError = EGL_SUCCESS;
  const char* drawer = "A card";
  int contexts = 0;
};
Device softwareDevice() { return {.kind = "EGL_MESA_device_software EGL_EXT_device_drm_render_node"}; }

// what the driver's functions, which have no other way to it, are about
std::vector<Device> devices;
Device* bound = nullptr;
EGLint lastError = EGL_SUCCESS;

EGLBoolean isDone(EGLint error) {
  lastError = error;
  return error == EGL_SUCCESS ? EGL_TRUE : EGL_FALSE;
}

const unsigned char* drawerOfBound(GLenum) { return reinterpret_cast<const unsigned char*>(bound->drawer); }

EglFunctions madeUpEgl() {
  EglFunctions egl;
  egl.bindApi = [](EGLenum) -> EGLBoolean { return EGL_TRUE; };
  egl.queryDevices = [](EGLint most, EGLDeviceEXT* list, EGLint* count) -> EGLBoolean {
    *count = 0;
    for (Device& device : devices) {
      if (*count < most) list[(*count)++] = &device;
    }
    return EGL_TRUE;
  };
  egl.queryDeviceString = [](EGLDeviceEXT device, EGLint name) -> const char* {
    const auto* const known = static_cast<const Device*>(device);
    return name == EGL_EXTENSIONS ? known->kind.c_str() : known->file;
  };
  egl.getDisplay = [](EGLenum, void* device, const EGLAttrib*) -> EGLDisplay { return device; };
  egl.initialize = [](EGLDisplay display, EGLint*, EGLint*) {
    return isDone(static_cast<Device*>(display)->startError);
  };
  egl.queryString = [](EGLDisplay display, EGLint) { return static_cast<Device*>(display)->extensions; };
  egl.createContext = [](EGLDisplay display, EGLConfig, EGLContext, const EGLint*) -> EGLContext {
    auto* const device = static_cast<Device*>(display);
    if (isDone(device->contextError) == EGL_FALSE) return EGL_NO_CONTEXT;
    ++device->contexts;
    return device;
  };
  egl.destroyContext = [](EGLDisplay display, EGLContext) -> EGLBoolean {
    --static_cast<Device*>(display)->contexts;
    return EGL_TRUE;
  };
  egl.makeCurrent = [](EGLDisplay display, EGLSurface, EGLSurface, EGLContext context) {
    bound = static_cast<Device*>(context);
    return isDone(context == EGL_NO_CONTEXT ? EGL_SUCCESS : static_cast<Device*>(display)->bindError);
  };
  egl.getError = [] { return lastError; };
  egl.getAddress = [](const char*) { return reinterpret_cast<Context::Function>(&drawerOfBound); };
  return egl;
}

std::string reasonOf(const std::function<void()>& fails) {
  try {
    fails();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

class MadeUpCards : public ::testing::Test {
 protected:
  ~MadeUpCards() override { devices.clear(); }
};

TEST_F(MadeUpCards, AreTakenInTheirOrderOnceOneCanDraw) {
  devices = {softwareDevice(), {.startError = EGL_NOT_INITIALIZED}, {}, {}};
  {
    const auto context = eglContext(madeUpEgl(), EglDevices::kCards);
    EXPECT_EQ(devices[2].contexts, 0);
    context->bind();
    EXPECT_EQ(bound, &devices[2]);
    context->release();
    EXPECT_EQ(bound, nullptr);
    context->bind();
    context->release();
    EXPECT_EQ(devices[2].contexts, 1);
  }
  EXPECT_EQ(devices[2].contexts, 0);
}

TEST_F(MadeUpCards, SayWhyTheyCantDraw) {
  devices = {{.file = "/dev/dri/card0", .startError = EGL_NOT_INITIALIZED},
             {.extensions = "EGL_KHR_no_config_context"},
             {.contextError = EGL_BAD_ALLOC},
             {.file = "/dev/dri/card3", .contextError = EGL_BAD_MATCH},
             {.bindError = EGL_BAD_ACCESS},
             {.file = "/dev/dri/card5", .drawer = "llvmpipe (LLVM 15.0.6, 256 bits)"},
             softwareDevice()};
  const auto context = eglContext(madeUpEgl(), EglDevices::kCards);
  EXPECT_EQ(reasonOf([&] { context->bind(); }),
            "graphics card /dev/dri/card0 does not start (EGL error 12289); "
            "graphics card 2 has no EGL_KHR_surfaceless_context; "
            "graphics card 3 makes no context of OpenGL 4.5: it has no memory left; "
            "graphics card /dev/dri/card3 makes no context of OpenGL 4.5 (EGL error 12297); "
            "graphics card 5 can't be used (EGL error 12290); "
            "graphics card /dev/dri/card5 draws in software itself, with llvmpipe (LLVM 15.0.6, 256 bits)");
  for (const Device& device : devices) EXPECT_EQ(device.contexts, 0);
}

TEST_F(MadeUpCards, AreNoSoftware) {
  devices = {softwareDevice()};
  EXPECT_THROW(eglContext(madeUpEgl(), EglDevices::kCards)->bind(), NoCard);
  EXPECT_NO_THROW(eglContext(madeUpEgl(), EglDevices::kAll)->bind());
  // a card that can't draw is to be known
  devices.push_back({.startError = EGL_BAD_ALLOC});
  EXPECT_EQ(reasonOf([] { eglContext(madeUpEgl(), EglDevices::kAll)->bind(); }),
            "graphics card 1 does not start: it has no memory left");
  devices.clear();
  EXPECT_EQ(reasonOf([] { eglContext(madeUpEgl(), EglDevices::kAll)->bind(); }), "EGL has nothing to draw with");
}

TEST_F(MadeUpCards, MayBeLost) {
  devices = {{}};
  const auto context = eglContext(madeUpEgl(), EglDevices::kCards);
  context->bind();
  context->release();
  devices[0].bindError = EGL_CONTEXT_LOST;
  EXPECT_EQ(reasonOf([&] { context->bind(); }), "graphics card 1 can't be used any more (EGL error 12302)");
}

/// The driver of this machine; skips where there is none.
class Egl : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      egl_ = loadEgl();
      const std::unique_ptr<Context> any = context();
      const Binding binding(*any);
    } catch (const std::runtime_error& error) {
      GTEST_SKIP() << error.what();
    }
  }
  std::unique_ptr<Context> context() const { return eglContext(egl_, EglDevices::kAll); }

  /// @return Which context is current, by a number that is kept in it.
  static GLint numberIn(const Context& context) {
    GLint number = 0;
    reinterpret_cast<PFNGLGETINTEGERVPROC>(context.function("glGetIntegerv"))(GL_PACK_SKIP_ROWS, &number);
    return number;
  }

  EglFunctions egl_;
};

TEST_F(Egl, HasOneContextForAllThreadsThatTakeTurns) {
  const auto first = context(), second = context();
  int number = 0;
  for (Context* each : {first.get(), second.get()}) {
    const Binding binding(*each);
    reinterpret_cast<PFNGLPIXELSTOREIPROC>(each->function("glPixelStorei"))(GL_PACK_SKIP_ROWS, ++number);
  }
  const auto look = [](Context& context) {
    const Binding binding(context);
    return numberIn(context);
  };
  GLint seen = 0;
  std::thread([&] { seen = look(*first); }).join();
  EXPECT_EQ(seen, 1);
  EXPECT_EQ(look(*first), 1);
  // two at the same time, each on a thread of its own
  const Binding binding(*first);
  std::thread([&] { seen = look(*second); }).join();
  EXPECT_EQ(seen, 2);
  EXPECT_EQ(numberIn(*first), 1);
}

TEST_F(Egl, DrawsWithOpenGl45) {
  const auto context = this->context();
  const Binding binding(*context);
  const auto get = reinterpret_cast<PFNGLGETINTEGERVPROC>(context->function("glGetIntegerv"));
  GLint major = 0, minor = 0, profile = 0;
  get(GL_MAJOR_VERSION, &major);
  get(GL_MINOR_VERSION, &minor);
  get(GL_CONTEXT_PROFILE_MASK, &profile);
  EXPECT_GE(10 * major + minor, 45);
  EXPECT_EQ(profile, GL_CONTEXT_CORE_PROFILE_BIT);
}

}  // namespace
}  // namespace pongsim::rendering
