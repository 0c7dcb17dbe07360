import { Buffer } from 'node:buffer';
import { brotliCompressSync, constants } from 'node:zlib';

const COMPRESSIBLE = /\.(js|css|svg)$/;
/** One less than the best takes half the time for 2 % more bytes. */
const QUALITY = 10;

/**
 * Adds each asset compressed with Brotli as `FILE.br`. The server gives it to browsers that accept it: it is a sixth smaller
 * than what the server compresses with gzip, and takes no time.
 */
export function brotli() {
  return {
    name: 'sitaf:brotli',
    generateBundle: {
      order: 'post',
      handler(_, bundle) {
        for (const [fileName, file] of Object.entries(bundle)) {
          if (!fileName.startsWith('assets/') || !COMPRESSIBLE.test(fileName)) continue;
          this.emitFile({
            type: 'asset',
            fileName: `${fileName}.br`,
            source: compressed(file.code ?? file.source),
          });
        }
      },
    },
  };
}

function compressed(content) {
  const bytes = Buffer.from(content);
  return brotliCompressSync(bytes, {
    params: {
      [constants.BROTLI_PARAM_QUALITY]: QUALITY,
      [constants.BROTLI_PARAM_SIZE_HINT]: bytes.length,
    },
  });
}
