#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <memory>

#include "rendering/context.hh"

namespace pongsim::rendering {

/// The functions of EGL in use.
struct EglFunctions {
  decltype(&eglBindAPI) bindApi = nullptr;
  decltype(&eglCreateContext) createContext = nullptr;
  decltype(&eglDestroyContext) destroyContext = nullptr;
  decltype(&eglGetError) getError = nullptr;
  decltype(&eglGetPlatformDisplay) getDisplay = nullptr;
  decltype(&eglGetProcAddress) getAddress = nullptr;
  decltype(&eglInitialize) initialize = nullptr;
  decltype(&eglMakeCurrent) makeCurrent = nullptr;
  decltype(&eglQueryString) queryString = nullptr;
  PFNEGLQUERYDEVICESEXTPROC queryDevices = nullptr;
  PFNEGLQUERYDEVICESTRINGEXTPROC queryDeviceString = nullptr;
};

/// Loads EGL (libEGL.so.1), which finds the drivers of graphics cards; needs no display.
/// @throws std::runtime_error if it is not installed, or can't list devices.
EglFunctions loadEgl();

/// What may draw: a graphics card, or also Mesa's software device if there is none.
enum class EglDevices { kCards, kAll };

/// @return A context on the first card that can draw. Devices are looked for when it is first bound; that throws
/// `NoCard` if there is none.
std::unique_ptr<Context> eglContext(const EglFunctions& egl, EglDevices devices);

}  // namespace pongsim::rendering
