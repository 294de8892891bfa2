/// Labels of the axes of a plot.

// of these, texts are written with an exponent
const kLarge = 1e6;
const kSmall = 1e-3;

/// The number of decimals that multiples of a step need: 1 for 2.5.
function decimalsOf(step: number): number {
  for (let decimals = 0; decimals < 20; ++decimals) {
    const scaled = step * 10 ** decimals;
    if (Math.abs(scaled - Math.round(scaled)) < 1e-6 * scaled) return decimals;
  }
  return 20;
}

/// Texts of an axis' labels, with as many digits as tell them apart.
export function tickTexts(labels: readonly number[]): string[] {
  const most = Math.max(...labels.map(Math.abs));
  const step = Math.min(...labels.slice(1).map((label, i) => Math.abs(label - labels[i]!)));
  const unit = Number.isFinite(step) && step > 0 ? step : most || 1;
  return labels.map((label) => {
    // 0 is the label next to which rounding may leave a little
    if (Math.abs(label) < unit / 1e6) return '0';
    return most >= kLarge || most < kSmall ? withExponent(label, unit) : label.toFixed(Math.min(decimalsOf(unit), 15));
  });
}

function withExponent(label: number, unit: number): string {
  const power = Math.floor(Math.log10(Math.abs(label)) + 1e-12);
  const unitPower = Math.floor(Math.log10(unit) + 1e-12);
  const digits = power - unitPower + decimalsOf(unit / 10 ** unitPower);
  const [mantissa, exponent] = label.toExponential(Math.min(Math.max(digits, 0), 17)).split('e');
  const short = mantissa!.includes('.') ? mantissa!.replace(/\.?0+$/, '') : mantissa;
  return `${short}e${Number(exponent)}`;
}
