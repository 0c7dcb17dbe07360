import '@testing-library/jest-dom/vitest';
import { cleanup, configure } from '@testing-library/react';
import { afterEach } from 'vitest';

afterEach(cleanup);

// Machines that run many things at once are slow; nothing waits this long when all is well.
configure({ asyncUtilTimeout: 8_000 });

// What browsers have, Mantine asks for, and jsdom lacks.
if (typeof window !== 'undefined') {
  window.matchMedia = (query) =>
    Object.assign(new EventTarget(), {
      matches: false,
      media: query,
      onchange: null,
      addListener: () => undefined,
      removeListener: () => undefined,
    });
  window.scrollTo = () => undefined;
  Element.prototype.scrollTo = () => undefined;
  // jsdom lays nothing out; lists draw the rows that fit in this height.
  Object.defineProperty(Element.prototype, 'clientHeight', { get: () => 600 });
  Object.defineProperty(Element.prototype, 'clientWidth', { get: () => 1000 });
  window.ResizeObserver = class {
    observe = () => undefined;
    unobserve = () => undefined;
    disconnect = () => undefined;
  };
  // Axe looks for icon fonts on a canvas; without one it does without.
  HTMLCanvasElement.prototype.getContext = () => null;
}
