// Descriptions taken from sdformat 12, Copyright 2012 Open Source Robotics Foundation, Apache License 2.0.
#include "sdf/schema/schema_table.hh"

namespace pongsim::sdf {

namespace {

using enum Use;

constexpr SchemaRow kWorldRows[] = {
    {"atmosphere", "", "", '1', 6, 0, kRead,
     "The atmosphere tag specifies the type and properties of the atmosphere model."},
    {"atmosphere@type", "string", "adiabatic", '1', 6, 0, kPassed,
     "The type of the atmosphere engine. Current options are adiabatic. Defaults to adiabatic if left unspecified."},
    {"atmosphere.pressure", "double", "101325", '0', 6, 0, kRead, "Pressure at sea level in pascals."},
    {"atmosphere.temperature", "double", "288.15", '0', 6, 0, kRead, "Temperature at sea level in kelvins."},
    {"atmosphere.temperature_gradient", "double", "-0.0065", '0', 6, 0, kRead,
     "Temperature gradient with respect to increasing altitude at sea level in units of K/m."},
    {"audio_sink", "", "", '1', 4, 0, kPassed, "An audio sink."},
    {"audio_source", "", "", '1', 4, 0, kPassed, "An audio source."},
    {"audio_source.contact", "", "", '0', 4, 0, kPassed, "List of collision objects that will trigger audio playback."},
    {"audio_source.contact.collision", "string", "", '+', 4, 0, kPassed,
     "Name of child collision element that will trigger audio playback."},
    {"audio_source.frame", "+frame", "", '*', 5, 7, kPassed, ""},
    {"audio_source.gain", "double", "1.0", '0', 4, 0, kPassed, "Gain for the audio media, in dB."},
    {"audio_source.loop", "bool", "false", '0', 4, 0, kPassed, "True to make the audio source loop playback."},
    {"audio_source.pitch", "double", "1.0", '0', 4, 0, kPassed, "Pitch for the audio media, in Hz"},
    {"audio_source.pose", "+pose", "", '0', 4, 0, kPassed, ""},
    {"audio_source.uri", "string", "", '1', 4, 0, kPassed, "URI of the audio media."},
    {"gui", "", "", '1', 0, 0, kKept, ""},
    {"gui@fullscreen", "bool", "false", '0', 0, 0, kKept, ""},
    {"gui.camera", "", "", '0', 0, 0, kKept, ""},
    {"gui.camera@name", "string", "user_camera", '1', 0, 0, kKept, ""},
    {"gui.camera.frame", "+frame", "", '*', 5, 7, kPassed, ""},
    {"gui.camera.pose", "+pose", "", '0', 2, 0, kKept, ""},
    {"gui.camera.projection_type", "string", "perspective", '0', 5, 0, kKept,
     "Set the type of projection for the camera. Valid values are \"perspective\" and \"orthographic\"."},
    {"gui.camera.track_visual", "", "", '0', 0, 0, kKept, ""},
    {"gui.camera.track_visual.inherit_yaw", "bool", "false", '0', 6, 0, kKept,
     "If set to true, the camera will inherit the yaw rotation of the tracked model. This parameter is only used if "
     "static and use_model_frame are set to true."},
    {"gui.camera.track_visual.max_dist", "double", "0", '0', 0, 0, kKept,
     "Maximum distance between the camera and the tracked visual. This parameter is only used if static is set to "
     "false."},
    {"gui.camera.track_visual.min_dist", "double", "0", '0', 0, 0, kKept,
     "Minimum distance between the camera and the tracked visual. This parameter is only used if static is set to "
     "false."},
    {"gui.camera.track_visual.name", "string", "", '0', 0, 0, kKept,
     "Name of the tracked visual. If no name is provided, the remaining settings will be applied whenever tracking is "
     "triggered in the GUI."},
    {"gui.camera.track_visual.static", "bool", "false", '0', 6, 0, kKept,
     "If set to true, the position of the camera is fixed relatively to the model or to the world, depending on the "
     "value of the use_model_frame element. Otherwise, the position of the camera may vary but the distance between "
     "the camera and the model will depend on the value of the min_dist and max_dist elements. In any case, the camera "
     "will always follow the model by changing its orientation."},
    {"gui.camera.track_visual.use_model_frame", "bool", "true", '0', 6, 0, kKept,
     "If set to true, the position of the camera is relative to the model reference frame, which means that its "
     "position relative to the model will not change. Otherwise, the position of the camera is relative to the world "
     "reference frame, which means that its position relative to the world will not change. This parameter is only "
     "used if static is set to true."},
    {"gui.camera.track_visual.xyz", "vector3", "-5.0 0.0 3.0", '0', 6, 0, kKept,
     "The position of the camera's reference frame. This parameter is only used if static is set to true. If "
     "use_model_frame is set to true, the position is relative to the model reference frame, otherwise it represents "
     "world coordinates."},
    {"gui.camera.view_controller", "string", "orbit", '0', 0, 0, kKept, ""},
    {"gui.plugin", "+plugin", "", '*', 5, 0, kKept, ""},
    {"light", "", "", '1', 0, 0, kRead, "The light element describes a light source."},
    {"light@name", "string", "", '1', 0, 0, kRead, "A unique name for the light."},
    {"light@type", "string", "point", '1', 0, 0, kRead, "The light type: point, directional, spot."},
    {"light.attenuation", "", "", '0', 0, 0, kRead, "Light attenuation"},
    {"light.attenuation.constant", "double", "1", '0', 2, 0, kRead,
     "The constant attenuation factor: 1.0 means never attenuate, 0.0 is complete attenutation."},
    {"light.attenuation.linear", "double", "1", '0', 2, 0, kRead,
     "The linear attenuation factor: 1 means attenuate evenly over the distance."},
    {"light.attenuation.quadratic", "double", "0", '0', 2, 0, kRead,
     "The quadratic attenuation factor: adds a curvature to the attenuation."},
    {"light.attenuation.range", "double", "10", '1', 2, 0, kRead, "Range of the light"},
    {"light.cast_shadows", "bool", "false", '0', 2, 0, kRead, "When true, the light will cast shadows."},
    {"light.diffuse", "color", "1 1 1 1", '0', 0, 0, kRead, "Diffuse light color"},
    {"light.direction", "vector3", "0 0 -1", '1', 0, 0, kRead,
     "Direction of the light, only applicable for spot and directional lights."},
    {"light.frame", "+frame", "", '*', 5, 7, kPassed, ""},
    {"light.intensity", "double", "1", '0', 8, 0, kRead, "Scale factor to set the relative power of a light."},
    {"light.light_on", "bool", "true", '0', 9, 0, kRead, "When true, the light is on."},
    {"light.pose", "+pose", "", '0', 2, 0, kRead, ""},
    {"light.specular", "color", ".1 .1 .1 1", '0', 0, 0, kRead, "Specular light color"},
    {"light.spot", "", "", '0', 0, 0, kRead, "Spot light parameters"},
    {"light.spot.falloff", "double", "0", '1', 2, 0, kRead,
     "The rate of falloff between the inner and outer cones. 1.0 means a linear falloff, less means slower falloff, "
     "higher means faster falloff."},
    {"light.spot.inner_angle", "double", "0", '1', 2, 0, kRead, "Angle covered by the bright inner cone"},
    {"light.spot.outer_angle", "double", "0", '1', 2, 0, kRead, "Angle covered by the outer cone"},
    {"light.visualize", "bool", "true", '0', 9, 0, kRead, "If true, the light is visualized in the GUI."},
    {"light_state", "", "", '1', 5, 0, kPassed, "Light state"},
    {"light_state@name", "string", "", '1', 5, 0, kPassed, "Name of the light"},
    {"light_state.frame", "+frame", "", '*', 5, 7, kPassed, ""},
    {"light_state.pose", "+pose", "", '0', 5, 0, kPassed, ""},
    {"link_state", "", "", '1', 5, 0, kPassed, "Link state"},
    {"link_state@name", "string", "", '1', 0, 0, kPassed, "Name of the link"},
    {"link_state.acceleration", "pose", "0 0 0 0 0 0", '0', 3, 0, kPassed,
     "Acceleration of the link. The x, y, z components of the pose correspond to the linear acceleration of the link, "
     "and the roll, pitch, yaw components correspond to the angular acceleration of the link"},
    {"link_state.collision", "", "", '*', 3, 0, kPassed, "Collision state"},
    {"link_state.collision@name", "string", "", '1', 3, 0, kPassed, "Name of the collision"},
    {"link_state.collision.pose", "pose", "0 0 0 0 0 0", '1', 3, 5, kPassed, "Pose of the link relative to the model"},
    {"link_state.frame", "+frame", "", '*', 5, 7, kPassed, ""},
    {"link_state.pose", "+pose", "", '0', 0, 0, kPassed, ""},
    {"link_state.velocity", "pose", "0 0 0 0 0 0", '0', 0, 0, kPassed,
     "Velocity of the link. The x, y, z components of the pose correspond to the linear velocity of the link, and the "
     "roll, pitch, yaw components correspond to the angular velocity of the link"},
    {"link_state.wrench", "pose", "0 0 0 0 0 0", '0', 0, 0, kPassed,
     "Force and torque applied to the link. The x, y, z components of the pose correspond to the force applied to the "
     "link, and the roll, pitch, yaw components correspond to the torque applied to the link"},
    {"model_state", "", "", '1', 5, 0, kPassed, "Model state"},
    {"model_state@name", "string", "", '1', 0, 0, kPassed, "Name of the model"},
    {"model_state.frame", "+frame", "", '*', 5, 0, kPassed, ""},
    {"model_state.joint", "", "", '*', 3, 0, kPassed, "Joint angle"},
    {"model_state.joint@name", "string", "", '1', 3, 0, kPassed, "Name of the joint"},
    {"model_state.joint.angle", "double", "0", '+', 3, 0, kPassed, "Angle of an axis"},
    {"model_state.joint.angle@axis", "unsigned int", "0", '1', 3, 0, kPassed, "Index of the axis."},
    {"model_state.link", "+link_state", "", '*', 0, 0, kPassed, ""},
    {"model_state.model", "+model_state", "", '*', 5, 0, kPassed, "A nested model state element"},
    {"model_state.pose", "+pose", "", '0', 0, 0, kPassed, ""},
    {"model_state.scale", "vector3", "1 1 1", '0', 6, 0, kPassed, "Scale for the 3 dimensions of the model."},
    {"physics", "", "", '1', 0, 0, kRead, "The physics tag specifies the type and properties of the dynamics engine."},
    {"physics@default", "bool", "false", '0', 5, 0, kRead,
     "If true, this physics element is set as the default physics profile for the world. If multiple default physics "
     "elements exist, the first element marked as default is chosen. If no default physics element exists, the first "
     "physics element is chosen."},
    {"physics@name", "string", "default_physics", '0', 5, 0, kRead, "The name of this set of physics parameters."},
    {"physics@type", "string", "ode", '1', 0, 0, kRead,
     "The type of the dynamics engine. Current options are ode, bullet, simbody and dart. Defaults to ode if left "
     "unspecified."},
    {"physics.bullet", "", "", '0', 0, 0, kRead, "Bullet specific physics properties"},
    {"physics.bullet.constraints", "", "", '1', 4, 0, kRead, "Bullet constraint parameters."},
    {"physics.bullet.constraints.cfm", "double", "0", '1', 4, 0, kRead,
     "Constraint force mixing parameter. See the ODE page for more information."},
    {"physics.bullet.constraints.contact_surface_layer", "double", "0.001", '1', 4, 0, kRead,
     "The depth of the surface layer around all geometry objects. Contacts are allowed to sink into the surface layer "
     "up to the given depth before coming to rest. The default value is zero. Increasing this to some small value "
     "(e.g. 0.001) can help prevent jittering problems due to contacts being repeatedly made and broken."},
    {"physics.bullet.constraints.erp", "double", "0.2", '1', 4, 0, kRead,
     "Error reduction parameter. See the ODE page for more information."},
    {"physics.bullet.constraints.split_impulse", "bool", "true", '1', 4, 0, kRead,
     "Similar to ODE's max_vel implementation. See "
     "http://web.archive.org/web/20120430155635/http://bulletphysics.org/mediawiki-1.5.8/index.php/"
     "BtContactSolverInfo#Split_Impulse for more information."},
    {"physics.bullet.constraints.split_impulse_penetration_threshold", "double", "-0.01", '1', 4, 0, kRead,
     "Similar to ODE's max_vel implementation. See "
     "http://web.archive.org/web/20120430155635/http://bulletphysics.org/mediawiki-1.5.8/index.php/"
     "BtContactSolverInfo#Split_Impulse for more information."},
    {"physics.bullet.solver", "", "", '1', 4, 0, kRead, ""},
    {"physics.bullet.solver.iters", "int", "50", '1', 4, 0, kRead,
     "Number of iterations for each step. A higher number produces greater accuracy at a performance cost."},
    {"physics.bullet.solver.min_step_size", "double", "0.0001", '0', 4, 0, kRead,
     "The time duration which advances with each iteration of the dynamics engine, this has to be no bigger than "
     "max_step_size under physics block. If left unspecified, min_step_size defaults to max_step_size."},
    {"physics.bullet.solver.sor", "double", "1.3", '1', 4, 0, kRead, "Set the successive over-relaxation parameter."},
    {"physics.bullet.solver.type", "string", "sequential_impulse", '1', 4, 0, kRead,
     "One of the following types: sequential_impulse only."},
    {"physics.dart", "", "", '0', 6, 0, kRead, "DART specific physics properties"},
    {"physics.dart.collision_detector", "string", "fcl", '0', 6, 0, kRead,
     "Specify collision detector for DART to use. Can be dart, fcl, bullet or ode."},
    {"physics.dart.solver", "", "", '1', 6, 0, kRead, ""},
    {"physics.dart.solver.solver_type", "string", "dantzig", '1', 6, 0, kRead,
     "One of the following types: pgs, dantzig. PGS stands for Projected Gauss-Seidel."},
    {"physics.gravity", "vector3", "0 0 -9.8", '1', 0, 6, kRead,
     "The gravity vector in m/s^2, expressed in a coordinate frame defined by the spherical_coordinates tag."},
    {"physics.magnetic_field", "vector3", "5.5645e-6 22.8758e-6 -42.3884e-6", '1', 5, 6, kRead,
     "The magnetic vector in Tesla, expressed in a coordinate frame defined by the spherical_coordinates tag."},
    {"physics.max_contacts", "int", "20", '0', 0, 0, kRead,
     "Maximum number of contacts allowed between two entities. This value can be over ridden by a max_contacts element "
     "in a collision element."},
    {"physics.max_step_size", "double", "0.001", '1', 4, 0, kRead,
     "Maximum time step size at which every system in simulation can interact with the states of the world. (was "
     "physics.sdf's dt)."},
    {"physics.ode", "", "", '0', 0, 0, kRead, "ODE specific physics properties"},
    {"physics.ode.constraints", "", "", '1', 0, 0, kRead, "ODE constraint parameters."},
    {"physics.ode.constraints.cfm", "double", "0", '1', 2, 0, kRead,
     "Constraint force mixing parameter. See the ODE page for more information."},
    {"physics.ode.constraints.contact_max_correcting_vel", "double", "100.0", '1', 2, 0, kRead,
     "The maximum correcting velocities allowed when resolving contacts."},
    {"physics.ode.constraints.contact_surface_layer", "double", "0.001", '1', 2, 0, kRead,
     "The depth of the surface layer around all geometry objects. Contacts are allowed to sink into the surface layer "
     "up to the given depth before coming to rest. The default value is zero. Increasing this to some small value "
     "(e.g. 0.001) can help prevent jittering problems due to contacts being repeatedly made and broken."},
    {"physics.ode.constraints.erp", "double", "0.2", '1', 2, 0, kRead,
     "Error reduction parameter. See the ODE page for more information."},
    {"physics.ode.solver", "", "", '1', 0, 0, kRead, ""},
    {"physics.ode.solver.friction_model", "string", "pyramid_model", '0', 6, 0, kRead,
     "Name of ODE friction model to use. Valid values include: pyramid_model: (default) friction forces limited in two "
     "directions in proportion to normal force. box_model: friction forces limited to constant in two directions. "
     "cone_model: friction force magnitude limited in proportion to normal force. See gazebo pull request 1522 for the "
     "implementation of this feature. "
     "https://osrf-migration.github.io/gazebo-gh-pages/#!/osrf/gazebo/pull-request/1522 "
     "https://github.com/osrf/gazebo/commit/968dccafdfbfca09c9b3326f855612076fed7e6f"},
    {"physics.ode.solver.island_threads", "int", "0", '0', 6, 0, kRead,
     "Number of threads to use for \"islands\" of disconnected models."},
    {"physics.ode.solver.iters", "int", "50", '1', 2, 0, kRead,
     "Number of iterations for each step. A higher number produces greater accuracy at a performance cost."},
    {"physics.ode.solver.min_step_size", "double", "0.0001", '0', 4, 0, kRead,
     "The time duration which advances with each iteration of the dynamics engine, this has to be no bigger than "
     "max_step_size under physics block. If left unspecified, min_step_size defaults to max_step_size."},
    {"physics.ode.solver.precon_iters", "int", "0", '0', 2, 0, kRead, "Experimental parameter."},
    {"physics.ode.solver.sor", "double", "1.3", '1', 2, 0, kRead, "Set the successive over-relaxation parameter."},
    {"physics.ode.solver.thread_position_correction", "bool", "false", '0', 6, 0, kRead,
     "Flag to use threading to speed up position correction computation."},
    {"physics.ode.solver.type", "string", "quick", '1', 2, 0, kRead, "One of the following types: world, quick"},
    {"physics.ode.solver.use_dynamic_moi_rescaling", "bool", "false", '1', 4, 0, kRead,
     "Flag to enable dynamic rescaling of moment of inertia in constrained directions. See gazebo pull request 1114 "
     "for the implementation of this feature. "
     "https://osrf-migration.github.io/gazebo-gh-pages/#!/osrf/gazebo/pull-request/1114"},
    {"physics.real_time_factor", "double", "1.0", '1', 4, 0, kRead,
     "target simulation speedup factor, defined by ratio of simulation time to real-time."},
    {"physics.real_time_update_rate", "double", "1000", '1', 4, 0, kRead,
     "Rate at which to update the physics engine (UpdatePhysics calls per real-time second). (was physics.sdf's "
     "update_rate)."},
    {"physics.simbody", "", "", '0', 4, 0, kRead, "Simbody specific physics properties"},
    {"physics.simbody.accuracy", "double", "1e-3", '0', 4, 0, kRead,
     "Roughly the relative error of the system. -LOG(accuracy) is roughly the number of significant digits."},
    {"physics.simbody.contact", "", "", '0', 4, 0, kRead,
     "Relationship among dissipation, coef. restitution, etc. d = dissipation coefficient (1/velocity) vc = capture "
     "velocity (velocity where e=e_max) vp = plastic velocity (smallest v where e=e_min) > vc Assume real COR=1 when "
     "v=0. e_min = given minimum COR, at v >= vp (a.k.a. plastic_coef_restitution) d = slope = (1-e_min)/vp OR, e_min "
     "= 1 - d*vp e_max = maximum COR = 1-d*vc, reached at v=vc e = 0, v <= vc = 1 - d*v, vc < v < vp = e_min, v >= vp "
     "dissipation factor = d*min(v,vp) [compliant] cor = e [rigid] Combining rule e = 0, e1==e2==0 = 2*e1*e2/(e1+e2), "
     "otherwise"},
    {"physics.simbody.contact.dissipation", "double", "100", '0', 4, 0, kRead,
     "dissipation coefficient to be used in compliant contact; if not given it is (1-min_cor)/plastic_impact_velocity"},
    {"physics.simbody.contact.dynamic_friction", "double", "0.9", '0', 4, 0, kRead,
     "dynamic friction (mu_d) as described by this plot: http://gazebosim.org/wiki/File:Stribeck_friction.png"},
    {"physics.simbody.contact.override_impact_capture_velocity", "double", "0.001", '0', 4, 0, kRead,
     "for rigid impacts only, impact velocity at which COR is set to zero; normally inherited from global default but "
     "can be overridden here. Combining rule: use larger velocity"},
    {"physics.simbody.contact.override_stiction_transition_velocity", "double", "0.001", '0', 4, 0, kRead,
     "This is the largest slip velocity at which we'll consider a transition to stiction. Normally inherited from a "
     "global default setting. For a continuous friction model this is the velocity at which the max static friction "
     "force is reached. Combining rule: use larger velocity"},
    {"physics.simbody.contact.plastic_coef_restitution", "double", "0.5", '0', 4, 0, kRead,
     "this is the COR to be used at high velocities for rigid impacts; if not given it is 1 - "
     "dissipation*plastic_impact_velocity"},
    {"physics.simbody.contact.plastic_impact_velocity", "double", "0.5", '0', 4, 0, kRead,
     "smallest impact velocity at which min COR is reached; set to zero if you want the min COR always to be used"},
    {"physics.simbody.contact.static_friction", "double", "0.9", '0', 4, 0, kRead,
     "static friction (mu_s) as described by this plot: http://gazebosim.org/wiki/File:Stribeck_friction.png"},
    {"physics.simbody.contact.stiffness", "double", "1e8", '0', 4, 0, kRead,
     "Default contact material stiffness (force/dist or torque/radian)."},
    {"physics.simbody.contact.viscous_friction", "double", "0.0", '0', 4, 0, kRead,
     "viscous friction (mu_v) with units of (1/velocity) as described by this plot: "
     "http://gazebosim.org/wiki/File:Stribeck_friction.png"},
    {"physics.simbody.max_transient_velocity", "double", "0.01", '0', 4, 0, kRead,
     "Tolerable \"slip\" velocity allowed by the solver when static friction is supposed to hold object in place."},
    {"physics.simbody.min_step_size", "double", "0.0001", '0', 4, 0, kRead,
     "(Currently not used in simbody) The time duration which advances with each iteration of the dynamics engine, "
     "this has to be no bigger than max_step_size under physics block. If left unspecified, min_step_size defaults to "
     "max_step_size."},
    {"plugin", "", "", '1', 0, 0, kRead,
     "A plugin is a dynamically loaded chunk of code. It can exist as a child of world, model, and sensor."},
    {"plugin@filename", "string", "", '1', 0, 0, kRead,
     "Name of the shared library to load. If the filename is not a full path name, the file will be searched for in "
     "the configuration paths."},
    {"plugin@name", "string", "", '1', 0, 0, kRead, "A unique name for the plugin, scoped to its parent."},
    {"plugin.*", "", "", '*', 0, 0, kKept,
     "This is a special element that should not be specified in an SDFormat file. It automatically copies child "
     "elements into the SDFormat element so that a plugin can access the data."},
    {"population", "", "", '1', 5, 0, kPassed,
     "The population element defines how and where a set of models will be automatically populated in Gazebo."},
    {"population@name", "string", "", '1', 5, 0, kPassed,
     "A unique name for the population. This name must not match another population in the world."},
    {"population.box", "+box", "", '0', 5, 0, kPassed, ""},
    {"population.cylinder", "+cylinder", "", '0', 5, 0, kPassed, ""},
    {"population.distribution", "", "", '1', 5, 0, kPassed,
     "Specifies the type of object distribution and its optional parameters."},
    {"population.distribution.cols", "int", "1", '0', 5, 0, kPassed, "Number of columns in the grid."},
    {"population.distribution.rows", "int", "1", '0', 5, 0, kPassed, "Number of rows in the grid."},
    {"population.distribution.step", "vector3", "0.5 0.5 0", '0', 5, 0, kPassed,
     "Distance between elements of the grid."},
    {"population.distribution.type", "string", "random", '1', 5, 0, kPassed,
     "Define how the objects will be placed in the specified region. - random: Models placed at random. - uniform: "
     "Models approximately placed in a 2D grid pattern with control over the number of objects. - grid: Models evenly "
     "placed in a 2D grid pattern. The number of objects is not explicitly specified, it is based on the number of "
     "rows and columns of the grid. - linear-x: Models evently placed in a row along the global x-axis. - linear-y: "
     "Models evently placed in a row along the global y-axis. - linear-z: Models evently placed in a row along the "
     "global z-axis."},
    {"population.frame", "+frame", "", '*', 5, 7, kPassed, ""},
    {"population.model", "+model", "", '1', 5, 0, kPassed, ""},
    {"population.model_count", "int", "1", '1', 5, 0, kPassed, "The number of models to place."},
    {"population.pose", "+pose", "", '0', 5, 0, kPassed, ""},
    {"road", "", "", '1', 0, 0, kPassed, ""},
    {"road@name", "string", "", '1', 0, 0, kPassed, "Name of the road"},
    {"road.material", "+material", "", '0', 5, 0, kPassed, ""},
    {"road.point", "vector3", "0 0 0", '+', 0, 0, kPassed, "A series of points that define the path of the road."},
    {"road.width", "double", "1.0", '1', 0, 0, kPassed, "Width of the road"},
    {"scene", "", "", '1', 0, 0, kRead, "Specifies the look of the environment."},
    {"scene.ambient", "color", "0.4 0.4 0.4 1.0", '1', 0, 0, kRead, "Color of the ambient light."},
    {"scene.background", "color", ".7 .7 .7 1", '1', 0, 0, kRead, "Color of the background."},
    {"scene.fog", "", "", '0', 0, 0, kRead, "Controls fog"},
    {"scene.fog.color", "color", "1 1 1 1", '0', 2, 0, kRead, "Fog color"},
    {"scene.fog.density", "double", "1.0", '0', 2, 0, kRead, "Density of fog"},
    {"scene.fog.end", "double", "100.0", '0', 2, 0, kRead, "Distance to end of fog"},
    {"scene.fog.start", "double", "1.0", '0', 2, 0, kRead, "Distance to start of fog"},
    {"scene.fog.type", "string", "none", '0', 2, 0, kRead, "Fog type: constant, linear, quadratic"},
    {"scene.grid", "bool", "true", '0', 0, 0, kRead, "Enable/disable the grid"},
    {"scene.origin_visual", "bool", "true", '0', 5, 0, kRead, "Show/hide world origin indicator"},
    {"scene.shadows", "bool", "true", '1', 0, 0, kRead, "Enable/disable shadows"},
    {"scene.sky", "", "", '0', 2, 0, kRead, "Properties for the sky"},
    {"scene.sky.clouds", "", "", '0', 2, 0, kRead, "Sunset time [0..24]"},
    {"scene.sky.clouds.ambient", "color", ".8 .8 .8 1", '0', 2, 0, kRead, "Ambient cloud color"},
    {"scene.sky.clouds.direction", "double", "0.0", '0', 2, 0, kRead, "Direction of the cloud movement"},
    {"scene.sky.clouds.humidity", "double", "0.5", '0', 2, 0, kRead, "Density of clouds"},
    {"scene.sky.clouds.mean_size", "double", "0.5", '0', 2, 0, kRead, "Average size of the clouds"},
    {"scene.sky.clouds.speed", "double", "0.6", '0', 2, 0, kRead, "Speed of the clouds"},
    {"scene.sky.sunrise", "double", "6.0", '0', 2, 0, kRead, "Sunrise time [0..24]"},
    {"scene.sky.sunset", "double", "20.0", '0', 2, 0, kRead, "Sunset time [0..24]"},
    {"scene.sky.time", "double", "10.0", '0', 2, 0, kRead, "Time of day [0..24]"},
    {"sdf", "", "", '1', 0, 0, kRead,
     "SDFormat base element that can include one model, actor, light, or worlds. A user of multiple worlds could run "
     "parallel instances of simulation, or offer selection of a world at runtime."},
    {"sdf@version", "string", "1.9", '1', 0, 0, kRead, "Version number of the SDFormat specification."},
    {"sdf.actor", "+actor", "", '0', 0, 0, kRead, ""},
    {"sdf.light", "+light", "", '0', 0, 0, kRead, ""},
    {"sdf.model", "+model", "", '0', 0, 0, kRead, ""},
    {"sdf.world", "+world", "", '*', 0, 0, kRead, ""},
    {"spherical_coordinates", "", "", '1', 4, 0, kRead, ""},
    {"spherical_coordinates.elevation", "double", "0.0", '1', 4, 0, kRead,
     "Elevation of origin of gazebo reference frame, specified in meters."},
    {"spherical_coordinates.heading_deg", "double", "0.0", '1', 4, 0, kRead,
     "Heading offset of gazebo reference frame, measured as angle between Gazebo world frame and the "
     "world_frame_orientation type. The direction of rotation follows the right-hand rule, so a positive angle "
     "indicates clockwise rotation (from east to north) when viewed from top-down. Note that this is not consistent "
     "with compass heading convention. The angle is specified in degrees."},
    {"spherical_coordinates.latitude_deg", "double", "0.0", '1', 4, 0, kRead,
     "Geodetic latitude at origin of gazebo reference frame, specified in units of degrees."},
    {"spherical_coordinates.longitude_deg", "double", "0.0", '1', 4, 0, kRead,
     "Longitude at origin of gazebo reference frame, specified in units of degrees."},
    {"spherical_coordinates.surface_model", "string", "EARTH_WGS84", '1', 4, 0, kRead,
     "Name of planetary surface model, used to determine the surface altitude at a given latitude and longitude. The "
     "default is an ellipsoid model of the earth based on the WGS-84 standard. It is used in Gazebo's GPS sensor "
     "implementation."},
    {"spherical_coordinates.world_frame_orientation", "string", "ENU", '0', 6, 0, kRead,
     "This field identifies how Gazebo world frame is aligned in Geographical sense. The final Gazebo world frame "
     "orientation is obtained by rotating a frame aligned with following notation by the field heading_deg. Options "
     "are: - ENU (East-North-Up)"},
    {"state", "", "", '1', 0, 0, kPassed, ""},
    {"state@world_name", "string", "", '1', 0, 0, kPassed, "Name of the world this state applies to"},
    {"state.deletions", "", "", '0', 3, 0, kPassed, "A list of names of deleted entities/"},
    {"state.deletions.name", "string", "", '+', 3, 0, kPassed, "The name of a deleted entity."},
    {"state.insertions", "", "", '0', 3, 0, kPassed, "A list containing the entire description of entities inserted."},
    {"state.insertions.light", "+light", "", '+', 6, 0, kPassed, ""},
    {"state.insertions.model", "+model", "", '+', 3, 0, kPassed, ""},
    {"state.iterations", "unsigned int", "0", '1', 5, 0, kPassed, "Number of simulation iterations."},
    {"state.light", "+light_state", "", '*', 5, 0, kPassed, ""},
    {"state.model", "+model_state", "", '*', 0, 0, kPassed, ""},
    {"state.real_time", "time", "0 0", '0', 3, 0, kPassed, "Real time stamp of the state [seconds nanoseconds]"},
    {"state.sim_time", "time", "0 0", '0', 3, 0, kPassed, "Simulation time stamp of the state [seconds nanoseconds]"},
    {"state.wall_time", "time", "0 0", '0', 3, 0, kPassed, "Wall time stamp of the state [seconds nanoseconds]"},
    {"world", "", "", '1', 0, 0, kRead,
     "The world element encapsulates an entire world description including: models, scene, physics, and plugins."},
    {"world@name", "string", "", '1', 0, 0, kRead, "Unique name of the world"},
    {"world.actor", "+actor", "", '*', 0, 0, kRead, ""},
    {"world.atmosphere", "+atmosphere", "", '1', 6, 0, kRead, ""},
    {"world.audio", "", "", '0', 4, 0, kPassed, "Global audio properties."},
    {"world.audio.device", "string", "default", '1', 4, 0, kPassed,
     "Device to use for audio playback. A value of \"default\" will use the system's default audio device. Otherwise, "
     "specify a an audio device file\""},
    {"world.frame", "+frame", "", '*', 7, 0, kRead, ""},
    {"world.gravity", "vector3", "0 0 -9.8", '1', 6, 0, kRead,
     "The gravity vector in m/s^2, expressed in a coordinate frame defined by the spherical_coordinates tag."},
    {"world.gui", "+gui", "", '0', 0, 0, kKept, ""},
    {"world.include", "", "", '*', 4, 0, kRead,
     "Include resources from a URI. Included resources can only contain one 'model', 'light' or 'actor' element. The "
     "URI can point to a directory or a file. If the URI is a directory, it must conform to the model database "
     "structure (see /tutorials?tut=composition&cat=specification&#defining-models-in-separate-files)."},
    {"world.include.name", "string", "", '0', 5, 0, kRead, "Override the name of the included entity."},
    {"world.include.placement_frame", "string", "", '0', 8, 0, kRead,
     "The frame inside the included entity whose pose will be set by the specified pose element. If this element is "
     "specified, the pose must be specified."},
    {"world.include.plugin", "+plugin", "", '*', 5, 0, kRead, ""},
    {"world.include.pose", "+pose", "", '0', 5, 0, kRead, ""},
    {"world.include.static", "bool", "false", '0', 5, 0, kRead, "Override the static value of the included entity."},
    {"world.include.uri", "string", "", '1', 4, 0, kRead, "URI to a resource, such as a model"},
    {"world.joint", "+joint", "", '*', 0, 0, kRead,
     "A joint between two models of the world, or a model and the world."},
    {"world.light", "+light", "", '*', 0, 0, kRead, ""},
    {"world.magnetic_field", "vector3", "5.5645e-6 22.8758e-6 -42.3884e-6", '1', 6, 0, kRead,
     "The magnetic vector in Tesla, expressed in a coordinate frame defined by the spherical_coordinates tag."},
    {"world.model", "+model", "", '*', 0, 0, kRead, ""},
    {"world.physics", "+physics", "", '+', 0, 0, kRead, ""},
    {"world.plugin", "+plugin", "", '*', 0, 0, kRead, ""},
    {"world.population", "+population", "", '*', 5, 0, kPassed, ""},
    {"world.road", "+road", "", '*', 0, 0, kPassed, ""},
    {"world.scene", "+scene", "", '1', 0, 0, kRead, ""},
    {"world.spherical_coordinates", "+spherical_coordinates", "", '0', 4, 0, kRead, ""},
    {"world.state", "+state", "", '*', 0, 0, kPassed, ""},
    {"world.wind", "", "", '0', 6, 0, kRead, "The wind tag specifies the type and properties of the wind."},
    {"world.wind.linear_velocity", "vector3", "0 0 0", '0', 6, 0, kRead, "Linear velocity of the wind."},
};

}  // namespace

std::span<const SchemaRow> worldRows() { return kWorldRows; }

}  // namespace pongsim::sdf
