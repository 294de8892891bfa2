#include "cli/topic/scan_plot.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace pongsim::cli {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// @return A plot of 12 by 6 letters, with beams ahead, to the left, back, to the right, and ahead again.
std::string plotOf(const std::vector<double>& ranges) {
  msgs::ScanRow scan;
  scan.time = fromSeconds(1.5);
  scan.angleStep = M_PI / 2;
  scan.ranges = ranges;
  return scanPlot(scan, 12, 6);
}

/// What a plot has beyond that of a scan which sees nothing.
std::string lineOf(const std::string& plot, int line) {
  std::size_t begin = 0;
  for (; line > 0; --line) begin = plot.find('\n', begin) + 1;
  return plot.substr(begin, plot.find('\n', begin) - begin);
}

TEST(ScanPlot, HasAheadAboveAndLeftAtTheLeft) {
  const std::string empty = plotOf({kInfinity, kInfinity, kInfinity, kInfinity, 1});
  const auto changedLines = [&](const std::vector<double>& ranges) {
    const std::string plot = plotOf(ranges);
    std::string lines;
    for (int line = 0; line < 6; ++line) {
      if (lineOf(plot, line) != lineOf(empty, line)) lines += std::to_string(line);
    }
    return lines;
  };
  EXPECT_EQ(changedLines({0.5, kInfinity, kInfinity, kInfinity, 1}), "1");
  EXPECT_EQ(changedLines({kInfinity, kInfinity, 0.5, kInfinity, 1}), "4");
  const std::string left = plotOf({kInfinity, 0.5, kInfinity, kInfinity, 1});
  const std::string right = plotOf({kInfinity, kInfinity, kInfinity, 0.5, 1});
  // the sensor is in the middle, each letter of three bytes or a space
  EXPECT_EQ(changedLines({kInfinity, 0.5, kInfinity, kInfinity, 1}),
            changedLines({kInfinity, kInfinity, kInfinity, 0.5, 1}));
  EXPECT_NE(left, right);
  EXPECT_NE(empty.find('+'), std::string::npos);
}

TEST(ScanPlot, TellsTheNumbersBelow) {
  EXPECT_EQ(lineOf(plotOf({3, 4.25, kInfinity, -kInfinity}), 6),
            "t 1.500 s  ring 5 m  2 of 4 beams hit, nearest 3.000 m, 1 too near");
  EXPECT_EQ(lineOf(plotOf({}), 6), "t 1.500 s  ring 1 m  0 of 0 beams hit");
}

TEST(ScanPlot, BearsWhateverAScanSays) {
  for (const double value : {0.0, -3.0, 1e-300, 1e300, std::nan(""), kInfinity}) {
    msgs::ScanRow scan;
    const std::vector<double> ranges{value, 1, value};
    scan.ranges = ranges;
    for (const double angle : {0.0, 1e300, std::nan("")}) {
      scan.firstAngle = scan.angleStep = scan.elevation = angle;
      EXPECT_FALSE(scanPlot(scan, 1, 1).empty());
      EXPECT_FALSE(scanPlot(scan, 40, 20).empty());
    }
  }
}

}  // namespace
}  // namespace pongsim::cli
