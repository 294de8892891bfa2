#pragma once

#include <chrono>

namespace pongsim::cli {

/// Asks a terminal for its features ("primary device attributes", CSI c), and waits for the answer.
/// @param input, output Where to read the answer and to write the query; unless both are terminals, nothing is asked.
/// @return Whether it reports support for sixels; false if it does not answer in time.
bool knowsSixels(int input, int output, std::chrono::milliseconds patience);

}  // namespace pongsim::cli
