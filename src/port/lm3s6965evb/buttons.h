/* The board's five buttons as those of the firmware. */
#ifndef FIXCAST_LM3S6965_BUTTONS_H
#define FIXCAST_LM3S6965_BUTTONS_H

#include <stdint.h>

void buttons_start(void);

/* FC_BUTTON_ bits of those that are held now. */
uint8_t buttons_read(void *context);

#endif
