#include "box_camera.hh"

#include <algorithm>
#include <fstream>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "edges.hh"
#include "pongsim/messages/fields.hh"
#include "sample_folder.hh"

namespace pongsim {

namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

// as in Fortress, whose cameras for boxes take this label for that of unlabelled things
constexpr std::uint8_t kUnlabelled = 255;
constexpr const char* kBoxes = "boxes";

/// @return Numbers in one line, with six decimals, behind a label.
std::string rowOf(std::uint8_t label, std::initializer_list<double> numbers) {
  std::string row = std::to_string(label);
  for (const double number : numbers) row += "," + std::to_string(number);
  return row + "\n";
}

std::string tableOf(std::span<const ImageBox> boxes) {
  std::string table = "label,x_center,y_center,width,height\n";
  for (const auto& [label, box] : boxes) {
    table += rowOf(label, {box.center().x(), box.center().y(), box.sizes().x(), box.sizes().y()});
  }
  return table;
}

std::string tableOf(std::span<const SpaceBox> boxes) {
  std::string table = "label,x,y,z,w,h,l,roll,pitch,yaw\n";
  for (const auto& [label, box] : boxes) {
    const Vector3 &place = box.pose.position, &size = box.size, angles = rollPitchYawOf(box.pose.rotation);
    table += rowOf(label,
                   {place.x(), place.y(), place.z(), size.x(), size.y(), size.z(), angles.x(), angles.y(), angles.z()});
  }
  return table;
}

/// @return The rotation from a camera's frame, with x ahead and z up, to that of renderers.
Quaternion toRenderersFrame() {
  Matrix3 axes;
  axes << 0, -1, 0,  //
      0, 0, 1,       //
      -1, 0, 0;
  return Quaternion(axes);
}

}  // namespace

BoxView::BoxView(const SensorContext& context, CameraBody& body)
    : body_(body), topic_(context.topic), images_(context.advertise(SensorReadings::kImage)) {
  beginImage(body_.settings().width, body_.settings().height, ignition::msgs::RGB_INT8, 3, image_);
  if (body_.saves()) body_.beginSavingAt(filesIn(std::filesystem::path(body_.settings().savePath) / kSampleImages));
}

std::vector<BoxView::Group> BoxView::groups() {
  numbers_.resize(body_.pixelCount());
  CameraScene& scene = body_.scene();
  scene.drawNumbers(body_.view(), numbers_);
  // of each visual, where it is seen
  std::vector<AlignedBox2d> seen(scene.visuals().size());
  const std::uint32_t width = body_.settings().width;
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    if (numbers_[i] == 0) continue;
    seen[numbers_[i] - 1].extend(Vector2d(static_cast<double>(i % width), static_cast<double>(i / width)));
  }
  std::map<std::pair<std::string, std::uint8_t>, Group, std::greater<>> found;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const SeenVisual& visual = scene.visuals()[i];
    const std::uint8_t label = visual.label.value_or(kUnlabelled);
    if (seen[i].isEmpty() || label == kUnlabelled) continue;
    Group& group = found[{visual.owner, label}];
    group.label = label;
    group.visuals.push_back(i);
    group.pixels.extend(seen[i]);
  }
  std::vector<Group> groups;
  for (auto& [owner, group] : found) groups.push_back(std::move(group));
  return groups;
}

void BoxView::draw() {
  pixels_.resize(3 * body_.pixelCount());
  body_.scene().drawColors(body_.view(), pixels_);
}

void BoxView::publish(const ignition::msgs::Header& header, std::span<const Vector2d> edges) {
  body_.publishInfo(header);
  if (!images_.hasSubscribers()) return;
  draw();
  drawEdges(edges, body_.settings().width, body_.settings().height, pixels_);
  *image_.mutable_header() = header;
  images_.publish(image_, {.size = pixels_.size(), .write = [this](std::span<std::byte> to) {
                             std::ranges::copy(std::as_bytes(std::span(pixels_)), to.begin());
                           }});
}

void BoxView::save(const std::string& table) {
  body_.save([&](const std::filesystem::path& folder, std::uint64_t number) {
    draw();
    CameraScene::writePicture(sampleFile(folder / kSampleImages, "image", number, ".png"), body_.settings().width,
                              body_.settings().height, pixels_);
    const std::filesystem::path file = sampleFile(folder / kBoxes, "boxes", number, ".csv");
    std::ofstream stream(file);
    stream << table;
    stream.close();
    if (!stream) throw std::runtime_error("'" + file.string() + "' can't be written");
  });
}

ImageBoxCamera::ImageBoxCamera(const SensorContext& context, CameraSurroundings& surroundings)
    : CameraOf(context, surroundings, CameraBody::InfoPlace::kBeside), view_(context, body_) {}

void ImageBoxCamera::measure() {
  boxes_.clear();
  message().clear_annotated_box();
  if (!view_.isWanted()) return;
  const bool isFull = body_.settings().boxes == CameraSettings::Boxes::kFull2d;
  const PictureView eye = body_.view();
  const AlignedBox2d image(Vector2d::Zero(), Vector2d(eye.width - 1.0, eye.height - 1.0));
  for (const BoxView::Group& group : view_.groups()) {
    AlignedBox2d box = group.pixels;
    if (isFull) {
      box.setEmpty();
      for (const std::size_t visual : group.visuals) box.extend(body_.scene().imageBounds(visual, eye));
      // of what is seen in the last column only, nothing is before it
      box = {box.min().cwiseMax(image.min()).cwiseMin(image.max()), box.max().cwiseMin(image.max())};
    }
    boxes_.push_back({group.label, box});
  }
  for (const auto& [label, box] : boxes_) {
    auto& added = *message().add_annotated_box();
    added.set_label(label);
    added.mutable_box()->mutable_min_corner()->set_x(box.min().x());
    added.mutable_box()->mutable_min_corner()->set_y(box.min().y());
    added.mutable_box()->mutable_max_corner()->set_x(box.max().x());
    added.mutable_box()->mutable_max_corner()->set_y(box.max().y());
  }
}

void ImageBoxCamera::publishElsewhere() {
  std::vector<Vector2d> edges;
  for (const ImageBox& each : boxes_) addEdges(each.box, edges);
  view_.publish(message().header(), edges);
  if (body_.saves()) view_.save(tableOf(boxes_));
}

SpaceBoxCamera::SpaceBoxCamera(const SensorContext& context, CameraSurroundings& surroundings)
    : CameraOf(context, surroundings, CameraBody::InfoPlace::kBeside), view_(context, body_) {}

void SpaceBoxCamera::measure() {
  boxes_.clear();
  message().clear_annotated_box();
  if (!view_.isWanted()) return;
  const Pose X_RendererWorld = Pose{Vector3::Zero(), toRenderersFrame()} * body_.view().X_WorldEye.inverse();
  for (const BoxView::Group& group : view_.groups()) {
    TurnedBox box = body_.scene().turnedBox(group.visuals);
    box.pose = X_RendererWorld * box.pose;
    boxes_.push_back({group.label, box});
    auto& added = *message().add_annotated_box();
    added.set_label(group.label);
    setVector(box.pose.position, *added.mutable_box()->mutable_center());
    setVector(box.size, *added.mutable_box()->mutable_boxsize());
    setRotation(box.pose.rotation, *added.mutable_box()->mutable_orientation());
  }
}

void SpaceBoxCamera::publishElsewhere() {
  std::vector<Vector2d> edges;
  for (const SpaceBox& each : boxes_) addEdges(each.box, body_.view(), edges);
  view_.publish(message().header(), edges);
  if (body_.saves()) view_.save(tableOf(boxes_));
}

}  // namespace pongsim
