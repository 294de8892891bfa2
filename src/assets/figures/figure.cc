#include "assets/figures/figure.hh"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <exception>
#include <optional>
#include <utility>
#include <variant>

#include "assets/figures/bvh_motion.hh"
#include "assets/meshes/mesh_file.hh"
#include "base/regular_file.hh"

namespace pongsim::assets {

namespace {

// relative to the figure: more than single precision's error, less than the distance of vertices that move apart
constexpr double kSamePlace = 1e-5;

/// @return The time within a motion that begins again after its end, or stays there.
double within(double time, double length, bool loops) {
  if (time <= length) return std::max(time, 0.0);
  return loops && length > 0 ? std::fmod(time, length) : length;
}

bool movesAny(const Motion& motion, const Skeleton& skeleton) {
  return std::ranges::any_of(skeleton.bones,
                             [&](const Skeleton::Bone& bone) { return motion.tracks.contains(bone.name); });
}

}  // namespace

std::size_t Figure::CellHash::operator()(const Cell& cell) const {
  std::size_t hash = 0;
  for (const std::int64_t each : cell) hash = hash * 1'000'003 + static_cast<std::size_t>(each);
  return hash;
}

Figure::Figure(Skeleton skeleton) : skeleton_(std::move(skeleton)) {
  Eigen::AlignedBox3d box;
  for (const Skeleton::Vertex& vertex : skeleton_.vertices) box.extend(vertex.position);
  const double size = box.isEmpty() ? 0 : box.diagonal().norm() + box.center().norm();
  cell_ = size > 0 && std::isfinite(size) ? size * kSamePlace : 1;
  for (std::size_t i = 0; i < skeleton_.vertices.size(); ++i) {
    const Cell cell = cellOf(skeleton_.vertices[i].position);
    // vertices of one place move together
    if (!vertices_.contains(cell)) vertices_.emplace(cell, i);
  }
}

std::unique_ptr<Figure> Figure::load(const description::Actor& actor, const Warn& warn) {
  if (actor.skin.file.empty()) return nullptr;
  auto read = readSkeleton(actor.skin.file);
  if (const auto* problem = std::get_if<Problem>(&read)) {
    if (!actor.animations.empty()) warn(actor.skin.file, *problem);
    return nullptr;
  }
  std::optional<Skeleton>& skeleton = std::get<0>(read);
  if (!skeleton || skeleton->vertices.empty()) {
    if (!actor.animations.empty()) warn(actor.skin.file, {"has no skin with a skeleton", {}});
    return nullptr;
  }
  std::unique_ptr<Figure> figure(new Figure(*std::move(skeleton)));
  figure->own_.motion = std::move(figure->skeleton_.motion);
  for (const description::Animation& animation : actor.animations) figure->addAnimation(animation, warn);
  if (figure->animations_.empty() && !movesAny(figure->own_.motion, figure->skeleton_)) return nullptr;
  return figure;
}

std::variant<Motion, Problem> Figure::colladaMotion(const std::filesystem::path& file) const {
  auto read = readSkeleton(file);
  if (auto* problem = std::get_if<Problem>(&read)) return std::move(*problem);
  std::optional<Skeleton>& source = std::get<0>(read);
  if (!source || source->motion.tracks.empty()) return Problem{"contains no animation", {}};
  if (!movesAny(source->motion, skeleton_)) {
    return Problem{"moves bones that the actor's skin lacks, such as '" + source->motion.tracks.begin()->first + "'",
                   "those of the skin are '" + skeleton_.bones.front().name + "' and those below it"};
  }
  // the file may have another unit than the skin
  source->motion.scale(source->unit / skeleton_.unit);
  return std::move(source->motion);
}

std::variant<Motion, Problem> Figure::bvhMotionOf(const description::ActorFile& source) const {
  auto read = base::readRegularFile(source.file, kLargestMeshFile);
  if (auto* unreadable = std::get_if<base::Unreadable>(&read)) return Problem{std::move(unreadable->reason), {}};
  try {
    Motion motion = bvhMotion(std::get<std::string>(read), source.scale, skeleton_);
    if (motion.tracks.empty()) return Problem{"contains no animation", {}};
    return motion;
  } catch (const std::exception& problem) {
    return Problem{"can't move this skin", problem.what()};
  }
}

void Figure::addAnimation(const description::Animation& animation, const Warn& warn) {
  const std::filesystem::path& file = animation.source.file;
  if (file.empty()) return;
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char letter) { return std::tolower(letter); });
  auto read = ending == ".bvh" ? bvhMotionOf(animation.source) : colladaMotion(file);
  if (const auto* problem = std::get_if<Problem>(&read)) return warn(file, *problem);
  Animation added{std::move(std::get<Motion>(read)), animation.followsPath};
  const auto root = added.motion.tracks.find(skeleton_.bones.front().name);
  const bool advances = root != added.motion.tracks.end() && root->second.lastX() > root->second.firstX();
  if (added.followsX && !advances) {
    warn(file, {"does not advance along x, so that <interpolate_x> has no effect", {}});
    added.followsX = false;
  }
  animations_.emplace(animation.name, std::move(added));
}

double Figure::timeIn(const Animation& animation, const Gait& gait) const {
  const double length = animation.motion.length();
  if (!animation.followsX || !gait.isOnPath || gait.distance == 0) return within(gait.time, length, gait.loops);
  // as in Fortress: the distance, less as often as needed how far the animation goes
  const Track& root = animation.motion.tracks.at(skeleton_.bones.front().name);
  const double x = gait.distance / skeleton_.unit;
  return root.timeAtX(std::max(within(x, root.lastX(), gait.loops), root.firstX()));
}

Figure::Bones Figure::bonesIn(const Gait& gait) const {
  const auto found = animations_.find(gait.animation);
  const Animation& animation = found == animations_.end() ? own_ : found->second;
  const double time = timeIn(animation, gait);
  std::vector<Eigen::Affine3d> X_FigureBone(skeleton_.bones.size());
  for (std::size_t i = 0; i < skeleton_.bones.size(); ++i) {
    const Skeleton::Bone& bone = skeleton_.bones[i];
    Eigen::Affine3d X_ParentBone = bone.X_ParentBone;
    if (const auto track = animation.motion.tracks.find(bone.name); track != animation.motion.tracks.end()) {
      const Pose pose = track->second.at(time);
      X_ParentBone = Eigen::Translation3d(pose.position) * pose.rotation;
    }
    if (i == 0 && gait.isOnPath) X_ParentBone.translation().setZero();
    X_FigureBone[i] = bone.parent == i ? X_ParentBone : X_FigureBone[bone.parent] * X_ParentBone;
  }
  Bones bones;
  for (const Skeleton::Joint& joint : skeleton_.joints) {
    bones.push_back(Eigen::Scaling(skeleton_.unit) * X_FigureBone[joint.bone] * joint.M_BoneFile);
  }
  return bones;
}

Figure::Cell Figure::cellOf(const Vector3& position) const {
  const Vector3 scaled = position / cell_;
  const auto whole = [](double value) { return static_cast<std::int64_t>(std::floor(value)); };
  return {whole(scaled.x()), whole(scaled.y()), whole(scaled.z())};
}

const std::vector<Skeleton::Influence>* Figure::influencesAt(const Vector3& position) const {
  const Cell middle = cellOf(position);
  const Skeleton::Vertex* nearest = nullptr;
  double distance = cell_;
  for (int i = 0; i < 27; ++i) {
    const auto [first, last] =
        vertices_.equal_range({middle[0] + i % 3 - 1, middle[1] + i / 3 % 3 - 1, middle[2] + i / 9 - 1});
    for (auto each = first; each != last; ++each) {
      const Skeleton::Vertex& vertex = skeleton_.vertices[each->second];
      if ((vertex.position - position).norm() >= distance) continue;
      distance = (vertex.position - position).norm();
      nearest = &vertex;
    }
  }
  return nearest == nullptr ? nullptr : &nearest->influences;
}

Eigen::Affine3d Figure::blend(const std::vector<Skeleton::Influence>& influences, const Bones& bones) {
  // linear blend skinning, as ogre does it
  Eigen::Affine3d sum;
  sum.matrix().setZero();
  for (const auto& [joint, weight] : influences) sum.matrix() += weight * bones[joint].matrix();
  return sum;
}

}  // namespace pongsim::assets
