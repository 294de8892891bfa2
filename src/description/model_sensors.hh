#pragma once

#include "description/model.hh"

namespace pongsim::description {

/// Calls `use(sensor)` for each sensor of a model: those of its links, of its joints, and of the models nested in it.
template <class Use>
void forEachSensor(const Model& model, const Use& use) {
  for (const Link& link : model.links) {
    for (const Sensor& sensor : link.sensors) use(sensor);
  }
  for (const Joint& joint : model.joints) {
    for (const Sensor& sensor : joint.sensors) use(sensor);
  }
  for (const Model& nested : model.models) forEachSensor(nested, use);
}

}  // namespace pongsim::description
