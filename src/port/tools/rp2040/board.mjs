/*
 * A Raspberry Pi Pico in an emulator (rp2040js, and core 1 besides) that is stricter than the emulator: it starts as the boot ROM starts a UF2
 * image, takes its time on SPI and UART, and minds resets, pin functions and clocks. What is wrong becomes a sentence.
 *
 * Numbers in brackets are sections of the RP2040 data sheet.
 */
import fs from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';

import { FlashInterface } from './flash.mjs';
import { SecondCore } from './second_core.mjs';

const FLASH = 0x10000000, FLASH_END = 0x11000000, BOOT2_AT = 0x20041f00, BOOT2_BYTES = 252;
/* What the emulator lacks and no program here needs: UART0's DMA. */
const NOT_EMULATED = ['UART0: Unimplemented peripheral write to 0x48: 0x3'];
const PROBLEMS_SHOWN = 20;
const BOOT_LIMIT = 1e9; /* ns */
/* A PL022 in mode 0 or 2 lets its frame signal rise between words (4.4.3.9): the clock rests for 1.5 periods. */
const PAUSE_BITS = 1.5;
const UART_FIFO = 32;
const CRYSTAL_MHZ = 12;

/* Peripherals that are held in reset until they are let go, by page of addresses (2.14.3). */
const RESET_BITS = {
  0x50000: [2, 'DMA'], 0x40014: [5, 'IO_BANK0'], 0x4001c: [8, 'PADS_BANK0'], 0x40028: [12, 'PLL_SYS'], 0x4002c: [13, 'PLL_USB'],
  0x4003c: [16, 'SPI0'], 0x40040: [17, 'SPI1'], 0x40054: [21, 'TIMER'], 0x40034: [22, 'UART0'], 0x40038: [23, 'UART1'],
};
const RESETS_ALL = 0x1ffffff;

export const PINS = { log: 0, button_1: 14, button_2: 15, dc: 16, select: 17, clock: 18, data: 19, reset: 20, backlight: 21 };
const FUNCTION_SPI = 1, FUNCTION_UART = 2, FUNCTION_SIO = 5;

/* As the boot ROM checks a second stage (2.8.1.3.1): CRC-32/MPEG-2. */
function crc32_mpeg2(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc = (crc ^ byte << 24) >>> 0;
    for (let bit = 0; bit < 8; bit++) crc = (crc & 0x80000000 ? crc << 1 ^ 0x04c11db7 : crc << 1) >>> 0;
  }
  return crc;
}

/* Checks a UF2 file as the ROM's USB drive would (2.8.4.2), and hands each block's address and bytes to `program`. */
function unpack_uf2(file, program) {
  const bad = (block, text) => { throw new Error(`${file}, block ${block}: ${text}`); };
  const all = fs.readFileSync(file);
  if (all.length === 0 || all.length % 512 !== 0) bad(0, `${all.length} bytes are no whole number of blocks of 512`);
  for (let number = 0; number < all.length / 512; number++) {
    const block = all.subarray(512 * number, 512 * (number + 1)), word = (i) => block.readUInt32LE(4 * i);
    if (word(0) !== 0x0a324655 || word(1) !== 0x9e5d5157 || word(127) !== 0x0ab16f30) bad(number, 'wrong magic numbers');
    if (word(2) !== 0x2000 || word(7) !== 0xe48bff56) bad(number, 'not for the family RP2040');
    if (word(4) !== 256 || word(3) % 256 !== 0) bad(number, 'not one page of 256 bytes');
    if (word(3) < FLASH || word(3) >= FLASH_END) bad(number, `address 0x${word(3).toString(16)} is outside flash`);
    if (word(5) !== number || word(6) !== all.length / 512) bad(number, 'numbered wrongly');
    program(word(3), block.subarray(32, 32 + 256));
  }
}

/* Resets (2.14.3), which the emulator lacks: everything is held from the start. */
class Resets {
  constructor() { this.held = RESETS_ALL; this.select = 0; }

  readUint32(offset) { return offset === 0 ? this.held : offset === 4 ? this.select : ~this.held & RESETS_ALL; }

  writeUint32Atomic(offset, value, type) {
    const old = this.readUint32(offset), to = [value, old ^ value, old | value, old & ~value][type] & RESETS_ALL;
    if (offset === 0) this.held = to;
    if (offset === 4) this.select = to;
  }
}

export class Board {
  /* `modules`: where npm has put rp2040js. `display(board)` makes what hangs on SPI0: an object with set_reset, set_select, byte.
   * `rom`: bytes of a boot ROM, or null. */
  constructor({ modules, uf2, display, rom = null, flash_status2 = 0 }) {
    const { RP2040 } = createRequire(path.join(path.resolve(modules), 'node_modules/'))('rp2040js');
    this.problems = [];
    this.problem_count = 0;
    this.log = '';
    this.bits_time = 0; /* nanoseconds in which bits moved */
    this.stopped = null; /* or why */
    const mcu = this.mcu = new RP2040();
    this.core = mcu.core;
    this.clock = mcu.clock;
    this.silence();
    unpack_uf2(uf2, (address, bytes) => mcu.flash.set(bytes, address - FLASH));
    if (rom !== null) new Uint8Array(mcu.bootrom.buffer).set(rom);
    this.wire_resets();
    this.wire_flash(flash_status2);
    this.wire_spi(display);
    this.wire_uart();
    this.second = new SecondCore(mcu, (text) => this.problem(text));
    this.start();
  }

  get now() { return this.clock.nanos; }

  problem(text) {
    this.problem_count++;
    if (this.problems.length < PROBLEMS_SHOWN) this.problems.push(`${(this.now / 1e6).toFixed(3)} ms: ${text}`);
  }

  /* The emulator's own complaints are problems too. */
  silence() {
    const nothing = () => {};
    const complain = (who, what) => { if (!NOT_EMULATED.includes(`${who}: ${what}`)) this.problem(`emulator, ${who}: ${what}`); };
    this.mcu.logger = { debug: nothing, info: nothing, warn: complain, error: complain };
    this.mcu.onBreak = (code) => {
      this.stopped = `the program stopped itself: breakpoint ${code} at 0x${this.core.PC.toString(16)} (a fault, or an interrupt without a handler)`;
    };
  }

  wire_resets() {
    const { mcu } = this, resets = this.resets = new Resets(), find = mcu.findPeripheral.bind(mcu);
    mcu.peripherals[0x4000c] = resets;
    mcu.peripherals[0x40010] ??= resets;
    const watchdog = mcu.peripherals[0x40058], write = watchdog.writeUint32.bind(watchdog);
    watchdog.tickEnable = false;
    watchdog.writeUint32 = (offset, value) => {
      const periods = value & 0x1ff;
      if (offset === 0x2c && periods !== CRYSTAL_MHZ) this.problem(`the timer's tick comes every ${periods} periods of the crystal, not every 12`);
      write(offset, value);
    };
    mcu.findPeripheral = (address) => {
      const page = (address >>> 14) << 2, reset = RESET_BITS[page];
      if (reset !== undefined && (resets.held >>> reset[0] & 1) !== 0) this.problem(`${reset[1]} is used while it is held in reset`);
      if (page === 0x40054 && !watchdog.tickEnable) this.problem('the timer is used, but its tick is off');
      return find(address);
    };
  }

  wire_flash(status2) {
    this.flash = new FlashInterface({ problem: (text) => this.problem(text), system_hz: () => this.mcu.clkSys, status2 });
    this.mcu.peripherals[0x18000] = this.flash;
    /* Pads and pins of the flash: taken as they come. */
    this.mcu.peripherals[0x40018] = { readUint32: () => 0, writeUint32Atomic() {} };
  }

  expect_pin(pin, name, functions, is_output) {
    const gpio = this.mcu.gpio[pin];
    if (!functions.includes(gpio.functionSelect)) {
      this.problem(`GPIO ${pin} (${name}) has function ${gpio.functionSelect}, it takes ${functions.join(' or ')}`);
    } else if (gpio.outputDisable) {
      this.problem(`the pad of GPIO ${pin} (${name}) has its output disabled`);
    } else if (is_output && !gpio.outputEnable) {
      this.problem(`GPIO ${pin} (${name}) does not drive`);
    }
  }

  /* Once, when the first byte goes out: what the emulator does not look at. */
  check_set_up() {
    this.expect_pin(PINS.clock, 'SPI0 SCK', [FUNCTION_SPI]);
    this.expect_pin(PINS.data, 'SPI0 TX', [FUNCTION_SPI]);
    for (const name of ['dc', 'select', 'reset']) this.expect_pin(PINS[name], name, [FUNCTION_SIO], true);
    const pll = this.mcu.pllSys;
    if (this.mcu.clocks.sysFreq === pll.frequency) {
      const vco = this.mcu.xoscFreq / (pll.refdiv || 1) * pll.fbdiv;
      if ((pll.pwr & 0x29) !== 0) this.problem('clk_sys runs from PLL_SYS, parts of which are powered down');
      if (vco < 750e6 || vco > 1600e6) this.problem(`PLL_SYS: its oscillator at ${vco / 1e6} MHz is outside 750 to 1600`);
      if (pll.postdiv1 < pll.postdiv2) this.problem('PLL_SYS: the first divider should be the larger one (2.18.2)');
    }
    if (!this.mcu.peripherals[0x40024].stable) this.problem('the crystal oscillator is not running');
  }

  wire_spi(make_display) {
    const { mcu, clock } = this, spi = mcu.spi[0], display = this.display = make_display(this);
    let word = 0, bits = 8, hz = 0, mode = 0, checked = false;
    /* D/C and CS count as they are when the last bit has left. */
    const done = clock.createAlarm(() => {
      const dc = mcu.gpio[PINS.dc].outputValue, count = Math.ceil(bits / 8);
      for (let i = count - 1; i >= 0; i--) display.byte(word >>> 8 * i & 0xff, dc, hz, mode);
      this.bits_time += bits * 1e9 / hz;
      spi.completeTransmit(0xff);
    });
    spi.onTransmit = (value) => {
      if (!checked) this.check_set_up();
      checked = true;
      word = value;
      bits = spi.dataBits;
      hz = spi.clockFrequency;
      mode = (spi.control0 & 0x40 ? 2 : 0) | (spi.control0 & 0x80 ? 1 : 0);
      if (!spi.enabled) this.problem('a byte is written to SPI0 while it is disabled');
      if (bits % 8 !== 0) this.problem(`SPI words of ${bits} bits: the display takes bytes`);
      done.schedule(1e9 * (bits + (mode & 1 ? 0 : PAUSE_BITS)) / hz);
    };
    const write = spi.writeUint32.bind(spi);
    spi.writeUint32 = (offset, value) => {
      if (spi.busy && (offset === 0x000 || offset === 0x010 || (offset === 0x004 && (value & 2) === 0))) {
        this.problem('SPI0 is set up anew or disabled while bits are moving');
      }
      write(offset, value);
    };
    const wire = (pin, act) => {
      let last = null;
      mcu.gpio[pin].addListener(() => {
        const gpio = mcu.gpio[pin], level = gpio.outputEnable ? gpio.outputValue : true;
        if (level === last) return;
        if (last !== null && spi.busy) this.problem(`GPIO ${pin} changes while bits are moving`);
        last = level;
        act(level);
      });
    };
    wire(PINS.dc, () => {});
    wire(PINS.select, (level) => display.set_select(!level));
    wire(PINS.reset, (level) => display.set_reset(level));
  }

  wire_uart() {
    const { mcu, clock } = this, uart = mcu.uart[0];
    let empty_at = 0; /* when the last character that was written has left */
    const character = () => 10e9 / uart.baudRate;
    const waiting = () => Math.max(0, Math.ceil((empty_at - clock.nanos) / character()));
    Object.defineProperty(uart, 'flags', {
      get: () => (waiting() > 0 ? 0x08 : 0x80) | (waiting() > UART_FIFO ? 0x20 : 0) | 0x10,
    });
    uart.onByte = (byte) => {
      if (this.log === '') {
        this.expect_pin(PINS.log, 'UART0 TX', [FUNCTION_UART]);
        if (!uart.enabled || !uart.txEnabled) this.problem('UART0 is written while it is disabled');
        if (Math.abs(uart.baudRate / 115200 - 1) > 0.02) this.problem(`the log runs at ${uart.baudRate} baud instead of 115200`);
      }
      if (waiting() > UART_FIFO) this.problem('a character of the log is lost: UART0 was full');
      empty_at = Math.max(empty_at, clock.nanos) + character();
      this.log += String.fromCharCode(byte);
    };
  }

  /* As the ROM hands over: the second stage in RAM, checked, clk_sys from the ring oscillator. */
  start() {
    const { mcu, core } = this, boot2 = mcu.flash.subarray(0, 256);
    const stored = boot2[252] | boot2[253] << 8 | boot2[254] << 16 | boot2[255] << 24;
    if (crc32_mpeg2(boot2.subarray(0, BOOT2_BYTES)) !== stored >>> 0) {
      throw new Error('the boot ROM would refuse this image: the CRC of its second stage is wrong');
    }
    mcu.sram.set(boot2, BOOT2_AT - 0x20000000);
    mcu.updateClocks();
    core.SP = BOOT2_AT;
    core.LR = 0;
    core.PC = BOOT2_AT;
    for (const button of ['button_1', 'button_2']) this.press(button, false);
  }

  press(button, pressed) { this.mcu.gpio[PINS[button]].setInputValue(!pressed); }

  instruction() {
    const { core, clock, second } = this;
    if (!core.waiting) {
      clock.tick(core.executeInstruction() * 1e9 / this.mcu.clkSys);
      if (second.running) second.catch_up(clock.nanos);
    } else if (second.busy) {
      const spent = second.instruction();
      second.now += spent;
      clock.tick(Math.max(0, second.now - clock.nanos));
    } else if (clock.nextAlarm !== null) {
      clock.tick(clock.nanosToNextAlarm);
    } else {
      this.stopped = 'the processor waits for an interrupt, and none will come';
    }
  }

  /* The second boot stage, until code runs from flash. */
  boot() {
    const { core } = this;
    while (this.stopped === null && !(core.PC >= FLASH && core.PC < FLASH_END)) {
      this.instruction();
      if (this.now > BOOT_LIMIT) this.stopped = 'the second boot stage never came to an end';
    }
    this.flash.check_in_place();
  }

  /* Runs to the next time that `address` is reached: true; or false when `limit_ms` of the chip's time have passed or it stopped, and `stopped`
   * says why. */
  run_to(address, limit_ms) {
    const { core } = this, limit = this.now + limit_ms * 1e6;
    do {
      this.instruction();
      if (this.stopped !== null) return false;
      if (this.now > limit) {
        this.stopped = `nothing came within ${limit_ms} ms of the chip's time; the program is at 0x${core.PC.toString(16)}`;
        return false;
      }
    } while (core.PC !== address);
    return true;
  }
}
