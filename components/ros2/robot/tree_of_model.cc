#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "ros2/robot/kinematic_tree.hh"

namespace pongsim::ros2 {

namespace {

/// A frame within this distance counts as on its joint's axis [m].
constexpr double kOnAxis = 1e-12;
/// The world, which has no link.
constexpr LinkId kWorld{};

/// A joint, followed in one direction.
struct Edge {
  Joint joint;
  /// "inner/wheel_joint"
  std::string name;
  LinkId from;
  LinkId to;
  bool isBackwards = false;
};

class TreeMaker {
 public:
  TreeMaker(const Model& model, const Frames& frames, std::string_view linkPrefix, std::string_view worldFrame)
      : model_(model), frames_(frames), linkPrefix_(linkPrefix), worldFrame_(worldFrame) {
    collect(model, "");
  }

  KinematicTree make() {
    if (links_.empty()) return std::move(tree_);
    addRoot();
    grow();
    for (const Link& link : links_) {
      if (tree_.find(link.id())) continue;
      warn("link '" + link.scopedName() + "' has no parent: it is \"floating\" in the URDF");
      addFree(link, 0, Frames().toRos(link.scopedName()) + "_floating");
      grow();
    }
    for (const Edge& edge : edges_) {
      if (used_.contains(edge.joint.id())) continue;
      warn("joint '" + edge.name + "' closes a loop: it is left out of the URDF");
    }
    return std::move(tree_);
  }

 private:
  void collect(const Model& model, const std::string& scope) {
    for (const Link& link : model.links()) {
      links_.push_back(link);
      linkFrames_[link.id()] = unique(frames_.prefix + linkPrefix_ + scope + std::string(link.name()));
    }
    for (const Joint& joint : model.joints()) {
      const std::string name = scope + std::string(joint.name());
      if (joint.type() == "gearbox") {
        warn("joint '" + name + "' is a gearbox: it is left out of the URDF");
        continue;
      }
      const std::optional<Link> parent = joint.parent();
      edges_.push_back({joint, name, parent ? parent->id() : kWorld, joint.child().id()});
    }
    for (const Model& inner : model.models()) collect(inner, scope + std::string(inner.name()) + "/");
  }

  void warn(std::string text) { tree_.warnings.push_back(std::move(text)); }

  std::optional<Link> linkOf(LinkId id) const {
    const auto found = std::ranges::find_if(links_, [id](const Link& link) { return link.id() == id; });
    if (found == links_.end()) return std::nullopt;
    return *found;
  }

  bool isMoved(LinkId id) const {
    return std::ranges::any_of(edges_, [id](const Edge& edge) { return edge.to == id; });
  }

  void addRoot() {
    if (std::ranges::any_of(edges_, [](const Edge& edge) { return edge.from == kWorld; })) {
      tree_.links.push_back({.frame = unique(frames_.toRos(worldFrame_))});
      indices_[kWorld] = 0;
      return;
    }
    const std::optional<Link> canonical = model_.canonicalLink();
    std::optional<Link> root = canonical;
    if (!canonical || isMoved(canonical->id())) {
      const auto found = std::ranges::find_if(links_, [this](const Link& link) { return !isMoved(link.id()); });
      if (found != links_.end()) root = *found;
    }
    if (!root) root = links_.front();
    add({.frame = frameOf(*root), .link = root});
  }

  const std::string& frameOf(const Link& link) const { return linkFrames_.at(link.id()); }

  std::string unique(std::string name) {
    while (!names_.insert(name).second) name += '_';
    return name;
  }
  std::string uniqueJoint(std::string name) {
    while (!jointNames_.insert(name).second) name += '_';
    return name;
  }

  std::size_t add(TreeLink link) {
    const std::size_t index = tree_.links.size();
    if (link.link) indices_[link.link->id()] = index;
    tree_.links.push_back(std::move(link));
    return index;
  }

  void addFree(const Link& link, std::size_t parent, const std::string& joint) {
    const Pose X_WorldParent = tree_.rootPose(model_) * tree_.poseInRoot(parent, model_);
    add({.frame = frameOf(link),
         .link = link,
         .parent = parent,
         .joint = uniqueJoint(joint),
         .motion = Motion::kFree,
         .X_ParentLink = X_WorldParent.inverse() * link.pose()});
  }

  /// Adds links that joints connect to the tree, nearest first; a joint is followed backwards only if its parent link
  /// is not reached otherwise.
  void grow() {
    while (growBy(false) || growBy(true)) {
    }
  }

  bool growBy(bool isBackwards) {
    for (const Edge& edge : edges_) {
      const LinkId from = isBackwards ? edge.to : edge.from, to = isBackwards ? edge.from : edge.to;
      if (used_.contains(edge.joint.id()) || !indices_.contains(from) || indices_.contains(to)) continue;
      used_.insert(edge.joint.id());
      Edge way = edge;
      way.from = from;
      way.to = to;
      way.isBackwards = isBackwards;
      addBelow(way);
      return true;
    }
    return false;
  }

  void addBelow(const Edge& edge) {
    const std::string_view type = edge.joint.type();
    const Link to = linkOf(edge.to).value();
    std::size_t parent = indices_.at(edge.from);
    if (type == "ball" || type == "screw") {
      warn("joint '" + edge.name + "' is a " + std::string(type) + (type == "ball" ? " joint" : "") +
           ", which URDF does not have: it is \"floating\" there");
      return addFree(to, parent, edge.name);
    }
    // seen from `to`, the joint rotates in the opposite direction
    const Pose X_FromJoint = edge.isBackwards ? edge.joint.poseInChild() : edge.joint.poseInParent();
    const Pose X_JointTo = (edge.isBackwards ? edge.joint.poseInParent() : edge.joint.poseInChild()).inverse();
    const int count = edge.joint.axisCount();
    Pose X_ParentJoint = X_FromJoint;
    for (int i = 0; i + 1 < count; ++i) {
      const int axis = edge.isBackwards ? count - 1 - i : i;
      parent = addMoving(edge, axis, parent, X_ParentJoint, Quaternion::Identity(), std::nullopt,
                         edge.name + "_axis" + std::to_string(axis + 1));
      X_ParentJoint = {};
    }
    const std::string joint = count > 1 ? edge.name + "_axis" + (edge.isBackwards ? "1" : "2") : edge.name;
    if (count > 1)
      warn("joint '" + edge.name + "' has two axes: it is two joints in the URDF, with '_axis1' and '_axis2'");
    if (count == 0) {
      add({.frame = frameOf(to),
           .link = to,
           .parent = parent,
           .joint = uniqueJoint(joint),
           .X_ParentLink = X_ParentJoint * X_JointTo});
      return;
    }
    const int last = edge.isBackwards ? 0 : count - 1;
    if (type == "prismatic" || isOnAxis(X_JointTo.position, edge.joint.axisInfo(last).xyz)) {
      addMoving(edge, last, parent, X_ParentJoint * X_JointTo, X_JointTo.rotation, to, joint);
      return;
    }
    parent = addMoving(edge, last, parent, X_ParentJoint, Quaternion::Identity(), std::nullopt, joint);
    add({.frame = frameOf(to),
         .link = to,
         .parent = parent,
         .joint = uniqueJoint(joint + "_offset"),
         .X_ParentLink = X_JointTo});
  }

  static bool isOnAxis(const Vector3& point, const Vector3& axis) {
    return (point - point.dot(axis) * axis).norm() <= kOnAxis;
  }

  /// @param R_JointLink Orientation of the link frame in that of the joint.
  /// @param link Empty for an auxiliary link between two joints.
  std::size_t addMoving(const Edge& edge, int axis, std::size_t parent, const Pose& X_ParentLink,
                        const Quaternion& R_JointLink, const std::optional<Link>& link, const std::string& joint) {
    const Vector3 xyz = edge.joint.axisInfo(axis).xyz;
    return add({.frame = link ? frameOf(*link) : unique(frames_.toRos(linkPrefix_ + joint)),
                .link = link,
                .parent = parent,
                .joint = uniqueJoint(joint),
                .motion = edge.joint.type() == "prismatic" ? Motion::kSliding : Motion::kTurning,
                .X_ParentLink = X_ParentLink,
                .axis = R_JointLink.conjugate() * (edge.isBackwards ? Vector3(-xyz) : xyz),
                .source = edge.joint,
                .sourceAxis = axis});
  }

  const Model& model_;
  const Frames& frames_;
  std::string linkPrefix_;
  std::string worldFrame_;
  std::vector<Link> links_;
  std::vector<Edge> edges_;
  std::set<JointId> used_;
  std::map<LinkId, std::size_t> indices_;
  std::map<LinkId, std::string> linkFrames_;
  std::set<std::string> names_;
  std::set<std::string> jointNames_;
  KinematicTree tree_;
};

}  // namespace

KinematicTree treeOfModel(const Model& model, const Frames& frames, std::string_view linkPrefix,
                          std::string_view worldFrame) {
  return TreeMaker(model, frames, linkPrefix, worldFrame).make();
}

}  // namespace pongsim::ros2
