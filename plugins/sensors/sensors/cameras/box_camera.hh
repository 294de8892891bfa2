#pragma once

#include <ignition/msgs/annotated_axis_aligned_2d_box_v.pb.h>
#include <ignition/msgs/annotated_oriented_3d_box_v.pb.h>
#include <ignition/msgs/image.pb.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "camera_body.hh"
#include "pongsim/node.hh"
#include "pongsim/sensing/sensor_system.hh"

namespace pongsim {

/// A labelled box in an image [pixels, from the left and the top].
struct ImageBox {
  std::uint8_t label = 0;
  Eigen::AlignedBox2d box;
};

/// A labelled box in the camera's frame as renderers have it: x to the right, y up, z backwards.
struct SpaceBox {
  std::uint8_t label = 0;
  TurnedBox box;
};

/// What bounding-box cameras have in common: which visuals belong together and are seen, the image, and saved samples.
class BoxView {
 public:
  /// The visuals of one model or actor with one label, as indices in `CameraScene::visuals`, all of which are at least
  /// partly seen.
  struct Group {
    std::uint8_t label = 0;
    std::vector<std::size_t> visuals;
    /// Around the pixels in which they are seen: from the first to the last column and row.
    Eigen::AlignedBox2d pixels;
  };

  /// @param body Must outlive it.
  BoxView(const SensorContext& context, CameraBody& body);

  /// @return Whether anybody wants boxes or the image.
  bool isWanted() const { return topic_.hasSubscribers() || images_.hasSubscribers() || body_.saves(); }
  bool isHeardElsewhere() const { return body_.isInfoHeard() || images_.hasSubscribers() || body_.saves(); }

  /// @return What is seen now, in descending order of the owners' names, as in Fortress.
  std::vector<Group> groups();

  /// Publishes `camera_info` and the image with edges drawn into it.
  /// @param edges Two ends for each, in pixels.
  void publish(const ignition::msgs::Header& header, std::span<const Eigen::Vector2d> edges);
  /// Saves the image without edges, and the boxes.
  /// @param table Comma-separated values.
  void save(const std::string& table);

 private:
  void draw();

  CameraBody& body_;
  const SensorTopic& topic_;
  Publisher images_;
  ignition::msgs::Image image_;
  std::vector<std::uint32_t> numbers_;
  std::vector<std::uint8_t> pixels_;
};

/// A camera that says where in its image labelled things are: around what is seen of them, or around all of them.
class ImageBoxCamera final : public CameraOf<ignition::msgs::AnnotatedAxisAligned2DBox_V> {
 public:
  /// @throws Error if its settings are not supported, or it has too many pixels.
  ImageBoxCamera(const SensorContext& context, CameraSurroundings& surroundings);

  void measure() override;
  bool isHeardElsewhere() const override { return view_.isHeardElsewhere(); }
  void publishElsewhere() override;

 private:
  BoxView view_;
  std::vector<ImageBox> boxes_;
};

/// A camera that says where in space labelled things are, and how they are turned.
class SpaceBoxCamera final : public CameraOf<ignition::msgs::AnnotatedOriented3DBox_V> {
 public:
  /// @throws Error if its settings are not supported, or it has too many pixels.
  SpaceBoxCamera(const SensorContext& context, CameraSurroundings& surroundings);

  void measure() override;
  bool isHeardElsewhere() const override { return view_.isHeardElsewhere(); }
  void publishElsewhere() override;

 private:
  BoxView view_;
  std::vector<SpaceBox> boxes_;
};

}  // namespace pongsim
