#pragma once

namespace pongsim::benchmark {

/// Measures what publishing takes beside subscribers that are slow, stopped or killed, and beside a flood, and prints
/// it.
void measureTroubles();

}  // namespace pongsim::benchmark
