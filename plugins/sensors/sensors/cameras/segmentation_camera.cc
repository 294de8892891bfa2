#include "segmentation_camera.hh"

#include <algorithm>

#include "sample_folder.hh"

namespace pongsim {

namespace {

constexpr const char* kColoredMaps = "colored_maps";
constexpr const char* kLabelMaps = "labels_maps";

}  // namespace

SegmentationCamera::SegmentationCamera(const SensorContext& context, CameraSurroundings& surroundings)
    : CameraOf(context, surroundings, CameraBody::InfoPlace::kBelow),
      topic_(context.topic),
      labels_(context.advertise(kLabels)) {
  for (ignition::msgs::Image* image : {&message(), &labelImage_}) {
    beginImage(body_.settings().width, body_.settings().height, ignition::msgs::RGB_INT8, 3, *image);
  }
  if (body_.saves()) body_.beginSavingAt(filesIn(std::filesystem::path(body_.settings().savePath) / kSampleImages));
}

void SegmentationCamera::measure() {
  if (!topic_.hasSubscribers() && !labels_.hasSubscribers() && !body_.saves()) return;
  numbers_.resize(body_.pixelCount());
  CameraScene& scene = body_.scene();
  scene.drawNumbers(body_.view(), numbers_);
  looks_ = labelLooks(scene.visuals(), body_.settings().segmentation);
  looks_.insert(looks_.begin(), LabelLook());
}

void SegmentationCamera::write(LabelColor LabelLook::*map, std::span<std::uint8_t> to) const {
  // a new subscriber gets the previous image, or a black one
  if (numbers_.empty()) {
    std::ranges::fill(to, std::uint8_t{0});
    return;
  }
  auto place = to.begin();
  for (const std::uint32_t number : numbers_) place = std::ranges::copy(looks_[number].*map, place).out;
}

Bulk SegmentationCamera::bulkOf(LabelColor LabelLook::*map) const {
  return {.size = 3 * body_.pixelCount(), .write = [this, map](std::span<std::byte> to) {
            write(map, {reinterpret_cast<std::uint8_t*>(to.data()), to.size()});
          }};
}

std::optional<Bulk> SegmentationCamera::bulk() { return bulkOf(&LabelLook::color); }

void SegmentationCamera::publishElsewhere() {
  body_.publishInfo(message().header());
  if (labels_.hasSubscribers()) {
    *labelImage_.mutable_header() = message().header();
    labels_.publish(labelImage_, bulkOf(&LabelLook::code));
  }
  body_.save([this](const std::filesystem::path& folder, std::uint64_t number) { save(folder, number); });
}

void SegmentationCamera::save(const std::filesystem::path& folder, std::uint64_t number) {
  std::vector<std::uint8_t> pixels(3 * body_.pixelCount());
  const auto write = [&](const char* subfolder, const char* kind) {
    CameraScene::writePicture(sampleFile(folder / subfolder, kind, number, ".png"), body_.settings().width,
                              body_.settings().height, pixels);
  };
  body_.scene().drawColors(body_.view(), pixels);
  write(kSampleImages, "image");
  this->write(&LabelLook::color, pixels);
  write(kColoredMaps, "colored");
  this->write(&LabelLook::code, pixels);
  write(kLabelMaps, "labels");
}

}  // namespace pongsim
