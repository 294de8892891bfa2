#include "rendering/mesa_version.hh"

#include <GL/gl.h>

#include <memory>
#include <stdexcept>
#include <string_view>

#include "rendering/osmesa.hh"

namespace pongsim::rendering {

std::string mesaVersion() {
  try {
    const std::unique_ptr<Context> context = openOsmesa();
    const Binding binding(*context);
    const auto getString = reinterpret_cast<decltype(&glGetString)>(context->function("glGetString"));
    // "4.5 (Core Profile) Mesa 22.3.6"
    const std::string_view text = reinterpret_cast<const char*>(getString(GL_VERSION));
    constexpr std::string_view kMark = "Mesa ";
    const std::size_t mark = text.find(kMark);
    return std::string(mark == std::string_view::npos ? text : text.substr(mark + kMark.size()));
  } catch (const std::runtime_error&) {
    return "not installed";
  }
}

}  // namespace pongsim::rendering
