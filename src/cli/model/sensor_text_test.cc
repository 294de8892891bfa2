#include "cli/model/sensor_text.hh"

#include <gtest/gtest.h>

#include <string>

namespace pongsim::cli {
namespace {

TEST(SensorText, PrintsNoiseAsFortressDoes) {
  AirPressureSettings settings;
  settings.referenceAltitude = 123;
  settings.pressure.mean = 0.5;
  settings.pressure.precision = 1e-7;
  EXPECT_EQ(sensorText(settings, 2),
            "  - Reference altitude (m): 123\n"
            "  - Pressure noise:\n"
            "    - Mean (Pa): 0.5\n"
            "    - Bias mean (Pa): 0\n"
            "    - Standard deviation (Pa): 0\n"
            "    - Bias standard deviation (Pa): 0\n"
            "    - Precision: 1e-07\n"
            "    - Dynamic bias standard deviation (Pa): 0\n"
            "    - Dynamic bias correlation time (s): 0\n");
}

TEST(SensorText, PrintsEachAxisOfAnImu) {
  ImuSettings settings;
  settings.localization = "ENU";
  const std::string text = sensorText(settings, 0);
  for (const char* line : {"- Linear acceleration X-axis noise:\n", "- Angular velocity Z-axis noise:\n",
                           "- Localization:ENU\n", "- Custom RPY: 0 0 0\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  }
}

TEST(SensorText, PrintsTheScansOfALidar) {
  LidarSettings settings;
  settings.maxRange = 12;
  const std::string text = sensorText(settings, 0);
  EXPECT_NE(text.find("- Range:\n  - Min (m): 0\n  - Max (m): 12\n"), std::string::npos) << text;
  EXPECT_NE(text.find("- Horizontal scan:\n  - Samples: 640\n"), std::string::npos) << text;
}

TEST(SensorText, IsEmptyForOthers) { EXPECT_EQ(sensorText(ContactSettings{}, 4), ""); }

}  // namespace
}  // namespace pongsim::cli
