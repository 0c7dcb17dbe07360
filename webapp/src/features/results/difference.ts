/** Actual less expected where both are one number; nothing where they are equal or no numbers. */
export function differenceOf(
  expected: Record<string, string> | null | undefined,
  actual: Record<string, string> | null | undefined,
): string | null {
  const differences = Object.entries(expected ?? {}).flatMap(([name, wanted]) => {
    const measured = actual?.[name];
    if (measured === undefined || measured === wanted) return [];
    const difference = Number(measured) - Number(wanted);
    if (!Number.isFinite(difference) || difference === 0 || measured === '' || wanted === '') {
      return [];
    }
    return [`${difference > 0 ? '+' : '−'}${formatMagnitude(Math.abs(difference))}`];
  });
  return differences.length > 0 ? differences.join(', ') : null;
}

/** Digits enough to tell one difference from another, and no noise of binary fractions. */
function formatMagnitude(value: number): string {
  return String(Number(value.toPrecision(6)));
}
