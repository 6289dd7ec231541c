// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the tests in the browser, or says why not.
import {spawnSync} from 'node:child_process';
import {fileURLToPath} from 'node:url';
import {executablePath} from '../browser.js';

if (!executablePath) {
  console.log('skipped: there is no Chromium: set CHROMIUM to its place, or use scripts/setup.sh --browser');
  process.exit(0);
}
const tests = ['viewer', 'controls', 'context', 'cling'].map(name => fileURLToPath(new URL(`${name}.test.js`, import.meta.url)));
process.exit(spawnSync(process.execPath, ['--test', '--test-reporter=spec', ...tests], {stdio: 'inherit'}).status ?? 1);
