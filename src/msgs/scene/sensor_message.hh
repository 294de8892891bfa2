#pragma once

#include "description/sensor.hh"

namespace ignition::msgs {
class Sensor;
}

namespace pongsim::msgs {

/// Fills in a sensor, but for its id and that of what holds it: name, type, topic, rate, pose, and the settings of
/// inertial measurement units, magnetometers, altimeters, air pressure sensors, lidars, cameras and logical cameras.
void setSensor(const description::Sensor& sensor, ignition::msgs::Sensor& message);

/// @return What such a message says; of a camera what it has place for.
description::Sensor sensorOf(const ignition::msgs::Sensor& message);

}  // namespace pongsim::msgs
