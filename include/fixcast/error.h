/* Error codes: every function that can fail returns 0 or more on success and one of these on failure. */
#ifndef FIXCAST_ERROR_H
#define FIXCAST_ERROR_H

#ifdef __cplusplus
extern "C" {
#endif

/* What functions return: FC_OK, or a negative error; fc_error_text says each in words. */
typedef enum fc_error {
  FC_OK = 0,
  FC_ERR_NULL = -1,           /* a required pointer is NULL */
  FC_ERR_SIZE = -2,           /* frame size outside 1..FC_SIZE_MAX, or rows outside the frame */
  FC_ERR_COORDINATE = -3,     /* a coordinate, radius or direction outside +-FC_COORDINATE_MAX */
  FC_ERR_EXPONENT = -4,       /* an exponent outside its documented range */
  FC_ERR_RADIUS = -5,         /* a sphere's radius is zero or negative */
  FC_ERR_NORMAL = -6,         /* a plane's normal is zero */
  FC_ERR_INDEX = -7,          /* a triangle names a vertex, or a shape a material, that does not exist */
  FC_ERR_COUNT = -8,          /* more than FC_PRIMITIVES_MAX primitives */
  FC_ERR_CAMERA_TARGET = -9,  /* eye and target are the same point */
  FC_ERR_CAMERA_UP = -10,     /* up is zero or parallel to the view direction */
  FC_ERR_FIELD_OF_VIEW = -11, /* tan_half_fov is zero or outside its range */
  FC_ERR_LIGHT = -12,         /* a light is more than 2^32 times as far away as the scene is large */
  FC_ERR_MEMORY = -13,        /* the memory handed over is too small or not aligned for int64_t */
  FC_ERR_FORMAT = -14,        /* unknown pixel format, field-of-view rule or shadow rule */
  FC_ERR_DIRECTION = -15,     /* a ray's direction is zero */
  FC_ERR_BVH = -16,           /* a bounding volume hierarchy that was not made for this scene, or is damaged */
  FC_ERR_PROFILE = -17,       /* unknown profile, or a field that is not 0 or 1 */
  FC_ERR_UNSUPPORTED = -18,   /* a display, panel or bus that cannot do what was asked */
  FC_ERR_AREA = -19,          /* an area that is empty, off the display or not aligned, or a pitch that is too small for it */
  FC_ERR_BUS = -20,           /* a bus that failed, or did not finish in time; ports with codes of their own return those */
  FC_ERR_MATERIAL = -21,      /* a material's layer without a kind or data, or with data outside its documented range */
  FC_ERR_ROTATION = -22,      /* a rotation that is not of unit length, or an entry of its matrix beyond 1 */
  FC_ERR_SAMPLING = -23,      /* no sampling pattern, or a count, depth, filter or threshold outside its documented range */
  FC_ERR_LENS = -24           /* no lens, or a lens with data outside its documented range */
} fc_error;

/* A sentence for an error code, never NULL; the text is constant and lives as long as the program. */
const char *fc_error_text(int error);

#ifdef __cplusplus
}
#endif

#endif
