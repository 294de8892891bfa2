#pragma once

#include <sdf/sdf.hh>
#include <string>

#include "description/sensor.hh"

namespace pongsim::test {

/// Expects that both descriptions are equal.
void compareSensor(const description::Sensor& a, const ::sdf::Sensor& b, const std::string& what);

}  // namespace pongsim::test
