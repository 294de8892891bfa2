#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/laserscan.pb.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "occupancy_grid.hh"
#include "pongsim/math.hh"
#include "pongsim/messages/fields.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Beams of a scan beyond these are ignored.
constexpr int kMostBeams = 100'000;

/// Maps a world with a lidar that it moves to where most is unknown.
class FreeSpaceExplorer : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Maps a world with a planar lidar, by moving its model to where most is unknown.",
                   Declaration::Place::kModel);
    declaration.parameter("lidar_topic", &scanTopic_, "", "topic of the scans");
    declaration.parameter("image_topic", &imageTopic_, "", "topic of the map");
    declaration.parameter("start_topic", &startTopic_, "", "topic that starts it");
    declaration.parameter("sensor_link", &linkName_, "", "link of the lidar, whose origin is the lidar's");
    declaration.parameter("width", &width_, "", "columns of the map").atLeast(1);
    declaration.parameter("height", &height_, "", "rows of the map").atLeast(1);
    declaration.parameter("resolution", &resolution_, "m", "side length of a cell").above(0);
    declaration.subscribes("<lidar_topic>", "ignition.msgs.LaserScan", "the scans");
    declaration.subscribes("<start_topic>", "ignition.msgs.Boolean", "`true` starts it");
    declaration.publishes("<image_topic>", "ignition.msgs.Image",
                          "the map after each scan: free cells white, occupied ones black, others grey");
  }

  void configure(const SystemContext& context) override {
    log_ = &context.log;
    model_ = context.model;
    link_ = model_->link(linkName_);
    if (!link_) {
      const Element* element = context.sdf.child("sensor_link");
      refuse(element != nullptr ? *element : context.sdf,
             "<sensor_link> '" + linkName_ + "' is not a link of model '" + std::string(model_->name()) + "'");
    }
    if (static_cast<double>(width_) * height_ > OccupancyGrid::kMostCells) {
      refuse(context.sdf, "the map has more than a million cells");
    }
    clear();
    scans_ = context.node.subscribe<ignition::msgs::LaserScan>(cleanTopic(scanTopic_), [this](const auto& scan) {
      if (isStarted_ && isUsable(scan)) waiting_ = scan;
    });
    starts_ = context.node.subscribe<ignition::msgs::Boolean>(
        cleanTopic(startTopic_), [this](const auto& message) { isStarted_ = isStarted_ || message.data(); });
    images_ = context.node.advertise<ignition::msgs::Image>(cleanTopic(imageTopic_));
  }

  void preUpdate(const StepInfo& info) override {
    if (info.paused || !waiting_) return;
    explore(*waiting_);
    waiting_.reset();
  }

  void reset() override {
    isStarted_ = isFinished_ = false;
    waiting_.reset();
    visited_.clear();
    clear();
  }

  void transfer(StateArchive& archive) override {
    archive(isStarted_);
    archive(isFinished_);
    archive(visited_);
    archive(grid_);
    std::string waiting = waiting_ ? waiting_->SerializeAsString() : "";
    archive(waiting);
    if (!archive.isGiving()) return;
    waiting_.reset();
    if (!waiting.empty()) archive.check(waiting_.emplace().ParseFromString(waiting) && isUsable(*waiting_));
  }

 private:
  using Scan = ignition::msgs::LaserScan;

  /// Begins a map around the link.
  void clear() {
    const Vector3 center = link_->pose().position;
    grid_ = OccupancyGrid(width_, height_, resolution_, center.x() - width_ * resolution_ / 2,
                          center.y() - height_ * resolution_ / 2);
  }

  static bool isUsable(const Scan& scan) {
    return std::isfinite(scan.angle_min()) && std::isfinite(scan.angle_step()) && scan.range_max() > 0 &&
           std::isfinite(scan.range_max()) && scan.ranges_size() > 0;
  }

  static int beamsOf(const Scan& scan) { return std::min(scan.ranges_size(), kMostBeams); }

  /// @return The range of the lidar [m]; farther than the map is useless.
  double rangeOf(const Scan& scan) const { return std::min(scan.range_max(), resolution_ * (width_ + height_)); }

  void explore(const Scan& scan) {
    mark(scan);
    publish();
    if (isFinished_) return;
    const Vector3 place = link_->pose().position;
    const std::vector<Cell> frontier = grid_.frontier(grid_.cellAt(place.x(), place.y()));
    if (const std::optional<Cell> next = best(frontier, scan)) return moveTo(*next);
    isFinished_ = true;
    log_->info("the map is complete: no unknown cell can be reached");
  }

  void mark(const Scan& scan) {
    const Pose pose = link_->pose();
    const double yaw = yawOf(pose.rotation), range = rangeOf(scan);
    for (int i = 0; i < beamsOf(scan); ++i) {
      const double length = scan.ranges(i);
      if (std::isnan(length) || length < 0) continue;
      const bool isHit = length <= range;
      const auto [sine, cosine] = math::sinCos(yaw + scan.angle_min() + i * scan.angle_step());
      const double way = std::min(length, range);
      grid_.mark(pose.position.x(), pose.position.y(), pose.position.x() + way * cosine, pose.position.y() + way * sine,
                 isHit);
    }
  }

  /// @return The cell from which a scan would see most unknown cells; nothing if none would see any.
  std::optional<Cell> best(const std::vector<Cell>& frontier, const Scan& scan) const {
    const double yaw = yawOf(link_->pose().rotation), cells = rangeOf(scan) / resolution_;
    std::vector<Cell> ends;
    for (int i = 0; i < beamsOf(scan); ++i) {
      const auto [sine, cosine] = math::sinCos(yaw + scan.angle_min() + i * scan.angle_step());
      ends.push_back({static_cast<int>(std::round(cells * cosine)), static_cast<int>(std::round(cells * sine))});
    }
    std::optional<Cell> chosen;
    std::int64_t most = 0;
    for (const Cell cell : frontier) {
      if (std::ranges::find(visited_, numberOf(cell)) != visited_.end()) continue;
      std::int64_t gain = 0;
      for (const Cell end : ends) gain += grid_.unknownOn(cell, {cell.x + end.x, cell.y + end.y});
      if (gain <= most) continue;
      most = gain;
      chosen = cell;
    }
    return chosen;
  }

  std::int64_t numberOf(Cell cell) const { return static_cast<std::int64_t>(cell.y) * width_ + cell.x; }

  void moveTo(Cell cell) {
    visited_.push_back(numberOf(cell));
    const Vector3 place = link_->pose().position;
    Pose pose = model_->pose();
    pose.position += Vector3(grid_.centerX(cell) - place.x(), grid_.centerY(cell) - place.y(), 0);
    const Outcome<void> moved = model_->setPose(pose);
    if (!moved) log_->warning("the model can't be moved: " + moved.error);
  }

  void publish() {
    if (!images_.hasSubscribers()) return;
    ignition::msgs::Image image;
    image.set_width(static_cast<std::uint32_t>(grid_.width()));
    image.set_height(static_cast<std::uint32_t>(grid_.height()));
    image.set_pixel_format_type(ignition::msgs::RGB_INT8);
    image.set_step(static_cast<std::uint32_t>(3 * grid_.width()));
    image.set_data(grid_.picture());
    images_.publish(image);
  }

  std::string scanTopic_ = "scan", imageTopic_ = "scan_image", startTopic_ = "start", linkName_ = "link";
  int width_ = 10;
  int height_ = 10;
  double resolution_ = 1;

  const Logger* log_ = nullptr;
  std::optional<Model> model_;
  std::optional<Link> link_;
  OccupancyGrid grid_;
  /// Of the last step.
  std::optional<Scan> waiting_;
  bool isStarted_ = false;
  bool isFinished_ = false;
  /// Numbers of the cells to which it has moved.
  std::vector<std::int64_t> visited_;
  Subscription scans_, starts_;
  Publisher images_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::FreeSpaceExplorer, "gz::sim::systems::FreeSpaceExplorer",
                      "ignition::gazebo::systems::FreeSpaceExplorer");
