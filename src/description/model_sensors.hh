#pragma once

#include <string>

#include "description/model.hh"

namespace pongsim::description {

/// Calls `use(sensor, holder)` for each sensor of a model's links and joints, `holder` being their name.
template <class Use>
void forEachOwnSensor(const Model& model, const Use& use) {
  for (const Link& link : model.links) {
    for (const Sensor& sensor : link.sensors) use(sensor, link.name);
  }
  for (const Joint& joint : model.joints) {
    for (const Sensor& sensor : joint.sensors) use(sensor, joint.name);
  }
}

/// Calls `use(sensor)` for each sensor of a model: those of its links, of its joints, and of the models nested in it.
template <class Use>
void forEachSensor(const Model& model, const Use& use) {
  forEachOwnSensor(model, [&use](const Sensor& sensor, const std::string&) { use(sensor); });
  for (const Model& nested : model.models) forEachSensor(nested, use);
}

}  // namespace pongsim::description
