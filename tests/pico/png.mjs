/* A picture of 5-6-5 words as a PNG file, for people to look at. */
import fs from 'node:fs';
import zlib from 'node:zlib';

function chunk(name, data) {
  const body = Buffer.concat([Buffer.from(name, 'latin1'), data]), out = Buffer.alloc(body.length + 8);
  out.writeUInt32BE(data.length, 0);
  body.copy(out, 4);
  out.writeUInt32BE(crc32(body), body.length + 4);
  return out;
}

/* CRC-32 as in PNG, zip and the golden files. */
export function crc32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit++) crc = crc & 1 ? crc >>> 1 ^ 0xedb88320 : crc >>> 1;
  }
  return (crc ^ 0xffffffff) >>> 0;
}

export function write_png(file, words, width, height) {
  const rows = Buffer.alloc(height * (1 + 3 * width)), header = Buffer.alloc(13);
  words.forEach((word, i) => {
    const r = word >> 11, g = word >> 5 & 63, b = word & 31, at = Math.floor(i / width) * (1 + 3 * width) + 1 + 3 * (i % width);
    rows.set([r << 3 | r >> 2, g << 2 | g >> 4, b << 3 | b >> 2], at);
  });
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, 2, 0, 0, 0], 8);
  fs.writeFileSync(`${file}.part`, Buffer.concat([
    Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]), chunk('IHDR', header), chunk('IDAT', zlib.deflateSync(rows)),
    chunk('IEND', Buffer.alloc(0))]));
  fs.renameSync(`${file}.part`, file);
}
