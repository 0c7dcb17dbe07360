/**
 * Moves the style sheets behind the body, so that the browser paints the header of index.html before it has them. Scripts
 * still wait for the style sheets.
 */
export function shellFirst() {
  return {
    name: 'sitaf:shell-first',
    transformIndexHtml: {
      order: 'post',
      handler(html) {
        const sheets = [];
        const rest = html.replace(/\s*<link rel="stylesheet"[^>]*>/g, (sheet) => {
          sheets.push(sheet);
          return '';
        });
        return rest.replace(/\s*<\/body>/, (end) => sheets.join('') + end);
      },
    },
  };
}
