#pragma once

#include "pongsim/program/nearest_word.hh"

namespace pongsim::base {

using pongsim::didYouMean;
using pongsim::nearestWord;

}  // namespace pongsim::base
