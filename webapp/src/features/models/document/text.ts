import type { NamedText } from './draft';

/** The XML of an element. */
export function serialized(element: Element): string {
  return new XMLSerializer().serializeToString(element);
}

/** Elements with texts in a list; those without a text are left out. */
export function list(name: string, item: string, texts: readonly NamedText[]): string[] {
  const given = texts.filter(({ text }) => text.trim() !== '');
  if (given.length === 0) return [];
  return [
    `  <${name}>`,
    ...given.map(
      ({ name: own, text }) => `    <${item}${attributes({ name: own })}>${escape(text)}</${item}>`,
    ),
    `  </${name}>`,
  ];
}

/** Attributes that are not empty. */
export function attributes(given: Record<string, string>): string {
  return Object.entries(given)
    .filter(([, value]) => value !== '')
    .map(([name, value]) => ` ${name}="${quoted(value)}"`)
    .join('');
}

/** The text of an element. */
export function escape(text: string): string {
  return text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
}

/** The value of an attribute. */
export function quoted(text: string): string {
  return escape(text).replaceAll('"', '&quot;');
}

export function attributesOf(element: Element | undefined): Record<string, string> {
  return Object.fromEntries(
    [...(element?.attributes ?? [])].map(({ name, value }) => [name, value]),
  );
}

export function child(parent: Element | null | undefined, name: string): Element | undefined {
  return children(parent, name)[0];
}

export function children(parent: Element | null | undefined, name: string): Element[] {
  return [...(parent?.children ?? [])].filter(({ tagName }) => tagName === name);
}

export function textOf(parent: Element, name: string): string {
  return child(parent, name)?.textContent.trim() ?? '';
}

export function namedOf(parent: Element | undefined, name: string): NamedText[] {
  return children(parent, name).map((element) => ({
    name: element.getAttribute('name') ?? '',
    text: element.textContent,
  }));
}

export function textsOf(parent: Element | undefined, name: string): string[] {
  return children(parent, name).map(({ textContent }) => textContent);
}
