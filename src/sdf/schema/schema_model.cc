// Descriptions taken from sdformat 12, Copyright 2012 Open Source Robotics Foundation, Apache License 2.0.
#include "sdf/schema/schema_table.hh"

namespace pongsim::sdf {

namespace {

using enum Use;

constexpr SchemaRow kModelRows[] = {
    {"actor", "", "", '1', 0, 0, kRead,
     "A special kind of model which can have a scripted motion. This includes both global waypoint type animations and "
     "skeleton animations."},
    {"actor@name", "string", "", '1', 0, 0, kRead, "A unique name for the actor."},
    {"actor@static", "bool", "false", '0', 0, 5, kPassed, ""},
    {"actor.animation", "", "", '*', 0, 0, kRead,
     "Animation file defines an animation for the skeleton in the skin. The skeleton must be compatible with the skin "
     "skeleton."},
    {"actor.animation@name", "string", "", '1', 0, 0, kRead, "Unique name for animation."},
    {"actor.animation.filename", "string", "", '1', 2, 0, kRead,
     "Path to animation file. Accepted formats: COLLADA, BVH."},
    {"actor.animation.interpolate_x", "bool", "false", '0', 2, 0, kRead,
     "Set to true so the animation is interpolated on X."},
    {"actor.animation.scale", "double", "1.0", '0', 2, 0, kRead, "Scale for the animation skeleton."},
    {"actor.frame", "+frame", "", '*', 5, 7, kPassed, ""},
    {"actor.joint", "+joint", "", '*', 0, 0, kPassed, ""},
    {"actor.link", "+link", "", '+', 0, 0, kRead, ""},
    {"actor.plugin", "+plugin", "", '*', 0, 0, kRead, ""},
    {"actor.pose", "+pose", "", '0', 2, 0, kRead, ""},
    {"actor.script", "", "", '1', 0, 0, kRead, "Adds scripted trajectories to the actor."},
    {"actor.script.auto_start", "bool", "true", '0', 2, 0, kRead,
     "Set to true if the animation should start as soon as the simulation starts playing. It is useful to set this to "
     "false if the animation should only start playing only when triggered by a plugin, for example."},
    {"actor.script.delay_start", "double", "0.0", '0', 2, 0, kRead,
     "This is the time to wait before starting the script. If running in a loop, this time will be waited before "
     "starting each cycle."},
    {"actor.script.loop", "bool", "true", '0', 2, 0, kRead,
     "Set this to true for the script to be repeated in a loop. For a fluid continuous motion, make sure the last "
     "waypoint matches the first one."},
    {"actor.script.trajectory", "", "", '*', 0, 0, kRead,
     "The trajectory contains a series of keyframes to be followed."},
    {"actor.script.trajectory@id", "int", "0", '1', 0, 0, kRead, "Unique id for a trajectory."},
    {"actor.script.trajectory@tension", "double", "0.0", '0', 6, 0, kRead,
     "The tension of the trajectory spline. The default value of zero equates to a Catmull-Rom spline, which may also "
     "cause the animation to overshoot keyframes. A value of one will cause the animation to stick to the keyframes."},
    {"actor.script.trajectory@type", "string", "", '1', 0, 0, kRead,
     "If it matches the type of an animation, they will be played at the same time."},
    {"actor.script.trajectory.waypoint", "", "", '*', 0, 0, kRead, "Each point in the trajectory."},
    {"actor.script.trajectory.waypoint.pose", "pose", "0 0 0 0 0 0", '1', 2, 0, kRead,
     "The pose which should be reached at the given time."},
    {"actor.script.trajectory.waypoint.time", "double", "0.0", '1', 2, 0, kRead,
     "The time in seconds, counted from the beginning of the script, when the pose should be reached."},
    {"actor.skin", "", "", '0', 0, 0, kRead,
     "Skin file which defines a visual and the underlying skeleton which moves it."},
    {"actor.skin.filename", "string", "", '1', 2, 0, kRead, "Path to skin file, accepted formats: COLLADA, BVH."},
    {"actor.skin.scale", "double", "1.0", '0', 2, 0, kRead, "Scale the skin's size."},
    {"actor.static", "bool", "true", '0', 5, 7, kPassed,
     "(DEPRECATION WARNING: This is deprecated in 1.6 and removed in 1.7. Actors should be static, so this is always "
     "true."},
    {"battery", "", "", '1', 5, 0, kPassed, "Description of a battery."},
    {"battery@name", "string", "", '1', 5, 0, kPassed, "Unique name for the battery."},
    {"battery.voltage", "double", "0.0", '1', 5, 0, kPassed, "Initial voltage in volts."},
    {"frame", "", "", '1', 5, 0, kRead, "A frame of reference in which poses may be expressed."},
    {"frame@attached_to", "string", "", '*', 7, 0, kRead,
     "If specified, this frame is attached to the specified frame. The specified frame must be within the same scope "
     "and may be defined implicitly, i.e., the name of any //frame, //model, //joint, or //link within the same scope "
     "may be used. If missing, this frame is attached to the containing scope's frame. Within a //world scope this is "
     "the implicit world frame, and within a //model scope this is the implicit model frame. A frame moves jointly "
     "with the frame it is @attached_to. This is different from //pose/@relative_to. @attached_to defines how the "
     "frame is attached to a //link, //model, or //world frame, while //pose/@relative_to defines how the frame's pose "
     "is represented numerically. As a result, following the chain of @attached_to attributes must always lead to a "
     "//link, //model, //world, or //joint (implicitly attached_to its child //link)."},
    {"frame@name", "string", "", '1', 5, 0, kRead,
     "Name of the frame. It must be unique whithin its scope (model/world), i.e., it must not match the name of "
     "another frame, link, joint, or model within the same scope."},
    {"frame.pose", "+pose", "", '0', 5, 0, kRead, ""},
    {"gripper", "", "", '1', 0, 0, kPassed, ""},
    {"gripper@name", "string", "", '1', 0, 0, kPassed, ""},
    {"gripper.grasp_check", "", "", '0', 0, 0, kPassed, ""},
    {"gripper.grasp_check.attach_steps", "int", "20", '0', 2, 0, kPassed, ""},
    {"gripper.grasp_check.detach_steps", "int", "40", '0', 2, 0, kPassed, ""},
    {"gripper.grasp_check.min_contact_count", "unsigned int", "2", '0', 2, 0, kPassed, ""},
    {"gripper.gripper_link", "string", "", '+', 0, 0, kPassed, ""},
    {"gripper.palm_link", "string", "", '1', 0, 0, kPassed, ""},
    {"inertial", "", "", '1', 0, 0, kRead, "The inertial properties of the link."},
    {"inertial.frame", "+frame", "", '*', 5, 7, kRead, ""},
    {"inertial.inertia", "", "", '0', 0, 0, kRead,
     "The 3x3 rotational inertia matrix. Because the rotational inertia matrix is symmetric, only 6 above-diagonal "
     "elements of this matrix are specified here, using the attributes ixx, ixy, ixz, iyy, iyz, izz."},
    {"inertial.inertia.ixx", "double", "1.0", '1', 2, 0, kRead, ""},
    {"inertial.inertia.ixy", "double", "0.0", '1', 2, 0, kRead, ""},
    {"inertial.inertia.ixz", "double", "0.0", '1', 2, 0, kRead, ""},
    {"inertial.inertia.iyy", "double", "1.0", '1', 2, 0, kRead, ""},
    {"inertial.inertia.iyz", "double", "0.0", '1', 2, 0, kRead, ""},
    {"inertial.inertia.izz", "double", "1.0", '1', 2, 0, kRead, ""},
    {"inertial.mass", "double", "1.0", '0', 2, 0, kRead, "The mass of the link."},
    {"inertial.pose", "pose", "0 0 0 0 0 0", '0', 2, 0, kRead,
     "A pose (translation, rotation) expressed in the frame of the link. The first three components (x, y, z) "
     "represent the position of the element's origin (in the @relative_to frame). The rotation component represents "
     "the orientation of the element as either a sequence of Euler rotations (r, p, y), see "
     "http://sdformat.org/tutorials?tut=specify_pose, or as a quaternion (x, y, z, w), where w is the real component."},
    {"inertial.pose@degrees", "bool", "false", '0', 9, 0, kRead,
     "Whether or not the euler angles are in degrees, otherwise they will be interpreted as radians by default."},
    {"inertial.pose@frame", "string", "", '*', 5, 7, kRead, "Name of frame which the pose is defined relative to."},
    {"inertial.pose@relative_to", "string", "", '*', 7, 8, kRead,
     "If specified, this pose is expressed in the named frame. The named frame must be declared within the same scope "
     "(world/model) as the element that has its pose specified by this tag. If missing, the pose is expressed in the "
     "frame of the parent XML element of the element that contains the pose. For exceptions to this rule and more "
     "details on the default behavior, see http://sdformat.org/tutorials?tut=pose_frame_semantics. Note that "
     "@relative_to merely affects an element's initial pose and does not affect the element's dynamic movement "
     "thereafter."},
    {"inertial.pose@rotation_format", "string", "euler_rpy", '0', 9, 0, kRead,
     "'euler_rpy' by default. Supported rotation formats are 'euler_rpy', Euler angles representation in roll, pitch, "
     "yaw. The pose is expected to have 6 values. 'quat_xyzw', Quaternion representation in x, y, z, w. The pose is "
     "expected to have 7 values."},
    {"joint", "", "", '1', 0, 0, kRead,
     "A joint connects two links with kinematic and dynamic properties. By default, the pose of a joint is expressed "
     "in the child link frame."},
    {"joint@name", "string", "", '1', 0, 0, kRead, "A unique name for the joint within the scope of the model."},
    {"joint@type", "string", "", '1', 0, 0, kRead,
     "The type of joint, which must be one of the following: (continuous) a hinge joint that rotates on a single axis "
     "with a continuous range of motion, (revolute) a hinge joint that rotates on a single axis with a fixed range of "
     "motion, (gearbox) geared revolute joints, (revolute2) same as two revolute joints connected in series, "
     "(prismatic) a sliding joint that slides along an axis with a limited range specified by upper and lower limits, "
     "(ball) a ball and socket joint, (screw) a single degree of freedom joint with coupled sliding and rotational "
     "motion, (universal) like a ball joint, but constrains one degree of freedom, (fixed) a joint with zero degrees "
     "of freedom that rigidly connects two links."},
    {"joint.axis", "", "", '0', 0, 0, kRead,
     "Parameters related to the axis of rotation for revolute joints, the axis of translation for prismatic joints."},
    {"joint.axis.dynamics", "", "", '0', 0, 0, kRead,
     "An element specifying physical properties of the joint. These values are used to specify modeling properties of "
     "the joint, particularly useful for simulation."},
    {"joint.axis.dynamics.damping", "double", "0", '0', 2, 0, kRead,
     "The physical velocity dependent viscous damping coefficient of the joint."},
    {"joint.axis.dynamics.friction", "double", "0", '0', 2, 0, kRead,
     "The physical static friction value of the joint."},
    {"joint.axis.dynamics.spring_reference", "double", "0", '1', 5, 0, kRead,
     "The spring reference position for this joint axis."},
    {"joint.axis.dynamics.spring_stiffness", "double", "0", '1', 5, 0, kRead,
     "The spring stiffness for this joint axis."},
    {"joint.axis.initial_position", "double", "0", '0', 6, 8, kPassed, "Default joint position for this joint axis."},
    {"joint.axis.limit", "", "", '1', 0, 0, kRead, "specifies the limits of this joint"},
    {"joint.axis.limit.dissipation", "double", "1.0", '0', 4, 0, kPassed, "Joint stop dissipation."},
    {"joint.axis.limit.effort", "double", "-1", '0', 2, 0, kRead,
     "A value for enforcing the maximum joint effort applied. Limit is not enforced if value is negative."},
    {"joint.axis.limit.lower", "double", "-1e16", '1', 2, 0, kRead,
     "Specifies the lower joint limit (radians for revolute joints, meters for prismatic joints). Omit if joint is "
     "continuous."},
    {"joint.axis.limit.stiffness", "double", "1e8", '0', 4, 0, kPassed, "Joint stop stiffness."},
    {"joint.axis.limit.upper", "double", "1e16", '1', 2, 0, kRead,
     "Specifies the upper joint limit (radians for revolute joints, meters for prismatic joints). Omit if joint is "
     "continuous."},
    {"joint.axis.limit.velocity", "double", "-1", '0', 2, 0, kRead,
     "A value for enforcing the maximum joint velocity."},
    {"joint.axis.use_parent_model_frame", "bool", "false", '1', 5, 7, kRead,
     "Flag to interpret the axis xyz element in the parent model frame instead of joint frame. Provided for Gazebo "
     "compatibility (see https://github.com/osrf/gazebo/issue/494 )."},
    {"joint.axis.xyz", "vector3", "0 0 1", '1', 2, 0, kRead,
     "Represents the x,y,z components of the axis unit vector. The axis is expressed in the joint frame unless a "
     "different frame is expressed in the expressed_in attribute. The vector should be normalized."},
    {"joint.axis.xyz@expressed_in", "string", "", '0', 7, 0, kRead,
     "Name of frame in whose coordinates the xyz unit vector is expressed."},
    {"joint.axis2", "", "", '0', 0, 0, kRead,
     "Parameters related to the second axis of rotation for revolute2 joints and universal joints."},
    {"joint.axis2.dynamics", "", "", '0', 0, 0, kRead,
     "An element specifying physical properties of the joint. These values are used to specify modeling properties of "
     "the joint, particularly useful for simulation."},
    {"joint.axis2.dynamics.damping", "double", "0", '0', 2, 0, kRead,
     "The physical velocity dependent viscous damping coefficient of the joint. EXPERIMENTAL: if damping coefficient "
     "is negative and implicit_spring_damper is true, adaptive damping is used."},
    {"joint.axis2.dynamics.friction", "double", "0", '0', 2, 0, kRead,
     "The physical static friction value of the joint."},
    {"joint.axis2.dynamics.spring_reference", "double", "0", '1', 5, 0, kRead,
     "The spring reference position for this joint axis."},
    {"joint.axis2.dynamics.spring_stiffness", "double", "0", '1', 5, 0, kRead,
     "The spring stiffness for this joint axis."},
    {"joint.axis2.initial_position", "double", "0", '0', 6, 8, kPassed, "Default joint position for this joint axis."},
    {"joint.axis2.limit", "", "", '1', 0, 0, kRead, ""},
    {"joint.axis2.limit.dissipation", "double", "1.0", '0', 4, 0, kPassed,
     "Joint stop dissipation. Supported physics engines: SimBody."},
    {"joint.axis2.limit.effort", "double", "-1", '0', 2, 0, kRead,
     "An attribute for enforcing the maximum joint effort applied by Joint::SetForce. Limit is not enforced if value "
     "is negative."},
    {"joint.axis2.limit.lower", "double", "-1e16", '0', 2, 0, kRead,
     "An attribute specifying the lower joint limit (radians for revolute joints, meters for prismatic joints). Omit "
     "if joint is continuous."},
    {"joint.axis2.limit.stiffness", "double", "1e8", '0', 4, 0, kPassed,
     "Joint stop stiffness. Supported physics engines: SimBody."},
    {"joint.axis2.limit.upper", "double", "1e16", '0', 2, 0, kRead,
     "An attribute specifying the upper joint limit (radians for revolute joints, meters for prismatic joints). Omit "
     "if joint is continuous."},
    {"joint.axis2.limit.velocity", "double", "-1", '0', 2, 0, kRead,
     "(not implemented) An attribute for enforcing the maximum joint velocity."},
    {"joint.axis2.use_parent_model_frame", "bool", "false", '1', 5, 7, kRead,
     "Flag to interpret the axis xyz element in the parent model frame instead of joint frame. Provided for Gazebo "
     "compatibility (see https://github.com/osrf/gazebo/issue/494 )."},
    {"joint.axis2.xyz", "vector3", "0 0 1", '1', 2, 0, kRead,
     "Represents the x,y,z components of the axis unit vector. The axis is expressed in the joint frame unless a "
     "different frame is expressed in the expressed_in attribute. The vector should be normalized."},
    {"joint.axis2.xyz@expressed_in", "string", "", '0', 7, 0, kRead,
     "Name of frame in whose coordinates the xyz unit vector is expressed."},
    {"joint.child", "string", "", '1', 0, 0, kRead,
     "Name of the child frame. The value \"world\" may not be specified."},
    {"joint.frame", "+frame", "", '*', 5, 7, kPassed, ""},
    {"joint.gearbox_ratio", "double", "1.0", '0', 4, 0, kRead,
     "Parameter for gearbox joints. Given theta_1 and theta_2 defined in description for gearbox_reference_body, "
     "theta_2 = -gearbox_ratio * theta_1."},
    {"joint.gearbox_reference_body", "string", "", '0', 4, 0, kRead,
     "Parameter for gearbox joints. Gearbox ratio is enforced over two joint angles. First joint angle (theta_1) is "
     "the angle from the gearbox_reference_body to the parent link in the direction of the axis element and the second "
     "joint angle (theta_2) is the angle from the gearbox_reference_body to the child link in the direction of the "
     "axis2 element."},
    {"joint.parent", "string", "", '1', 0, 0, kRead, "Name of the parent frame or \"world\"."},
    {"joint.physics", "", "", '0', 0, 0, kPassed, "Parameters that are specific to a certain physics engine."},
    {"joint.physics.ode", "", "", '0', 0, 0, kPassed, "ODE specific parameters"},
    {"joint.physics.ode.bounce", "double", "0", '0', 0, 0, kPassed, "Bounciness of the limits"},
    {"joint.physics.ode.cfm", "double", "0", '0', 0, 0, kPassed, "Constraint force mixing for constrained directions"},
    {"joint.physics.ode.cfm_damping", "bool", "false", '0', 3, 0, kPassed,
     "If cfm damping is set to true, ODE will use CFM to simulate damping, allows for infinite damping, and one "
     "additional constraint row (previously used for joint limit) is always active."},
    {"joint.physics.ode.erp", "double", "0.2", '0', 4, 0, kPassed,
     "Error reduction parameter for constrained directions"},
    {"joint.physics.ode.fudge_factor", "double", "0", '0', 0, 0, kPassed,
     "Scale the excess for in a joint motor at joint limits. Should be between zero and one."},
    {"joint.physics.ode.implicit_spring_damper", "bool", "false", '0', 4, 0, kPassed,
     "If implicit_spring_damper is set to true, ODE will use CFM, ERP to simulate stiffness and damping, allows for "
     "infinite damping, and one additional constraint row (previously used for joint limit) is always active. This "
     "replaces cfm_damping parameter in SDFormat 1.4."},
    {"joint.physics.ode.limit", "", "", '0', 0, 0, kPassed, ""},
    {"joint.physics.ode.limit.cfm", "double", "0.0", '1', 2, 0, kPassed,
     "Constraint force mixing parameter used by the joint stop"},
    {"joint.physics.ode.limit.erp", "double", "0.2", '1', 2, 0, kPassed,
     "Error reduction parameter used by the joint stop"},
    {"joint.physics.ode.max_force", "double", "0", '0', 0, 0, kPassed,
     "Maximum force or torque used to reach the desired velocity."},
    {"joint.physics.ode.provide_feedback", "bool", "false", '0', 3, 7, kPassed,
     "(DEPRECATION WARNING: In SDFormat 1.5 this tag will be replaced by the same tag directly under the "
     "physics-block. For now, this tag overrides the one outside of ode-block, but in SDFormat 1.5 this tag will be "
     "removed completely.) If provide feedback is set to true, ODE will compute the constraint forces at this joint."},
    {"joint.physics.ode.suspension", "", "", '0', 0, 0, kPassed, ""},
    {"joint.physics.ode.suspension.cfm", "double", "0.0", '1', 2, 0, kPassed,
     "Suspension constraint force mixing parameter"},
    {"joint.physics.ode.suspension.erp", "double", "0.2", '1', 2, 0, kPassed, "Suspension error reduction parameter"},
    {"joint.physics.ode.velocity", "double", "0", '0', 0, 0, kPassed,
     "The desired velocity of the joint. Should only be set if you want the joint to move on load."},
    {"joint.physics.provide_feedback", "bool", "false", '0', 4, 0, kPassed,
     "If provide feedback is set to true, physics engine will compute the constraint forces at this joint."},
    {"joint.physics.simbody", "", "", '0', 4, 0, kPassed, "Simbody specific parameters"},
    {"joint.physics.simbody.must_be_loop_joint", "bool", "false", '0', 4, 0, kPassed,
     "Force cut in the multibody graph at this joint."},
    {"joint.pose", "+pose", "", '0', 2, 0, kRead, ""},
    {"joint.sensor", "+sensor", "", '*', 4, 0, kRead, ""},
    {"joint.thread_pitch", "double", "1.0", '0', 0, 0, kRead, "Parameter for screw joints."},
    {"link", "", "", '1', 0, 0, kRead,
     "A physical link with inertia, collision, and visual properties. A link must be a child of a model, and any "
     "number of links may exist in a model."},
    {"link@name", "string", "", '1', 0, 0, kRead, "A unique name for the link within the scope of the model."},
    {"link.audio_sink", "+audio_sink", "", '*', 4, 0, kPassed, ""},
    {"link.audio_source", "+audio_source", "", '*', 4, 0, kPassed, ""},
    {"link.battery", "+battery", "", '*', 5, 0, kPassed, ""},
    {"link.collision", "+collision", "", '*', 0, 0, kRead, ""},
    {"link.enable_wind", "bool", "false", '0', 6, 0, kRead, "If true, the link is affected by the wind."},
    {"link.frame", "+frame", "", '*', 5, 7, kPassed, ""},
    {"link.gravity", "bool", "true", '0', 2, 0, kRead, "If true, the link is affected by gravity."},
    {"link.inertial", "+inertial", "", '0', 0, 0, kRead, ""},
    {"link.kinematic", "bool", "false", '0', 2, 0, kRead, "If true, the link is kinematic only"},
    {"link.light", "+light", "", '*', 6, 0, kRead, ""},
    {"link.must_be_base_link", "bool", "false", '0', 4, 0, kPassed,
     "If true, the link will have 6DOF and be a direct child of world."},
    {"link.particle_emitter", "+particle_emitter", "", '*', 6, 0, kPassed, ""},
    {"link.pose", "+pose", "", '0', 2, 0, kRead, ""},
    {"link.projector", "+projector", "", '*', 0, 0, kPassed, ""},
    {"link.self_collide", "bool", "false", '0', 2, 0, kRead,
     "If true, the link can collide with other links in the model. Two links within a model will collide if "
     "link1.self_collide OR link2.self_collide. Links connected by a joint will never collide."},
    {"link.sensor", "+sensor", "", '*', 0, 0, kRead, ""},
    {"link.velocity_decay", "", "", '0', 2, 0, kRead, "Exponential damping of the link's velocity."},
    {"link.velocity_decay.angular", "double", "0.0", '0', 2, 0, kRead, "Angular damping"},
    {"link.velocity_decay.linear", "double", "0.0", '0', 2, 0, kRead, "Linear damping"},
    {"link.visual", "+visual", "", '*', 0, 0, kRead, ""},
    {"model", "", "", '1', 0, 0, kRead, "The model element defines a complete robot or any other physical object."},
    {"model@canonical_link", "string", "", '0', 7, 0, kRead,
     "The name of the model's canonical link, to which the model's implicit coordinate frame is attached. If unset or "
     "set to an empty string, the first link element listed as a child of this model is chosen as the canonical link."},
    {"model@name", "string", "", '1', 0, 0, kRead,
     "The name of the model and its implicit frame. This name must be unique among all elements defining frames within "
     "the same scope, i.e., it must not match another //model, //frame, //joint, or //link within the same scope."},
    {"model@placement_frame", "string", "", '0', 8, 0, kRead,
     "The frame inside this model whose pose will be set by the pose element of the model. i.e, the pose element "
     "specifies the pose of this frame instead of the model frame."},
    {"model.allow_auto_disable", "bool", "true", '0', 2, 0, kPassed,
     "Allows a model to auto-disable, which is means the physics engine can skip updating the model when the model is "
     "at rest. This parameter is only used by models with no joints."},
    {"model.enable_wind", "bool", "false", '0', 6, 0, kRead,
     "If set to true, all links in the model will be affected by the wind. Can be overriden by the link wind "
     "property."},
    {"model.frame", "+frame", "", '*', 5, 0, kRead, ""},
    {"model.gripper", "+gripper", "", '*', 0, 0, kPassed, ""},
    {"model.include", "", "", '*', 5, 0, kRead,
     "Include resources from a URI. This can be used to nest models. The included resource can only contain one "
     "'model' element. The URI can point to a directory or a file. If the URI is a directory, it must conform to the "
     "model database structure (see /tutorials?tut=composition&cat=specification&#defining-models-in-separate-files)."},
    {"model.include@merge", "bool", "false", '0', 9, 0, kRead, "Merge the included nested model into the top model"},
    {"model.include.name", "string", "", '0', 5, 0, kRead, "Override the name of the included model."},
    {"model.include.placement_frame", "string", "", '0', 8, 0, kRead,
     "The frame inside the included model whose pose will be set by the specified pose element. If this element is "
     "specified, the pose must be specified."},
    {"model.include.plugin", "+plugin", "", '*', 5, 0, kRead, ""},
    {"model.include.pose", "+pose", "", '0', 5, 0, kRead, ""},
    {"model.include.static", "bool", "false", '0', 5, 0, kRead, "Override the static value of the included model."},
    {"model.include.uri", "string", "", '1', 5, 0, kRead, "URI to a resource, such as a model"},
    {"model.joint", "+joint", "", '*', 0, 0, kRead, ""},
    {"model.link", "+link", "", '*', 0, 0, kRead, ""},
    {"model.model", "+model", "", '*', 5, 0, kRead, "A nested model element"},
    {"model.plugin", "+plugin", "", '*', 0, 0, kRead, ""},
    {"model.pose", "+pose", "", '0', 2, 0, kRead, ""},
    {"model.self_collide", "bool", "false", '0', 5, 0, kRead,
     "If set to true, all links in the model will collide with each other (except those connected by a joint). Can be "
     "overridden by the link or collision element self_collide property. Two links within a model will collide if "
     "link1.self_collide OR link2.self_collide. Links connected by a joint will never collide."},
    {"model.static", "bool", "false", '0', 2, 0, kRead,
     "If set to true, the model is immovable. Otherwise the model is simulated in the dynamics engine."},
    {"particle_emitter", "", "", '1', 6, 0, kPassed,
     "A particle emitter that can be used to describe fog, smoke, and dust."},
    {"particle_emitter@name", "string", "", '1', 6, 0, kPassed, "A unique name for the particle emitter."},
    {"particle_emitter@type", "string", "point", '1', 6, 0, kPassed,
     "The type of a particle emitter. One of \"box\", \"cylinder\", \"ellipsoid\", or \"point\"."},
    {"particle_emitter.color_end", "color", "1 1 1 1", '0', 6, 0, kPassed,
     "Sets the end color for all particles emitted. The actual color will be interpolated between this color and the "
     "one set under color_start. Color::White is the default color for the particles unless a specific function is "
     "used (see color_start for more information about defining custom colors with RGB values). Note that this "
     "function overrides the particle colors set with color_range_image."},
    {"particle_emitter.color_range_image", "string", "", '0', 6, 0, kPassed,
     "Sets the path to the color image used as an affector. This affector modifies the color of particles in flight. "
     "The colors are taken from a specified image file. The range of color values begins from the left side of the "
     "image and moves to the right over the lifetime of the particle, therefore only the horizontal dimension of the "
     "image is used. Note that this function overrides the particle colors set with color_start and color_end."},
    {"particle_emitter.color_start", "color", "1 1 1 1", '0', 6, 0, kPassed,
     "Sets the starting color for all particles emitted. The actual color will be interpolated between this color and "
     "the one set under color_end. Color::White is the default color for the particles unless a specific function is "
     "used. To specify a color, RGB values should be passed in. For example, to specify red, a user should enter: "
     "<color_start>1 0 0</color_start> Note that this function overrides the particle colors set with "
     "color_range_image."},
    {"particle_emitter.duration", "double", "0", '0', 6, 0, kPassed,
     "The number of seconds the emitter is active. A value less than or equal to zero means infinite duration."},
    {"particle_emitter.emitting", "bool", "true", '0', 6, 0, kPassed,
     "True indicates that the particle emitter should generate particles when loaded"},
    {"particle_emitter.lifetime", "double", "5", '0', 6, 0, kPassed,
     "The number of seconds each particle will ’live’ for before being destroyed. This value must be greater than "
     "zero."},
    {"particle_emitter.material", "+material", "", '0', 6, 0, kPassed, ""},
    {"particle_emitter.max_velocity", "double", "1", '0', 6, 0, kPassed,
     "Sets a maximum velocity for each particle (m/s)."},
    {"particle_emitter.min_velocity", "double", "1", '0', 6, 0, kPassed,
     "Sets a minimum velocity for each particle (m/s)."},
    {"particle_emitter.particle_scatter_ratio", "float", "0.65", '0', 6, 0, kPassed,
     "This is used to determine the ratio of particles that will be detected by sensors. Increasing the ratio means "
     "there is a higher chance of particles reflecting and interfering with depth sensing, making the emitter appear "
     "more dense. Decreasing the ratio decreases the chance of particles reflecting and interfering with depth "
     "sensing, making it appear less dense."},
    {"particle_emitter.particle_size", "vector3", "1 1 1", '0', 6, 0, kPassed,
     "The particle dimensions (width, height, depth)."},
    {"particle_emitter.pose", "+pose", "", '0', 6, 0, kPassed, ""},
    {"particle_emitter.rate", "double", "10", '0', 6, 0, kPassed,
     "The number of particles per second that should be emitted."},
    {"particle_emitter.scale_rate", "double", "0", '0', 6, 0, kPassed,
     "Sets the amount by which to scale the particles in both x and y direction per second."},
    {"particle_emitter.size", "vector3", "1 1 1", '0', 6, 0, kPassed,
     "The size of the emitter where the particles are sampled. Default value is (1, 1, 1). Note that the "
     "interpretation of the emitter area varies depending on the emmiter type: - point: The area is ignored. - box: "
     "The area is interpreted as width X height X depth. - cylinder: The area is interpreted as the bounding box of "
     "the cylinder. The cylinder is oriented along the Z-axis. - ellipsoid: The area is interpreted as the bounding "
     "box of an ellipsoid shaped area, i.e. a sphere or squashed-sphere area. The parameters are again identical to "
     "EM_BOX, except that the dimensions describe the widest points along each of the axes."},
    {"particle_emitter.topic", "string", "", '0', 6, 0, kPassed,
     "Topic used to update particle emitter properties at runtime. The default topic is "
     "/model/{model_name}/particle_emitter/{emitter_name} Note that the emitter id and name may not be changed."},
    {"pose", "pose", "0 0 0 0 0 0", '1', 5, 0, kRead,
     "A pose (translation, rotation) expressed in the frame named by @relative_to. The first three components (x, y, "
     "z) represent the position of the element's origin (in the @relative_to frame). The rotation component represents "
     "the orientation of the element as either a sequence of Euler rotations (r, p, y), see "
     "http://sdformat.org/tutorials?tut=specify_pose, or as a quaternion (x, y, z, w), where w is the real component."},
    {"pose@degrees", "bool", "false", '0', 9, 0, kRead,
     "Whether or not the euler angles are in degrees, otherwise they will be interpreted as radians by default."},
    {"pose@frame", "string", "", '*', 5, 7, kRead, "Name of frame which the pose is defined relative to."},
    {"pose@relative_to", "string", "", '0', 7, 0, kRead,
     "If specified, this pose is expressed in the named frame. The named frame must be declared within the same scope "
     "(world/model) as the element that has its pose specified by this tag. If missing, the pose is expressed in the "
     "frame of the parent XML element of the element that contains the pose. For exceptions to this rule and more "
     "details on the default behavior, see http://sdformat.org/tutorials?tut=pose_frame_semantics. Note that "
     "@relative_to merely affects an element's initial pose and does not affect the element's dynamic movement "
     "thereafter. New in v1.8: @relative_to may use frames of nested scopes. In this case, the frame is specified "
     "using `::` as delimiter to define the scope of the frame, e.g. `nested_model_A::nested_model_B::awesome_frame`."},
    {"pose@rotation_format", "string", "euler_rpy", '0', 9, 0, kRead,
     "'euler_rpy' by default. Supported rotation formats are 'euler_rpy', Euler angles representation in roll, pitch, "
     "yaw. The pose is expected to have 6 values. 'quat_xyzw', Quaternion representation in x, y, z, w. The pose is "
     "expected to have 7 values."},
    {"projector", "", "", '1', 0, 0, kPassed, ""},
    {"projector@name", "string", "", '1', 0, 0, kPassed, "Name of the projector"},
    {"projector.far_clip", "double", "10.0", '0', 0, 0, kPassed, "far clip distance"},
    {"projector.fov", "double", "0.785", '0', 0, 0, kPassed, "Field of view"},
    {"projector.frame", "+frame", "", '*', 5, 7, kPassed, ""},
    {"projector.near_clip", "double", "0.1", '0', 0, 0, kPassed, "Near clip distance"},
    {"projector.plugin", "+plugin", "", '*', 0, 0, kPassed, ""},
    {"projector.pose", "+pose", "", '0', 0, 0, kPassed, ""},
    {"projector.texture", "string", "", '1', 0, 0, kPassed, "Texture name"},
};

}  // namespace

std::span<const SchemaRow> modelRows() { return kModelRows; }

}  // namespace pongsim::sdf
