/*
 * Counts decisions and how many of them needed their exact form, for reports and tests.
 *
 * Nothing is counted unless FC_TALLY names a function taking (fc_decision, bool exact); the tally test
 * builds the core that way.
 */
#ifndef FC_TALLY_H
#define FC_TALLY_H

#include <stdbool.h>

typedef enum fc_decision {
  FC_DECIDE_EDGE,   /* side of a triangle's edge, primary ray */
  FC_DECIDE_NEARER, /* order of two roots */
  FC_DECIDE_FAR,    /* a root against the far limit or an end of t's interval */
  FC_DECIDE_DEPTH,  /* rounding of a depth code */
  FC_DECIDE_FACING, /* a surface and a light */
  FC_DECIDE_SIDE,   /* a point and a plane */
  FC_DECIDE_PIERCE, /* a segment and a triangle's edges */
  FC_DECIDE_PASS,   /* a segment and a sphere */
  FC_DECIDE_PIXEL,  /* a pixel that the scan engine left to the ray engine */
  FC_DECIDE_LIT,    /* ... a light at a pixel */
  FC_DECISIONS
} fc_decision;

#ifdef FC_TALLY
void FC_TALLY(fc_decision decision, bool exact);
#else
#define FC_TALLY(decision, exact) ((void)0)
#endif

#endif
