/* What a hit's triangle has at its vertices. */
#ifndef FC_VERTEX_H
#define FC_VERTEX_H

#include <stdbool.h>
#include <stdint.h>

#include "space.h"

typedef struct fc_corner {
  uint32_t weight_q30; /* barycentric */
  uint16_t vertex;     /* in the table's vertices */
} fc_corner;

/* The three vertices of a surface's triangle; false for other shapes. */
bool fc_corners_of(const fc_surface *surface, fc_corner corner[3]);

#endif
