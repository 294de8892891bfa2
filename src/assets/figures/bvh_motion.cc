#include "assets/figures/bvh_motion.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "base/parse_number.hh"
#include "pongsim/math.hh"

namespace pongsim::assets {

namespace {

constexpr std::size_t kMostBvhBones = 10'000;
/// Values of all bones at all times.
constexpr std::size_t kMostBvhValues = 20'000'000;
constexpr std::array<std::string_view, 6> kChannels{"Xposition", "Yposition", "Zposition",
                                                    "Xrotation", "Yrotation", "Zrotation"};

struct BvhBone {
  /// Index; the bone itself for the root.
  std::size_t parent = 0;
  std::size_t childCount = 0;
  std::size_t firstChild = 0;
  /// At rest, in the frame of the parent, which is not turned. In the file's unit.
  Vector3 offset = Vector3::Zero();
  /// Indices in `kChannels`, in the order of the file.
  std::vector<std::size_t> channels;
};

struct BvhFile {
  /// In the order of the file: parents come first.
  std::vector<BvhBone> bones;
  std::size_t frameCount = 0;
  /// [s]
  double frameTime = 0;
  /// Of each frame the channels of all bones.
  std::vector<double> values;
};

class BvhReader {
 public:
  explicit BvhReader(std::string_view content) : rest_(content) {}

  BvhFile read() {
    expect("HIERARCHY");
    expect("ROOT");
    readHierarchy();
    expect("MOTION");
    readFrames();
    return std::move(file_);
  }

 private:
  [[noreturn]] void refuse(const std::string& fault) const {
    throw std::runtime_error("line " + std::to_string(line_) + ": " + fault);
  }

  /// @return The next word; empty at the end.
  std::string_view next() {
    constexpr std::string_view kSpaces = " \t\r\n";
    const std::size_t begin = std::min(rest_.find_first_not_of(kSpaces), rest_.size());
    line_ += static_cast<std::size_t>(std::ranges::count(rest_.substr(0, begin), '\n'));
    rest_.remove_prefix(begin);
    const std::string_view word = rest_.substr(0, std::min(rest_.find_first_of(kSpaces), rest_.size()));
    rest_.remove_prefix(word.size());
    return word;
  }

  void expect(std::string_view word) {
    if (const std::string_view found = next(); found != word) {
      refuse("here should be '" + std::string(word) + "', not '" + std::string(found.substr(0, 40)) + "'");
    }
  }

  double number() {
    const std::string_view word = next();
    const std::optional<double> value = base::parseDouble(word);
    if (!value || !std::isfinite(*value)) refuse("'" + std::string(word.substr(0, 40)) + "' is no finite number");
    return *value;
  }

  std::size_t count(std::size_t most) {
    const double value = number();
    if (value < 0 || value > static_cast<double>(most) || value != std::floor(value)) {
      refuse("this number is not from 0 to " + std::to_string(most));
    }
    return static_cast<std::size_t>(value);
  }

  /// Behind "ROOT".
  void readHierarchy() {
    std::vector<std::size_t> open;
    beginBone(open);
    while (!open.empty()) {
      const std::string_view word = next();
      if (word == "JOINT") {
        beginBone(open);
      } else if (word == "End") {
        expect("Site");
        expect("{");
        expect("OFFSET");
        for (int i = 0; i < 3; ++i) number();
        expect("}");
      } else if (word == "}") {
        open.pop_back();
      } else if (word == "OFFSET") {
        for (double& each : file_.bones[open.back()].offset) each = number();
      } else if (word == "CHANNELS") {
        readChannels(file_.bones[open.back()]);
      } else {
        refuse("'" + std::string(word.substr(0, 40)) + "' does not belong into a bone");
      }
    }
  }

  /// Reads a bone's name and its opening brace.
  void beginBone(std::vector<std::size_t>& open) {
    const std::size_t bone = file_.bones.size();
    if (bone >= kMostBvhBones) refuse("there are more than " + std::to_string(kMostBvhBones) + " bones");
    file_.bones.push_back({.parent = open.empty() ? bone : open.back(), .channels = {}});
    if (!open.empty() && file_.bones[open.back()].childCount++ == 0) file_.bones[open.back()].firstChild = bone;
    next();
    expect("{");
    open.push_back(bone);
  }

  void readChannels(BvhBone& bone) {
    bone.channels.clear();
    for (std::size_t left = count(kChannels.size()); left > 0; --left) {
      const std::string_view word = next();
      const auto* const found = std::ranges::find(kChannels, word);
      if (found == kChannels.end()) refuse("'" + std::string(word.substr(0, 40)) + "' is no channel");
      bone.channels.push_back(static_cast<std::size_t>(found - kChannels.begin()));
    }
  }

  void readFrames() {
    std::size_t width = 0;
    for (const BvhBone& bone : file_.bones) width += bone.channels.size();
    expect("Frames:");
    file_.frameCount = count(kMostBvhValues / std::max<std::size_t>(width, 1));
    expect("Frame");
    expect("Time:");
    file_.frameTime = number();
    if (!(file_.frameTime > 0)) refuse("the time of a frame is not above 0");
    for (std::size_t i = 0; i < file_.frameCount * width; ++i) file_.values.push_back(number());
  }

  std::string_view rest_;
  std::size_t line_ = 1;
  BvhFile file_;
};

/// Where a bone is in a frame, in the file's axes.
Eigen::Affine3d bvhPose(const BvhBone& bone, const double* values) {
  Vector3 position = bone.offset;
  Quaternion rotation = Quaternion::Identity();
  for (std::size_t i = 0; i < bone.channels.size(); ++i) {
    const std::size_t channel = bone.channels[i];
    const auto axis = static_cast<Eigen::Index>(channel % 3);
    if (channel < 3) {
      position[axis] = values[i];
    } else {
      rotation = rotation * rotationAbout(Vector3::Unit(axis), values[i] * std::numbers::pi / 180);
    }
  }
  return Eigen::Translation3d(position) * rotation;
}

/// From a motion of the file's bones to one of the skin's: X_skin = before X_file after.
struct Alignment {
  std::optional<Quaternion> before;
  Quaternion after = Quaternion::Identity();
};

/// Computes alignments as ign-common's `Skeleton::AddBvhAnimation` does: bones are turned by up to 90 degrees until
/// they rest as those of the skin.
class Aligner {
 public:
  Aligner(const std::vector<BvhBone>& bones, const Skeleton& skin) : bones_(bones), alignments_(bones.size()) {
    for (std::size_t i = 0; i < bones.size(); ++i) {
      file_.push_back({bones[i].offset, Quaternion::Identity()});
      skin_.push_back({skin.bones[i].X_ParentBone.translation(), Track::rotationIn(skin.bones[i].X_ParentBone)});
    }
  }

  std::vector<Alignment> align() {
    for (std::size_t i = 0; i < bones_.size(); ++i) turn(i);
    for (std::size_t i = 1; i < bones_.size(); ++i) {
      const Quaternion before = alignments_[i].before.value_or(Quaternion::Identity());
      alignments_[i].after = file_[i].rotation.conjugate() * before.conjugate() * skin_[i].rotation;
    }
    return std::move(alignments_);
  }

 private:
  /// @return From the bone to the figure.
  Pose inFigure(const std::vector<Pose>& poses, std::size_t bone) const {
    Pose pose = poses[bone];
    while (bones_[bone].parent != bone) {
      bone = bones_[bone].parent;
      pose = poses[bone] * pose;
    }
    return pose;
  }

  void turn(std::size_t i) {
    const BvhBone& bone = bones_[i];
    if (bone.childCount == 0) return;
    if (i == 0) {
      alignments_[0].before = skin_[0].rotation;
      file_[0].rotation = skin_[0].rotation;
    }
    if (bone.childCount > 1) return;
    const Pose ofFile = inFigure(file_, i), ofSkin = inFigure(skin_, i);
    const Vector3 alongFile = inFigure(file_, bone.firstChild).position - ofFile.position;
    const Vector3 alongSkin = inFigure(skin_, bone.firstChild).position - ofSkin.position;
    if (alongFile.isZero(0) || alongSkin.isZero(0)) return;
    const Vector3 axis = alongFile.cross(alongSkin);
    const double sine = std::min(1.0, axis.norm() / (alongFile.norm() * alongSkin.norm()));
    const Quaternion way = axis.isZero(0) ? Quaternion::Identity() : rotationAbout(axis.normalized(), math::asin(sine));
    alignments_[bone.firstChild].before = ofSkin.rotation.conjugate() * way * ofFile.rotation;
    file_[i].rotation = ofFile.rotation.conjugate() * way * ofFile.rotation;
  }

  const std::vector<BvhBone>& bones_;
  std::vector<Pose> file_, skin_;
  std::vector<Alignment> alignments_;
};

void checkForm(const std::vector<BvhBone>& bones, const Skeleton& skin) {
  std::vector<std::size_t> childCounts(skin.bones.size());
  for (std::size_t i = 0; i < skin.bones.size(); ++i) {
    if (skin.bones[i].parent != i) ++childCounts[skin.bones[i].parent];
  }
  if (bones.size() != childCounts.size()) {
    throw std::runtime_error("it has " + std::to_string(bones.size()) + " bones, the actor's skin " +
                             std::to_string(childCounts.size()));
  }
  for (std::size_t i = 0; i < bones.size(); ++i) {
    if (bones[i].childCount == childCounts[i]) continue;
    throw std::runtime_error("its bones hang together in another way than those of the actor's skin, at '" +
                             skin.bones[i].name + "'");
  }
}

}  // namespace

Motion bvhMotion(const std::string& content, double scale, const Skeleton& skin) {
  const BvhFile file = BvhReader(content).read();
  checkForm(file.bones, skin);
  const std::vector<Alignment> alignments = Aligner(file.bones, skin).align();
  Motion motion;
  const double* values = file.values.data();
  for (std::size_t frame = 0; frame < file.frameCount; ++frame) {
    for (std::size_t i = 0; i < file.bones.size(); ++i) {
      const Quaternion before = alignments[i].before.value_or(Quaternion::Identity());
      motion.tracks[skin.bones[i].name].add(static_cast<double>(frame) * file.frameTime,
                                            before * bvhPose(file.bones[i], values) * alignments[i].after);
      values += file.bones[i].channels.size();
    }
  }
  motion.scale(scale / skin.unit);
  return motion;
}

}  // namespace pongsim::assets
