/*
 * Runs a UF2 image in an emulated Raspberry Pi Pico with a strict ST7789, and says what was seen.
 *
 * node run.mjs MODULES IMAGE.uf2 PANEL OUT [FRAMES [MILLISECONDS]]
 * MODULES: the directory in which npm installed rp2040js. PANEL: a name of st7789.mjs. OUT: files OUT.png (the glass at the end),
 * OUT.rgb565 (the same, two bytes a pixel, high byte first), OUT.log (the serial line), OUT.json (figures and what was wrong).
 * Stops when FRAMES (60) pictures after the first one, which is a test pattern, are on the glass, or with an error after MILLISECONDS
 * (10000) of emulated time. Exit code 0: all of them came and nothing was wrong; 1 otherwise.
 */
import fs from 'node:fs';

import { Board } from './board.mjs';
import { write_png } from './png.mjs';
import { GLASSES, St7789 } from './st7789.mjs';

function write(file, data) {
  fs.writeFileSync(`${file}.part`, data);
  fs.renameSync(`${file}.part`, file);
}

function run([modules, uf2, panel, out, frames = '60', limit_ms = '10000']) {
  if (out === undefined) throw new Error('usage: run.mjs MODULES IMAGE.uf2 PANEL OUT [FRAMES [MILLISECONDS]]');
  const glass = GLASSES[panel], wanted = Number(frames);
  if (glass === undefined) throw new Error(`no panel ${panel}: say one of ${Object.keys(GLASSES).join(', ')}`);
  if (!(wanted >= 2) || !(Number(limit_ms) > 0)) throw new Error('FRAMES is at least 2, MILLISECONDS at least 1');
  const bits_at = []; /* time in which bits had moved, at the beginning of each picture */
  const board = new Board({
    modules, uf2,
    display: (on) => new St7789({
      glass, now: () => on.now, problem: (text) => on.problem(text), frame_begins: () => bits_at.push(on.bits_time) }),
  });
  const started = performance.now(), display = board.display, pixels = glass.width * glass.height;
  /* The pattern, `wanted` pictures, and the first command of the next one: then a picture is whole and its line has been written. */
  const end = board.run(() => display.frames.length > wanted + 1, Number(limit_ms));
  if (end === 'limit') board.problem(`only ${Math.max(0, display.frames.length - 2)} of ${wanted} pictures came in ${limit_ms} ms of the chip's time`);
  if (end === 'done' && display.pixels < pixels * (wanted + 1)) board.problem(`${display.pixels} pixels came, which is not ${wanted + 1} whole pictures`);
  display.finish();
  const first = display.frames[1], last = display.frames.at(-1), picture = display.picture();
  const result = {
    end, frames: display.frames.length - 2, problems: board.problems, problem_count: board.problem_count,
    frames_a_second: (display.frames.length - 2) * 1e9 / (last - first),
    bus_busy: (bits_at.at(-1) - bits_at[1]) / (last - first),
    bus_hz: board.mcu.spi[0].clockFrequency, system_hz: board.mcu.clkSys, backlight: board.mcu.gpio[21].outputValue,
    milliseconds: board.now / 1e6, host_seconds: (performance.now() - started) / 1000,
  };
  write_png(`${out}.png`, picture, glass.width, glass.height);
  write(`${out}.rgb565`, Buffer.from(picture.buffer).swap16());
  write(`${out}.log`, board.log);
  write(`${out}.json`, `${JSON.stringify(result, null, 1)}\n`);
  return end === 'done' && board.problem_count === 0 ? 0 : 1;
}

try {
  process.exitCode = run(process.argv.slice(2));
} catch (error) {
  console.error(`run.mjs: ${error.message}`);
  process.exitCode = 2;
}
