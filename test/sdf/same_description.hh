#pragma once

#include "sdf/loader.hh"

namespace pongsim::sdf::test {

/// Forgets where the parts of a description stand.
class PositionEraser {
 public:
  void erase(Root& root) {
    for (description::World& world : root.worlds) erase(world);
    for (description::Model& model : root.models) erase(model);
    for (description::Light& light : root.lights) light.position = {};
  }

 private:
  void erase(description::World& world) {
    world.position = {};
    for (description::Model& model : world.models) erase(model);
    for (description::Light& light : world.lights) light.position = {};
    eraseCommon(world);
  }

  void erase(description::Model& model) {
    model.position = {};
    for (description::Link& link : model.links) {
      link.position = {};
      for (description::Collision& collision : link.collisions) collision.position = {};
      for (description::Visual& visual : link.visuals) visual.position = {};
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
    for (description::Plugin& plugin : holder.plugins) erase(plugin.sdf);
  }

  template <class Holder>
  void eraseSensors(Holder& holder) {
    for (description::Sensor& sensor : holder.sensors) {
      sensor.position = {};
      erase(sensor.sdf);
    }
  }

  void erase(Element& element) {
    element.position = {};
    for (Element::Attribute& attribute : element.attributes) attribute.position = {};
    for (Element& child : element.children) erase(child);
  }
};

/// @return Whether both say the same, wherever it stands.
inline bool isSame(Root a, Root b) {
  PositionEraser eraser;
  eraser.erase(a);
  eraser.erase(b);
  return a.worlds == b.worlds && a.models == b.models && a.lights == b.lights;
}

}  // namespace pongsim::sdf::test
