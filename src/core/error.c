/* Error texts. */
#include "fixcast/error.h"

const char *fc_error_text(int error) {
  if (error >= 0) return "no error";
  switch ((fc_error)error) {
    case FC_OK: break;
    case FC_ERR_NULL: return "a required pointer is NULL";
    case FC_ERR_SIZE: return "the frame size, pixel, rows or pitch is out of range";
    case FC_ERR_COORDINATE: return "a coordinate, radius or direction is out of range";
    case FC_ERR_EXPONENT: return "an exponent is out of range";
    case FC_ERR_RADIUS: return "a sphere's radius is not positive";
    case FC_ERR_NORMAL: return "a plane's normal is zero";
    case FC_ERR_INDEX: return "an index names a vertex or material that does not exist";
    case FC_ERR_COUNT: return "the scene has more than 65535 primitives";
    case FC_ERR_CAMERA_TARGET: return "the camera's eye and target are the same point";
    case FC_ERR_CAMERA_UP: return "the camera's up direction is zero or parallel to the view";
    case FC_ERR_FIELD_OF_VIEW: return "the field of view is out of range";
    case FC_ERR_LIGHT: return "a light is too far away";
    case FC_ERR_MEMORY: return "the memory handed over is too small or misaligned";
    case FC_ERR_FORMAT: return "unknown pixel format, field-of-view rule, depth format or offset rule";
    case FC_ERR_DIRECTION: return "a ray's direction is zero";
    case FC_ERR_BVH: return "the bounding volume hierarchy does not belong to the scene";
    case FC_ERR_PROFILE: return "unknown profile or field";
    case FC_ERR_UNSUPPORTED: return "the display, panel or bus cannot do that";
    case FC_ERR_AREA: return "the area is empty, off the display or not aligned, or its pitch is too small";
    case FC_ERR_BUS: return "the bus failed or did not finish in time";
    case FC_ERR_ROTATION: return "a rotation is not of unit length";
  }
  return "unknown error";
}
