#include <unistd.h>

#include <algorithm>
#include <optional>
#include <string>

#include "cli/topic/scan_plot.hh"
#include "cli/topic/topic_command.hh"
#include "cli/view/picture_plot.hh"
#include "cli/view/terminal_size.hh"
#include "msgs/fields/image_message.hh"
#include "msgs/fields/scan_message.hh"
#include "shared/program/console.hh"

namespace pongsim::cli {

namespace {

/// @return A drawing of the scan, as large as the terminal allows.
std::string drawnScan(const Message& message) {
  const TerminalSize size = terminalSize();
  // a character is twice as high as wide; below are the line of numbers and the cursor
  const int rows = std::max(1, std::min(size.rows - 2, size.columns / 2));
  return scanPlot(msgs::levelRowOf(message), 2 * rows, rows);
}

std::string drawnImage(const Message& message) {
  const std::optional<msgs::ImagePixels> image = msgs::pixelsOf(message);
  if (!image) return "an image that is empty or in a format that can't be drawn\n";
  const TerminalSize size = terminalSize();
  return picturePlot(image->pixels, image->width, image->height, size.columns, std::max(1, size.rows - 1));
}

class PlotTask final : public TopicTask {
 public:
  std::optional<int> begin(const std::string& type) override {
    if (type == "ignition.msgs.LaserScan") draw_ = drawnScan;
    if (type == "ignition.msgs.Image") draw_ = drawnImage;
    if (draw_ != nullptr) return std::nullopt;
    return fail("--plot draws ignition.msgs.LaserScan and ignition.msgs.Image, not " + type);
  }

  std::optional<int> take(const Message& message) override {
    const std::string plot = draw_(message);
    // on a terminal, each drawing replaces the previous one
    const std::string text = isatty(STDOUT_FILENO) != 0 ? "\033[H\033[J" + plot : plot + '\n';
    if (print(text)) return std::nullopt;
    return outputIsClosed() ? kDone : kFailed;
  }

  int end(bool) override { return kDone; }

 private:
  std::string (*draw_)(const Message&) = nullptr;
};

}  // namespace

int plotTopic(const ReadOptions& options) {
  TopicReader reader(options);
  PlotTask task;
  return reader.run(task);
}

}  // namespace pongsim::cli
