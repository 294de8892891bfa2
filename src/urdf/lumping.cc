#include "urdf/lumping.hh"

namespace pongsim::urdf {

namespace {

/// Steiner's theorem: how much a mass at an offset from a point adds to the moments about that point.
Matrix3 momentsOfPoint(double mass, const Vector3& offset) {
  return mass * (offset.squaredNorm() * Matrix3::Identity() - offset * offset.transpose());
}

/// Adds the mass of another link whose frame is at `X_TargetLink`.
void addInertial(const Inertial& added, const Pose& X_TargetLink, std::optional<Inertial>& target) {
  if (!target) target.emplace().position = added.position;
  const Vector3 addedCom = X_TargetLink * added.com;
  const double mass = target->mass + added.mass;
  const Vector3 com = mass > 0 ? Vector3((target->mass * target->com + added.mass * addedCom) / mass) : target->com;
  const Matrix3 rotation = X_TargetLink.rotation.toRotationMatrix();
  target->moments += momentsOfPoint(target->mass, target->com - com) + rotation * added.moments * rotation.transpose() +
                     momentsOfPoint(added.mass, addedCom - com);
  target->mass = mass;
  target->com = com;
}

bool isLumped(const Robot& robot, const Joint& joint, const Extensions& extensions) {
  return joint.urdf->type == ::urdf::Joint::FIXED && robot.links[joint.parent].name != "world" &&
         extensions.fixingOf(joint.urdf->name) == Extensions::Fixing::kLumped;
}

}  // namespace

void lumpFixedJoints(Robot& robot, const Extensions& extensions) {
  // parents come first, so a parent's own target is known
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    Link& link = robot.links[i];
    if (!link.joint) continue;
    const bool lumps = isLumped(robot, *link.joint, extensions);
    Lumped target{link.joint->parent, link.joint->X_ParentJoint};
    if (const std::optional<Lumped>& parents = robot.links[target.link].lumpedInto) {
      target = {parents->link, parents->X_TargetLink * target.X_TargetLink};
    }
    if (!lumps) {
      link.joint->parent = target.link;
      link.joint->X_ParentJoint = target.X_TargetLink;
      continue;
    }
    link.lumpedInto = target;
    Link& bearer = robot.links[target.link];
    bearer.lumped.push_back({i, target.X_TargetLink});
    if (link.inertial) addInertial(*link.inertial, target.X_TargetLink, bearer.inertial);
  }
}

}  // namespace pongsim::urdf
