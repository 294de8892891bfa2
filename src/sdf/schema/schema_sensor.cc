// Descriptions taken from sdformat 12, Copyright 2012 Open Source Robotics Foundation, Apache License 2.0.
#include "sdf/schema/schema_table.hh"

namespace pongsim::sdf {

namespace {

using enum Use;

constexpr SchemaRow kSensorRows[] = {
    {"air_pressure", "", "", '1', 6, 0, kRead, "These elements are specific to an air pressure sensor."},
    {"air_pressure.pressure", "", "", '0', 6, 0, kRead, "Noise parameters for the pressure data."},
    {"air_pressure.pressure.noise", "+noise", "", '0', 6, 0, kRead, ""},
    {"air_pressure.reference_altitude", "double", "0.0", '0', 6, 0, kRead,
     "The initial altitude in meters. This value can be used by a sensor implementation to augment the altitude of the "
     "sensor. For example, if you are using simulation instead of creating a 1000 m mountain model on which to place "
     "your sensor, you could instead set this value to 1000 and place your model on a ground plane with a Z height of "
     "zero."},
    {"altimeter", "", "", '1', 5, 0, kRead, "These elements are specific to an altimeter sensor."},
    {"altimeter.vertical_position", "", "", '0', 5, 0, kRead, "Noise parameters for vertical position"},
    {"altimeter.vertical_position.noise", "+noise", "", '0', 5, 0, kRead, ""},
    {"altimeter.vertical_velocity", "", "", '0', 5, 0, kRead, "Noise parameters for vertical velocity"},
    {"altimeter.vertical_velocity.noise", "+noise", "", '0', 5, 0, kRead, ""},
    {"contact", "", "", '1', 0, 0, kRead, "These elements are specific to the contact sensor."},
    {"contact.collision", "string", "", '1', 0, 0, kRead,
     "name of the collision element within a link that acts as the contact sensor."},
    {"contact.topic", "string", "__default_topic__", '1', 0, 0, kRead, "Topic on which contact data is published."},
    {"force_torque", "", "", '1', 4, 0, kRead, "These elements are specific to the force torque sensor."},
    {"force_torque.force", "", "", '0', 7, 0, kRead,
     "These elements are specific to measurement-frame force, which is expressed in Newtons"},
    {"force_torque.force.x", "", "", '0', 7, 0, kRead, "Force along the X axis"},
    {"force_torque.force.x.noise", "+noise", "", '0', 7, 0, kRead, ""},
    {"force_torque.force.y", "", "", '0', 7, 0, kRead, "Force along the Y axis"},
    {"force_torque.force.y.noise", "+noise", "", '0', 7, 0, kRead, ""},
    {"force_torque.force.z", "", "", '0', 7, 0, kRead, "Force along the Z axis"},
    {"force_torque.force.z.noise", "+noise", "", '0', 7, 0, kRead, ""},
    {"force_torque.frame", "string", "child", '0', 4, 0, kRead,
     "Frame in which to report the wrench values. Currently supported frames are: \"parent\" report the wrench "
     "expressed in the orientation of the parent link frame, \"child\" report the wrench expressed in the orientation "
     "of the child link frame, \"sensor\" report the wrench expressed in the orientation of the joint sensor frame. "
     "Note that for each option the point with respect to which the torque component of the wrench is expressed is the "
     "joint origin."},
    {"force_torque.measure_direction", "string", "child_to_parent", '0', 5, 0, kRead,
     "Direction of the wrench measured by the sensor. The supported options are: \"parent_to_child\" if the measured "
     "wrench is the one applied by the parent link on the child link, \"child_to_parent\" if the measured wrench is "
     "the one applied by the child link on the parent link."},
    {"force_torque.torque", "", "", '0', 7, 0, kRead,
     "These elements are specific to measurement-frame torque, which is expressed in Newton-meters"},
    {"force_torque.torque.x", "", "", '0', 7, 0, kRead, "Torque about the X axis"},
    {"force_torque.torque.x.noise", "+noise", "", '0', 7, 0, kRead, ""},
    {"force_torque.torque.y", "", "", '0', 7, 0, kRead, "Force about the Y axis"},
    {"force_torque.torque.y.noise", "+noise", "", '0', 7, 0, kRead, ""},
    {"force_torque.torque.z", "", "", '0', 7, 0, kRead, "Torque about the Z axis"},
    {"force_torque.torque.z.noise", "+noise", "", '0', 7, 0, kRead, ""},
    {"gps", "", "", '1', 4, 0, kRead, "These elements are specific to the GPS sensor."},
    {"gps.position_sensing", "", "", '0', 4, 0, kRead, "Parameters related to GPS position measurement."},
    {"gps.position_sensing.horizontal", "", "", '0', 4, 0, kRead,
     "Noise parameters for horizontal position measurement, in units of meters."},
    {"gps.position_sensing.horizontal.noise", "+noise", "", '0', 4, 0, kRead, ""},
    {"gps.position_sensing.vertical", "", "", '0', 4, 0, kRead,
     "Noise parameters for vertical position measurement, in units of meters."},
    {"gps.position_sensing.vertical.noise", "+noise", "", '0', 4, 0, kRead, ""},
    {"gps.velocity_sensing", "", "", '0', 4, 0, kRead, "Parameters related to GPS position measurement."},
    {"gps.velocity_sensing.horizontal", "", "", '0', 4, 0, kRead,
     "Noise parameters for horizontal velocity measurement, in units of meters/second."},
    {"gps.velocity_sensing.horizontal.noise", "+noise", "", '0', 4, 0, kRead, ""},
    {"gps.velocity_sensing.vertical", "", "", '0', 4, 0, kRead,
     "Noise parameters for vertical velocity measurement, in units of meters/second."},
    {"gps.velocity_sensing.vertical.noise", "+noise", "", '0', 4, 0, kRead, ""},
    {"imu", "", "", '1', 3, 0, kRead, "These elements are specific to the IMU sensor."},
    {"imu.angular_velocity", "", "", '0', 5, 0, kRead,
     "These elements are specific to body-frame angular velocity, which is expressed in radians per second"},
    {"imu.angular_velocity.x", "", "", '0', 5, 0, kRead, "Angular velocity about the X axis"},
    {"imu.angular_velocity.x.noise", "+noise", "", '0', 5, 0, kRead, ""},
    {"imu.angular_velocity.y", "", "", '0', 5, 0, kRead, "Angular velocity about the Y axis"},
    {"imu.angular_velocity.y.noise", "+noise", "", '0', 5, 0, kRead, ""},
    {"imu.angular_velocity.z", "", "", '0', 5, 0, kRead, "Angular velocity about the Z axis"},
    {"imu.angular_velocity.z.noise", "+noise", "", '0', 5, 0, kRead, ""},
    {"imu.enable_orientation", "bool", "true", '0', 6, 0, kRead,
     "Some IMU sensors rely on external filters to produce orientation estimates. True to generate and output "
     "orientation data, false to disable orientation data generation."},
    {"imu.linear_acceleration", "", "", '0', 5, 0, kRead,
     "These elements are specific to body-frame linear acceleration, which is expressed in meters per second squared"},
    {"imu.linear_acceleration.x", "", "", '0', 5, 0, kRead, "Linear acceleration about the X axis"},
    {"imu.linear_acceleration.x.noise", "+noise", "", '0', 5, 0, kRead, ""},
    {"imu.linear_acceleration.y", "", "", '0', 5, 0, kRead, "Linear acceleration about the Y axis"},
    {"imu.linear_acceleration.y.noise", "+noise", "", '0', 5, 0, kRead, ""},
    {"imu.linear_acceleration.z", "", "", '0', 5, 0, kRead, "Linear acceleration about the Z axis"},
    {"imu.linear_acceleration.z.noise", "+noise", "", '0', 5, 0, kRead, ""},
    {"imu.noise", "", "", '0', 4, 6, kRead,
     "The properties of the noise model that should be applied to generated data"},
    {"imu.noise.accel", "", "", '1', 4, 6, kRead, "Noise parameters for linear accelerations."},
    {"imu.noise.accel.bias_mean", "double", "0.0", '0', 4, 6, kRead,
     "For type \"gaussian,\" the mean of the Gaussian distribution from which bias values are drawn."},
    {"imu.noise.accel.bias_stddev", "double", "0.0", '0', 4, 6, kRead,
     "For type \"gaussian,\" the standard deviation of the Gaussian distribution from which bias values are drawn."},
    {"imu.noise.accel.mean", "double", "0.0", '0', 4, 6, kRead,
     "For type \"gaussian,\" the mean of the Gaussian distribution from which noise values are drawn."},
    {"imu.noise.accel.stddev", "double", "0.0", '0', 4, 6, kRead,
     "For type \"gaussian,\" the standard deviation of the Gaussian distribution from which noise values are drawn."},
    {"imu.noise.rate", "", "", '1', 4, 6, kRead, "Noise parameters for angular rates."},
    {"imu.noise.rate.bias_mean", "double", "0.0", '0', 4, 6, kRead,
     "For type \"gaussian,\" the mean of the Gaussian distribution from which bias values are drawn."},
    {"imu.noise.rate.bias_stddev", "double", "0.0", '0', 4, 6, kRead,
     "For type \"gaussian,\" the standard deviation of the Gaussian distribution from which bias values are drawn."},
    {"imu.noise.rate.mean", "double", "0.0", '0', 4, 6, kRead,
     "For type \"gaussian,\" the mean of the Gaussian distribution from which noise values are drawn."},
    {"imu.noise.rate.stddev", "double", "0.0", '0', 4, 6, kRead,
     "For type \"gaussian,\" the standard deviation of the Gaussian distribution from which noise values are drawn."},
    {"imu.noise.type", "string", "gaussian", '1', 4, 6, kRead,
     "The type of noise. Currently supported types are: \"gaussian\" (draw noise values independently for each beam "
     "from a Gaussian distribution)."},
    {"imu.orientation_reference_frame", "", "", '0', 6, 0, kRead, ""},
    {"imu.orientation_reference_frame.custom_rpy", "vector3", "0 0 0", '0', 6, 0, kRead,
     "This field and parent_frame are used when localization is set to CUSTOM. Orientation (fixed axis roll, pitch "
     "yaw) transform from parent_frame to this IMU's reference frame. Some common examples are: - IMU reports in its "
     "local frame on boot. IMU sensor frame is the reference frame. Example: parent_frame=\"\", custom_rpy=\"0 0 0\" - "
     "IMU reports in Gazebo world frame. Example sdf: parent_frame=\"world\", custom_rpy=\"0 0 0\" - IMU reports in "
     "NWU frame. Uses SphericalCoordinates class to determine world frame in relation to magnetic north and gravity; "
     "i.e. rotation between North-West-Up and world (+X,+Y,+Z) frame is defined by SphericalCoordinates class. Example "
     "sdf given world is NWU: parent_frame=\"world\", custom_rpy=\"0 0 0\" - IMU reports in NED frame. Uses "
     "SphericalCoordinates class to determine world frame in relation to magnetic north and gravity; i.e. rotation "
     "between North-East-Down and world (+X,+Y,+Z) frame is defined by SphericalCoordinates class. Example sdf given "
     "world is NWU: parent_frame=\"world\", custom_rpy=\"M_PI 0 0\" - IMU reports in ENU frame. Uses "
     "SphericalCoordinates class to determine world frame in relation to magnetic north and gravity; i.e. rotation "
     "between East-North-Up and world (+X,+Y,+Z) frame is defined by SphericalCoordinates class. Example sdf given "
     "world is NWU: parent_frame=\"world\", custom_rpy=\"0 0 -0.5*M_PI\" - IMU reports in ROS optical frame as "
     "described in http://www.ros.org/reps/rep-0103.html#suffix-frames, which is (z-forward, x-left to right when "
     "facing +z, y-top to bottom when facing +z). (default gazebo camera is +x:view direction, +y:left, +z:up). "
     "Example sdf: parent_frame=\"local\", custom_rpy=\"-0.5*M_PI 0 -0.5*M_PI\""},
    {"imu.orientation_reference_frame.custom_rpy@parent_frame", "string", "", '0', 6, 0, kRead,
     "Name of parent frame which the custom_rpy transform is defined relative to. It can be any valid fully scoped "
     "Gazebo Link name or the special reserved \"world\" frame. If left empty, use the sensor's own local frame."},
    {"imu.orientation_reference_frame.grav_dir_x", "vector3", "1 0 0", '0', 6, 0, kPassed,
     "Used when localization is set to GRAV_UP or GRAV_DOWN, a projection of this vector into a plane that is "
     "orthogonal to the gravity vector defines the direction of the IMU reference frame's X-axis. grav_dir_x is "
     "defined in the coordinate frame as defined by the parent_frame element."},
    {"imu.orientation_reference_frame.grav_dir_x@parent_frame", "string", "", '0', 6, 0, kPassed,
     "Name of parent frame in which the grav_dir_x vector is defined. It can be any valid fully scoped Gazebo Link "
     "name or the special reserved \"world\" frame. If left empty, use the sensor's own local frame."},
    {"imu.orientation_reference_frame.localization", "string", "CUSTOM", '1', 6, 0, kRead,
     "This string represents special hardcoded use cases that are commonly seen with typical robot IMU's: - CUSTOM: "
     "use Euler angle custom_rpy orientation specification. The orientation of the IMU's reference frame is defined by "
     "adding the custom_rpy rotation to the parent_frame. - NED: The IMU XYZ aligns with NED, where NED orientation "
     "relative to Gazebo world is defined by the SphericalCoordinates class. - ENU: The IMU XYZ aligns with ENU, where "
     "ENU orientation relative to Gazebo world is defined by the SphericalCoordinates class. - NWU: The IMU XYZ aligns "
     "with NWU, where NWU orientation relative to Gazebo world is defined by the SphericalCoordinates class. - "
     "GRAV_UP: where direction of gravity maps to IMU reference frame Z-axis with Z-axis pointing in the opposite "
     "direction of gravity. IMU reference frame X-axis direction is defined by grav_dir_x. Note if grav_dir_x is "
     "parallel to gravity direction, this configuration fails. Otherwise, IMU reference frame X-axis is defined by "
     "projection of grav_dir_x onto a plane normal to the gravity vector. IMU reference frame Y-axis is a vector "
     "orthogonal to both X and Z axis following the right hand rule. - GRAV_DOWN: where direction of gravity maps to "
     "IMU reference frame Z-axis with Z-axis pointing in the direction of gravity. IMU reference frame X-axis "
     "direction is defined by grav_dir_x. Note if grav_dir_x is parallel to gravity direction, this configuration "
     "fails. Otherwise, IMU reference frame X-axis is defined by projection of grav_dir_x onto a plane normal to the "
     "gravity vector. IMU reference frame Y-axis is a vector orthogonal to both X and Z axis following the right hand "
     "rule."},
    {"imu.topic", "string", "__default_topic__", '0', 3, 7, kPassed,
     "Topic on which data is published. DEPRECATED. Use the topic element that is a child of the sensor element."},
    {"lidar", "", "", '1', 6, 0, kRead, "These elements are specific to the lidar sensor."},
    {"lidar.noise", "", "", '0', 6, 0, kRead,
     "The properties of the noise model that should be applied to generated scans"},
    {"lidar.noise.mean", "double", "0.0", '0', 6, 0, kRead,
     "For type \"gaussian,\" the mean of the Gaussian distribution from which noise values are drawn."},
    {"lidar.noise.stddev", "double", "0.0", '0', 6, 0, kRead,
     "For type \"gaussian,\" the standard deviation of the Gaussian distribution from which noise values are drawn."},
    {"lidar.noise.type", "string", "gaussian", '1', 6, 0, kRead,
     "The type of noise. Currently supported types are: \"gaussian\" (draw noise values independently for each beam "
     "from a Gaussian distribution)."},
    {"lidar.range", "", "", '1', 6, 0, kRead, "specifies range properties of each simulated lidar"},
    {"lidar.range.max", "double", "0", '1', 6, 0, kRead, "The maximum distance for each lidar ray."},
    {"lidar.range.min", "double", "0", '1', 6, 0, kRead, "The minimum distance for each lidar ray."},
    {"lidar.range.resolution", "double", "0", '0', 6, 0, kRead, "Linear resolution of each lidar ray."},
    {"lidar.scan", "", "", '1', 6, 0, kRead, ""},
    {"lidar.scan.horizontal", "", "", '1', 6, 0, kRead, ""},
    {"lidar.scan.horizontal.max_angle", "double", "0", '1', 6, 0, kRead, "Must be greater or equal to min_angle"},
    {"lidar.scan.horizontal.min_angle", "double", "0", '1', 6, 0, kRead, ""},
    {"lidar.scan.horizontal.resolution", "double", "1", '1', 6, 0, kRead,
     "This number is multiplied by samples to determine the number of range data points returned. If resolution is not "
     "equal to one, range data is interpolated."},
    {"lidar.scan.horizontal.samples", "unsigned int", "640", '1', 6, 0, kRead,
     "The number of simulated lidar rays to generate per complete laser sweep cycle."},
    {"lidar.scan.vertical", "", "", '0', 6, 0, kRead, ""},
    {"lidar.scan.vertical.max_angle", "double", "0", '1', 6, 0, kRead, "Must be greater or equal to min_angle"},
    {"lidar.scan.vertical.min_angle", "double", "0", '1', 6, 0, kRead, ""},
    {"lidar.scan.vertical.resolution", "double", "1", '0', 6, 0, kRead,
     "This number is multiplied by samples to determine the number of range data points returned. If resolution is not "
     "equal to one, range data is interpolated."},
    {"lidar.scan.vertical.samples", "unsigned int", "1", '1', 6, 0, kRead,
     "The number of simulated lidar rays to generate per complete laser sweep cycle."},
    {"lidar.visibility_mask", "unsigned int", "4294967295", '0', 9, 0, kRead,
     "Visibility mask of a lidar. When (lidar's visibility_mask & visual's visibility_flags) evaluates to non-zero, "
     "the visual will be visible to the lidar."},
    {"logical_camera", "", "", '1', 5, 0, kRead,
     "These elements are specific to logical camera sensors. A logical camera reports objects that fall within a "
     "frustum. Computation should be performed on the CPU."},
    {"logical_camera.aspect_ratio", "double", "1", '1', 5, 0, kRead,
     "Aspect ratio of the near and far planes. This is the width divided by the height of the near or far planes."},
    {"logical_camera.far", "double", "1", '1', 5, 0, kRead, "Far clipping distance of the view frustum"},
    {"logical_camera.horizontal_fov", "double", "1", '1', 5, 0, kRead,
     "Horizontal field of view of the frustum, in radians. This is the angle between the frustum's vertex and the "
     "edges of the near or far plane."},
    {"logical_camera.near", "double", "0", '1', 5, 0, kRead, "Near clipping distance of the view frustum"},
    {"magnetometer", "", "", '1', 5, 0, kRead, "These elements are specific to a Magnetometer sensor."},
    {"magnetometer.x", "", "", '0', 5, 0, kRead, "Parameters related to the body-frame X axis of the magnetometer"},
    {"magnetometer.x.noise", "+noise", "", '0', 5, 0, kRead, ""},
    {"magnetometer.y", "", "", '0', 5, 0, kRead, "Parameters related to the body-frame Y axis of the magnetometer"},
    {"magnetometer.y.noise", "+noise", "", '0', 5, 0, kRead, ""},
    {"magnetometer.z", "", "", '0', 5, 0, kRead, "Parameters related to the body-frame Z axis of the magnetometer"},
    {"magnetometer.z.noise", "+noise", "", '0', 5, 0, kRead, ""},
    {"navsat", "", "", '1', 7, 0, kRead, "These elements are specific to the NavSat sensor."},
    {"navsat.position_sensing", "", "", '0', 7, 0, kRead, "Parameters related to NavSat position measurement."},
    {"navsat.position_sensing.horizontal", "", "", '0', 7, 0, kRead,
     "Noise parameters for horizontal position measurement, in units of meters."},
    {"navsat.position_sensing.horizontal.noise", "+noise", "", '0', 7, 0, kRead, ""},
    {"navsat.position_sensing.vertical", "", "", '0', 7, 0, kRead,
     "Noise parameters for vertical position measurement, in units of meters."},
    {"navsat.position_sensing.vertical.noise", "+noise", "", '0', 7, 0, kRead, ""},
    {"navsat.velocity_sensing", "", "", '0', 7, 0, kRead, "Parameters related to NavSat position measurement."},
    {"navsat.velocity_sensing.horizontal", "", "", '0', 7, 0, kRead,
     "Noise parameters for horizontal velocity measurement, in units of meters/second."},
    {"navsat.velocity_sensing.horizontal.noise", "+noise", "", '0', 7, 0, kRead, ""},
    {"navsat.velocity_sensing.vertical", "", "", '0', 7, 0, kRead,
     "Noise parameters for vertical velocity measurement, in units of meters/second."},
    {"navsat.velocity_sensing.vertical.noise", "+noise", "", '0', 7, 0, kRead, ""},
    {"noise", "", "", '1', 4, 0, kRead, "The properties of a sensor noise model."},
    {"noise@type", "string", "none", '1', 4, 0, kRead,
     "The type of noise. Currently supported types are: \"none\" (no noise). \"gaussian\" (draw noise values "
     "independently for each measurement from a Gaussian distribution). \"gaussian_quantized\" (\"gaussian\" plus "
     "quantization of outputs (ie. rounding))"},
    {"noise.bias_mean", "double", "0.0", '0', 4, 0, kRead,
     "For type \"gaussian*\", the mean of the Gaussian distribution from which bias values are drawn."},
    {"noise.bias_stddev", "double", "0.0", '0', 4, 0, kRead,
     "For type \"gaussian*\", the standard deviation of the Gaussian distribution from which bias values are drawn."},
    {"noise.dynamic_bias_correlation_time", "double", "0.0", '0', 6, 0, kRead,
     "For type \"gaussian*\", the correlation time in seconds of the noise used to drive a process to model slow "
     "variations in a sensor bias. A typical value, when used, would be on the order of 3600 seconds (1 hour)."},
    {"noise.dynamic_bias_stddev", "double", "0.0", '0', 6, 0, kRead,
     "For type \"gaussian*\", the standard deviation of the noise used to drive a process to model slow variations in "
     "a sensor bias."},
    {"noise.mean", "double", "0.0", '0', 4, 0, kRead,
     "For type \"gaussian*\", the mean of the Gaussian distribution from which noise values are drawn."},
    {"noise.precision", "double", "0.0", '0', 4, 0, kRead,
     "For type \"gaussian_quantized\", the precision of output signals. A value of zero implies infinite precision / "
     "no quantization."},
    {"noise.stddev", "double", "0.0", '0', 4, 0, kRead,
     "For type \"gaussian*\", the standard deviation of the Gaussian distribution from which noise values are drawn."},
    {"ray", "", "", '1', 0, 0, kRead, "These elements are specific to the ray (laser) sensor."},
    {"ray.noise", "", "", '0', 4, 0, kRead,
     "The properties of the noise model that should be applied to generated scans"},
    {"ray.noise.mean", "double", "0.0", '0', 4, 0, kRead,
     "For type \"gaussian,\" the mean of the Gaussian distribution from which noise values are drawn."},
    {"ray.noise.stddev", "double", "0.0", '0', 4, 0, kRead,
     "For type \"gaussian,\" the standard deviation of the Gaussian distribution from which noise values are drawn."},
    {"ray.noise.type", "string", "gaussian", '1', 4, 0, kRead,
     "The type of noise. Currently supported types are: \"gaussian\" (draw noise values independently for each beam "
     "from a Gaussian distribution)."},
    {"ray.range", "", "", '1', 0, 0, kRead, "specifies range properties of each simulated ray"},
    {"ray.range.max", "double", "0", '1', 2, 0, kRead, "The maximum distance for each ray."},
    {"ray.range.min", "double", "0", '1', 2, 0, kRead, "The minimum distance for each ray."},
    {"ray.range.resolution", "double", "0", '0', 2, 0, kRead, "Linear resolution of each ray."},
    {"ray.scan", "", "", '1', 0, 0, kRead, ""},
    {"ray.scan.horizontal", "", "", '1', 0, 0, kRead, ""},
    {"ray.scan.horizontal.max_angle", "double", "0", '1', 2, 0, kRead, "Must be greater or equal to min_angle"},
    {"ray.scan.horizontal.min_angle", "double", "0", '1', 2, 0, kRead, ""},
    {"ray.scan.horizontal.resolution", "double", "1", '1', 2, 0, kRead,
     "This number is multiplied by samples to determine the number of range data points returned. If resolution is "
     "less than one, range data is interpolated. If resolution is greater than one, range data is averaged."},
    {"ray.scan.horizontal.samples", "unsigned int", "640", '1', 2, 0, kRead,
     "The number of simulated rays to generate per complete laser sweep cycle."},
    {"ray.scan.vertical", "", "", '0', 0, 0, kRead, ""},
    {"ray.scan.vertical.max_angle", "double", "0", '1', 2, 0, kRead, "Must be greater or equal to min_angle"},
    {"ray.scan.vertical.min_angle", "double", "0", '1', 2, 0, kRead, ""},
    {"ray.scan.vertical.resolution", "double", "1", '0', 2, 0, kRead,
     "This number is multiplied by samples to determine the number of range data points returned. If resolution is "
     "less than one, range data is interpolated. If resolution is greater than one, range data is averaged."},
    {"ray.scan.vertical.samples", "unsigned int", "1", '1', 2, 0, kRead,
     "The number of simulated rays to generate per complete laser sweep cycle."},
    {"ray.visibility_mask", "unsigned int", "4294967295", '0', 9, 0, kRead,
     "Visibility mask of a lidar. When (lidar's visibility_mask & visual's visibility_flags) evaluates to non-zero, "
     "the visual will be visible to the lidar."},
    {"rfid", "", "", '1', 0, 0, kRead, ""},
    {"rfidtag", "", "", '1', 0, 0, kRead, ""},
    {"sensor", "", "", '1', 0, 0, kRead, "The sensor tag describes the type and properties of a sensor."},
    {"sensor@name", "string", "", '1', 0, 0, kRead,
     "A unique name for the sensor. This name must not match another model in the model."},
    {"sensor@type", "string", "", '1', 0, 0, kRead,
     "The type name of the sensor. By default, SDFormat supports types air_pressure, altimeter, camera, contact, "
     "boundingbox_camera, boundingbox, custom, depth_camera, depth, force_torque, gps, gpu_lidar, gpu_ray, imu, lidar, "
     "logical_camera, magnetometer, multicamera, navsat, ray, rfid, rfidtag, rgbd_camera, rgbd, segmentation_camera, "
     "segmentation, sonar, thermal_camera, thermal, wireless_receiver, and wireless_transmitter. The \"ray\", "
     "\"gpu_ray\", and \"gps\" types are equivalent to \"lidar\", \"gpu_lidar\", and \"navsat\", respectively. It is "
     "preferred to use \"lidar\", \"gpu_lidar\", and \"navsat\" since \"ray\", \"gpu_ray\", and \"gps\" will be "
     "deprecated. The \"ray\", \"gpu_ray\", and \"gps\" types are maintained for legacy support."},
    {"sensor.air_pressure", "+air_pressure", "", '0', 6, 0, kRead, ""},
    {"sensor.altimeter", "+altimeter", "", '0', 5, 0, kRead, ""},
    {"sensor.always_on", "bool", "false", '0', 2, 0, kRead,
     "If true the sensor will always be updated according to the update rate."},
    {"sensor.camera", "+camera", "", '0', 0, 0, kRead, ""},
    {"sensor.contact", "+contact", "", '0', 0, 0, kRead, ""},
    {"sensor.enable_metrics", "bool", "false", '0', 7, 0, kRead,
     "If true, the sensor will publish performance metrics"},
    {"sensor.force_torque", "+force_torque", "", '0', 4, 0, kRead, ""},
    {"sensor.frame", "+frame", "", '*', 5, 7, kPassed, ""},
    {"sensor.gps", "+gps", "", '0', 4, 0, kRead, ""},
    {"sensor.gz_frame_id", "string", "", '0', 0, 0, kRead, "The later name of ignition_frame_id."},
    {"sensor.ignition_frame_id", "string", "", '0', 0, 0, kRead,
     "Name of the frame in the sensor's messages. Fortress reads it, although SDF 1.9 does not define it."},
    {"sensor.imu", "+imu", "", '0', 3, 0, kRead, ""},
    {"sensor.lidar", "+lidar", "", '0', 6, 0, kRead, ""},
    {"sensor.logical_camera", "+logical_camera", "", '0', 5, 0, kRead, ""},
    {"sensor.magnetometer", "+magnetometer", "", '0', 5, 0, kRead, ""},
    {"sensor.navsat", "+navsat", "", '0', 7, 0, kRead, ""},
    {"sensor.plugin", "+plugin", "", '*', 0, 0, kRead, ""},
    {"sensor.pose", "+pose", "", '0', 2, 0, kRead, ""},
    {"sensor.ray", "+ray", "", '0', 0, 0, kRead, ""},
    {"sensor.rfid", "+rfid", "", '0', 0, 0, kRead, ""},
    {"sensor.rfidtag", "+rfidtag", "", '0', 0, 0, kRead, ""},
    {"sensor.sonar", "+sonar", "", '0', 4, 0, kRead, ""},
    {"sensor.topic", "string", "", '0', 0, 0, kRead,
     "Name of the topic on which data is published. This is necessary for visualization"},
    {"sensor.transceiver", "+transceiver", "", '0', 4, 0, kRead, ""},
    {"sensor.update_rate", "double", "0", '0', 2, 0, kRead,
     "The frequency at which the sensor data is generated. If left unspecified, the sensor will generate data every "
     "cycle."},
    {"sensor.visualize", "bool", "false", '0', 2, 0, kRead, "If true, the sensor is visualized in the GUI"},
    {"sonar", "", "", '1', 4, 0, kRead, "These elements are specific to the sonar sensor."},
    {"sonar.geometry", "string", "cone", '0', 6, 0, kRead,
     "The sonar collision shape. Currently supported geometries are: \"cone\" and \"sphere\"."},
    {"sonar.max", "double", "1.0", '1', 4, 0, kRead, "Max range"},
    {"sonar.min", "double", "0", '1', 4, 0, kRead, "Minimum range"},
    {"sonar.radius", "double", "0.5", '0', 4, 0, kRead,
     "Radius of the sonar cone at max range. This parameter is only used if geometry is \"cone\"."},
    {"transceiver", "", "", '1', 4, 0, kRead, "These elements are specific to a wireless transceiver."},
    {"transceiver.essid", "string", "wireless", '0', 4, 0, kRead, "Service set identifier (network name)"},
    {"transceiver.frequency", "double", "2442", '0', 4, 0, kRead, "Specifies the frequency of transmission in MHz"},
    {"transceiver.gain", "double", "2.5", '1', 4, 0, kRead, "Specifies the antenna gain in dBi"},
    {"transceiver.max_frequency", "double", "2484", '0', 4, 0, kRead,
     "Only a frequency range is filtered. Here we set the upper bound (MHz)."},
    {"transceiver.min_frequency", "double", "2412", '0', 4, 0, kRead,
     "Only a frequency range is filtered. Here we set the lower bound (MHz)."},
    {"transceiver.power", "double", "14.50", '1', 4, 0, kRead, "Specifies the transmission power in dBm"},
    {"transceiver.sensitivity", "double", "-90", '0', 4, 0, kRead, "Mininum received signal power in dBm"},
};

}  // namespace

std::span<const SchemaRow> sensorRows() { return kSensorRows; }

}  // namespace pongsim::sdf
