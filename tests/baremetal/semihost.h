/* Arm semihosting: text and an exit code out of an emulated chip. */
#ifndef FIXCAST_TEST_SEMIHOST_H
#define FIXCAST_TEST_SEMIHOST_H

/* Characters are collected and written a line at a time: each write stops the processor. */
void semihost_char(int c);
void semihost_flush(void);

/* Flushes and ends the emulator with this exit code. */
void semihost_exit(int code);

#endif
