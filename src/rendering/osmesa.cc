#include "rendering/osmesa.hh"

#include <GL/osmesa.h>

#include <array>
#include <cstdint>
#include <stdexcept>

#include "base/shared_library.hh"

namespace pongsim::rendering {

namespace {

/// The functions of the library in use.
struct OsmesaFunctions {
  decltype(&OSMesaCreateContextAttribs) createContext = nullptr;
  decltype(&OSMesaDestroyContext) destroyContext = nullptr;
  decltype(&OSMesaMakeCurrent) makeCurrent = nullptr;
  decltype(&OSMesaGetProcAddress) getAddress = nullptr;
};

class OsmesaContext final : public Context {
 public:
  explicit OsmesaContext(const OsmesaFunctions& functions) : functions_(functions) {}
  ~OsmesaContext() override {
    if (context_ != nullptr) functions_.destroyContext(context_);
  }
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  void bind() override {
    if (context_ == nullptr) create();
    if (functions_.makeCurrent(context_, window_.data(), GL_UNSIGNED_BYTE, kEdge, kEdge) == 0) {
      throw std::runtime_error("OSMesa can't draw");
    }
  }

  void release() override { functions_.makeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }

  Function function(const char* name) const override { return functions_.getAddress(name); }

 private:
  void create() {
    constexpr std::array<int, 11> kWanted{OSMESA_FORMAT,
                                          OSMESA_RGBA,
                                          OSMESA_PROFILE,
                                          OSMESA_CORE_PROFILE,
                                          OSMESA_CONTEXT_MAJOR_VERSION,
                                          4,
                                          OSMESA_CONTEXT_MINOR_VERSION,
                                          5,
                                          0,
                                          0,
                                          0};
    context_ = functions_.createContext(kWanted.data(), nullptr);
    if (context_ == nullptr) throw std::runtime_error("OSMesa has no OpenGL 4.5");
  }

  // images are drawn into framebuffers of their own
  static constexpr int kEdge = 4;

  OsmesaFunctions functions_;
  OSMesaContext context_ = nullptr;
  std::array<std::uint32_t, kEdge * kEdge> window_{};
};

}  // namespace

std::unique_ptr<Context> openOsmesa() {
  const auto library = base::SharedLibrary::require(PONGSIM_OSMESA, "libosmesa6");
  OsmesaFunctions functions;
  library.bind(functions.createContext, "OSMesaCreateContextAttribs");
  library.bind(functions.destroyContext, "OSMesaDestroyContext");
  library.bind(functions.makeCurrent, "OSMesaMakeCurrent");
  library.bind(functions.getAddress, "OSMesaGetProcAddress");
  return std::make_unique<OsmesaContext>(functions);
}

}  // namespace pongsim::rendering
