import { readdirSync, readFileSync } from 'node:fs';
import { join, relative, sep } from 'node:path';
import { fileURLToPath, URL } from 'node:url';
import { zipSync } from 'fflate';

/** The examples that the portal offers, see src/features/activities/Examples.tsx. */
const NAMES = ['ir-sensor-faulty', 'ir-sensor-python', 'wall-approach'];
const FOLDER = fileURLToPath(new URL('../../examples/', import.meta.url));
const PATH = 'assets/examples/';
/** The same files give the same bytes. */
const MTIME = new Date(2026, 0, 1);

/** Adds the examples as zip files to the build, and serves them during development. */
export function examples() {
  return {
    name: 'sitaf-examples',
    generateBundle() {
      for (const name of NAMES) {
        this.emitFile({ type: 'asset', fileName: `${PATH}${name}.zip`, source: zipOf(name) });
      }
    },
    configureServer(server) {
      server.middlewares.use((request, response, next) => {
        const name = NAMES.find((known) => request.url === `/${PATH}${known}.zip`);
        if (name) response.end(zipOf(name));
        else next();
      });
    },
  };
}

function zipOf(name) {
  const root = join(FOLDER, name);
  const files = readdirSync(root, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath, entry.name))
    .sort();
  return zipSync(
    Object.fromEntries(
      files.map((file) => [
        relative(root, file).split(sep).join('/'),
        [readFileSync(file), { mtime: MTIME }],
      ]),
    ),
  );
}
