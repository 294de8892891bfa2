#pragma once

#include <string>

#include "msgs/fields/scan_message.hh"

namespace pongsim::cli {

/// Draws a scan as seen from above, ahead being up and the sensor in the middle, with the dots of Braille letters, two
/// by four each; below a line with the numbers. A ring of single dots is as far as that line says.
/// @param columns, rows Of letters for the drawing, one at least.
/// @return Lines, each with its end.
std::string scanPlot(const msgs::ScanRow& scan, int columns, int rows);

}  // namespace pongsim::cli
