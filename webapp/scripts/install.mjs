// Installs what package-lock.json pins, and only when it has changed since: Maven calls this on every
// build, and a second build must need neither the network nor the time.
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
  // Last, so that an interrupted install is done again.
  writeFileSync(STAMP, wanted);
}
