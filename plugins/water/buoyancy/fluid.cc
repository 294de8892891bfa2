#include "fluid.hh"

#include <algorithm>

namespace pongsim {

bool Fluid::addLayer(double from, double density) {
  auto layer = std::ranges::lower_bound(layers_, from, {}, &Layer::from);
  const bool isNew = layer == layers_.end() || layer->from != from;
  if (isNew) layer = layers_.insert(layer, {from, density, 0});
  layer->density = density;
  top_ = bottom_;
  for (Layer& each : layers_) {
    each.drop = top_ - each.density;
    top_ = each.density;
  }
  return isNew;
}

}  // namespace pongsim
