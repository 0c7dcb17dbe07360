import '@testing-library/jest-dom/vitest';
import { cleanup, configure } from '@testing-library/react';
import { afterEach } from 'vitest';

afterEach(cleanup);

// For slow machines: the first test of a file also loads its page. A passing test does not wait this long.
configure({ asyncUtilTimeout: 30_000 });

// Browser APIs that Mantine needs and jsdom does not have.
if (typeof window !== 'undefined') {
  window.matchMedia = (query) =>
    Object.assign(new EventTarget(), {
      // Dialogs and drawers appear at once: a slow machine sees the frames of their transitions.
      matches: query === '(prefers-reduced-motion: reduce)',
      media: query,
      onchange: null,
      addListener: () => undefined,
      removeListener: () => undefined,
    });
  window.scrollTo = () => undefined;
  Element.prototype.scrollTo = () => undefined;
  // jsdom has no layout; virtual lists render the rows that fit into this height.
  Object.defineProperty(Element.prototype, 'clientHeight', { get: () => 600, configurable: true });
  Object.defineProperty(Element.prototype, 'clientWidth', { get: () => 1000, configurable: true });
  window.ResizeObserver = class {
    observe = () => undefined;
    unobserve = () => undefined;
    disconnect = () => undefined;
  };
  // Growing text areas wait for fonts.
  Object.defineProperty(document, 'fonts', { value: new EventTarget(), configurable: true });
  Blob.prototype.arrayBuffer = function () {
    return new Promise((resolve, reject) => {
      const reader = new FileReader();
      reader.addEventListener('load', () => {
        resolve(reader.result as ArrayBuffer);
      });
      reader.addEventListener('error', reject);
      reader.readAsArrayBuffer(this);
    });
  };
  // Charts draw on a canvas that shows nothing. Others have none: axe would check icon fonts on it.
  const blank: object = new Proxy({}, { get: () => () => blank, set: () => true });
  HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement) {
    return this.hasAttribute('data-zr-dom-id') ? blank : null;
  } as typeof HTMLCanvasElement.prototype.getContext;
}
