#include "core/dynamics.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "core/errors.hh"
#include "core/state_vector.hh"

namespace pongsim::python {

namespace {

Matrix3 crossMatrix(const Vector3& v) {
  return (Matrix3() << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0).finished();
}

Vector6 join(const Vector3& angular, const Vector3& linear) { return (Vector6() << angular, linear).finished(); }

/// @return The rate of a motion vector that moves with v: v x m.
Vector6 crossMotion(const Vector6& v, const Vector6& m) {
  const Vector3 w = v.head<3>(), linear = v.tail<3>(), a = m.head<3>();
  const Vector3 b = m.tail<3>();
  return join(w.cross(a), linear.cross(a) + w.cross(b));
}

/// @return The rate of a force vector that moves with v: v x* f.
Vector6 crossForce(const Vector6& v, const Vector6& f) {
  const Vector3 w = v.head<3>(), linear = v.tail<3>(), couple = f.head<3>();
  const Vector3 force = f.tail<3>();
  return join(w.cross(couple) + linear.cross(force), w.cross(force));
}

[[noreturn]] void refuse(const std::string& joint, const std::string& why) {
  raise("Refused", "joint '" + joint + "' " + why + ", which this is not written for");
}

}  // namespace

/// A joint with the place of its velocities.
struct Dynamics::Edge {
  Joint joint;
  std::string name;
  Eigen::Index place = 0;
  /// Whether the tree leads from the joint's child to its parent.
  bool isReversed = false;
};

/// Links that joints connect.
struct Dynamics::Group {
  /// First one that hangs on the world, if one does.
  std::vector<std::size_t> links;
  bool isHanging = false;
};

/// Links and joints of a model with its nested ones, in the order of `StateVector`.
struct Dynamics::Parts {
  using Place = std::optional<std::size_t>;

  std::vector<Link> links;
  std::vector<Edge> joints;
  std::map<std::uint64_t, std::size_t> places;

  void collect(const Model& model) {
    for (const Link& link : model.links()) {
      places[link.id().value] = links.size();
      links.push_back(link);
    }
    for (const Joint& joint : model.joints())
      joints.push_back({joint, model.scopedName() + "::" + std::string(joint.name())});
    for (const Model& nested : model.models()) collect(nested);
  }

  /// @return The links' places; nothing for the world and what does not move.
  std::pair<Place, Place> ends(const Edge& edge) const {
    const auto place = [&](const std::optional<Link>& link) -> Place {
      if (!link || link->model().isStatic()) return std::nullopt;
      const auto found = places.find(link->id().value);
      if (found == places.end()) refuse(edge.name, "connects the model to another one");
      return found->second;
    };
    return {place(edge.joint.parent()), place(edge.joint.child())};
  }

  /// @return The groups of links that move, in the order of their first links.
  std::vector<Group> groups() const {
    std::vector<bool> isKnown(links.size(), false), hangs(links.size(), false);
    std::vector<std::vector<std::size_t>> neighbours(links.size());
    for (std::size_t i = 0; i < links.size(); ++i) isKnown[i] = links[i].model().isStatic();
    for (const Edge& edge : joints) {
      const auto [parent, child] = ends(edge);
      if (parent && child) {
        neighbours[*parent].push_back(*child);
        neighbours[*child].push_back(*parent);
      } else if (parent || child) {
        hangs[parent ? *parent : *child] = true;
      }
    }
    std::vector<Group> found;
    for (std::size_t first = 0; first < links.size(); ++first) {
      if (isKnown[first]) continue;
      std::vector<std::size_t>& group = found.emplace_back(Group{{first}}).links;
      isKnown[first] = true;
      for (std::size_t i = 0; i < group.size(); ++i) {
        for (const std::size_t next : neighbours[group[i]]) {
          if (!isKnown[next]) group.push_back(next);
          isKnown[next] = true;
        }
      }
      const auto hanging = std::ranges::find_if(group, [&](std::size_t link) { return hangs[link]; });
      found.back().isHanging = hanging != group.end();
      if (found.back().isHanging) std::swap(group.front(), *hanging);
    }
    return found;
  }
};

Dynamics::Dynamics(const Model& model, const Vector3& gravity) : gravity_(gravity), origin_(model.pose().position) {
  if (model.parent()) throw py::value_error("model '" + model.scopedName() + "' is nested; ask its top-level model");
  Parts parts;
  parts.collect(model);
  const std::vector<Group> groups = parts.groups();
  constexpr Eigen::Index kTwist = 6;
  size_ = kTwist * std::ranges::count(groups, false, &Group::isHanging);
  for (Edge& edge : parts.joints) {
    edge.place = size_;
    size_ += edge.joint.axisCount();
  }
  Eigen::Index place = 0;
  for (const Group& group : groups) {
    const std::size_t begin = bodies_.size();
    if (group.isHanging) {
      addHanging(parts, group.links.front());
    } else {
      // as in `StateVector`: of a whole model its frame, which moves with the canonical link
      const bool isWhole = group.links.size() == parts.links.size();
      const Link root = isWhole ? model.canonicalLink().value() : parts.links[std::ranges::min(group.links)];
      addFree(root, isWhole ? model.pose() : root.pose(), place);
      place += kTwist;
    }
    addRest(parts, begin);
  }
}

void Dynamics::addBody(const Link& link, std::optional<std::size_t> parent, std::vector<Freedom> freedoms) {
  bodies_.push_back({link.id(), parent, std::move(freedoms), velocityOf(link), inertiaOf(link)});
}

/// The velocity of a frame's origin p and the angular velocity w: at o, v = dp/dt + w x (o - p), and at constant
/// velocities its rate is -w x dp/dt.
void Dynamics::addFree(const Link& root, const Pose& frame, Eigen::Index place) {
  const Vector3& p = frame.position;
  const Vector3 w = root.angularVelocity();
  const Vector3 speed = root.linearVelocity() + w.cross(p - root.pose().position);
  std::vector<Freedom> freedoms;
  for (int i = 0; i < 3; ++i)
    freedoms.push_back({place + i, join(Vector3::Zero(), Vector3::Unit(i)), Vector6::Zero(), speed[i]});
  for (int i = 0; i < 3; ++i) {
    const Vector3 axis = Vector3::Unit(i);
    freedoms.push_back(
        {place + 3 + i, join(axis, axis.cross(origin_ - p)), join(Vector3::Zero(), speed.cross(axis)), w[i]});
  }
  addBody(root, std::nullopt, std::move(freedoms));
}

void Dynamics::addHanging(const Parts& parts, std::size_t root) {
  const std::size_t begin = bodies_.size();
  for (Edge edge : parts.joints) {
    const auto [parent, child] = parts.ends(edge);
    if ((parent && child) || (parent ? parent : child) != root) continue;
    if (bodies_.size() > begin) refuse(edge.name, "closes a loop");
    edge.isReversed = parent.has_value();
    addBody(parts.links[root], std::nullopt, freedomsOf(edge));
  }
}

/// Adds the links that joints connect to the bodies from `begin` on.
void Dynamics::addRest(const Parts& parts, std::size_t begin) {
  std::vector<bool> isFound(parts.links.size(), false);
  std::vector<std::optional<std::size_t>> from(bodies_.size());
  isFound[parts.places.at(bodies_[begin].link.value)] = true;
  for (std::size_t body = begin; body < bodies_.size(); ++body) {
    const std::size_t own = parts.places.at(bodies_[body].link.value);
    for (std::size_t i = 0; i < parts.joints.size(); ++i) {
      Edge edge = parts.joints[i];
      const auto [parent, child] = parts.ends(edge);
      if (from[body] == i || (parent != own && child != own)) continue;
      edge.isReversed = child == own;
      const auto next = edge.isReversed ? parent : child;
      if (!next && body == begin) continue;  // what the root hangs on
      if (!next || isFound[*next]) refuse(edge.name, "closes a loop");
      isFound[*next] = true;
      addBody(parts.links[*next], body, freedomsOf(edge));
      from.push_back(i);
    }
  }
}

std::vector<Dynamics::Freedom> Dynamics::freedomsOf(const Edge& edge) const {
  const Joint& joint = edge.joint;
  const std::string_view type = joint.type();
  if (type == "screw" || type == "gearbox" || type == "ball") refuse(edge.name, "is a " + std::string(type));
  const std::optional<Link> parent = joint.parent();
  const Link child = joint.child();
  const Pose X_WorldParentJoint = (parent ? parent->pose() : Pose()) * joint.poseInParent();
  const Pose X_WorldChildJoint = child.pose() * joint.poseInChild();
  const Vector3 arm = X_WorldChildJoint.position - origin_;
  const double sign = edge.isReversed ? -1 : 1;
  std::vector<Freedom> freedoms;
  for (int i = 0; i < joint.axisCount(); ++i) {
    // the first axis is fixed to the parent, the second one to the child
    const Pose& X_WorldJoint = i == 0 ? X_WorldParentJoint : X_WorldChildJoint;
    const Vector3 along = sign * (X_WorldJoint.rotation * joint.axisInfo(i).xyz);
    const Vector6 axis = type == "prismatic" ? join(Vector3::Zero(), along) : join(along, arm.cross(along));
    const Vector6 carrier = i == 1 ? velocityOf(child) : parent ? velocityOf(*parent) : Vector6(Vector6::Zero());
    freedoms.push_back({edge.place + i, axis, crossMotion(carrier, axis), joint.velocity(i)});
  }
  return freedoms;
}

Vector6 Dynamics::velocityOf(const Link& link) const {
  const Vector3 w = link.angularVelocity();
  return join(w, link.linearVelocity() + w.cross(origin_ - link.pose().position));
}

Matrix6 Dynamics::inertiaOf(const Link& link) const {
  const MassInfo mass = link.mass();
  const Pose X_WorldLink = link.pose();
  const Matrix3 R = X_WorldLink.rotation.toRotationMatrix();
  const Matrix3 c = crossMatrix(X_WorldLink * mass.center - origin_);
  Matrix6 inertia;
  inertia.topLeftCorner<3, 3>() = R * mass.inertia * R.transpose() + mass.mass * c * c.transpose();
  inertia.topRightCorner<3, 3>() = mass.mass * c;
  inertia.bottomLeftCorner<3, 3>() = mass.mass * c.transpose();
  inertia.bottomRightCorner<3, 3>() = mass.mass * Matrix3::Identity();
  return inertia;
}

Eigen::MatrixXd Dynamics::massMatrix() const {
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(size_, size_);
  std::vector<Matrix6> composites;
  for (const Body& body : bodies_) composites.push_back(body.inertia);
  for (std::size_t i = bodies_.size(); i-- > 0;) {
    if (bodies_[i].parent) composites[*bodies_[i].parent] += composites[i];
    for (const Freedom& freedom : bodies_[i].freedoms) {
      const Vector6 force = composites[i] * freedom.axis;
      for (std::optional<std::size_t> k = i; k; k = bodies_[*k].parent) {
        for (const Freedom& other : bodies_[*k].freedoms) {
          M(freedom.place, other.place) = M(other.place, freedom.place) = other.axis.dot(force);
        }
      }
    }
  }
  return M;
}

Eigen::VectorXd Dynamics::inverseDynamics(const Eigen::VectorXd& accelerations) const {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(size_);
  const Vector6 rest = join(Vector3::Zero(), -gravity_);
  std::vector<Vector6> rates, wrenches;
  for (const Body& body : bodies_) {
    Vector6 rate = body.parent ? rates[*body.parent] : rest;
    for (const Freedom& freedom : body.freedoms)
      rate += freedom.axis * accelerations[freedom.place] + freedom.rate * freedom.speed;
    rates.push_back(rate);
    wrenches.push_back(body.inertia * rate + crossForce(body.velocity, body.inertia * body.velocity));
  }
  for (std::size_t i = bodies_.size(); i-- > 0;) {
    for (const Freedom& freedom : bodies_[i].freedoms) forces[freedom.place] = freedom.axis.dot(wrenches[i]);
    if (bodies_[i].parent) wrenches[*bodies_[i].parent] += wrenches[i];
  }
  return forces;
}

Eigen::MatrixXd Dynamics::jacobian(const Link& link, const Vector3& point) const {
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(6, size_);
  const Vector3 arm = link.pose() * point - origin_;
  const auto found = std::ranges::find(bodies_, link.id(), &Body::link);
  for (std::optional<std::size_t> k = found == bodies_.end() ? std::nullopt
                                                             : std::optional<std::size_t>(found - bodies_.begin());
       k; k = bodies_[*k].parent) {
    for (const Freedom& freedom : bodies_[*k].freedoms) {
      const Vector3 angular = freedom.axis.head<3>();
      J.col(freedom.place) << freedom.axis.tail<3>() + angular.cross(arm), angular;
    }
  }
  return J;
}

}  // namespace pongsim::python
