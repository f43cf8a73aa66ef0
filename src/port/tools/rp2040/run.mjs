/*
 * Runs a board's firmware in an emulated Raspberry Pi Pico with a strict ST7789, and says what was seen.
 *
 * node run.mjs MODULES IMAGE.uf2 PANEL STOP FRAMES OUT [rom=FILE] [AFTER:BUTTONS ...]
 * MODULES: the directory in which npm installed rp2040js. PANEL: a name of GLASSES in st7789.mjs. STOP: the address (hexadecimal) that the
 * program reaches each time that a picture is on the glass: first a test pattern, then FRAMES frames. OUT: files OUT.glass (the glass at
 * each stop, 3 bytes a pixel, red first), OUT.log (the serial line), OUT.json (figures and what was wrong).
 * rom=FILE: bytes of a boot ROM, for programs that call it once they run.
 * AFTER:BUTTONS: after that many stops the buttons are held so, bit 0 for the first, bit 1 for the second.
 * Exit code 0: all ran, whatever is in OUT.json; 2: it could not be started.
 */
import fs from 'node:fs';

import { Board } from './board.mjs';
import { GLASSES, St7789 } from './st7789.mjs';

const STOP_LIMIT_MS = 4000; /* for any one picture */

function write(file, data) {
  fs.writeFileSync(`${file}.part`, data);
  fs.renameSync(`${file}.part`, file);
}

function buttons_of(words) {
  return new Map(words.map((word) => {
    const match = /^(\d+):([0-3])$/.exec(word);
    if (match === null) throw new Error(`buttons are '${word}': say AFTER:BUTTONS, a number of stops and 0 to 3`);
    return [Number(match[1]), Number(match[2])];
  }));
}

function run([modules, uf2, panel, stop, frames, out, ...words]) {
  if (out === undefined) throw new Error('usage: run.mjs MODULES IMAGE.uf2 PANEL STOP FRAMES OUT [rom=FILE] [AFTER:BUTTONS ...]');
  const glass = GLASSES[panel], wanted = Number(frames), address = parseInt(stop, 16);
  const rom = words[0]?.startsWith('rom=') ? fs.readFileSync(words.shift().slice(4)) : null, buttons = buttons_of(words);
  if (glass === undefined) throw new Error(`no panel ${panel}: say one of ${Object.keys(GLASSES).join(', ')}`);
  if (!(wanted >= 1) || !(address > 0)) throw new Error(`FRAMES is '${frames}' and STOP is '${stop}': say a count and a hexadecimal address`);
  const started = performance.now(), seen = [], stops = [];
  const board = new Board({ modules, uf2, rom, display: (on) => new St7789({ glass, now: () => on.now, problem: (text) => on.problem(text) }) });
  board.boot();
  while (stops.length <= wanted && board.run_to(address, STOP_LIMIT_MS)) {
    stops.push({ now: board.now, bits: board.bits_time });
    seen.push(board.display.picture());
    const held = buttons.get(stops.length);
    if (held !== undefined) [1, 2].forEach((i) => board.press(`button_${i}`, (held & i) !== 0));
  }
  if (board.stopped !== null) board.problem(board.stopped);
  if (stops.length > wanted) board.display.finish();
  const first = stops[1], last = stops.at(-1), counted = stops.length - 2;
  write(`${out}.glass`, Buffer.concat(seen));
  write(`${out}.log`, board.log);
  write(`${out}.json`, `${JSON.stringify({
    stops: stops.length, width: glass.width, height: glass.height, problems: board.problems, problem_count: board.problem_count,
    frames_a_second: counted > 0 ? counted * 1e9 / (last.now - first.now) : null,
    bus_busy: counted > 0 ? (last.bits - first.bits) / (last.now - first.now) : null,
    bus_hz: board.mcu.spi[0].clockFrequency, system_hz: board.mcu.clkSys, backlight: board.mcu.gpio[21].outputValue,
    milliseconds: board.now / 1e6, host_seconds: (performance.now() - started) / 1000,
  }, null, 1)}\n`);
}

try {
  run(process.argv.slice(2));
} catch (error) {
  console.error(error.message);
  process.exitCode = 2;
}
