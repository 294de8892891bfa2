#include "sdf/readers/sensors/camera_reader.hh"
#include "sdf/includes/includes.hh"

#include <array>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string_view>

#include "sdf/readers/sensors/noise_reader.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

namespace {

// what is too large to draw is a warning of the system that draws it
constexpr long long kLongestEdge = std::numeric_limits<std::int32_t>::max();

PixelFormat readFormat(const Element& image, Context& context) {
  using enum PixelFormat;
  // the names in the format, and those that libsdformat writes for the same
  constexpr std::array<std::string_view, 14> kNames{
      "L8",          "L16",         "R8G8B8",      "B8G8R8", "R_FLOAT16", "R_FLOAT32", "BAYER_RGGB8",
      "BAYER_BGGR8", "BAYER_GBRG8", "BAYER_GRBG8", "L_INT8", "L_INT16",   "RGB_INT8",  "BGR_INT8"};
  constexpr std::array kFormats{kL8,         kL16,        kR8G8B8,     kB8G8R8, kRFloat16, kRFloat32, kBayerRggb8,
                                kBayerBggr8, kBayerGbrg8, kBayerGrbg8, kL8,     kL16,      kR8G8B8,   kB8G8R8};
  static_assert(kNames.size() == kFormats.size());
  return kFormats[readWord(image, "format", 2, kNames, context)];
}

void readImage(const Element& image, CameraSettings& camera, Context& context) {
  const auto readCount = [&](std::string_view child, std::uint32_t fallback, long long least, long long most) {
    return static_cast<std::uint32_t>(readInteger(image, child, fallback, least, most, context));
  };
  camera.width = readCount("width", camera.width, 1, kLongestEdge);
  camera.height = readCount("height", camera.height, 1, kLongestEdge);
  camera.antiAliasing = readCount("anti_aliasing", camera.antiAliasing, 0, 64);
  camera.format = readFormat(image, context);
}

/// @param label "sensor 's'"
ClipSettings readClip(const Element& element, ClipSettings clip, const std::string& label, Context& context) {
  clip.near = readNotNegative(element, "near", clip.near, context);
  clip.far = readLimit(element, "far", clip.far, context);
  if (!(clip.near < clip.far)) {
    context.diagnostics.error(element.position, label + " sees nothing: <near> must be below <far>");
  }
  return clip;
}

DistortionSettings readDistortion(const Element& element, Context& context) {
  DistortionSettings distortion;
  distortion.k1 = readNumber(element, "k1", distortion.k1, context);
  distortion.k2 = readNumber(element, "k2", distortion.k2, context);
  distortion.k3 = readNumber(element, "k3", distortion.k3, context);
  distortion.p1 = readNumber(element, "p1", distortion.p1, context);
  distortion.p2 = readNumber(element, "p2", distortion.p2, context);
  distortion.center = readVector2(element, "center", distortion.center, context);
  return distortion;
}

LensSettings::Custom readCustomFunction(const Element& element, Context& context) {
  using enum LensSettings::Function;
  constexpr std::array<std::string_view, 3> kNames{"sin", "tan", "id"};
  constexpr std::array kFunctions{kSin, kTan, kId};
  LensSettings::Custom custom;
  custom.c1 = readNumber(element, "c1", custom.c1, context);
  custom.c2 = readNumber(element, "c2", custom.c2, context);
  custom.c3 = readNumber(element, "c3", custom.c3, context);
  custom.f = readNumber(element, "f", custom.f, context);
  custom.function = kFunctions[readWord(element, "fun", 1, kNames, context)];
  return custom;
}

LensSettings::Intrinsics readIntrinsics(const Element& element, Context& context) {
  LensSettings::Intrinsics intrinsics;
  intrinsics.fx = readPositive(element, "fx", intrinsics.fx, context);
  intrinsics.fy = readPositive(element, "fy", intrinsics.fy, context);
  intrinsics.cx = readNumber(element, "cx", intrinsics.cx, context);
  intrinsics.cy = readNumber(element, "cy", intrinsics.cy, context);
  intrinsics.skew = readNumber(element, "s", intrinsics.skew, context);
  return intrinsics;
}

LensSettings::Projection readProjection(const Element& element, Context& context) {
  LensSettings::Projection projection;
  projection.fx = readPositive(element, "p_fx", projection.fx, context);
  projection.fy = readPositive(element, "p_fy", projection.fy, context);
  projection.cx = readNumber(element, "p_cx", projection.cx, context);
  projection.cy = readNumber(element, "p_cy", projection.cy, context);
  projection.tx = readNumber(element, "tx", projection.tx, context);
  projection.ty = readNumber(element, "ty", projection.ty, context);
  return projection;
}

LensSettings readLens(const Element& element, Context& context) {
  using enum LensSettings::Type;
  constexpr std::array<std::string_view, 6> kNames{"gnomonical",      "stereographic", "equidistant",
                                                   "equisolid_angle", "orthographic",  "custom"};
  constexpr std::array kTypes{kGnomonical, kStereographic, kEquidistant, kEquisolidAngle, kOrthographic, kCustom};
  LensSettings lens;
  lens.type = kTypes[readWord(element, "type", 1, kNames, context)];
  lens.scalesToHorizontalFov = readFlag(element, "scale_to_hfov", lens.scalesToHorizontalFov, context);
  if (const Element* custom = element.child("custom_function")) lens.custom = readCustomFunction(*custom, context);
  lens.cutoffAngle = readNumber(element, "cutoff_angle", lens.cutoffAngle, context);
  lens.environmentTextureSize =
      readInteger(element, "env_texture_size", lens.environmentTextureSize, 1, kLongestEdge, context);
  if (const Element* intrinsics = element.child("intrinsics")) lens.intrinsics = readIntrinsics(*intrinsics, context);
  if (const Element* projection = element.child("projection")) lens.projection = readProjection(*projection, context);
  return lens;
}

void readSave(const Element& element, CameraSettings& camera, Context& context) {
  camera.savesPictures = readFlagAttribute(element, "enabled", false, context);
  camera.savePath = readText(element, "path", "");
  if (!camera.savesPictures || context.includes.mayWrite(context.folder)) return;
  context.diagnostics.warning(element.position,
                              "no images are saved: models that are inserted or downloaded write no files",
                              "put the camera into the world that the run starts with");
  camera.savesPictures = false;
}

void readDepth(const Element& element, const std::string& label, CameraSettings& camera, Context& context) {
  constexpr ClipSettings kClip{.near = 0.1, .far = 10};
  camera.depthOutput = readText(element, "output", camera.depthOutput);
  if (const Element* clip = element.child("clip")) camera.depthClip = readClip(*clip, kClip, label, context);
}

void readPurposes(const Element& element, CameraSettings& camera, Context& context) {
  using enum CameraSettings::Segmentation;
  using enum CameraSettings::Boxes;
  constexpr std::array<std::string_view, 3> kSegmentations{"semantic", "panoptic", "instance"};
  constexpr std::array kSegmentationOfName{kSemantic, kPanoptic, kPanoptic};
  constexpr std::array<std::string_view, 6> kBoxes{"2d",      "visible_2d",  "visible_box_2d",
                                                   "full_2d", "full_box_2d", "3d"};
  constexpr std::array kBoxOfName{kVisible2d, kVisible2d, kVisible2d, kFull2d, kFull2d, k3d};
  camera.segmentation = kSegmentationOfName[readWord(element, "segmentation_type", 0, kSegmentations, context)];
  camera.boxes = kBoxOfName[readWord(element, "box_type", 0, kBoxes, context)];
}

}  // namespace

CameraSettings readCamera(const Element* element, const std::string& label, Context& context) {
  CameraSettings camera;
  if (element == nullptr) return camera;
  camera.name = element->attributeOr("name", "");
  camera.horizontalFov = readPositive(*element, "horizontal_fov", camera.horizontalFov, context);
  if (camera.horizontalFov > 2 * std::numbers::pi) {
    context.diagnostics.error(element->child("horizontal_fov")->position,
                              "the field of view of " + label + " is more than 2 pi");
  }
  if (const Element* image = element->child("image")) readImage(*image, camera, context);
  if (const Element* clip = element->child("clip")) camera.clip = readClip(*clip, camera.clip, label, context);
  if (const Element* depth = element->child("depth_camera")) readDepth(*depth, label, camera, context);
  if (const Element* distortion = element->child("distortion")) {
    camera.distortion = readDistortion(*distortion, context);
  }
  if (const Element* lens = element->child("lens")) camera.lens = readLens(*lens, context);
  camera.noise = readNoiseIn(element, NoiseSettings::Type::kGaussian, context);
  if (camera.noise.type == NoiseSettings::Type::kGaussianQuantized) {
    context.diagnostics.warning(element->child("noise")->position,
                                "the noise of " + label + " has no effect: its type is gaussian_quantized",
                                "as in Fortress, cameras support gaussian noise only");
  }
  camera.visibilityMask = readUnsigned(*element, "visibility_mask", camera.visibilityMask, context);
  camera.isTriggered = readFlag(*element, "triggered", camera.isTriggered, context);
  camera.triggerTopic = readText(*element, "trigger_topic", "");
  camera.infoTopic = readText(*element, "camera_info_topic", "");
  camera.opticalFrame = readText(*element, "optical_frame_id", "");
  if (const Element* save = element->child("save")) readSave(*save, camera, context);
  readPurposes(*element, camera, context);
  return camera;
}

}  // namespace pongsim::sdf
