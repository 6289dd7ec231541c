// SPDX-License-Identifier: GPL-3.0-or-later
// The data of the page: what is known of the mesh and the curves as JSON, numbers in a block of bytes in base64. The
// format is described where it is written, in view_page.cpp and data_block.h of the program.

const types = {f32: Float32Array, u32: Uint32Array, u16: Uint16Array, u8: Uint8Array, i8: Int8Array};

const bytesOf = base64 => {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i)
    bytes[i] = text.charCodeAt(i);
  return bytes.buffer;
};

// Returns the object of the JSON, in which `arrays` are typed arrays by name.
export function readData(document) {
  const data = JSON.parse(document.getElementById('data').textContent);
  const block = document.getElementById('block');
  const buffer = bytesOf(block.textContent);
  block.remove(); // it need not be kept twice
  for (const [name, {type, offset, length}] of Object.entries(data.arrays))
    data.arrays[name] = new types[type](buffer, offset, length);
  // JSON has no infinity: a curve without a number cannot slide anywhere
  for (const c of data.curves)
    c.prominence ??= Infinity;
  return data;
}
