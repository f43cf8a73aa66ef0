/*
 * An ST7789V controller and its glass that forgives nothing: what the data sheet does not allow becomes a sentence.
 *
 * Times and commands: Sitronix ST7789V data sheet 1.4, sections 7.4.3 (serial timing), 7.4.5 (reset), 9.1 and 9.2 (commands). All
 * times are in nanoseconds of the emulated chip.
 */
const MS = 1e6, US = 1e3;
const MEMORY_WIDTH = 240, MEMORY_HEIGHT = 320;
const FASTEST_HZ = 62.5e6; /* a write cycle takes at least 16 ns */
const RESET_PULSE = 10 * US, AFTER_RESET = 5 * MS, SLEEP_OUT_AFTER_RESET = 120 * MS;
const AFTER_SLEEP = 5 * MS, SLEEP_AGAIN = 120 * MS;

/* Parameters of each command that a driver may use; undefined: any number (pixels). */
const PARAMETERS = {
  0x00: 0, 0x01: 0, 0x10: 0, 0x11: 0, 0x12: 0, 0x13: 0, 0x20: 0, 0x21: 0, 0x26: 1, 0x28: 0, 0x29: 0, 0x2a: 4, 0x2b: 4, 0x2c: undefined,
  0x33: 6, 0x35: 1, 0x34: 0, 0x36: 1, 0x37: 2, 0x38: 0, 0x39: 0, 0x3a: 1, 0x3c: undefined, 0x44: 2, 0x51: 1, 0x53: 1, 0x55: 1,
  0xb0: 2, 0xb1: 3, 0xb2: 5, 0xb3: 3, 0xb5: 1, 0xb7: 1, 0xba: 1, 0xbb: 1, 0xbc: 1, 0xbd: 1, 0xc0: 1, 0xc1: 3, 0xc2: 2, 0xc3: 1,
  0xc4: 1, 0xc5: 1, 0xc6: 1, 0xc7: 1, 0xc8: 1, 0xca: 1, 0xcc: 1, 0xd0: 2, 0xd2: 1, 0xe0: 14, 0xe1: 14, 0xe2: 64, 0xe3: 64, 0xe4: 3,
  0xe8: 1, 0xe9: 3,
};
const MADCTL_MY = 0x80, MADCTL_MX = 0x40, MADCTL_MV = 0x20, MADCTL_BGR = 0x08;
const hex = (byte) => `0x${byte.toString(16).padStart(2, '0')}`;

export class St7789 {
  /* `glass`: {width, height, x, y} of what is seen, in the memory as it is without mirroring. `now()`: the time. `problem(text)`. */
  constructor({ glass, now, problem }) {
    Object.assign(this, { glass, now, problem });
    this.memory = new Uint16Array(MEMORY_WIDTH * MEMORY_HEIGHT); /* RGB 5-6-5 */
    this.memory.fill(0x5aa5);                                    /* as after power-on: anything */
    this.reset_line = true;
    this.selected = false;
    this.power_on = this.now();
    this.had_reset = false;
    this.reset_state();
  }

  reset_state() {
    this.command_code = null;
    this.parameters = [];
    this.sleeping = true;
    this.on = false;
    this.inverted = false;
    this.madctl = 0;
    this.colmod = 0x66;
    this.colmod_set = false;
    this.columns = [0, MEMORY_WIDTH - 1];
    this.rows = [0, MEMORY_HEIGHT - 1];
    this.pending = [];   /* bytes of a pixel that is not whole yet */
    this.position = null; /* [x, y] of the next pixel, or null when the window is full */
    this.free_at = 0;
    this.sleep_out_at = 0;
    this.sleep_in_at = 0;
  }

  /* ---- wires ---- */

  set_reset(high) {
    if (high === this.reset_line) return;
    this.reset_line = high;
    if (!high) {
      this.reset_began = this.now();
      return;
    }
    const pulse = this.now() - this.reset_began;
    if (pulse < RESET_PULSE) this.problem(`reset was low for ${(pulse / US).toFixed(1)} us, it takes 10 us`);
    this.reset_state();
    this.had_reset = true;
    this.free_at = this.now() + AFTER_RESET;
    this.sleep_out_at = this.now() + SLEEP_OUT_AFTER_RESET;
  }

  set_select(active) { this.selected = active; }

  /* A byte whose last bit came now, with D/C as it is at that bit. */
  byte(value, is_data, hz, mode) {
    if (hz > FASTEST_HZ) this.problem(`the bus runs at ${(hz / 1e6).toFixed(1)} MHz, more than 62.5`);
    if (mode !== 0 && mode !== 3) this.problem(`SPI mode ${mode}: the controller takes bits at rising edges only (0 or 3)`);
    if (!this.selected) return this.problem(`byte ${hex(value)} while chip select is high`);
    if (!this.reset_line) return this.problem(`byte ${hex(value)} while reset is low`);
    if (!this.had_reset) return this.problem(`byte ${hex(value)} before the first reset`);
    return is_data ? this.data(value) : this.command(value);
  }

  /* ---- commands ---- */

  end_command() {
    const code = this.command_code, wanted = PARAMETERS[code];
    if (code === null) return;
    if (this.pending.length > 0) this.problem(`${this.pending.length} odd byte(s) after the last whole pixel`);
    this.pending = [];
    if (wanted !== undefined && this.parameters.length !== wanted) {
      this.problem(`command ${hex(code)} with ${this.parameters.length} parameters, it takes ${wanted}`);
    }
  }

  command(code) {
    const now = this.now();
    this.end_command();
    this.command_code = code;
    this.parameters = [];
    this.position = null;
    if (!(code in PARAMETERS)) return this.problem(`command ${hex(code)} is unknown`);
    if (now < this.free_at) this.problem(`command ${hex(code)} comes ${((this.free_at - now) / MS).toFixed(2)} ms too early`);
    switch (code) {
      case 0x01: {
        const was_awake = !this.sleeping;
        this.reset_state();
        this.command_code = code;
        this.free_at = now + AFTER_RESET;
        this.sleep_out_at = was_awake ? now + SLEEP_OUT_AFTER_RESET : 0;
        break;
      }
      case 0x10:
        if (now < this.sleep_in_at) this.problem('sleep in less than 120 ms after sleep out');
        this.sleeping = true;
        this.free_at = now + AFTER_SLEEP;
        this.sleep_out_at = now + SLEEP_AGAIN;
        break;
      case 0x11:
        if (now < this.sleep_out_at) this.problem(`sleep out ${((this.sleep_out_at - now) / MS).toFixed(1)} ms too early, it takes 120 ms`);
        this.sleeping = false;
        this.free_at = now + AFTER_SLEEP;
        this.sleep_in_at = now + SLEEP_AGAIN;
        break;
      case 0x20: this.inverted = false; break;
      case 0x21: this.inverted = true; break;
      case 0x28: this.on = false; break;
      case 0x29:
        if (this.sleeping) this.problem('display on while it sleeps');
        this.on = true;
        break;
      case 0x2c:
        this.position = [this.columns[0], this.rows[0]];
      /* fall through */
      case 0x3c:
        if (code === 0x3c) this.problem('write continue is not used by our drivers');
        if (!this.colmod_set || ![3, 5].includes(this.colmod & 7)) {
          this.problem(`pixels in format ${hex(this.colmod)}: neither 12 nor 16 bits a pixel were chosen`);
        }
        break;
      default:
    }
    return undefined;
  }

  data(value) {
    if (this.command_code === null || !(this.command_code in PARAMETERS)) return this.problem(`data ${hex(value)} without a command`);
    if (this.command_code === 0x2c) return this.pixel_byte(value);
    this.parameters.push(value);
    if (this.parameters.length > PARAMETERS[this.command_code]) {
      return this.problem(`command ${hex(this.command_code)} takes no parameter number ${this.parameters.length}`);
    }
    if (this.parameters.length === PARAMETERS[this.command_code]) this.execute();
    return undefined;
  }

  execute() {
    const p = this.parameters;
    const swapped = (this.madctl & MADCTL_MV) !== 0;
    switch (this.command_code) {
      case 0x2a: this.columns = this.window('columns', p, swapped ? MEMORY_HEIGHT : MEMORY_WIDTH); break;
      case 0x2b: this.rows = this.window('rows', p, swapped ? MEMORY_WIDTH : MEMORY_HEIGHT); break;
      case 0x36:
        if (p[0] & 0x03) this.problem(`MADCTL ${hex(p[0])} sets bits that are reserved`);
        this.madctl = p[0];
        break;
      case 0x3a:
        this.colmod = p[0];
        this.colmod_set = true;
        break;
      default:
    }
  }

  window(what, p, limit) {
    const from = p[0] << 8 | p[1], to = p[2] << 8 | p[3];
    if (from > to || to >= limit) this.problem(`${what} ${from} to ${to}: they have to lie within 0 to ${limit - 1}`);
    return [from, to];
  }

  pixel_byte(value) {
    this.pending.push(value);
    if ((this.colmod & 7) === 3) {
      if (this.pending.length < 3) return;
      const [a, b, c] = this.pending;
      this.pending = [];
      this.pixel(a >> 4, a & 15, b >> 4, 4);
      this.pixel(b & 15, c >> 4, c & 15, 4);
    } else if (this.pending.length === 2) {
      const word = this.pending[0] << 8 | this.pending[1];
      this.pending = [];
      this.put(word);
    }
  }

  /* Four bits a channel become five and six by repeating the upper ones. */
  pixel(r, g, b) { this.put((r << 1 | r >> 3) << 11 | (g << 2 | g >> 2) << 5 | (b << 1 | b >> 3)); }

  put(word) {
    if (this.position === null) return this.problem('a pixel after the last one of the window');
    let [x, y] = this.position;
    this.position = x < this.columns[1] ? [x + 1, y] : y < this.rows[1] ? [this.columns[0], y + 1] : null;
    if (this.madctl & MADCTL_MV) [x, y] = [y, x];
    if (this.madctl & MADCTL_MX) x = MEMORY_WIDTH - 1 - x;
    if (this.madctl & MADCTL_MY) y = MEMORY_HEIGHT - 1 - y;
    if (x >= 0 && y >= 0 && x < MEMORY_WIDTH && y < MEMORY_HEIGHT) this.memory[y * MEMORY_WIDTH + x] = word;
    return undefined;
  }

  /* ---- what is seen ---- */

  /* What the glass shows, row by row from the top left, three bytes a pixel, red first: an IPS panel, which shows colours as they are meant
   * when inversion is on; black while the display is off or asleep. */
  picture() {
    const { width, height, x, y } = this.glass, out = Buffer.alloc(3 * width * height);
    if (!this.on || this.sleeping) return out;
    const change = this.inverted ? 0 : 0xff, swap = this.madctl & MADCTL_BGR ? 2 : 0;
    for (let row = 0, at = 0; row < height; row++) {
      for (let column = 0; column < width; column++, at += 3) {
        const word = this.memory[(y + row) * MEMORY_WIDTH + x + column], r = word >> 11, g = word >> 5 & 63, b = word & 31;
        out[at + swap] = (r << 3 | r >> 2) ^ change;
        out[at + 1] = (g << 2 | g >> 4) ^ change;
        out[at + 2 - swap] = (b << 3 | b >> 2) ^ change;
      }
    }
    return out;
  }

  /* What only shows when nothing more comes. */
  finish() {
    this.end_command();
    this.command_code = null;
    if (this.sleeping || !this.on) this.problem('the display is asleep or off at the end');
  }
}

/* The panels that firmware can be built for. */
export const GLASSES = {
  'st7789-240': { width: 240, height: 240, x: 0, y: 0 },
  'st7789-135': { width: 135, height: 240, x: 52, y: 40 },
  'st7789-320': { width: 240, height: 320, x: 0, y: 0 },
};
