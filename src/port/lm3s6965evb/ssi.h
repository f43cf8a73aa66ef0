/* The wires to the OLED: SSI 0 with D/C on PC7, as an fc_bus whose transfers may go on by interrupt. */
#ifndef FIXCAST_LM3S6965_SSI_H
#define FIXCAST_LM3S6965_SSI_H

#include "fixcast/bus.h"

/* After clock_start(). There is one: its context is not looked at. */
void ssi_start(void);
extern const fc_bus ssi_bus;

/* The interrupt of SSI 0. */
void ssi_interrupt(void);

#endif
