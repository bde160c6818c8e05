// Range of the vertical axis of a plot.

/** Smallest span of the vertical axis, by the unit of the curves. Smaller differences are rounding. */
const minSpan: Record<string, number> = {
  N: 0.01,
  'N m': 0.01,
  mm: 0.001,
  '°': 0.001,
  rad: 1e-5,
  'rad/s': 1e-4,
  '%': 0.01,
  ms: 0.001,
};

/** Range of the vertical axis for values between min and max, with a margin of 8 %. */
export function spanOf(min: number, max: number, unit: string): [number, number] {
  const pad = Math.max(
    0.08 * (max - min),
    1e-3 * Math.max(Math.abs(min), Math.abs(max)),
    0.5 * ((minSpan[unit] ?? 2e-9) - (max - min)),
  );
  return [min - pad, max + pad];
}
