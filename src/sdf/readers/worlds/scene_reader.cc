#include "sdf/readers/worlds/scene_reader.hh"

#include <array>
#include <string_view>

#include "sdf/text/values.hh"

namespace pongsim::sdf {

namespace {

description::Sky readSky(const Element& element, Context& context) {
  description::Sky sky;
  sky.time = readNumber(element, "time", sky.time, context);
  sky.sunrise = readNumber(element, "sunrise", sky.sunrise, context);
  sky.sunset = readNumber(element, "sunset", sky.sunset, context);
  if (const Element* clouds = element.child("clouds")) {
    sky.cloudSpeed = readNumber(*clouds, "speed", sky.cloudSpeed, context);
    sky.cloudDirection = readNumber(*clouds, "direction", sky.cloudDirection, context);
    sky.humidity = readNumber(*clouds, "humidity", sky.humidity, context);
    sky.cloudSize = readNumber(*clouds, "mean_size", sky.cloudSize, context);
    sky.cloudAmbient = readColor(*clouds, "ambient", sky.cloudAmbient, context);
  }
  return sky;
}

description::Fog readFog(const Element& element, Context& context) {
  using enum description::Fog::Type;
  constexpr std::array<std::string_view, 4> kNames{"none", "constant", "linear", "quadratic"};
  constexpr std::array kTypes{kNone, kConstant, kLinear, kQuadratic};
  description::Fog fog;
  fog.type = kTypes[readWord(element, "type", 0, kNames, context)];
  fog.color = readColor(element, "color", fog.color, context);
  fog.start = readNumber(element, "start", fog.start, context);
  fog.end = readLimit(element, "end", fog.end, context);
  fog.density = readNumber(element, "density", fog.density, context);
  return fog;
}

}  // namespace

description::Scene readScene(const Element& world, Context& context) {
  description::Scene scene;
  const Element* element = world.child("scene");
  if (element == nullptr) return scene;
  scene.ambient = readColor(*element, "ambient", scene.ambient, context);
  scene.background = readColor(*element, "background", scene.background, context);
  scene.hasShadows = readFlag(*element, "shadows", scene.hasShadows, context);
  scene.hasGrid = readFlag(*element, "grid", scene.hasGrid, context);
  scene.showsOrigin = readFlag(*element, "origin_visual", scene.showsOrigin, context);
  if (const Element* sky = element->child("sky")) scene.sky = readSky(*sky, context);
  if (const Element* fog = element->child("fog")) scene.fog = readFog(*fog, context);
  return scene;
}

}  // namespace pongsim::sdf
