// SPDX-License-Identifier: GPL-3.0-or-later
// node build.js PAGE_TEMPLATE.cpp
//
// Bundles the page of the viewer, and writes it as a C++ file that defines page_template().
import {build} from 'esbuild';
import {readFileSync, writeFileSync} from 'node:fs';
import {fileURLToPath} from 'node:url';

const source = name => fileURLToPath(new URL(`src/${name}`, import.meta.url));

const bundle = async entry => {
  const result = await build({
    entryPoints: [source(entry)],
    bundle: true,
    minify: true,
    format: 'iife',
    target: ['chrome100', 'firefox100', 'safari15'],
    legalComments: 'inline',
    write: false,
    logLevel: 'warning',
  });
  return result.outputFiles[0].text.trim();
};

// The marks are replaced by functions, since $ has a meaning in replacement texts.
const script = await bundle('main.js');
const style = await bundle('style.css');
const page = readFileSync(source('page.html'), 'utf8')
  .replace('/* style */', () => style)
  .replace('/* script */', () => script);
if ((page.match(/<\/script>/g) ?? []).length !== 1)
  throw new Error('the script ends itself');

// Compilers need not take longer literals than 65,536 bytes.
const characters = Buffer.from(page, 'utf8');
const pieces = [];
for (let begin = 0; begin < characters.length; begin += 16000) {
  let piece = '';
  for (const c of characters.subarray(begin, begin + 16000))
    piece += c === 0x22 || c === 0x5c ? '\\' + String.fromCharCode(c)
      : c >= 0x20 && c < 0x7f && c !== 0x3f ? String.fromCharCode(c)
      : '\\' + c.toString(8).padStart(3, '0');
  pieces.push(`    "${piece}"`);
}
writeFileSync(process.argv[2], `// Made by build.js.
#include "page_template.h"

namespace constrictions {

namespace {

const char* const pieces[] = {
${pieces.join(',\n')}};

} // namespace

const std::string& page_template()
{
  static const std::string page = [] {
    std::string result;
    for(const char* piece : pieces)
      result += piece;
    return result;
  }();
  return page;
}

} // namespace constrictions
`);
