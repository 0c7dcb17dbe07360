/** Actual − expected of two numbers; null if they are equal or not both finite numbers. */
export function differenceOf(
  expected: string | undefined,
  actual: string | undefined,
): string | null {
  if (!expected || !actual) return null;
  const difference = Number(actual) - Number(expected);
  if (!Number.isFinite(difference) || difference === 0) return null;
  return `${difference > 0 ? '+' : '−'}${formatMagnitude(Math.abs(difference))}`;
}

/** Six digits, to hide the rounding errors of binary fractions. */
function formatMagnitude(value: number): string {
  return value < 1e-4 ? value.toExponential(2) : String(Number(value.toPrecision(6)));
}
