#pragma once

#include "description/sensor.hh"

namespace ignition::msgs {
class Sensor;
}

namespace pongsim::msgs {

/// Fills in a sensor, except for its id and its parent's: name, type, topic, rate, pose, and the settings of IMUs,
/// magnetometers, altimeters, air pressure sensors, lidars, cameras and logical cameras.
void setSensor(const description::Sensor& sensor, ignition::msgs::Sensor& message);

/// @return The sensor in such a message; for a camera, as far as the message has fields.
description::Sensor sensorOf(const ignition::msgs::Sensor& message);

}  // namespace pongsim::msgs
