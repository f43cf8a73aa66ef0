/*
 * The RP2040's registers that this port uses. Numbers in brackets are sections of the RP2040 data sheet (Raspberry Pi Ltd,
 * build-date 2024-10-15); M0+ is the Armv6-M Architecture Reference Manual.
 */
#ifndef FIXCAST_PORT_PICO_RP2040_H
#define FIXCAST_PORT_PICO_RP2040_H

#include <stdint.h>

#define RP_REG(address) (*(volatile uint32_t *)(uintptr_t)(address))

/* Aliases that set and clear single bits without a read (2.1.2). Not for SIO and the core's own registers. */
#define RP_SET(address) RP_REG((address) + 0x2000u)
#define RP_CLEAR(address) RP_REG((address) + 0x3000u)

/* Subsystem resets (2.14): a peripheral is usable once its bit is clear in RESET and set in RESET_DONE. */
#define RESETS_RESET 0x4000c000u
#define RESETS_DONE 0x4000c008u
#define RESETS_DMA (1u << 2)
#define RESETS_IO_BANK0 (1u << 5)
#define RESETS_PADS_BANK0 (1u << 8)
#define RESETS_PLL_SYS (1u << 12)
#define RESETS_SPI0 (1u << 16)
#define RESETS_TIMER (1u << 21)
#define RESETS_UART0 (1u << 22)

/* Power-on state machine (2.13): what holds core 1 in reset. */
#define PSM_FRCE_OFF 0x40010004u
#define PSM_PROC1 (1u << 16)

/* Clocks (2.15.7) */
#define CLK_REF_CTRL 0x40008030u
#define CLK_REF_SELECTED 0x40008038u
#define CLK_REF_SRC_XOSC 2u
#define CLK_SYS_CTRL 0x4000803cu
#define CLK_SYS_DIV 0x40008040u
#define CLK_SYS_SELECTED 0x40008044u
#define CLK_SYS_SRC_REF 0u
#define CLK_SYS_SRC_AUX 1u /* the auxiliary source 0 is PLL_SYS */
#define CLK_PERI_CTRL 0x40008048u
#define CLK_PERI_ENABLE (1u << 11) /* the auxiliary source 0 is clk_sys */
#define CLK_SYS_RESUS_CTRL 0x40008078u

/* Crystal oscillator (2.16.7) */
#define XOSC_CTRL 0x40024000u
#define XOSC_CTRL_1_15MHZ 0xaa0u
#define XOSC_CTRL_ENABLE (0xfabu << 12)
#define XOSC_STATUS 0x40024004u
#define XOSC_STATUS_STABLE (1u << 31)
#define XOSC_STARTUP 0x4002400cu

/* PLL_SYS (2.18.4) */
#define PLL_CS 0x40028000u
#define PLL_CS_LOCK (1u << 31)
#define PLL_PWR 0x40028004u
#define PLL_PWR_PD (1u << 0)
#define PLL_PWR_POSTDIVPD (1u << 3)
#define PLL_PWR_VCOPD (1u << 5)
#define PLL_FBDIV 0x40028008u
#define PLL_PRIM 0x4002800cu
#define PLL_PRIM_POSTDIV1_SHIFT 16
#define PLL_PRIM_POSTDIV2_SHIFT 12

/* Watchdog's tick generator (4.7.6): what the timer counts */
#define WATCHDOG_TICK 0x4005802cu
#define WATCHDOG_TICK_ENABLE (1u << 9)

/* Timer (4.6.5) */
#define TIMER_TIMERAWH 0x40054024u
#define TIMER_TIMERAWL 0x40054028u

/* Pads and pin functions of bank 0 (2.19.6) */
#define PADS_GPIO(pin) (0x4001c004u + 4u * (pin))
#define PADS_SLEWFAST (1u << 0)
#define PADS_SCHMITT (1u << 1)
#define PADS_PDE (1u << 2)
#define PADS_PUE (1u << 3)
#define PADS_DRIVE_4MA (1u << 4)
#define PADS_DRIVE_8MA (2u << 4)
#define PADS_IE (1u << 6)
#define IO_GPIO_CTRL(pin) (0x40014004u + 8u * (pin))
#define IO_FUNCTION_SPI 1u
#define IO_FUNCTION_UART 2u
#define IO_FUNCTION_SIO 5u

/* Single-cycle IO (2.3.1.7): one a core, on the core's own bus */
#define SIO_CPUID 0xd0000000u
#define SIO_GPIO_IN 0xd0000004u
#define SIO_GPIO_OUT_SET 0xd0000014u
#define SIO_GPIO_OUT_CLR 0xd0000018u
#define SIO_GPIO_OE_SET 0xd0000024u
#define SIO_FIFO_ST 0xd0000050u
#define SIO_FIFO_ST_VLD (1u << 0) /* there is something to read */
#define SIO_FIFO_ST_RDY (1u << 1) /* there is room to write */
#define SIO_FIFO_WR 0xd0000054u
#define SIO_FIFO_RD 0xd0000058u

/* UART0, a PL011 (4.2.8) */
#define UART0_DR 0x40034000u
#define UART0_FR 0x40034018u
#define UART_FR_BUSY (1u << 3)
#define UART_FR_TXFF (1u << 5)
#define UART0_IBRD 0x40034024u
#define UART0_FBRD 0x40034028u
#define UART0_LCR_H 0x4003402cu
#define UART_LCR_H_FEN (1u << 4)
#define UART_LCR_H_8BIT (3u << 5)
#define UART0_CR 0x40034030u
#define UART_CR_UARTEN (1u << 0)
#define UART_CR_TXE (1u << 8)
#define UART_CR_RXE (1u << 9)

/* SPI0, a PL022 (4.4.4) */
#define SPI0_CR0 0x4003c000u
#define SPI_CR0_SPO (1u << 6) /* clock idles high */
#define SPI_CR0_SPH (1u << 7) /* data is taken at the second edge */
#define SPI_CR0_SCR_SHIFT 8
#define SPI0_CR1 0x4003c004u
#define SPI_CR1_SSE (1u << 1)
#define SPI0_DR 0x4003c008u
#define SPI0_SR 0x4003c00cu
#define SPI_SR_TNF (1u << 1)
#define SPI_SR_RNE (1u << 2)
#define SPI_SR_BSY (1u << 4) /* a word is being shifted, or the transmit FIFO is not empty */
#define SPI0_CPSR 0x4003c010u
#define SPI0_ICR 0x4003c020u
#define SPI_ICR_ROR (1u << 0)
#define SPI0_DMACR 0x4003c024u
#define SPI_DMACR_TXDMAE (1u << 1)

/* DMA (2.5.7) */
#define DMA_READ_ADDR(channel) (0x50000000u + 0x40u * (channel))
#define DMA_WRITE_ADDR(channel) (0x50000004u + 0x40u * (channel))
#define DMA_TRANS_COUNT(channel) (0x50000008u + 0x40u * (channel))
#define DMA_CTRL_TRIG(channel) (0x5000000cu + 0x40u * (channel))
#define DMA_CTRL_EN (1u << 0)
#define DMA_CTRL_HIGH_PRIORITY (1u << 1)
#define DMA_CTRL_SIZE_SHIFT 2 /* 0: bytes, 1: halfwords */
#define DMA_CTRL_INCR_READ (1u << 4)
#define DMA_CTRL_CHAIN_TO_SHIFT 11 /* to itself: none */
#define DMA_CTRL_TREQ_SHIFT 15
#define DMA_TREQ_SPI0_TX 16u
#define DMA_CTRL_BSWAP (1u << 22)
#define DMA_CTRL_BUSY (1u << 24)
#define DMA_CTRL_ERRORS (7u << 29) /* AHB, read, write; the last two are cleared by writing 1 */
#define DMA_INTE0 0x50000404u
#define DMA_INTS0 0x5000040cu
#define DMA_CHAN_ABORT 0x50000444u
#define IRQ_DMA_0 11

/* The core's own (2.4.8) */
#define SYST_CSR 0xe000e010u
#define SYST_CSR_ENABLE (1u << 0)
#define SYST_CSR_TICKINT (1u << 1)
#define SYST_CSR_CLKSOURCE (1u << 2) /* the processor's clock */
#define SYST_RVR 0xe000e014u
#define SYST_CVR 0xe000e018u
#define NVIC_ISER 0xe000e100u
#define NVIC_ICPR 0xe000e280u
#define NVIC_ICSR 0xe000ed04u
#define NVIC_ICSR_PENDSTSET (1u << 26)
#define SCB_VTOR 0xe000ed08u

#endif
