#include "sdf/readers/sensors/noise_reader.hh"

#include <array>
#include <string>

#include "base/nearest_word.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

namespace {

NoiseSettings::Type readType(const Element& noise, NoiseSettings::Type fallback, Context& context) {
  using Type = NoiseSettings::Type;
  // up to SDF 1.6 the type is a child element, later an attribute
  const Element::Attribute* attribute = noise.attribute("type");
  const Element* child = noise.child("type");
  const std::string type = attribute != nullptr ? attribute->value : child != nullptr ? child->text : "";
  if (type.empty()) return fallback;
  if (type == "none") return Type::kNone;
  if (type == "gaussian") return Type::kGaussian;
  if (type == "gaussian_quantized") return Type::kGaussianQuantized;
  constexpr std::array<std::string_view, 3> kNoiseTypes{"none", "gaussian", "gaussian_quantized"};
  std::string hint = base::didYouMean(type, kNoiseTypes);
  if (hint.empty()) hint = "it can be none, gaussian or gaussian_quantized";
  context.diagnostics.error(attribute != nullptr ? attribute->position
                            : child != nullptr   ? child->position
                                                 : noise.position,
                            "<noise> has the unknown type '" + type + "'", hint);
  return Type::kNone;
}

}  // namespace

NoiseSettings readNoiseIn(const Element* holder, NoiseSettings::Type fallback, Context& context) {
  NoiseSettings settings;
  const Element* noise = holder != nullptr ? holder->child("noise") : nullptr;
  if (noise == nullptr) return settings;
  settings.type = readType(*noise, fallback, context);
  settings.mean = readNumber(*noise, "mean", 0, context);
  settings.standardDeviation = readNotNegative(*noise, "stddev", 0, context);
  settings.biasMean = readNumber(*noise, "bias_mean", 0, context);
  settings.biasStandardDeviation = readNotNegative(*noise, "bias_stddev", 0, context);
  settings.dynamicBiasStandardDeviation = readNotNegative(*noise, "dynamic_bias_stddev", 0, context);
  settings.dynamicBiasCorrelationTime = readNotNegative(*noise, "dynamic_bias_correlation_time", 0, context);
  settings.precision = readNotNegative(*noise, "precision", 0, context);
  return settings;
}

NoiseSettings readNoise(const Element* parent, std::string_view child, Context& context) {
  return readNoiseIn(parent != nullptr ? parent->child(child) : nullptr, NoiseSettings::Type::kNone, context);
}

NoiseSettings3 readNoise3(const Element* parent, Context& context) {
  return {readNoise(parent, "x", context), readNoise(parent, "y", context), readNoise(parent, "z", context)};
}

}  // namespace pongsim::sdf
