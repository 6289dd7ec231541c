// SPDX-License-Identifier: GPL-3.0-or-later
// A browser without a screen, that draws without a graphics card.
import {chromium} from 'playwright-core';
import {existsSync} from 'node:fs';

// Debian's, unless CHROMIUM names another one.
export const executablePath = process.env.CHROMIUM ?? ['/usr/bin/chromium', '/usr/bin/chromium-browser'].find(existsSync);

// It may be slow on a machine with other work to do.
export const patience = 120_000; // milliseconds

export function openBrowser() {
  return chromium.launch({
    executablePath,
    timeout: patience,
    args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
  });
}
