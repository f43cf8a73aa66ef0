/* The layer of Phong's highlight. */
#include "coat.h"
#include "fixcast/error.h"
#include "layer.h"
#include "segment.h"

static FC_COLD int check(const void *data) {
  fc_phong phong;
  if (data == NULL) return FC_ERR_MATERIAL;
  FC_READ(&phong, data, sizeof phong);
  return phong.shininess_q8 == 0 || phong.shininess_q8 > UINT32_C(1) << 24 ? FC_ERR_MATERIAL : FC_OK;
}

/* base^(exponent / 256), base up to 1: squares for the whole part, roots for the rest. */
static FC_COLD fc_quick power(fc_quick base, uint32_t exponent_q8) {
  fc_quick result = fc_quick_from(1, 0), root = base;
  uint32_t whole = exponent_q8 >> 8;
  uint8_t bit;
  for (bit = 128; bit != 0; bit >>= 1) {
    if ((exponent_q8 & (2u * bit - 1u)) == 0) break;
    root = fc_quick_mul(root, fc_quick_rsqrt(root)); /* base > 0 */
    if (exponent_q8 & bit) result = fc_quick_mul(result, root);
  }
  for (;;) {
    if (whole & 1) result = fc_quick_mul(result, base);
    whole >>= 1;
    if (whole == 0) return result;
    base = fc_quick_mul(base, base);
    if (base.e < -200) base.m = 0; /* far below the last bit; and exponents stay small */
  }
}

static FC_COLD void light(fc_shading *shading, const void *data) {
  const fc_surface *surface = shading->surface;
  fc_phong phong;
  fc_quick value, view_scale;
  int64_t view[3];
  int32_t nl, nv, lv;
  int64_t cosine_q30;
  uint64_t q24;
  uint16_t specular[3];
  uint8_t i;
  FC_READ(&phong, data, sizeof phong);
  for (i = 0; i < 3; i++) view[i] = -surface->direction[i]; /* below 2^30 */
  view_scale = fc_inverse_length(view);
  /* cosines in Q30, each within 2^-24 */
  nl = fc_quick_times(fc_quick_mul(shading->normal_scale, shading->light.to_scale), fc_dot(shading->normal, shading->light.to), 30);
  nv = fc_quick_times(fc_quick_mul(shading->normal_scale, view_scale), fc_dot(shading->normal, view), 30);
  lv = fc_quick_times(fc_quick_mul(shading->light.to_scale, view_scale), fc_dot(shading->light.to, view), 30);
  if (nl <= 0 || nv <= 0) return; /* a normal that leans over may say so of a point that is lit */
  cosine_q30 = fc_floor_shift64((int64_t)nl * nv, 29) - lv;
  if (cosine_q30 <= 0) return;
  if (cosine_q30 > INT64_C(1) << 30) cosine_q30 = INT64_C(1) << 30;
  value = fc_quick_mul(power(fc_quick_from((uint64_t)cosine_q30, -30), phong.shininess_q8), shading->light.strength);
  value.e += 24;
  q24 = value.e > 0 ? UINT32_MAX : fc_quick_to_u64(value);
  fc_channels(&phong.specular, specular);
  for (i = 0; i < 3; i++) {
    /* 16 + 16 + 32 bits, then 49, for each of 65535 lights: cut before it overflows */
    shading->added[i] += ((uint64_t)specular[i] * shading->light.colour[i] * q24) >> 15;
    if (shading->added[i] > FC_RADIANCE_MAX) shading->added[i] = FC_RADIANCE_MAX;
  }
}

const fc_layer_kind fc_layer_phong FC_ROM = {check, NULL, light, NULL, &fc_coat_layer_phong};
