/** A comment of a document, and the place to which it belongs. */
export interface Comment {
  text: string;
  /** The element that contains the comment. */
  parent: string;
  /** The element that follows the comment in its parent; absent for the last ones. */
  before?: string;
}

/** Elements that are kept as text, with their comments. */
const KEPT = ['strength', 'case_list'];

/** Collects the comments of a test model that the editor would not keep otherwise. */
export function readComments(root: Element): Comment[] {
  const found: Comment[] = [];
  collect(root, addressOf(root), found);
  return found;
}

function collect(parent: Element, address: string, found: Comment[]) {
  for (const node of parent.childNodes) {
    if (node.nodeType === Node.COMMENT_NODE) {
      const next = nextElement(node);
      found.push({
        text: node.textContent ?? '',
        parent: address,
        ...(next ? { before: `${address}/${addressOf(next)}` } : {}),
      });
    } else if (node instanceof Element && !KEPT.includes(node.tagName)) {
      collect(node, `${address}/${addressOf(node)}`, found);
    }
  }
}

/**
 * Writes comments into a document: before the element that followed, or at the end of the parent. A
 * comment of an element that was removed moves to the nearest element around it.
 */
export function withComments(xml: string, comments: readonly Comment[]): string {
  if (comments.length === 0) return xml;
  const document = new DOMParser().parseFromString(xml, 'application/xml');
  const root = document.documentElement;
  const elements = new Map<string, Element>();
  index(root, addressOf(root), elements);
  for (const { text, parent, before } of comments) {
    const comment = document.createComment(text);
    const next = before === undefined ? undefined : elements.get(before);
    if (next?.parentNode) {
      next.before(comment, indentation(next));
    } else {
      appendTo(nearest(parent, elements) ?? root, comment);
    }
  }
  return `<?xml version="1.0" encoding="UTF-8"?>\n${new XMLSerializer().serializeToString(root)}\n`;
}

/** Appends a comment on a line of its own, unless the element has text. */
function appendTo(parent: Element, comment: globalThis.Comment) {
  const end = parent.lastChild;
  if (end?.nodeType === Node.TEXT_NODE && end.textContent?.trim() === '') {
    const line = comment.ownerDocument.createTextNode(`${end.textContent}  `);
    end.before(line, comment);
  } else {
    parent.append(comment);
  }
}

function index(element: Element, address: string, elements: Map<string, Element>) {
  elements.set(address, element);
  for (const inner of element.children) index(inner, `${address}/${addressOf(inner)}`, elements);
}

function nearest(address: string, elements: Map<string, Element>): Element | undefined {
  for (let at = address; at !== ''; at = at.slice(0, Math.max(0, at.lastIndexOf('/')))) {
    const element = elements.get(at);
    if (element) return element;
  }
  return undefined;
}

/** The line break and the spaces before an element. */
function indentation(element: Element): string {
  const before = element.previousSibling;
  const text = before?.nodeType === Node.TEXT_NODE ? (before.textContent ?? '') : '';
  return text.slice(Math.max(0, text.lastIndexOf('\n')));
}

function nextElement(node: Node): Element | null {
  let next = node.nextSibling;
  while (next && !(next instanceof Element)) next = next.nextSibling;
  return next;
}

/** The name of an element among its siblings: by its own name, or by its number. */
function addressOf(element: Element): string {
  const own = element.getAttribute('name') ?? childName(element);
  const same = [...(element.parentElement?.children ?? [])].filter(
    ({ tagName }) => tagName === element.tagName,
  );
  const key = own ?? String(same.indexOf(element));
  return `${element.tagName}[${key.replaceAll('/', '|')}]`;
}

function childName(element: Element): string | undefined {
  return element.tagName === 'test_element'
    ? [...element.children].find(({ tagName }) => tagName === 'name')?.textContent.trim()
    : undefined;
}
