#include "ros2/pairs/gz_parts.hh"

#include <map>

#include "ros2/pairs/convert.hh"
#include "ros2/pairs/parameter_value.hh"

namespace pongsim::ros2 {

namespace gz = ros_gz_interfaces;

void convert(const ignition::msgs::Entity& from, gz::Entity& to) {
  to.id = from.id();
  to.name = from.name();
  to.type = static_cast<std::uint8_t>(from.type());
}

void convert(const gz::Entity& from, ignition::msgs::Entity& to) {
  to.set_id(from.id);
  to.set_name(from.name);
  using Type = ignition::msgs::Entity::Type;
  const bool isKnown = ignition::msgs::Entity::Type_IsValid(from.type);
  to.set_type(isKnown ? static_cast<Type>(from.type) : ignition::msgs::Entity::NONE);
}

void convert(const ignition::msgs::JointWrench& from, gz::JointWrench& to, const Frames& frames) {
  convert(from.header(), to.header, frames);
  to.body_1_name.data = from.body_1_name();
  to.body_1_id.data = from.body_1_id();
  to.body_2_name.data = from.body_2_name();
  to.body_2_id.data = from.body_2_id();
  convert(from.body_1_wrench(), to.body_1_wrench);
  convert(from.body_2_wrench(), to.body_2_wrench);
}

void convert(const gz::JointWrench& from, ignition::msgs::JointWrench& to, const Frames& frames) {
  convert(from.header, *to.mutable_header(), frames);
  to.set_body_1_name(from.body_1_name.data);
  to.set_body_1_id(from.body_1_id.data);
  to.set_body_2_name(from.body_2_name.data);
  to.set_body_2_id(from.body_2_id.data);
  convert(from.body_1_wrench, *to.mutable_body_1_wrench());
  convert(from.body_2_wrench, *to.mutable_body_2_wrench());
}

namespace {

void convertVectors(const google::protobuf::RepeatedPtrField<ignition::msgs::Vector3d>& from,
                    std::vector<geometry_msgs::Vector3>& to) {
  to.resize(static_cast<std::size_t>(from.size()));
  for (int i = 0; i < from.size(); ++i) convert(from.Get(i), to[static_cast<std::size_t>(i)]);
}

}  // namespace

void convert(const ignition::msgs::Contact& from, gz::Contact& to, const Frames& frames) {
  convert(from.collision1(), to.collision1);
  convert(from.collision2(), to.collision2);
  convertVectors(from.position(), to.positions);
  convertVectors(from.normal(), to.normals);
  copyNumbers(from.depth(), to.depths);
  convertList(from.wrench(), to.wrenches, frames);
}

void convert(const gz::Contact& from, ignition::msgs::Contact& to, const Frames& frames) {
  to.Clear();
  convert(from.collision1, *to.mutable_collision1());
  convert(from.collision2, *to.mutable_collision2());
  for (const geometry_msgs::Vector3& position : from.positions) convert(position, *to.add_position());
  for (const geometry_msgs::Vector3& normal : from.normals) convert(normal, *to.add_normal());
  addNumbers(from.depths, to.mutable_depth());
  for (const gz::JointWrench& wrench : from.wrenches) convert(wrench, *to.add_wrench(), frames);
}

void convert(const ignition::msgs::TrackVisual& from, gz::TrackVisual& to, const Frames& frames) {
  convert(from.header(), to.header, frames);
  to.name = from.name();
  to.id = from.id();
  to.inherit_orientation = from.inherit_orientation();
  to.min_dist = from.min_dist();
  to.max_dist = from.max_dist();
  to.is_static = from.static_();
  to.use_model_frame = from.use_model_frame();
  convert(from.xyz(), to.xyz);
  to.inherit_yaw = from.inherit_yaw();
}

void convert(const gz::TrackVisual& from, ignition::msgs::TrackVisual& to, const Frames& frames) {
  convert(from.header, *to.mutable_header(), frames);
  to.set_name(from.name);
  to.set_id(from.id);
  to.set_inherit_orientation(from.inherit_orientation);
  to.set_min_dist(from.min_dist);
  to.set_max_dist(from.max_dist);
  to.set_static_(from.is_static);
  to.set_use_model_frame(from.use_model_frame);
  convert(from.xyz, *to.mutable_xyz());
  to.set_inherit_yaw(from.inherit_yaw);
}

void convert(const ignition::msgs::Light& from, gz::Light& to, const Frames& frames) {
  convert(from.header(), to.header, frames);
  to.name = from.name();
  to.type = static_cast<std::uint8_t>(from.type());
  convert(from.pose(), to.pose);
  convert(from.diffuse(), to.diffuse);
  convert(from.specular(), to.specular);
  to.attenuation_constant = from.attenuation_constant();
  to.attenuation_linear = from.attenuation_linear();
  to.attenuation_quadratic = from.attenuation_quadratic();
  convert(from.direction(), to.direction);
  to.range = from.range();
  to.cast_shadows = from.cast_shadows();
  to.spot_inner_angle = from.spot_inner_angle();
  to.spot_outer_angle = from.spot_outer_angle();
  to.spot_falloff = from.spot_falloff();
  to.id = from.id();
  to.parent_id = from.parent_id();
  to.intensity = from.intensity();
}

void convert(const gz::Light& from, ignition::msgs::Light& to, const Frames& frames) {
  using ignition::msgs::Light;
  convert(from.header, *to.mutable_header(), frames);
  to.set_name(from.name);
  to.set_type(Light::LightType_IsValid(from.type) ? static_cast<Light::LightType>(from.type) : Light::POINT);
  convert(from.pose, *to.mutable_pose());
  convert(from.diffuse, *to.mutable_diffuse());
  convert(from.specular, *to.mutable_specular());
  to.set_attenuation_constant(from.attenuation_constant);
  to.set_attenuation_linear(from.attenuation_linear);
  to.set_attenuation_quadratic(from.attenuation_quadratic);
  convert(from.direction, *to.mutable_direction());
  to.set_range(from.range);
  to.set_cast_shadows(from.cast_shadows);
  to.set_spot_inner_angle(from.spot_inner_angle);
  to.set_spot_outer_angle(from.spot_outer_angle);
  to.set_spot_falloff(from.spot_falloff);
  to.set_id(from.id);
  to.set_parent_id(from.parent_id);
  to.set_intensity(from.intensity);
}

void convert(const ignition::msgs::WorldControl& from, gz::WorldControl& to) {
  to.pause = from.pause();
  to.step = from.step();
  to.multi_step = from.multi_step();
  to.reset = {from.reset().all(), from.reset().time_only(), from.reset().model_only()};
  to.seed = from.seed();
  convert(from.run_to_sim_time(), to.run_to_sim_time);
}

void convert(const gz::WorldControl& from, ignition::msgs::WorldControl& to) {
  to.Clear();
  to.set_pause(from.pause);
  to.set_step(from.step);
  to.set_multi_step(from.multi_step);
  if (from.reset != gz::WorldReset()) {
    to.mutable_reset()->set_all(from.reset.all);
    to.mutable_reset()->set_time_only(from.reset.time_only);
    to.mutable_reset()->set_model_only(from.reset.model_only);
  }
  to.set_seed(from.seed);
  if (from.run_to_sim_time != builtin_interfaces::Time()) {
    convert(from.run_to_sim_time, *to.mutable_run_to_sim_time());
  }
}

void addParameters(const ignition::msgs::Param& from, const std::string& prefix,
                   std::vector<rcl_interfaces::Parameter>& to) {
  // protobuf's maps have no defined order
  const std::map<std::string, ignition::msgs::Any> sorted(from.params().begin(), from.params().end());
  for (const auto& [name, value] : sorted) {
    to.push_back({prefix + name, {}});
    convert(value, to.back().value);
  }
  for (int i = 0; i < from.children_size(); ++i) {
    addParameters(from.children(i), prefix + "child_" + std::to_string(i) + "/", to);
  }
}

void convert(const gz::ParamVec& from, ignition::msgs::Param& to, const Frames& frames) {
  to.Clear();
  convert(from.header, *to.mutable_header(), frames);
  for (const rcl_interfaces::Parameter& parameter : from.params) {
    convert(parameter.value, (*to.mutable_params())[parameter.name]);
  }
}

}  // namespace pongsim::ros2
