// pongsim-video FILE WIDTH HEIGHT RATE, which `pongsim view --video` runs: makes a video of the images, red, green,
// blue, that it reads (stream.hh). It says itself what went wrong.
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "pongsim/outcome.hh"
#include "shared/program/command_line.hh"
#include "shared/program/console.hh"
#include "video/encoder.hh"
#include "video/output_file.hh"
#include "video/stream.hh"

namespace {

namespace fs = std::filesystem;
using namespace pongsim;

/// [bit] A moving world in this many for each pixel of an image looks as the images do.
constexpr double kBitsPerPixel = 0.1;
constexpr double kLowestBitrate = 200'000, kHighestBitrate = 1e9;

Outcome<void> makeVideo(const fs::path& wanted, video::VideoSettings settings) {
  const fs::path file = fs::absolute(wanted);
  settings.format = file.extension().string().erase(0, 1);
  if (!video::isVideoFormat(settings.format)) return {"'" + wanted.string() + "' ends in none of .mp4, .avi and .ogv"};
  Outcome<fs::path> place = video::placeOf(file, file.parent_path(), file.extension());
  if (!place) return {place.error};
  const double pixels = static_cast<double>(settings.width) * settings.height * settings.rate;
  settings.bitrate = static_cast<int>(std::clamp(kBitsPerPixel * pixels, kLowestBitrate, kHighestBitrate));
  Outcome<std::unique_ptr<video::Encoder>> encoder = video::Encoder::create(*place, settings);
  if (!encoder) return {encoder.error};
  const std::size_t size =
      std::size_t{3} * static_cast<unsigned>(settings.width) * static_cast<unsigned>(settings.height);
  return video::encodeStream(STDIN_FILENO, size, **encoder);
}

}  // namespace

int main(int argc, char** argv) {
  // what stops the writer ends the images, and the video is complete up to there
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
  return cli::reportingFailures([&] {
    if (argc != 5) return cli::fail("'pongsim view --video' runs this program: pongsim-video FILE WIDTH HEIGHT RATE");
    const Outcome<void> made =
        makeVideo(argv[1], {.width = std::atoi(argv[2]), .height = std::atoi(argv[3]), .rate = std::atoi(argv[4])});
    return made ? cli::kDone : cli::fail(made.error);
  });
}
