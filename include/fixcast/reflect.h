/* Mirror directions in whole numbers. */
#ifndef FIXCAST_REFLECT_H
#define FIXCAST_REFLECT_H

#include "fixcast/error.h"
#include "fixcast/vec3.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Where a mirror sends a ray: R = D - 2 (n . D) n / n^2 (the law of reflection), for a direction and a normal of any
 * length but 0, times the power of two that gives its largest component 30 bits (29 in the rare case that 30 leave no room), rounded.
 *
 * Each component is within 1/2 + 2^-30 of that multiple of R; it is the multiple where that is whole, so three mirrors at right angles along
 * the axes send a ray back along exactly -D. n . R has the sign of -n . D, without fail: where rounding would turn a grazing ray into the
 * mirror, the component along the normal's largest axis is moved by up to 2 units. n . D = 0: D itself.
 *
 * FC_OK or FC_ERR_NULL, FC_ERR_DIRECTION (the direction is zero), FC_ERR_NORMAL (the normal is), FC_ERR_COORDINATE: a component beyond
 * +-2^30. Unit normals in Q30 may come. *reflected may be *direction.
 */
int fc_reflect(fc_vec3 *reflected, const fc_vec3 *direction, const fc_vec3 *normal);

#ifdef __cplusplus
}
#endif

#endif
