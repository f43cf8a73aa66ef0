/*
 * The second stage of booting: puts the flash of a Pico (W25Q16JV) into quad read without an instruction byte, then starts the image.
 *
 * The boot ROM copies the first 256 bytes of flash to the end of RAM, checks the CRC that uf2.py leaves in the last four, and calls
 * what it copied with LR = 0 (RP2040 data sheet 2.8.1.3). This code knows no address of its own. 8 bytes of code that miss the cache
 * then cost 28 clocks of the flash at half the system clock; plain serial reads at a rate that any flash bears would cost 96.
 *
 * SSI: RP2040 data sheet 4.10. Flash: Winbond W25Q16JV data sheet, instructions 35h, 06h, 31h, 05h, EBh.
 */
  .syntax unified
  .cpu cortex-m0plus
  .thumb

  .equ SSI_BASE, 0x18000000
  .equ CTRLR0, 0x00
  .equ CTRLR1, 0x04
  .equ SSIENR, 0x08
  .equ SER, 0x10
  .equ BAUDR, 0x14
  .equ SR, 0x28
  .equ DR0, 0x60
  .equ RX_SAMPLE_DLY, 0xf0 /* from SSI_BASE; SPI_CTRLR0 is 4 further */

  .equ SR_BUSY, 1 << 0
  .equ SR_TFE, 1 << 2

  .equ PADS_QSPI, 0x40020000 /* +4: clock; +8 to +20: data lines 0 to 3 */
  .equ CLEAR_BITS, 0x3000

  .equ READ_STATUS_1, 0x05
  .equ WRITE_ENABLE, 0x06
  .equ WRITE_STATUS_2, 0x31
  .equ READ_STATUS_2, 0x35
  .equ FAST_READ_QUAD_IO, 0xeb
  .equ CONTINUE, 0xa0 /* the mode byte after an address: no instruction before the next one */
  .equ STATUS_1_BUSY, 1 << 0
  .equ STATUS_2_QUAD_ENABLE, 1 << 1

  .equ STANDARD_8BIT, 7 << 16
  .equ QUAD_32BIT_READ, (2 << 21) | (31 << 16) | (3 << 8)
  /* 8 address digits (24 bits and the mode byte), 4 dummy clocks; first after an instruction sent on one line, then without one. */
  .equ FIRST_READ, (8 << 2) | (4 << 11) | (2 << 8) | 1
  .equ NEXT_READS, (CONTINUE << 24) | (8 << 2) | (4 << 11) | 2

  .section .boot2, "ax"
  .global boot2
  .thumb_func
boot2:
  push {r4, lr}

  /* Clock: 8 mA, fast edges. Data: no hysteresis, which would be late at 62.5 MHz. */
  ldr r3, =PADS_QSPI
  movs r0, #0x21
  str r0, [r3, #4]
  ldr r3, =PADS_QSPI + CLEAR_BITS
  movs r0, #2
  str r0, [r3, #8]
  str r0, [r3, #12]
  str r0, [r3, #16]
  str r0, [r3, #20]

  ldr r3, =SSI_BASE
  ldr r4, =SSI_BASE + RX_SAMPLE_DLY
  movs r0, #0
  str r0, [r3, #SSIENR]
  movs r0, #2
  str r0, [r3, #BAUDR]
  movs r0, #1
  str r0, [r4]
  str r0, [r3, #SER]

  /* Quad enable is kept without power, so it is set once in a flash's life. */
  ldr r0, =STANDARD_8BIT
  str r0, [r3, #CTRLR0]
  movs r0, #1
  str r0, [r3, #SSIENR]
  movs r0, #READ_STATUS_2
  bl exchange2
  movs r1, #STATUS_2_QUAD_ENABLE
  tst r0, r1
  bne quad_enabled
  orrs r1, r0
  movs r0, #WRITE_ENABLE
  bl exchange1
  movs r0, #WRITE_STATUS_2
  bl exchange2_with
1:
  movs r0, #READ_STATUS_1
  bl exchange2
  lsrs r0, r0, #1 /* STATUS_1_BUSY into carry */
  bcs 1b
quad_enabled:
  movs r0, #0
  str r0, [r3, #SSIENR]

  /* One read with an instruction, whose mode byte makes the next ones do without. */
  ldr r0, =QUAD_32BIT_READ
  str r0, [r3, #CTRLR0]
  movs r0, #0
  str r0, [r3, #CTRLR1]
  ldr r0, =FIRST_READ
  str r0, [r4, #4]
  movs r0, #1
  str r0, [r3, #SSIENR]
  movs r0, #FAST_READ_QUAD_IO
  str r0, [r3, #DR0]
  movs r0, #CONTINUE
  str r0, [r3, #DR0]
  bl wait
  movs r0, #0
  str r0, [r3, #SSIENR]
  ldr r0, =NEXT_READS
  str r0, [r4, #4]
  movs r0, #1
  str r0, [r3, #SSIENR]

  /* Whoever called this after programming the flash goes on; from the ROM, the image's vectors. */
  pop {r0, r1}
  cmp r1, #0
  beq 1f
  mov r4, r0
  bx r1
1:
  ldr r0, =0x10000100
  ldr r1, =0xe000ed08 /* VTOR */
  str r0, [r1]
  ldmia r0!, {r1, r2}
  msr msp, r1
  bx r2

/* Sends r0, then perhaps a second byte (0, or r1); r0 = what came in with the last. Changes r2. */
  .thumb_func
exchange2:
  movs r1, #0
  .thumb_func
exchange2_with:
  push {lr}
  str r0, [r3, #DR0]
  str r1, [r3, #DR0]
  bl wait
  ldr r0, [r3, #DR0]
  ldr r0, [r3, #DR0]
  pop {pc}
  .thumb_func
exchange1:
  push {lr}
  str r0, [r3, #DR0]
  bl wait
  ldr r0, [r3, #DR0]
  pop {pc}

/* Until all has been sent: busy alone is not yet set when the first word has just been written. Changes r0, r2. */
  .thumb_func
wait:
  ldr r0, [r3, #SR]
  movs r2, #SR_TFE
  tst r0, r2
  beq wait
  movs r2, #SR_BUSY
  tst r0, r2
  bne wait
  bx lr

  .ltorg
