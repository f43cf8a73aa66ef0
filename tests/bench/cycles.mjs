/*
 * Runs an image in an emulated RP2040 (one core, everything in RAM) and counts instructions and cycles as count_plugin.c
 * counts instructions: by region and function.
 *
 * node cycles.mjs MODULES IMAGE OUT SYMBOLS LIMIT REGION...
 * MODULES: the directory in which npm installed rp2040js. IMAGE: raw bytes from 0x20000000. SYMBOLS: lines `address name`,
 * hexadecimal, in order. LIMIT: of instructions. REGION: addresses (hexadecimal). What the image prints goes to stdout,
 * counts go to OUT, with `cycles I COUNT` and `function_cycles I NAME COUNT` besides.
 */
import fs from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';

const [modules, image, out, symbols, limit, ...regions] = process.argv.slice(2);
const { RP2040 } = createRequire(path.join(path.resolve(modules), 'node_modules/'))('rp2040js');
const RAM = 0x20000000;
const SYS_WRITE0 = 0x04, SYS_EXIT_EXTENDED = 0x20;

const mcu = new RP2040();
const nothing = () => {};
mcu.logger = { debug: nothing, info: nothing, warn: nothing, error: (who, what) => console.error(`${who}: ${what}`) };
const bytes = fs.readFileSync(image);
mcu.sram.set(bytes, 0);
const core = mcu.core;
core.VTOR = RAM;
core.reset();

/* Which function and which region each halfword of the image belongs to. */
const names = ['?'], function_at = new Uint16Array(bytes.length / 2 + 1), region_at = new Int8Array(function_at.length).fill(-1);
const index = (address) => ((address & ~1) - RAM) >>> 1;
for (const line of fs.readFileSync(symbols, 'utf8').split('\n')) {
  const [address, name] = line.split(' ');
  if (name === undefined || index(parseInt(address, 16)) >= function_at.length) continue;
  function_at.fill(names.push(name) - 1, index(parseInt(address, 16)));
}
regions.forEach((address, i) => { region_at[index(parseInt(address, 16))] = i; });

let exit_code = null;
mcu.onBreak = (code) => {
  if (code !== 0xab) throw new Error(`breakpoint ${code} at 0x${core.PC.toString(16)}`);
  const argument = core.registers[1];
  if (core.registers[0] === SYS_WRITE0) {
    let text = '';
    for (let at = argument; mcu.readUint8(at) !== 0; at++) text += String.fromCharCode(mcu.readUint8(at));
    process.stdout.write(text);
  } else if (core.registers[0] === SYS_EXIT_EXTENDED) {
    exit_code = mcu.readUint32(argument + 4);
  } else {
    throw new Error(`semihosting call ${core.registers[0]}`);
  }
};

const count = regions.map(() => 0), cycles = regions.map(() => 0), calls = regions.map(() => 0);
const by_function = regions.map(() => new Float64Array(names.length));
const cycles_by_function = regions.map(() => new Float64Array(names.length));
let region = 0, left = Number(limit);
while (exit_code === null && left-- > 0) {
  const at = index(core.PC), before = core.cycles;
  if (at >= function_at.length) throw new Error(`the program ran off to 0x${core.PC.toString(16)}`);
  if (region_at[at] >= 0) {
    region = region_at[at];
    calls[region]++;
  }
  core.executeInstruction();
  const spent = core.cycles - before;
  count[region]++;
  cycles[region] += spent;
  by_function[region][function_at[at]]++;
  cycles_by_function[region][function_at[at]] += spent;
}

const lines = exit_code === null ? ['limit'] : [];
regions.forEach((_, i) => {
  lines.push(`region ${i} ${count[i]} ${calls[i]}`, `cycles ${i} ${cycles[i]}`);
  names.forEach((name, f) => {
    if (by_function[i][f] === 0) return;
    lines.push(`function ${i} ${name} ${by_function[i][f]}`, `function_cycles ${i} ${name} ${cycles_by_function[i][f]}`);
  });
});
fs.writeFileSync(out, lines.join('\n') + '\n');
process.exit(exit_code ?? 0);
