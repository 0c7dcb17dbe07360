/** Seven digits of a number; other texts unchanged. */
export function shortNumber(text: string | undefined): string {
  if (text === undefined) return '–';
  return /^-?\d+\.\d{7,}$/.test(text) ? String(Number(Number(text).toPrecision(7))) : text;
}
