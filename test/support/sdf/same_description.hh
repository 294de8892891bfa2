#pragma once

#include "sdf/loader.hh"

namespace pongsim::sdf::test {

/// Clears the source positions in a description.
class PositionEraser {
 public:
  void erase(Root& root) {
    for (description::World& world : root.worlds) erase(world);
    for (description::Model& model : root.models) erase(model);
    for (description::Light& light : root.lights) light.position = {};
    for (description::Actor& actor : root.actors) erase(actor);
  }

 private:
  void erase(description::World& world) {
    world.position = {};
    for (description::Model& model : world.models) erase(model);
    for (description::Light& light : world.lights) light.position = {};
    for (description::Actor& actor : world.actors) erase(actor);
    if (world.gui) erase(*world.gui);
    for (description::Performer& performer : world.levels.performers) performer.position = {};
    for (description::Level& level : world.levels.levels) {
      level.position = {};
      for (description::Level::Member& member : level.members) member.position = {};
    }
    eraseCommon(world);
  }

  void erase(description::Model& model) {
    model.position = {};
    for (description::Link& link : model.links) {
      link.position = {};
      for (description::Collision& collision : link.collisions) collision.position = {};
      for (description::Visual& visual : link.visuals) {
        visual.position = {};
        erasePlugins(visual);
      }
      for (description::Light& light : link.lights) light.position = {};
      for (description::ParticleEmitter& emitter : link.emitters) emitter.position = {};
      eraseSensors(link);
    }
    for (description::Model& inner : model.models) erase(inner);
    eraseCommon(model);
  }

  template <class Holder>
  void eraseCommon(Holder& holder) {
    for (description::Joint& joint : holder.joints) {
      joint.position = {};
      eraseSensors(joint);
    }
    for (description::Frame& frame : holder.frames) frame.position = {};
    erasePlugins(holder);
  }

  void erase(description::Actor& actor) {
    actor.position = {};
    for (description::Visual& visual : actor.visuals) {
      visual.position = {};
      erasePlugins(visual);
    }
    erasePlugins(actor);
  }

  template <class Holder>
  void erasePlugins(Holder& holder) {
    for (description::Plugin& plugin : holder.plugins) erase(plugin.sdf);
  }

  template <class Holder>
  void eraseSensors(Holder& holder) {
    for (description::Sensor& sensor : holder.sensors) {
      sensor.position = {};
      erase(sensor.sdf);
      erasePlugins(sensor);
    }
  }

  void erase(Element& element) {
    element.position = {};
    for (Element::Attribute& attribute : element.attributes) attribute.position = {};
    for (Element& child : element.children) erase(child);
  }
};

/// Clears the XML elements of sensors, which contain everything as written, whether it is read or not.
template <class Holder>
void forgetSensorElementsOf(std::vector<Holder>& holders) {
  for (Holder& holder : holders) {
    for (description::Sensor& sensor : holder.sensors) sensor.sdf = {};
  }
}

inline void forgetSensorElements(std::vector<description::Model>& models) {
  for (description::Model& model : models) {
    forgetSensorElementsOf(model.links);
    forgetSensorElementsOf(model.joints);
    forgetSensorElements(model.models);
  }
}

inline void forgetSensorElements(Root& root) {
  for (description::World& world : root.worlds) {
    forgetSensorElements(world.models);
    forgetSensorElementsOf(world.joints);
  }
  forgetSensorElements(root.models);
}

/// @return Whether both describe the same, apart from source positions.
inline bool isSame(Root a, Root b) {
  PositionEraser eraser;
  eraser.erase(a);
  eraser.erase(b);
  return a.worlds == b.worlds && a.models == b.models && a.lights == b.lights && a.actors == b.actors;
}

}  // namespace pongsim::sdf::test
