#pragma once

#include <string>

#include "msgs/fields/scan_message.hh"

namespace pongsim::cli {

/// Draws a scan in top view, with ahead pointing up and the sensor in the centre, in dots of Braille characters, two by
/// four each. A line with numbers follows. A circle of single dots marks the distance given in that line.
/// @param columns, rows Size of the drawing in characters, at least one.
/// @return Lines, each with its line break.
std::string scanPlot(const msgs::ScanRow& scan, int columns, int rows);

}  // namespace pongsim::cli
