#include "sdf/readers/shapes/visual_reader.hh"

#include <limits>

#include "sdf/readers/shapes/data_systems.hh"
#include "sdf/readers/shapes/geometry_reader.hh"
#include "sdf/readers/shapes/material_reader.hh"
#include "sdf/readers/worlds/plugin_reader.hh"
#include "sdf/text/names.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

description::Visual readVisual(const Element& element, const std::string& owner, Context& context) {
  description::Visual visual;
  visual.name = readName(element, owner, context);
  visual.position = element.position;
  const std::string label = partLabel(element, visual.name, owner);
  visual.geometry = readGeometry(element, label, context);
  if (const Element* material = element.child("material")) visual.material = readMaterial(*material, context);
  visual.transparency = readNumber(element, "transparency", visual.transparency, context);
  visual.castsShadows = readFlag(element, "cast_shadows", visual.castsShadows, context);
  visual.visibilityFlags = readUnsigned(element, "visibility_flags", visual.visibilityFlags, context);
  visual.laserRetro = readNumber(element, "laser_retro", visual.laserRetro, context);
  if (const Element* meta = element.child("meta")) {
    using Limits = std::numeric_limits<int>;
    visual.layer = readInteger(*meta, "layer", visual.layer, Limits::min(), Limits::max(), context);
  }
  for (const Element* plugin : element.childrenNamed("plugin")) {
    visual.plugins.push_back(readPlugin(*plugin, label, context));
  }
  visual.label = readLabel(visual.plugins, label, context);
  visual.heat = readHeat(visual.plugins, label, context);
  return visual;
}

}  // namespace pongsim::sdf
