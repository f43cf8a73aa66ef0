/*
 * What programs of the Pico SDK call in the boot ROM, for an emulator that has none: functions found by two letters, as the RP2040 data
 * sheet's 2.8.3 says. Linked at address 0. There is no floating point: a program that uses it stops.
 */
  .syntax unified
  .cpu cortex-m0plus
  .thumb
  .text

rom:
  .space 0x10
  .byte 'M', 'u', 1, 2      /* magic, version */
  .hword functions - rom
  .hword data - rom
  .hword look_up - rom + 1

/* Entries of two letters and an address, until 0. */
functions:
  .ascii "MS"
  .hword set - rom + 1
  .ascii "S4"
  .hword set - rom + 1
  .ascii "MC"
  .hword copy - rom + 1
  .ascii "C4"
  .hword copy - rom + 1
  .ascii "L3"
  .hword leading_zeros - rom + 1
  .ascii "T3"
  .hword trailing_zeros - rom + 1
  .ascii "P3"
  .hword ones - rom + 1
  .ascii "R3"
  .hword reversed - rom + 1
  .hword 0, 0
data:
  .ascii "SF"
  .hword no_float - rom
  .ascii "SD"
  .hword no_float - rom
  .hword 0, 0

  .hword 0x2020 /* words in each table that follows, twice: before it, where its reader looks */
no_float:
  .rept 32
  .word stop - rom + 1
  .endr

/* r0: table, r1: letters -> r0: address, or 0. */
  .thumb_func
look_up:
  ldrh r2, [r0]
  cmp r2, #0
  beq 2f
  cmp r2, r1
  beq 1f
  adds r0, #4
  b look_up
1:
  ldrh r0, [r0, #2]
  bx lr
2:
  movs r0, #0
  bx lr

/* r0: to, r1: byte, r2: count -> r0. */
  .thumb_func
set:
  subs r2, #1
  bcc 1f
  strb r1, [r0, r2]
  b set
1:
  bx lr

/* r0: to, r1: from, r2: count -> r0. */
  .thumb_func
copy:
  push {r4, lr}
1:
  subs r2, #1
  bcc 2f
  ldrb r4, [r1, r2]
  strb r4, [r0, r2]
  b 1b
2:
  pop {r4, pc}

/* r0 -> r0: zeros above the highest one. */
  .thumb_func
leading_zeros:
  movs r1, #32
1:
  cmp r0, #0
  beq 2f
  subs r1, #1
  lsrs r0, r0, #1
  b 1b
2:
  mov r0, r1
  bx lr

/* r0 -> r0: zeros below the lowest one. */
  .thumb_func
trailing_zeros:
  movs r1, #32
1:
  cmp r0, #0
  beq 2f
  subs r1, #1
  lsls r0, r0, #1
  b 1b
2:
  mov r0, r1
  bx lr

  .thumb_func
ones:
  movs r1, #0
  movs r2, #0
1:
  lsrs r0, r0, #1
  adcs r1, r2
  cmp r0, #0
  bne 1b
  mov r0, r1
  bx lr

  .thumb_func
reversed:
  movs r2, #32
  movs r1, #0
1:
  lsrs r0, r0, #1
  adcs r1, r1
  subs r2, #1
  bne 1b
  mov r0, r1
  bx lr

  .thumb_func
stop:
  bkpt #2
  b stop
