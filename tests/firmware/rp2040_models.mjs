/*
 * The strict panel and flash of the RP2040 emulator (src/port/tools/rp2040), each told what a bad driver tells them: every mistake has to become its
 * sentence, and a good driver's bytes none.
 */
import { FlashInterface } from '../../src/port/tools/rp2040/flash.mjs';
import { GLASSES, St7789 } from '../../src/port/tools/rp2040/st7789.mjs';

let wrong = 0, checked = 0;

function check(holds, text) {
  checked++;
  if (holds) return;
  wrong++;
  console.log(`FAIL: ${text}`);
}

/* ---- panel ---- */

const MS = 1e6;
/* A driver's doings: [command, data...] at 10 MHz, numbers of milliseconds, or functions of the rig. */
const RESET = [(rig) => rig.panel.set_reset(false), 0.02, (rig) => rig.panel.set_reset(true), 120];
const START = [...RESET, [0x11], 5, [0x3a, 0x55], [0x36, 0], [0x21], [0x29]];
const WINDOW = [[0x2a, 0, 10, 0, 11], [0x2b, 0, 20, 0, 20]];
const PIXELS = [0x2c, 0xf8, 0x00, 0x07, 0xe0];

function play(doings, { glass = GLASSES['st7789-240'], hz = 10e6, mode = 0 } = {}) {
  const rig = { now: 0, said: [], hz, mode };
  rig.panel = new St7789({ glass, now: () => rig.now, problem: (text) => rig.said.push(text) });
  rig.panel.set_select(true);
  for (const doing of doings) {
    if (typeof doing === 'number') rig.now += doing * MS;
    else if (typeof doing === 'function') doing(rig);
    else doing.forEach((byte, i) => rig.panel.byte(byte, i > 0, rig.hz, rig.mode));
  }
  rig.panel.finish();
  return rig;
}

function expect(what, sentence, doings, options) {
  const { said } = play(doings, options);
  if (sentence === null) check(said.length === 0, `${what}: ${said[0]}`);
  else check(said.some((text) => sentence.test(text)), `${what}: no sentence like ${sentence}, but ${JSON.stringify(said.slice(0, 3))}`);
}

expect('a good driver', null, [...START, ...WINDOW, PIXELS]);
expect('a good driver with 12 bits', null, [...START, [0x3a, 0x53], ...WINDOW, [0x2c, 1, 2, 3]]);
expect('pixels in two pieces', null, [...START, ...WINDOW, [0x2c, 1, 2], (rig) => [3, 4].forEach((b) => rig.panel.byte(b, true, 10e6, 0))]);
expect('a short reset', /reset was low for 5.0 us/, [(rig) => rig.panel.set_reset(false), 0.005, (rig) => rig.panel.set_reset(true), 120, ...START]);
expect('no reset', /before the first reset/, START.slice(RESET.length));
expect('a byte in reset', /while reset is low/, [...START, (rig) => rig.panel.set_reset(false), [0x00]]);
expect('a command too soon after reset', /comes 1.00 ms too early/, [...RESET.slice(0, 3), 4, [0x00], 120, ...START]);
expect('sleep out too soon after reset', /sleep out 20.0 ms too early/, [...RESET.slice(0, 3), 100, [0x11], 5, ...START.slice(RESET.length + 2)]);
expect('a command too soon after sleep out', /0x3a comes 5.00 ms too early/, [...RESET, [0x11], ...START.slice(RESET.length + 2)]);
expect('sleep out too soon after software reset', /sleep out 115.0 ms too early/, [...START, [0x01], 5, ...START.slice(RESET.length)]);
expect('sleep in too soon', /less than 120 ms after sleep out/, [...START, [0x10], 130, ...START.slice(RESET.length)]);
expect('on while asleep', /while it sleeps/, [...RESET, [0x29], ...START.slice(RESET.length)]);
expect('never on', /asleep or off at the end/, START.slice(0, -1));
expect('a byte without chip select', /chip select is high/, [...START, (rig) => rig.panel.set_select(false), [0x00]]);
expect('a fast clock', /80.0 MHz/, [...START, ...WINDOW, PIXELS], { hz: 80e6 });
expect('a wrong SPI mode', /SPI mode 1/, [...START, ...WINDOW, PIXELS], { mode: 1 });
expect('an unknown command', /0x99 is unknown/, [...START, [0x99]]);
expect('too few parameters', /0x2a with 3 parameters, it takes 4/, [...START, [0x2a, 0, 0, 0], [0x00]]);
expect('too many parameters', /no parameter number 2/, [...START, [0x36, 0, 0]]);
expect('data without a command', /without a command/, [...RESET, (rig) => rig.panel.byte(1, true, 10e6, 0), ...START.slice(RESET.length)]);
expect('no pixel format', /neither 12 nor 16 bits/, [...START.filter((doing) => doing[0] !== 0x3a), ...WINDOW, [0x2c]]);
expect('an odd byte', /1 odd byte/, [...START, ...WINDOW, PIXELS.slice(0, 4), [0x00]]);
expect('a pixel too many', /after the last one of the window/, [...START, ...WINDOW, [...PIXELS, 1, 2]]);
expect('columns outside', /columns 0 to 240/, [...START, [0x2a, 0, 0, 0, 240]]);
expect('rows outside', /rows 0 to 320/, [...START, [0x2b, 0, 0, 1, 64]]);
expect('columns in the wrong order', /columns 5 to 4/, [...START, [0x2a, 0, 5, 0, 4]]);

function pixel_at(doings, x, y, options) {
  const { panel } = play(doings, options), at = 3 * (y * panel.glass.width + x);
  return panel.picture().subarray(at, at + 3).toString('hex');
}

const GREEN_RIGHT = [...START, ...WINDOW, PIXELS];
check(pixel_at(GREEN_RIGHT, 10, 20) === 'ff0000' && pixel_at(GREEN_RIGHT, 11, 20) === '00ff00', 'pixels go from left to right, red is red');
check(pixel_at([...START, [0x36, 0xc0], ...WINDOW, PIXELS], 229, 299, { glass: GLASSES['st7789-320'] }) === 'ff0000',
  'MY and MX turn by half a circle');
check(pixel_at([...START, [0x36, 0x20], ...WINDOW, PIXELS], 20, 11) === '00ff00', 'MV swaps rows and columns');
check(pixel_at([...START, [0x36, 0x08], ...WINDOW, PIXELS], 10, 20) === '0000ff', 'BGR swaps red and blue');
check(pixel_at([...START, [0x20], ...WINDOW, PIXELS], 10, 20) === '00ffff', 'without inversion an IPS glass shows the opposite');
check(pixel_at([...START, ...WINDOW, PIXELS, [0x28], [0x00]], 10, 20) === '000000', 'a display that is off is black');
check(pixel_at([...START, [0x3a, 0x53], ...WINDOW, [0x2c, 0xf0, 0x00, 0xf0]], 11, 20) === '00ff00', 'two pixels of 12 bits in three bytes');
check(pixel_at([...START, [0x2a, 0, 52, 0, 53], [0x2b, 0, 40, 0, 40], PIXELS], 0, 0, { glass: GLASSES['st7789-135'] }) === 'ff0000',
  'the small glass begins at 52, 40');

/* ---- flash ---- */

const SSI = { ctrlr0: 0x00, ctrlr1: 0x04, enable: 0x08, select: 0x10, divider: 0x14, status: 0x28, data: 0x60, format: 0xf4 };
const QUAD = 2 << 21 | 31 << 16 | 3 << 8, FIRST = 8 << 2 | 4 << 11 | 2 << 8 | 1, NEXT = (0xa0 << 24 | 8 << 2 | 4 << 11 | 2) >>> 0;
/* A boot stage's writes: [register, value], or [register] for a read. */
const send = (...bytes) => [...bytes.map((byte) => ['data', byte]), ['status']];
const BEGIN = [['enable', 0], ['divider', 2], ['select', 1], ['ctrlr0', 7 << 16], ['enable', 1]];
const ENABLE_QUAD = [...send(0x06), ...send(0x31, 2), ...send(0x05, 0), ...send(0x05, 0), ...send(0x05, 0), ...send(0x05, 0)];
const QUAD_READS = [['enable', 0], ['ctrlr0', QUAD], ['ctrlr1', 0], ['format', FIRST], ['enable', 1],
  ...send(0xeb, 0xa0), ['enable', 0], ['format', NEXT], ['enable', 1]];

function boot(writes, { hz = 125e6, status2 = 0 } = {}) {
  const said = [], flash = new FlashInterface({ problem: (text) => said.push(text), system_hz: () => hz, status2 });
  for (const [register, value] of writes) {
    if (value === undefined) flash.readUint32(SSI[register]);
    else flash.writeUint32Atomic(SSI[register], value, 0);
  }
  flash.check_in_place();
  return said;
}

function expect_flash(what, sentence, writes, options) {
  const said = boot(writes, options);
  if (sentence === null) check(said.length === 0, `${what}: ${said[0]}`);
  else check(said.some((text) => sentence.test(text)), `${what}: no sentence like ${sentence}, but ${JSON.stringify(said.slice(0, 3))}`);
}

const without = (list, i) => list.filter((_, at) => at !== i);
const changed = (list, i, value) => list.map((write, at) => (at === i ? [write[0], value] : write));
expect_flash('a good boot stage', null, [...BEGIN, ...ENABLE_QUAD, ...QUAD_READS]);
expect_flash('a flash that has quad enable on', null, [...BEGIN, ...QUAD_READS], { status2: 2 });
expect_flash('quad enable left off', /quad enable off/, [...BEGIN, ...QUAD_READS]);
expect_flash('no write enable', /without a write enable/, [...BEGIN, ...ENABLE_QUAD.slice(2), ...QUAD_READS]);
expect_flash('no wait for the write', /while the flash is busy/, [...BEGIN, ...ENABLE_QUAD.slice(0, 5), ...send(0x35, 0), ...QUAD_READS]);
expect_flash('too fast', /133 MHz/, [...changed(BEGIN, 1, 2), ...ENABLE_QUAD, ...QUAD_READS], { hz: 300e6 });
expect_flash('an odd divider', /no clock/, [...changed(BEGIN, 1, 3), ...ENABLE_QUAD, ...QUAD_READS]);
expect_flash('set up while on', /while SSI is on/, [...BEGIN, ...ENABLE_QUAD, ...without(QUAD_READS, 0)]);
expect_flash('wrong dummy clocks', /5 dummy clocks/, [...BEGIN, ...ENABLE_QUAD, ...changed(QUAD_READS, 3, FIRST + (1 << 11))]);
expect_flash('no mode byte', /not in quad reads/, [...BEGIN, ...ENABLE_QUAD, ...changed(QUAD_READS, 6, 0)]);
expect_flash('no first read', /not in quad reads/, [...BEGIN, ...ENABLE_QUAD, ...QUAD_READS.slice(0, 5), ...QUAD_READS.slice(8)]);
expect_flash('instructions kept in reads', /8 bits of instruction/, [...BEGIN, ...ENABLE_QUAD, ...changed(QUAD_READS, 9, NEXT + (2 << 8))]);
expect_flash('words of 8 bits in reads', /words of 32 bits/, [...BEGIN, ...ENABLE_QUAD, ...changed(QUAD_READS, 1, 2 << 21 | 7 << 16 | 3 << 8)]);
expect_flash('left off', /SSI is off/, [...BEGIN, ...ENABLE_QUAD, ...QUAD_READS.slice(0, -1)]);
expect_flash('an unknown instruction', /9fh is not one/, [...BEGIN, ...send(0x9f, 0), ...ENABLE_QUAD, ...QUAD_READS]);

console.log(`${checked} checks, ${wrong} wrong`);
process.exitCode = wrong > 0 || checked === 0 ? 1 : 0;
