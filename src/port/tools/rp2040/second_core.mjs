/*
 * Core 1 of an RP2040, which the emulator lacks: a second processor on the same memory, the FIFOs between the two, and the boot ROM's loop
 * that starts it (RP2040 data sheet 2.3.1.4, 2.8.2).
 *
 * Core 1 is kept as far in time as core 0. What is not there: the two never wait for each other at a memory or the flash's cache.
 */
const FIFO_WORDS = 8;
const CPUID = 0x000, FIFO_ST = 0x050, FIFO_WR = 0x054, FIFO_RD = 0x058;
const PSM_FRCE_OFF = 0x4, PSM_PROC1 = 1 << 16;

export class SecondCore {
  /* `problem(text)` is told what is wrong. */
  constructor(mcu, problem) {
    Object.assign(this, { mcu, problem });
    this.core = new mcu.core.constructor(mcu);
    this.running = false;
    this.active = 0; /* which core's access it is */
    this.fifo = [[], []]; /* words to core 0, to core 1 */
    this.now = 0; /* nanoseconds */
    this.rom = [];  /* what the ROM's loop has taken */
    this.wire_sio();
    this.wire_reset();
  }

  wire_sio() {
    const { sio } = this.mcu, read = sio.readUint32.bind(sio), write = sio.writeUint32.bind(sio);
    sio.readUint32 = (offset) => {
      const own = this.fifo[this.active], other = this.fifo[1 - this.active];
      switch (offset) {
        case CPUID: return this.active;
        case FIFO_ST: return (own.length > 0 ? 1 : 0) | (other.length < FIFO_WORDS ? 2 : 0);
        case FIFO_RD:
          if (own.length === 0) this.problem(`core ${this.active} reads its FIFO, which is empty`);
          return own.shift() ?? 0;
        default: return read(offset);
      }
    };
    sio.writeUint32 = (offset, value) => {
      if (offset !== FIFO_WR) return write(offset, value);
      const other = this.fifo[1 - this.active];
      if (other.length === FIFO_WORDS) this.problem(`core ${this.active} writes to the FIFO, which is full`);
      else other.push(value >>> 0);
      (this.active === 0 ? this.core : this.mcu.core).waiting = false; /* a word is an event */
      if (this.active === 0 && !this.running) this.boot_rom();
      return undefined;
    };
  }

  wire_reset() {
    const psm = this.mcu.peripherals[0x40010], write = psm.writeUint32.bind(psm);
    psm.writeUint32 = (offset, value) => {
      write(offset, value);
      if (offset !== PSM_FRCE_OFF || (value & PSM_PROC1) === 0) return;
      this.running = false;
      this.rom = [];
      this.fifo = [[], []];
    };
  }

  /* 0, 0, 1, vectors, stack, code: each word is sent back, and one that does not fit starts it over. */
  boot_rom() {
    while (this.fifo[1].length > 0) {
      const word = this.fifo[1].shift(), wanted = [0, 0, 1][this.rom.length];
      if (wanted !== undefined && word !== wanted) this.rom = [];
      else this.rom.push(word);
      this.fifo[0].push(word);
    }
    if (this.rom.length < 6) return;
    const { core } = this, [, , , vectors, stack, code] = this.rom;
    if ((code & 1) === 0) this.problem('core 1 is started at an even address: no Thumb code');
    if (stack % 8 !== 0) this.problem('the stack of core 1 is not aligned to 8 bytes');
    core.VTOR = vectors;
    core.SP = stack;
    core.PC = code & ~1;
    core.waiting = false;
    this.running = true;
    this.now = this.mcu.clock.nanos;
  }

  /* One instruction; the time it took. */
  instruction() {
    this.active = 1;
    const spent = this.core.executeInstruction() * 1e9 / this.mcu.clkSys;
    this.active = 0;
    return spent;
  }

  /* Up to `nanos`. */
  catch_up(nanos) {
    while (this.running && !this.core.waiting && this.now < nanos) this.now += this.instruction();
    if (this.now < nanos) this.now = nanos;
  }

  get busy() { return this.running && !this.core.waiting; }
}
