#pragma once

/// Marks what libpongsim.so exports; everything else in it is hidden.
#define PONGSIM_API __attribute__((visibility("default")))
