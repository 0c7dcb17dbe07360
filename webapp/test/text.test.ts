// @vitest-environment node
import { expect, test } from 'vitest';
import { formatAge, formatDuration, formatTime, plural } from '@/shared/lib/format';
import { visible } from '@/shared/lib/visible';

test('visible text has no control characters and no direction marks', () => {
  const all = Array.from({ length: 0x3000 }, (_, code) => String.fromCharCode(code)).join('');
  const hidden = /[\p{Cc}\p{Bidi_Control}]/gu;
  expect(all.match(hidden)?.length).toBeGreaterThan(70);
  expect(visible(all).match(hidden)).toEqual(['\t', '\n']);
});

test.each(['plain', 'Größe', '거리', '𝄞 and 🤖', 'two\nlines\tand a tab', ''])(
  'visible characters are not changed: %j',
  (text) => {
    expect(visible(text)).toBe(text);
  },
);

test('times have three digits in the unit that fits, and missing times are a dash', () => {
  expect(formatTime(64_254.855)).toBe('64.3 ms');
  expect(formatTime(4.605137)).toBe('4.61 µs');
  expect(formatTime(0.0421)).toBe('42.1 ns');
  expect(formatTime(999.96)).toBe('1.00 ms');
  expect(formatTime(999_499)).toBe('999 ms');
  expect(formatTime(1.5e6)).toBe('1.50 s');
  expect(formatTime(125e6)).toBe('2 min 5 s');
  expect(formatTime(0)).toBe('0 µs');
  expect(formatTime(-1500)).toBe('-1.50 ms');
  expect([undefined, null, Number.NaN].map(formatTime)).toEqual(['–', '–', '–']);
});

test('ages are given in minutes, days or as a date', () => {
  const now = new Date('2026-03-10T12:00:00Z');
  expect(formatAge('2026-03-10T11:59:30Z', now)).toBe('just now');
  expect(formatAge('2026-03-10T11:55:00Z', now)).toBe('5 minutes ago');
  expect(formatAge('2026-03-08T12:00:00Z', now)).toBe('2 days ago');
  expect(formatAge('2026-02-01T12:00:00Z', now)).toContain('2026');
});

test('durations are given in seconds, or in minutes and seconds', () => {
  const start = '2026-03-10T12:00:00Z';
  expect(formatDuration(start, '2026-03-10T12:00:04.250Z')).toBe('4.3 s');
  expect(formatDuration(start, '2026-03-10T12:02:05Z')).toBe('2 min 5 s');
  expect(formatDuration('2026-03-10T12:00:01Z', start)).toBe('0.0 s');
});

test('a count of one has a singular noun', () => {
  expect([0, 1, 55].map((count) => plural(count, 'case'))).toEqual([
    '0 cases',
    '1 case',
    '55 cases',
  ]);
});
