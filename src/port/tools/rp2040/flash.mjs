/*
 * The flash of a Pico, a W25Q16JV, behind the RP2040's SSI, as a second boot stage meets it: what it is told has to make
 * sense to the flash, and reads in place have to be set up before code runs from it.
 *
 * SSI: RP2040 data sheet 4.10.13. Flash: Winbond W25Q16JV data sheet, chapter 8.
 */
const CTRLR0 = 0x00, CTRLR1 = 0x04, SSIENR = 0x08, SER = 0x10, BAUDR = 0x14, SR = 0x28, DR0 = 0x60, RX_SAMPLE_DLY = 0xf0, SPI_CTRLR0 = 0xf4;
const STATUS_2_QE = 2;
const FLASH_HZ = 133e6; /* for all but plain reads (03h), which end at 50 MHz */

export class FlashInterface {
  /* `problem(text)` is told what is wrong; `system_hz()` is clk_sys. `status2`: the flash's, as the last user left it. */
  constructor({ problem, system_hz, status2 = 0 }) {
    Object.assign(this, { problem, system_hz, status2 });
    this.registers = { [CTRLR0]: 0, [CTRLR1]: 0, [SSIENR]: 0, [SER]: 1, [BAUDR]: 0, [RX_SAMPLE_DLY]: 0, [SPI_CTRLR0]: 0x03000000 };
    this.sent = [];
    this.received = [];
    this.write_enabled = false;
    this.busy_polls = 0;
    this.continuous = false; /* the flash's: it expects an address, no instruction */
  }

  field(register, low, bits) { return this.registers[register] >>> low & (1 << bits) - 1; }

  quad() { return this.field(CTRLR0, 21, 2) === 2; }

  readUint32(offset) {
    if (offset in this.registers) return this.registers[offset] >>> 0;
    if (offset === SR) {
      this.finish();
      return 0x6 | (this.received.length > 0 ? 0x8 : 0); /* idle; the transmit FIFO is empty and not full */
    }
    if (offset === DR0) {
      this.finish();
      if (this.received.length === 0) this.problem('the boot stage reads a byte from the flash that has not come');
      return this.received.shift() ?? 0;
    }
    this.problem(`the boot stage reads SSI register 0x${offset.toString(16)}, which this model of the flash does not know`);
    return 0;
  }

  writeUint32(offset, value) {
    value >>>= 0;
    if (offset === DR0) {
      if (this.registers[SSIENR] === 0) this.problem('a byte for the flash while SSI is off');
      else this.sent.push(value);
    } else if (!(offset in this.registers)) {
      this.problem(`the boot stage writes SSI register 0x${offset.toString(16)}, which this model of the flash does not know`);
    } else {
      if (offset === SSIENR && value === 0) {
        this.finish();
        this.received = [];
      } else if (offset !== SSIENR && this.registers[SSIENR] !== 0) {
        this.problem(`SSI register 0x${offset.toString(16)} is written while SSI is on`);
      }
      this.registers[offset] = value;
    }
  }

  writeUint32Atomic(offset, value, type) {
    if (type === 0) this.writeUint32(offset, value);
    else this.problem('SSI has no aliases that set and clear bits (RP2040 data sheet 2.1.2)');
  }

  /* A transfer ends when nothing more is written: the flash sees its chip select rise. */
  finish() {
    if (this.sent.length === 0) return;
    const sent = this.sent;
    this.sent = [];
    const divider = this.registers[BAUDR];
    if (divider < 2 || divider % 2 !== 0 || this.registers[SER] !== 1) this.problem('the flash has no clock or is not selected');
    else if (this.system_hz() / divider > FLASH_HZ) this.problem('the flash is clocked faster than 133 MHz');
    if (this.quad()) this.quad_read(sent);
    else this.received.push(...this.instruction(sent));
  }

  instruction(sent) {
    const [code, ...data] = sent, name = `flash instruction ${code.toString(16)}h`;
    if (this.field(CTRLR0, 16, 5) !== 7) this.problem(`${name} in words of other than 8 bits`);
    if (this.field(CTRLR0, 8, 2) !== 0) this.problem(`${name} while SSI does not both send and receive`);
    if (this.continuous) this.problem(`${name} while the flash expects an address`);
    if (this.busy_polls > 0 && code !== 0x05) this.problem(`${name} while the flash is busy writing its status`);
    const lengths = { 0x01: 2, 0x05: 1, 0x06: 0, 0x31: 1, 0x35: 1 };
    if (!(code in lengths)) this.problem(`${name} is not one that this model knows`);
    else if (data.length !== lengths[code]) this.problem(`${name} with ${data.length} bytes of data`);
    switch (code) {
      case 0x05: return [0xff, this.busy_polls > 0 && this.busy_polls-- > 0 ? 1 : 0];
      case 0x35: return [0xff, this.status2];
      case 0x06:
        this.write_enabled = true;
        return [0xff];
      case 0x01:
      case 0x31:
        if (!this.write_enabled) this.problem('flash status is written without a write enable before');
        this.write_enabled = false;
        this.status2 = data.at(-1);
        this.busy_polls = 3;
        return sent.map(() => 0xff);
      default: return sent.map(() => 0xff);
    }
  }

  quad_read(sent) {
    if ((this.status2 & STATUS_2_QE) === 0) this.problem('a quad read while the flash has quad enable off');
    if (this.continuous || this.field(SPI_CTRLR0, 8, 2) !== 2 || sent.length !== 2 || sent[0] !== 0xeb) {
      this.problem('the first quad read has to be instruction EBh and one word of address and mode');
    } else if (this.shape() !== 'address of 32 bits, 4 dummy clocks, type 1') {
      this.problem(`the first quad read has an ${this.shape()}`);
    } else {
      this.continuous = (sent[1] & 0x30) === 0x20; /* mode bits M5-4 */
    }
  }

  shape() {
    return `address of ${4 * this.field(SPI_CTRLR0, 2, 4)} bits, ${this.field(SPI_CTRLR0, 11, 5)} dummy clocks, type ${this.field(SPI_CTRLR0, 0, 2)}`;
  }

  /* Whether code can run in place now: how it is set up, in words, or a problem. */
  check_in_place() {
    this.finish();
    const instruction_bits = [0, 4, 8, 16][this.field(SPI_CTRLR0, 8, 2)], command = this.field(SPI_CTRLR0, 24, 8);
    if (this.registers[SSIENR] !== 1) return this.problem('code runs from flash while SSI is off');
    if (this.field(CTRLR0, 8, 2) !== 3 || this.field(CTRLR0, 16, 5) !== 31 || this.registers[CTRLR1] !== 0) {
      return this.problem('code runs from flash, but SSI does not read words of 32 bits');
    }
    if (!this.quad() || !this.continuous) return this.problem('code runs from flash, which is not in quad reads without an instruction');
    if (instruction_bits !== 0 || (command & 0x30) !== 0x20 || this.shape() !== 'address of 32 bits, 4 dummy clocks, type 2') {
      return this.problem(`code runs from flash with ${instruction_bits} bits of instruction, mode ${command.toString(16)}h, ${this.shape()}`);
    }
    return undefined;
  }
}
