// Installs the packages of package-lock.json if it has changed. Maven runs this in every build, and
// only the first one needs the network.
import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';

const STAMP = 'node_modules/.installed';

const wanted = createHash('sha256')
  .update(readFileSync('package.json'))
  .update(readFileSync('package-lock.json'))
  .update(`${process.platform} ${process.arch} ${process.versions.modules}`)
  .digest('hex');
const installed = existsSync(STAMP) ? readFileSync(STAMP, 'utf8') : '';

if (installed !== wanted) {
  console.log('Installing the packages of the portal (once; npm ci)');
  const { status, error } = spawnSync('npm', ['ci', '--prefer-offline'], { stdio: 'inherit' });
  if (error) {
    console.error(`npm could not be started: ${error.message}. Install Node.js 20.19 or newer.`);
  }
  if (status !== 0) process.exit(status ?? 1);
  // Written last, so that an interrupted installation is repeated.
  writeFileSync(STAMP, wanted);
}
