/* See clocks.h. */
#include "clocks.h"

#include "rp2040.h"

/* PLL (2.18.2): crystal / REFDIV * FBDIV = VCO, 750 to 1600 MHz, FBDIV 16 to 320; VCO / POSTDIV1 / POSTDIV2 is what comes out. */
enum {
  FBDIV = 125, /* 12 MHz * 125 = 1500 MHz */
  POSTDIV1 = 6,
  POSTDIV2 = 2
};
typedef char dividers_fit[(int64_t)FCP_CRYSTAL_HZ * FBDIV == (int64_t)FCP_SYSTEM_HZ * POSTDIV1 * POSTDIV2 ? 1 : -1];

void fcp_reset_peripherals(uint32_t bits) {
  RP_SET(RESETS_RESET) = bits;
  RP_CLEAR(RESETS_RESET) = bits;
  while ((RP_REG(RESETS_DONE) & bits) != bits) continue;
}

static void start_crystal(void) {
  RP_REG(XOSC_CTRL) = XOSC_CTRL_1_15MHZ;
  RP_REG(XOSC_STARTUP) = (FCP_CRYSTAL_HZ / 1000 + 128) / 256; /* about 1 ms, in units of 256 periods (2.16.3) */
  RP_SET(XOSC_CTRL) = XOSC_CTRL_ENABLE;
  while ((RP_REG(XOSC_STATUS) & XOSC_STATUS_STABLE) == 0) continue;
}

static void start_pll(void) {
  fcp_reset_peripherals(RESETS_PLL_SYS);
  RP_REG(PLL_CS) = 1; /* REFDIV */
  RP_REG(PLL_FBDIV) = FBDIV;
  RP_CLEAR(PLL_PWR) = PLL_PWR_PD | PLL_PWR_VCOPD;
  while ((RP_REG(PLL_CS) & PLL_CS_LOCK) == 0) continue;
  RP_REG(PLL_PRIM) = (uint32_t)POSTDIV1 << PLL_PRIM_POSTDIV1_SHIFT | (uint32_t)POSTDIV2 << PLL_PRIM_POSTDIV2_SHIFT;
  RP_CLEAR(PLL_PWR) = PLL_PWR_POSTDIVPD;
}

void fcp_clocks_start(void) {
  RP_REG(CLK_SYS_RESUS_CTRL) = 0; /* no watch for a stopped clk_sys while it is changed */
  start_crystal();

  /* The system may run from the PLL already, after a debugger's reset: away from it before the PLL is touched. Sources are switched
   * without glitches, auxiliary sources are not (2.15.3.2): so leave the auxiliary multiplexer first, then set it, then return. */
  RP_CLEAR(CLK_SYS_CTRL) = CLK_SYS_SRC_AUX;
  while (RP_REG(CLK_SYS_SELECTED) != 1u << CLK_SYS_SRC_REF) continue;
  RP_REG(CLK_REF_CTRL) = CLK_REF_SRC_XOSC;
  while (RP_REG(CLK_REF_SELECTED) != 1u << CLK_REF_SRC_XOSC) continue;

  start_pll();
  RP_REG(CLK_SYS_DIV) = 1u << 8;
  RP_REG(CLK_SYS_CTRL) = CLK_SYS_SRC_REF; /* auxiliary source: PLL_SYS */
  RP_REG(CLK_SYS_CTRL) = CLK_SYS_SRC_AUX;
  while (RP_REG(CLK_SYS_SELECTED) != 1u << CLK_SYS_SRC_AUX) continue;

  RP_REG(CLK_PERI_CTRL) = 0; /* its source may only change while it is off */
  RP_REG(CLK_PERI_CTRL) = CLK_PERI_ENABLE;

  RP_REG(WATCHDOG_TICK) = WATCHDOG_TICK_ENABLE | FCP_CRYSTAL_HZ / 1000000; /* clk_ref / 12 */
  fcp_reset_peripherals(RESETS_TIMER);
}
