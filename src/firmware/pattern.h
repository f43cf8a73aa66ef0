/* The bring-up pattern: three bars red, green, blue from left to right, a white border of one pixel, a white arrow that points up. What is mirrored,
 * turned, cut off or swapped in colour shows at once; grey and monochrome displays show the bars as their greys. */
#ifndef FIXCAST_FIRMWARE_PATTERN_H
#define FIXCAST_FIRMWARE_PATTERN_H

#include <stdint.h>

/* Rows y .. y + rows - 1 of the pattern of width x height pixels, as FC_RGB565_BE, rows one after the other. */
void fc_pattern_rows(uint16_t width, uint16_t height, uint16_t y, uint16_t rows, uint8_t *pixels);

#endif
