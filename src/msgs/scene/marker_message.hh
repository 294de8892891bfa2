#pragma once

#include <string>
#include <vector>

#include "pongsim/message.hh"
#include "pongsim/outcome.hh"
#include "world/markers.hh"

namespace pongsim::msgs {

/// @param message An `ignition.msgs.Marker`.
/// @return What it asks for, or what can't be understood.
Outcome<world::MarkerChange> markerChange(const Message& message);

/// @param message An `ignition.msgs.Marker_V`.
std::vector<const Message*> markersIn(const Message& message);

/// Fills in an `ignition.msgs.Marker` that adds the marker.
void setMarker(const world::Markers::Key& key, const world::Marker& marker, Time now, Message& message);

/// Fills in an `ignition.msgs.Marker` that removes it.
/// @param isAll All of the name space, or all if that is empty.
void setMarkerRemoval(const world::Markers::Key& key, bool isAll, Message& message);

/// Appends a marker to an `ignition.msgs.Marker_V`.
Message& addMarker(Message& message);

/// Says in the header of an `ignition.msgs.Marker_V`, or of an `ignition.msgs.Marker`, whose markers they are: the
/// services have the same names in all worlds.
void setWorldOfMarkers(const std::string& world, Message& message);
void setWorldOfMarker(const std::string& world, Message& message);
/// @param message An `ignition.msgs.Marker_V`.
/// @return Empty if it does not say.
std::string worldOfMarkers(const Message& message);

}  // namespace pongsim::msgs
