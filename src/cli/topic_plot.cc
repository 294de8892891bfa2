#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <string>

#include "cli/console.hh"
#include "cli/scan_plot.hh"
#include "cli/topic_command.hh"
#include "msgs/scan_message.hh"

namespace pongsim::cli {

namespace {

struct Size {
  int columns;
  int rows;
};

/// @return What a drawing may take of the terminal on stdout; elsewhere as much as one of 80 by 25 leaves.
Size plotSize() {
  winsize window{};
  Size size{80, 25};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0 && window.ws_col > 0 && window.ws_row > 0) {
    size = {window.ws_col, window.ws_row};
  }
  // a letter is twice as high as it is wide; below stand the line of numbers and the cursor
  const int rows = std::max(1, std::min(size.rows - 2, size.columns / 2));
  return {2 * rows, rows};
}

class PlotTask final : public TopicTask {
 public:
  std::optional<int> begin(const std::string& type) override {
    if (type == "ignition.msgs.LaserScan") return std::nullopt;
    return fail("--plot draws ignition.msgs.LaserScan, not " + type);
  }

  std::optional<int> take(const Message& message) override {
    const Size size = plotSize();
    const std::string plot = scanPlot(msgs::levelRowOf(message), size.columns, size.rows);
    // on a terminal each takes the place of the one before
    const std::string text = isatty(STDOUT_FILENO) != 0 ? "\033[H\033[J" + plot : plot + '\n';
    if (print(text)) return std::nullopt;
    return outputIsClosed() ? kDone : kFailed;
  }

  int end(bool) override { return kDone; }
};

}  // namespace

int plotTopic(const ReadOptions& options) {
  TopicReader reader(options);
  PlotTask task;
  return reader.run(task);
}

}  // namespace pongsim::cli
