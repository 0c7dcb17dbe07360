/**
 * Makes invisible characters of untrusted text visible: control characters become symbols (␛, ␀),
 * characters that change the text direction become code points. Line breaks and tabs are kept.
 */
export function visible(text: string): string {
  let shown = '';
  for (const character of text) {
    const code = character.codePointAt(0) ?? 0;
    if (code < 0x20 && character !== '\n' && character !== '\t') {
      shown += String.fromCodePoint(0x2400 + code);
    } else if (code === 0x7f) {
      shown += '␡';
    } else if (changesDirection(code) || (code > 0x7f && code < 0xa0)) {
      shown += `⟨U+${code.toString(16).toUpperCase().padStart(4, '0')}⟩`;
    } else {
      shown += character;
    }
  }
  return shown;
}

/** Unicode's explicit bidirectional formatting characters (UAX #9, section 2). */
function changesDirection(code: number): boolean {
  return (
    code === 0x061c ||
    code === 0x200e ||
    code === 0x200f ||
    (code >= 0x202a && code <= 0x202e) ||
    (code >= 0x2066 && code <= 0x2069)
  );
}
