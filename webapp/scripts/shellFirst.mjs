/**
 * Moves the style sheets between the header of index.html and the portal, so that the browser paints the header before it
 * has them. Scripts still wait for them, and the variables of the theme, which come with the portal, still follow them.
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
        const place = rest.search(/\s*<div id="root">/);
        if (place < 0) throw new Error('index.html has no element #root for the portal');
        return rest.slice(0, place) + sheets.join('') + rest.slice(place);
      },
    },
  };
}
