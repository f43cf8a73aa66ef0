/* The LM3S6965's registers that this board's firmware uses: addresses and bits, by the names of the data sheet (its sections in brackets). */
#ifndef FIXCAST_LM3S6965_H
#define FIXCAST_LM3S6965_H

#include <stdint.h>

#define REGISTER(address) (*(volatile uint32_t *)(uintptr_t)(address))

/* System control [6.5] */
#define SYSCTL_DID0 REGISTER(0x400fe000)
#define SYSCTL_LDOPCTL REGISTER(0x400fe034)
#define SYSCTL_RIS REGISTER(0x400fe050)
#define SYSCTL_RCC REGISTER(0x400fe060)
#define SYSCTL_RCGC1 REGISTER(0x400fe104)
#define SYSCTL_RCGC2 REGISTER(0x400fe108)

enum {
  RIS_PLLLRIS = 1 << 6,
  RCC_MOSCDIS = 1 << 0,
  RCC_OSCSRC = 3 << 4, /* 0: the main oscillator */
  RCC_XTAL = 15 << 6,
  RCC_XTAL_8MHZ = 14 << 6,
  RCC_BYPASS = 1 << 11,
  RCC_PWRDN = 1 << 13,
  RCC_USESYSDIV = 1 << 22,
  RCC_SYSDIV = 15 << 23,
  RCC_SYSDIV_4 = 3 << 23,
  RCGC1_UART0 = 1 << 0,
  RCGC1_SSI0 = 1 << 4,
  RCGC2_GPIOA = 1 << 0,
  RCGC2_GPIOC = 1 << 2,
  RCGC2_GPIOD = 1 << 3,
  RCGC2_GPIOE = 1 << 4,
  RCGC2_GPIOF = 1 << 5
};

/* Ports [9.5]: the data register is 256 words, whose address bits 9:2 say which pins a read or a write is about. */
#define GPIO_A UINT32_C(0x40004000)
#define GPIO_C UINT32_C(0x40006000)
#define GPIO_D UINT32_C(0x40007000)
#define GPIO_E UINT32_C(0x40024000)
#define GPIO_F UINT32_C(0x40025000)
#define GPIO_DATA(port, pins) REGISTER((port) + ((uint32_t)(pins) << 2))
#define GPIO_DIR(port) REGISTER((port) + 0x400)
#define GPIO_AFSEL(port) REGISTER((port) + 0x420)
#define GPIO_PUR(port) REGISTER((port) + 0x510)
#define GPIO_DEN(port) REGISTER((port) + 0x51c)

/* UART 0 [13.6] */
#define UART0_DR REGISTER(0x4000c000)
#define UART0_FR REGISTER(0x4000c018)
#define UART0_IBRD REGISTER(0x4000c024)
#define UART0_FBRD REGISTER(0x4000c028)
#define UART0_LCRH REGISTER(0x4000c02c)
#define UART0_CTL REGISTER(0x4000c030)

enum {
  FR_TXFF = 1 << 5,
  LCRH_FEN = 1 << 4,
  LCRH_WLEN_8 = 3 << 5,
  UART_CTL_UARTEN = 1 << 0,
  UART_CTL_TXE = 1 << 8
};

/* SSI 0 [14.6] */
#define SSI0_CR0 REGISTER(0x40008000)
#define SSI0_CR1 REGISTER(0x40008004)
#define SSI0_DR REGISTER(0x40008008)
#define SSI0_SR REGISTER(0x4000800c)
#define SSI0_CPSR REGISTER(0x40008010)
#define SSI0_IM REGISTER(0x40008014)

enum {
  SSI_CR0_DSS_8 = 7,
  SSI_CR0_SPO = 1 << 6,
  SSI_CR0_SPH = 1 << 7,
  SSI_CR0_SCR_AT = 8,
  SSI_CR1_SSE = 1 << 1,
  SSI_SR_TNF = 1 << 1,
  SSI_SR_RNE = 1 << 2,
  SSI_SR_BSY = 1 << 4,
  SSI_IM_TXIM = 1 << 3, /* when the transmit FIFO is half empty or more */
  SSI0_INTERRUPT = 7
};

/* Cortex-M3 [2.5, 3]: SysTick, and the interrupt controller's first set-enable register. */
#define SYST_CSR REGISTER(0xe000e010)
#define SYST_RVR REGISTER(0xe000e014)
#define SYST_CVR REGISTER(0xe000e018)
#define NVIC_ISER0 REGISTER(0xe000e100)

enum {
  SYST_ENABLE = 1 << 0,
  SYST_TICKINT = 1 << 1,
  SYST_PROCESSOR_CLOCK = 1 << 2
};

#endif
