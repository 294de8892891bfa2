#include "rendering/renderer.hh"

#include <GL/glcorearb.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "assets/images/picture_file.hh"
#include "pongsim/program/log_sink.hh"
#include "rendering/egl.hh"
#include "rendering/osmesa.hh"
#include "support/rendering/drawn_world.hh"
#include "support/temp_folder.hh"

namespace pongsim::rendering {
namespace {

using test::DrawnWorld;
using test::view;

std::unique_ptr<Context> openEgl() { return eglContext(loadEgl(), EglDevices::kAll); }

/// What is drawn with all programs: lamps of three kinds with shadows, maps, fog, clouds, a transparent thing,
/// temperatures.
class EverythingDrawn : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      openOsmesa();
      const std::unique_ptr<Context> egl = openEgl();
      const Binding binding(*egl);
    } catch (const std::runtime_error& error) {
      GTEST_SKIP() << error.what();
    }
    addLamps();
    addThings();
    world_.description().scene.sky.emplace();
    world_.description().scene.fog = description::Fog{.type = description::Fog::Type::kLinear, .density = 0.5};
    world_.start();
    ASSERT_TRUE(world_.warnings().empty());
    eye_.X_WorldEye = {{-5, -2, 3}, fromRollPitchYaw(0, 0.4, 0.4)};
  }

  /// @return A picture with waves of a length of a sixth of it, of different colours.
  description::Texture waves(const std::string& name) {
    constexpr std::uint32_t kSide = 64;
    std::vector<std::uint8_t> pixels;
    for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
      for (const double phase : {0.0, 1.0, 2.0}) {
        const double wave = std::sin(0.6 * (i % kSide) + phase) * std::cos(0.6 * (i / kSide));
        pixels.push_back(static_cast<std::uint8_t>(std::lround(160 + 80 * wave)));
      }
    }
    const auto file = folder_.path() / name;
    EXPECT_FALSE(assets::writePicture(file, kSide, kSide, pixels));
    return {file.string(), file};
  }

  void addLamps() {
    using enum description::LightType;
    for (const auto type : {kDirectional, kSpot, kPoint}) {
      description::Light& light = world_.description().lights.emplace_back();
      light.name = "lamp" + std::to_string(world_.description().lights.size());
      light.type = type;
      light.castsShadows = true;
      light.X_ParentLight.position = {1, -2, 4};
      light.direction = Vector3(0.3, 0.2, -1).normalized();
      light.diffuse = {0.5F, 0.4F, 0.3F, 1};
      light.specular = {0.3F, 0.3F, 0.3F, 1};
      light.linearAttenuation = 0.05;
      light.outerAngle = 1;
      light.innerAngle = 0.6;
      light.falloff = 1;
    }
  }

  description::Material& add(const description::Geometry& geometry, const Vector3& place) {
    description::Visual& visual = world_.add(geometry, {place, fromRollPitchYaw(0.1, 0.2, 0.7)});
    visual.material.emplace();
    visual.material->diffuse = visual.material->ambient = {0.7F, 0.5F, 0.4F, 1};
    visual.material->specular = {0.5F, 0.5F, 0.5F, 1};
    return *visual.material;
  }

  void addThings() {
    world_.add(description::Plane{Vector3::UnitZ(), {20, 20}}).material.emplace().diffuse = {0.6F, 0.6F, 0.6F, 1};
    add(description::Box{{1, 1, 1}}, {0, 0, 0.7});
    auto& shiny = add(description::Sphere{0.6}, {0, 2, 0.8}).metal.emplace();
    shiny.metalness = 0.8;
    shiny.roughness = 0.3;
    add(description::Cylinder{0.4, 1.6}, {2, 1, 0.9}).diffuse.alpha = 0.5F;
    auto& painted = add(description::Box{{1, 1, 1}}, {1, -1.5, 0.7}).metal.emplace();
    painted.maps.albedo = waves("colors.png");
    auto& mapped = add(description::Capsule{0.4, 0.8}, {-1, -1, 0.7}).metal.emplace();
    mapped.maps.normal = waves("normals.png");
    mapped.maps.emissive = mapped.roughnessMap = mapped.metalnessMap = waves("maps.png");
    add(description::Cone{0.5, 1}, {-1, 1.5, 0.6}).isLit = false;
  }

  struct Drawn {
    std::vector<std::uint8_t> smooth, coarse, large;
    std::vector<float> depths;
    std::vector<std::uint32_t> numbers;
    std::vector<float> temperatures;
  };
  Drawn draw(Contexts contexts) {
    world_.drawWith(std::move(contexts));
    Drawn drawn;
    drawn.smooth = world_.colors(eye_);
    PictureView coarse = eye_;
    coarse.antiAliasing = 1;
    drawn.coarse = world_.colors(coarse);
    // for the pixels of a line each OpenGL has its own rule
    coarse.showsGrid = coarse.showsAxes = true;
    world_.colors(coarse);
    // with finer shadows
    PictureView large = view(640, 480, 500);
    large.X_WorldEye = eye_.X_WorldEye;
    drawn.large = world_.colors(large);
    drawn.depths = world_.depths(eye_);
    drawn.numbers = world_.numbers(eye_);
    drawn.temperatures = world_.temperatures(eye_, {270, 290});
    return drawn;
  }

  pongsim::test::TempFolder folder_;
  DrawnWorld world_;
  PictureView eye_ = view(320, 240, 250);
};

/// @param apart How far two values are apart, in what is allowed.
/// @return Share of the pixels' values that are farther apart.
template <class Value, class Apart>
double shareApart(const std::vector<Value>& a, const std::vector<Value>& b, const Apart& apart) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    // also if one of them alone is infinite
    if (a[i] != b[i] && !(apart(static_cast<double>(a[i]), static_cast<double>(b[i])) <= 1)) ++count;
  }
  return a.size() == b.size() ? static_cast<double>(count) / static_cast<double>(a.size()) : 1;
}

TEST_F(EverythingDrawn, LooksTheSameBySoftwareAndByEgl) {
  const Drawn software = draw({openOsmesa()}), egl = draw({openEgl()});
  // the tolerance in docs/sensors.md, which leaves edges out
  constexpr double kEdges = 0.01;
  const auto byColor = [](double a, double b) { return std::abs(a - b) / 4; };
  EXPECT_LE(shareApart(software.smooth, egl.smooth, byColor), kEdges);
  EXPECT_LE(shareApart(software.coarse, egl.coarse, byColor), kEdges);
  EXPECT_LE(shareApart(software.large, egl.large, byColor), kEdges);
  const auto byDepth = [](double a, double b) { return std::abs(a - b) / (0.002 * a); };
  EXPECT_LE(shareApart(software.depths, egl.depths, byDepth), kEdges);
  EXPECT_LE(shareApart(software.numbers, egl.numbers, [](double, double) { return 2; }), kEdges);
  const auto byTemperature = [](double a, double b) { return std::abs(a - b) / 0.1; };
  EXPECT_LE(shareApart(software.temperatures, egl.temperatures, byTemperature), kEdges);
}

/// Passes everything on, and may change it.
class Changed : public Context {
 public:
  explicit Changed(std::unique_ptr<Context> context) : context_(std::move(context)) {}
  void bind() override { context_->bind(); }
  void release() override { context_->release(); }
  Function function(const char* name) const override { return context_->function(name); }

 private:
  std::unique_ptr<Context> context_;
};

/// Notes what OpenGL reports of errors and of what is undefined (KHR_debug).
class Watched final : public Changed {
 public:
  Watched(std::unique_ptr<Context> context, std::vector<std::string>& reports)
      : Changed(std::move(context)), reports_(reports) {}

  void bind() override {
    Changed::bind();
    const auto enable = reinterpret_cast<PFNGLENABLEPROC>(function("glEnable"));
    enable(GL_DEBUG_OUTPUT);
    enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    reinterpret_cast<PFNGLDEBUGMESSAGECALLBACKPROC>(function("glDebugMessageCallback"))(&note, &reports_);
  }
  void release() override {
    // so that it is known that errors are noted
    const std::size_t before = reports_.size();
    reinterpret_cast<PFNGLENABLEPROC>(function("glEnable"))(GL_RGBA);
    EXPECT_EQ(reports_.size(), before + 1);
    reports_.resize(before);
    reinterpret_cast<PFNGLGETERRORPROC>(function("glGetError"))();
    Changed::release();
  }

 private:
  static void note(GLenum, GLenum type, GLuint, GLenum severity, GLsizei length, const GLchar* text, const void* data) {
    const bool isWrong = type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR ||
                         type == GL_DEBUG_TYPE_DEPRECATED_BEHAVIOR || type == GL_DEBUG_TYPE_PORTABILITY;
    if (!isWrong && severity != GL_DEBUG_SEVERITY_HIGH) return;
    auto& reports = *static_cast<std::vector<std::string>*>(const_cast<void*>(data));
    reports.emplace_back(text, static_cast<std::size_t>(length));
  }

  std::vector<std::string>& reports_;
};

TEST_F(EverythingDrawn, IsDrawnAsOpenGlAllows) {
  for (const bool isEgl : {false, true}) {
    std::vector<std::string> reports;
    draw({std::make_unique<Watched>(isEgl ? openEgl() : openOsmesa(), reports)});
    // what is deleted, too
    world_.drawWith({openOsmesa()});
    EXPECT_EQ(reports, std::vector<std::string>()) << (isEgl ? "EGL" : "OSMesa");
  }
}

/// A card that can draw a number of pictures.
class FailingCard final : public Changed {
 public:
  FailingCard(std::unique_ptr<Context> context, int pictures) : Changed(std::move(context)), pictures_(pictures) {}
  void bind() override {
    if (pictures_-- <= 0) throw std::runtime_error("graphics card 1 can't be used any more");
    Changed::bind();
  }

 private:
  int pictures_;
};

/// A card without memory left.
class FullCard final : public Changed {
 public:
  using Changed::Changed;
  Function function(const char* name) const override {
    if (name != std::string_view("glGetError")) return Changed::function(name);
    return reinterpret_cast<Function>(&error);
  }

 private:
  static GLenum error() { return GL_OUT_OF_MEMORY; }
};

class NoCardAtAll final : public Context {
 public:
  void bind() override { throw NoCard("there is no graphics card"); }
  void release() override {}
  Function function(const char*) const override { return nullptr; }
};

TEST_F(EverythingDrawn, GoesOnInSoftwareWhereACardFails) {
  world_.drawWith({openOsmesa()});
  const auto expected = world_.colors(eye_);
  std::vector<std::string> heard;
  const LogSink sink(LogLevel::kInfo, [&heard](const LogRecord& record) {
    heard.push_back(std::to_string(static_cast<int>(record.level)) + ' ' +
                    std::string(record.message.substr(0, record.message.find(" (LLVM"))));
  });
  const std::string software = "3 pictures are drawn by llvmpipe",
                    said = "2 pictures are drawn in software from now on: ";
  const auto drawTwice = [&](std::unique_ptr<Context> card) {
    heard.clear();
    world_.drawWith({std::move(card), openOsmesa()});
    EXPECT_EQ(world_.colors(eye_), expected);
    EXPECT_EQ(world_.colors(eye_), expected);
    return heard;
  };
  using Lines = std::vector<std::string>;
  EXPECT_EQ(drawTwice(std::make_unique<NoCardAtAll>()), (Lines{"3 there is no graphics card", software}));
  EXPECT_EQ(drawTwice(std::make_unique<FailingCard>(openOsmesa(), 0)),
            (Lines{said + "graphics card 1 can't be used any more", software}));
  EXPECT_EQ(drawTwice(std::make_unique<FailingCard>(openOsmesa(), 1)),
            (Lines{software, said + "graphics card 1 can't be used any more", software}));
  EXPECT_EQ(drawTwice(std::make_unique<FullCard>(openOsmesa())),
            (Lines{software, said + "OpenGL has no memory left", software}));
}

TEST_F(EverythingDrawn, IsAnErrorWhereACardFailsAndNothingElseWasChosen) {
  world_.drawWith({std::make_unique<FullCard>(openOsmesa())});
  EXPECT_THROW(world_.colors(eye_), std::runtime_error);
}

}  // namespace
}  // namespace pongsim::rendering
