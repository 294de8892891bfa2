#include "rendering/renderer.hh"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "pongsim/log.hh"
#include "rendering/billboards.hh"
#include "rendering/frame.hh"
#include "rendering/gl.hh"
#include "rendering/lighting.hh"
#include "rendering/lines.hh"
#include "rendering/program.hh"
#include "rendering/projection.hh"
#include "rendering/resolve.hh"
#include "rendering/shaders.hh"
#include "rendering/shadow_maps.hh"
#include "rendering/store.hh"
#include "rendering/surface_programs.hh"

namespace pongsim::rendering {

namespace {

using Eigen::Matrix4d;
using Eigen::Matrix4f;

constexpr int kSamples = 4;
// small images don't need fine shadows
constexpr std::uint64_t kLargePicture = 200'000;

const Logger& logger() {
  static const Logger log("rendering");
  return log;
}

Matrix4d placeFromSurface(const Item& item, const Vector3& eye) {
  const Pose X_WorldSurface = item.X_WorldSurface();
  Matrix4d place = Matrix4d::Identity();
  place.topLeftCorner<3, 3>() = X_WorldSurface.rotation.toRotationMatrix() * item.scale.asDiagonal();
  place.topRightCorner<3, 1>() = X_WorldSurface.position - eye;
  return place;
}

/// @return All visible items: opaque ones first, of these the ground last, which most others hide in part; then the
/// others from far to near.
std::vector<const Item*> seenItems(const Scene& scene, const PictureView& view, const Matrix4d& clip) {
  std::vector<const Item*> opaque, ground;
  std::vector<std::pair<double, const Item*>> others;
  for (const Item& item : scene.items()) {
    if ((item.visibility & view.visibilityMask) == 0) continue;
    const Eigen::AlignedBox3d box = item.boundsInWorld();
    const Vector3 middle = box.center() - view.X_WorldEye.position;
    if (!mayBeSeen(clip, middle, box.diagonal().norm() / 2)) continue;
    if (item.paint.opacity < 1) {
      others.emplace_back(-middle.squaredNorm(), &item);
    } else {
      (item.isGround ? ground : opaque).push_back(&item);
    }
  }
  std::ranges::stable_sort(others, {}, &std::pair<double, const Item*>::first);
  opaque.insert(opaque.end(), ground.begin(), ground.end());
  for (const auto& [distance, item] : others) opaque.push_back(item);
  return opaque;
}

}  // namespace

class Renderer::Content {
 public:
  explicit Content(const Context& context)
      : gl_(context),
        store_(gl_),
        surfaces_(gl_),
        resolve_(gl_),
        depthPass_(gl_),
        sky_(gl_, shaders::kSkyVertex, shaders::kSkyFragment),
        markerProgram_(gl_, shaders::kSurfaceVertex, shaders::kMarkerFragment),
        lines_(gl_) {
    gl_.clipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl_.genBuffers(1, &lamps_);
    gl_.genVertexArrays(1, &nothing_);
  }

  ~Content() {
    gl_.deleteBuffers(1, &lamps_);
    gl_.deleteVertexArrays(1, &nothing_);
  }
  Content(const Content&) = delete;
  Content& operator=(const Content&) = delete;

  /// @return What OpenGL calls what it draws with, such as "llvmpipe (LLVM 15.0.6, 256 bits)".
  std::string name() const {
    const GLubyte* const text = gl_.getString(GL_RENDERER);
    return text == nullptr ? "an OpenGL without a name" : reinterpret_cast<const char*>(text);
  }
  /// @throws std::runtime_error if OpenGL has refused something, such as memory.
  void check() const { gl_.check(); }

  void drawColors(const Scene& scene, const PictureView& view, std::span<std::uint8_t> pixels) {
    assert(pixels.size() == std::size_t{3} * view.width * view.height);
    tidy(scene);
    const int shadowEdge = std::uint64_t{view.width} * view.height > kLargePicture ? 2048 : 1024;
    const Lighting lighting = lightingOf(scene, view, shadowEdge);
    if (!lighting.shadows.empty()) shadowsOf(shadowEdge).draw(scene, lighting.shadows, store_);
    setLighting(lighting.block);

    const Frame& frame = frameFor(Frame::Kind::kColors, view, view.antiAliasing >= kSamples ? kSamples : 1);
    // before binding the framebuffer, because Mesa clears with the state set at that time
    gl_.enable(GL_FRAMEBUFFER_SRGB);
    begin(frame);
    drawBackground(scene, view, lighting.block);
    surfaces_.setLight(lighting.kinds);
    const Matrix4d clip = clipFromPlace(view);
    drawMarkersInColors(scene, view, clip, false);
    const Program* inUse = nullptr;
    for (const Item* item : seenItems(scene, view, clip)) {
      const Program& program = surfaces_.of(*item);
      if (&program != inUse) {
        program.use();
        setMatrix(shaders::kClipFromPlace, clip);
        inUse = &program;
      }
      drawInColors(*item, view.X_WorldEye.position);
    }
    if (!scene.billboards().empty()) drawBillboards(scene, view, clip);
    drawMarkersInColors(scene, view, clip, true);
    gl_.disable(GL_BLEND);
    gl_.depthMask(GL_TRUE);
    lines_.draw(view, clip);
    frame.read(resolve_, pixels);
  }

  void drawDepths(const Scene& scene, const PictureView& view, std::span<float> depths) {
    depthPass_.setAhead(view.X_WorldEye.rotation * Vector3::UnitX());
    drawValues(scene, view, depthPass_, INFINITY, depths);
  }

  void drawNumbers(const Scene& scene, const PictureView& view, std::span<std::uint32_t> numbers) {
    if (numberPass_ == nullptr) numberPass_ = std::make_unique<NumberPass>(gl_);
    values_.resize(numbers.size());
    drawValues(scene, view, *numberPass_, NumberPass::kNothing, values_);
    std::ranges::transform(values_, numbers.begin(), [](float value) { return static_cast<std::uint32_t>(value); });
  }

  void drawTemperatures(const Scene& scene, const PictureView& view, const AirTemperatures& air,
                        std::span<float> temperatures) {
    if (temperaturePass_ == nullptr) temperaturePass_ = std::make_unique<TemperaturePass>(gl_);
    temperaturePass_->setAir(air);
    drawValues(scene, view, *temperaturePass_, static_cast<float>(air.coldest), temperatures);
  }

 private:
  /// @param pass See `values.hh`.
  /// @param nothing The value where nothing is.
  template <class Pass>
  void drawValues(const Scene& scene, const PictureView& view, const Pass& pass, float nothing,
                  std::span<float> values) {
    assert(values.size() == std::size_t{view.width} * view.height);
    tidy(scene);
    const Frame& frame = frameFor(Frame::Kind::kDepths, view, 1);
    gl_.disable(GL_FRAMEBUFFER_SRGB);
    begin(frame);
    const std::array<float, 4> background{nothing, 0, 0, 0};
    gl_.clearBufferfv(GL_COLOR, 0, background.data());
    const Matrix4d clip = clipFromPlace(view);
    pass.use();
    setMatrix(shaders::kClipFromPlace, clip);
    for (const Item* item : seenItems(scene, view, clip)) {
      pass.set(*item, store_);
      drawSurface(*item, view.X_WorldEye.position);
    }
    // they have no number and no temperature
    if constexpr (std::is_same_v<Pass, DepthPass>) {
      for (const PlacedMarker& marker : scene.markers()) drawMarker(marker, view, false);
    }
    frame.read(values);
  }

  void tidy(const Scene& scene) {
    if (scene.version() != version_) store_.tidy();
    version_ = scene.version();
  }

  const Frame& frameFor(Frame::Kind kind, const PictureView& view, int samples) {
    std::unique_ptr<Frame>& frame = frames_[{kind, view.width, view.height, samples}];
    if (frame == nullptr) frame = std::make_unique<Frame>(gl_, kind, view.width, view.height, samples);
    return *frame;
  }

  void begin(const Frame& frame) {
    frame.use();
    gl_.enable(GL_DEPTH_TEST);
    gl_.depthFunc(GL_GREATER);
    gl_.depthMask(GL_TRUE);
    gl_.disable(GL_BLEND);
    constexpr float kFar = 0;
    gl_.clearBufferfv(GL_DEPTH, 0, &kFar);
  }

  ShadowMaps& shadowsOf(int edge) {
    std::unique_ptr<ShadowMaps>& shadows = shadows_[edge];
    if (shadows == nullptr) shadows = std::make_unique<ShadowMaps>(gl_, edge);
    return *shadows;
  }

  void drawBackground(const Scene& scene, const PictureView& view, const LampBlock& block) {
    gl_.clearBufferfv(GL_COLOR, 0, block.background.data());
    const auto& sky = scene.surroundings().sky;
    if (!sky) return;
    const SkyColors colors = skyColors(*sky);
    sky_.use();
    const Eigen::Matrix3f directions = directionFromClip(view).cast<float>();
    gl_.uniformMatrix3fv(shaders::kDirectionFromClip, 1, GL_FALSE, directions.data());
    gl_.uniform3fv(shaders::kZenith, 1, colors.zenith.data());
    gl_.uniform3fv(shaders::kHorizon, 1, colors.horizon.data());
    gl_.uniform4fv(shaders::kClouds, 1, cloudsOf(*sky, scene.time()).data());
    gl_.uniform3fv(shaders::kCloudColor, 1, colors.clouds.data());
    gl_.disable(GL_DEPTH_TEST);
    gl_.disable(GL_CULL_FACE);
    gl_.bindVertexArray(nothing_);
    gl_.drawArrays(GL_TRIANGLES, 0, 3);
    gl_.enable(GL_DEPTH_TEST);
  }

  void drawBillboards(const Scene& scene, const PictureView& view, const Matrix4d& clip) {
    if (billboards_ == nullptr) billboards_ = std::make_unique<Billboards>(gl_);
    gl_.enable(GL_BLEND);
    gl_.blendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl_.depthMask(GL_FALSE);
    gl_.disable(GL_CULL_FACE);
    billboards_->draw(scene.billboards(), view, clip, store_);
  }

  void useMaps(const Item& item) {
    const auto& pictures = item.pictures;
    if (pictures[kColorMap] != nullptr) store_.use(0, pictures[kColorMap], true);
    if (!isMapped(item)) return;
    // unit 1 is taken by the shadow maps
    for (const Map map : {kNormalMap, kRoughnessMap, kMetalnessMap, kGlowMap}) {
      store_.use(static_cast<GLuint>(map) + 1, pictures[map], map == kGlowMap);
    }
    gl_.uniform1i(shaders::kHasNormals, pictures[kNormalMap] != nullptr ? 1 : 0);
  }

  void drawInColors(const Item& item, const Vector3& eye) {
    const Paint& paint = item.paint;
    gl_.uniform4fv(shaders::kDiffuse, 1,
                   Eigen::Vector4f(paint.diffuse.x(), paint.diffuse.y(), paint.diffuse.z(), paint.opacity).data());
    gl_.uniform3fv(shaders::kAmbient, 1, paint.ambient.data());
    gl_.uniform3fv(shaders::kSpecular, 1, paint.specular.data());
    gl_.uniform3fv(shaders::kEmissive, 1, paint.emissive.data());
    gl_.uniform2fv(shaders::kFinish, 1, Eigen::Vector2f(paint.metalness, paint.roughness).data());
    useMaps(item);
    if (paint.opacity < 1) {
      gl_.enable(GL_BLEND);
      gl_.blendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
      gl_.depthMask(GL_FALSE);
    }
    drawSurface(item, eye);
  }

  /// Opaque ones come before what shines through, translucent ones after it.
  void drawMarkersInColors(const Scene& scene, const PictureView& view, const Matrix4d& clip, bool isTranslucent) {
    if (scene.markers().empty()) return;
    markerProgram_.use();
    setMatrix(shaders::kClipFromPlace, clip);
    if (isTranslucent) {
      gl_.enable(GL_BLEND);
      gl_.blendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
      gl_.depthMask(GL_FALSE);
    }
    for (const PlacedMarker& marker : scene.markers()) {
      if ((marker.marker->color.w() < 1) == isTranslucent) drawMarker(marker, view, true);
    }
  }

  /// With the program that is in use; the others than that for markers take no colour.
  void drawMarker(const PlacedMarker& marker, const PictureView& view, bool isInColors) {
    constexpr GLenum kModes[] = {GL_TRIANGLES, GL_LINES, GL_POINTS};
    gl_.disable(GL_CULL_FACE);
    for (const MarkerPart& part : *marker.parts) {
      Eigen::Affine3d X_PlacePart = marker.X_WorldPart(part, view.X_WorldEye.rotation);
      X_PlacePart.translation() -= view.X_WorldEye.position;
      setMatrix(shaders::kPlaceFromSurface, X_PlacePart.matrix());
      if (isInColors) {
        const Eigen::Vector4f& own = marker.marker->color;
        const Eigen::Vector3f color = part.color.value_or(own.head<3>());
        gl_.uniform4fv(shaders::kDiffuse, 1, Eigen::Vector4f(color.x(), color.y(), color.z(), own.w()).data());
      }
      store_.draw(part.surface, kModes[static_cast<std::size_t>(part.kind)]);
    }
  }

  void drawSurface(const Item& item, const Vector3& eye) {
    setMatrix(shaders::kPlaceFromSurface, placeFromSurface(item, eye));
    const Matrix3 normals = item.X_WorldSurface().rotation.toRotationMatrix() * item.scale.cwiseInverse().asDiagonal();
    gl_.uniformMatrix3fv(shaders::kNormalFromSurface, 1, GL_FALSE, Eigen::Matrix3f(normals.cast<float>()).data());
    if (item.paint.isDoubleSided) {
      gl_.disable(GL_CULL_FACE);
    } else {
      gl_.enable(GL_CULL_FACE);
    }
    // the image is upside down, which flips all triangles, as mirroring does
    gl_.frontFace(item.scale.prod() < 0 ? GL_CCW : GL_CW);
    store_.draw(item.surface);
  }

  void setMatrix(int place, const Matrix4d& matrix) {
    gl_.uniformMatrix4fv(place, 1, GL_FALSE, Matrix4f(matrix.cast<float>()).data());
  }

  void setLighting(const LampBlock& block) {
    static_assert(sizeof(LampBlock) == (6 * shaders::kMostLamps + 4 * shaders::kMostShadows + 4) * 4 * sizeof(float));
    gl_.bindBuffer(GL_UNIFORM_BUFFER, lamps_);
    gl_.bufferData(GL_UNIFORM_BUFFER, sizeof(block), &block, GL_STREAM_DRAW);
    gl_.bindBufferBase(GL_UNIFORM_BUFFER, 0, lamps_);
  }

  Gl gl_;
  Store store_;
  /// Keyed by their edges.
  std::map<int, std::unique_ptr<ShadowMaps>> shadows_;
  SurfacePrograms surfaces_;
  Resolve resolve_;
  DepthPass depthPass_;
  /// Created for the first picture of the kind.
  std::unique_ptr<NumberPass> numberPass_;
  std::unique_ptr<TemperaturePass> temperaturePass_;
  std::unique_ptr<Billboards> billboards_;
  std::vector<float> values_;
  Program sky_;
  Program markerProgram_;
  Lines lines_;
  std::map<std::tuple<Frame::Kind, std::uint32_t, std::uint32_t, int>, std::unique_ptr<Frame>> frames_;
  GLuint lamps_ = 0;
  /// An empty vertex array, for geometry made in a shader.
  GLuint nothing_ = 0;
  std::uint64_t version_ = 0;
};

Renderer::Renderer(Contexts contexts) : contexts_(std::move(contexts)) {}

Renderer::~Renderer() { clear(); }

void Renderer::clear() {
  if (content_ == nullptr) return;
  std::optional<Binding> binding;
  try {
    binding.emplace(*contexts_.first);
  } catch (const std::runtime_error&) {
    // a context that is lost has taken along what was in it; without one, OpenGL's functions do nothing
  }
  content_.reset();
}

template <class Draw>
void Renderer::drawNow(const Draw& draw) {
  const Binding binding(*contexts_.first);
  if (content_ == nullptr) {
    content_ = std::make_unique<Content>(*contexts_.first);
    logger().info("pictures are drawn by " + content_->name());
  }
  draw(*content_);
  content_->check();
}

template <class Draw>
void Renderer::draw(const Draw& draw) {
  if (contexts_.spare == nullptr) return drawNow(draw);
  try {
    return drawNow(draw);
  } catch (const NoCard& reason) {
    logger().info(reason.what());
  } catch (const std::runtime_error& reason) {
    logger().warning("pictures are drawn in software from now on: " + std::string(reason.what()));
  }
  clear();
  contexts_.first = std::move(contexts_.spare);
  drawNow(draw);
}

void Renderer::drawColors(const Scene& scene, const PictureView& view, std::span<std::uint8_t> pixels) {
  draw([&](Content& content) { content.drawColors(scene, view, pixels); });
}

void Renderer::drawDepths(const Scene& scene, const PictureView& view, std::span<float> depths) {
  draw([&](Content& content) { content.drawDepths(scene, view, depths); });
}

void Renderer::drawNumbers(const Scene& scene, const PictureView& view, std::span<std::uint32_t> numbers) {
  draw([&](Content& content) { content.drawNumbers(scene, view, numbers); });
}

void Renderer::drawTemperatures(const Scene& scene, const PictureView& view, const AirTemperatures& air,
                                std::span<float> temperatures) {
  draw([&](Content& content) { content.drawTemperatures(scene, view, air, temperatures); });
}

}  // namespace pongsim::rendering
