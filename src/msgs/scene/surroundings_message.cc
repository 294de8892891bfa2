#include "msgs/scene/surroundings_message.hh"

#include <ignition/msgs/scene.pb.h>

#include "msgs/scene/color_message.hh"

namespace pongsim::msgs {

namespace im = ignition::msgs;

void setSurroundings(const description::Scene& surroundings, im::Scene& message) {
  message.Clear();
  setColor(surroundings.ambient, *message.mutable_ambient());
  setColor(surroundings.background, *message.mutable_background());
  message.set_shadows(surroundings.hasShadows);
  message.set_grid(surroundings.hasGrid);
  message.set_origin_visual(surroundings.showsOrigin);
  if (!surroundings.sky) return;
  const description::Sky& sky = *surroundings.sky;
  im::Sky& added = *message.mutable_sky();
  added.set_time(sky.time);
  added.set_sunrise(sky.sunrise);
  added.set_sunset(sky.sunset);
  added.set_wind_speed(sky.cloudSpeed);
  added.set_wind_direction(sky.cloudDirection);
  added.set_humidity(sky.humidity);
  added.set_mean_cloud_size(sky.cloudSize);
  setColor(sky.cloudAmbient, *added.mutable_cloud_ambient());
}

description::Scene surroundingsFrom(const im::Scene& message) {
  description::Scene surroundings;
  if (message.has_ambient()) surroundings.ambient = colorOf(message.ambient());
  if (message.has_background()) surroundings.background = colorOf(message.background());
  surroundings.hasShadows = message.shadows();
  surroundings.hasGrid = message.grid();
  surroundings.showsOrigin = message.origin_visual();
  if (message.has_sky()) {
    const im::Sky& sky = message.sky();
    surroundings.sky = {sky.time(),           sky.sunrise(),  sky.sunset(),          sky.wind_speed(),
                        sky.wind_direction(), sky.humidity(), sky.mean_cloud_size(), colorOf(sky.cloud_ambient())};
  }
  return surroundings;
}

}  // namespace pongsim::msgs
