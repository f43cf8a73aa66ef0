/* Infinite planes: one division a ray, and everything else is which side a point is on. */
#include "bits.h"
#include "fixcast/error.h"
#include "kind.h"
#include "scan_kinds.h"
#include "view.h"

static FC_COLD void read_item(const fc_shapes *shapes, uint16_t index, fc_plane *plane) {
  FC_READ_ONE(plane, (const fc_plane *)shapes->items + index);
}

static FC_COLD int check(const fc_scene *scene, const fc_shapes *shapes) {
  uint16_t i;
  for (i = 0; i < shapes->count; i++) {
    fc_plane p;
    read_item(shapes, i, &p);
    if (fc_abs32(p.normal.x) > (uint32_t)FC_COORDINATE_MAX || fc_abs32(p.normal.y) > (uint32_t)FC_COORDINATE_MAX ||
        fc_abs32(p.normal.z) > (uint32_t)FC_COORDINATE_MAX || fc_abs32(p.d) > (uint32_t)FC_COORDINATE_MAX)
      return FC_ERR_COORDINATE;
    if ((p.normal.x | p.normal.y | p.normal.z) == 0) return FC_ERR_NORMAL;
    if (p.d_exponent < 0 || p.d_exponent > 32) return FC_ERR_EXPONENT;
    if (p.material >= scene->material_count) return FC_ERR_INDEX;
  }
  return FC_OK;
}

static FC_COLD uint32_t memory(const fc_shapes *shapes) { return shapes->count * (uint32_t)sizeof(fc_placed_plane); }

static FC_COLD void normal_of(const fc_plane *p, int64_t n[3]) {
  n[0] = p->normal.x;
  n[1] = p->normal.y;
  n[2] = p->normal.z;
}

/* k of the plane relative to the eye, in units of 2^-fine: -d - normal . eye; 30+32+31 bits and 30+61+2: below 2^94. */
static FC_COLD fc_i128 offset_from_eye(const fc_view *view, const fc_plane *p) {
  int64_t n[3];
  fc_i128 d = fc_i128_from(p->d), along;
  fc_i128_move(&d, (int16_t)(p->d_exponent + view->fine));
  normal_of(p, n);
  along = fc_i128_dot(n, view->eye);
  fc_i128_plus(&d, &along);
  fc_i128_negate(&d);
  return d;
}

static FC_COLD fc_num extent(const fc_view *view, const fc_shapes *shapes) {
  fc_num most = {0, 0};
  uint16_t i;
  for (i = 0; i < shapes->count; i++) {
    fc_plane p;
    int64_t n[3];
    fc_num distance, length;
    fc_i128 k;
    read_item(shapes, i, &p);
    normal_of(&p, n);
    k = offset_from_eye(view, &p);
    fc_num_set_abs(&distance, &k);
    fc_length_to(&length, n);
    fc_num_over(&distance, &length);
    if (fc_num_order_of(&distance, &most) > 0) most = distance;
  }
  return most;
}

static FC_COLD void place(const fc_view *view, const fc_shapes *shapes, void *to) {
  fc_placed_plane *placed = to;
  uint16_t i;
  for (i = 0; i < shapes->count; i++) {
    fc_plane p;
    int64_t n[3], rotated[3];
    fc_i128 k;
    uint8_t j, bits;
    int16_t scale;
    read_item(shapes, i, &p);
    normal_of(&p, n);
    /* unit row times 30-bit normal: below 2^30 * 2^31 */
    for (j = 0; j < 3; j++)
      rotated[j] = view->row[j][0] * n[0] + view->row[j][1] * n[1] + view->row[j][2] * n[2];
    bits = fc_vector_bits(rotated);
    /* keep 29 bits and a rounding: at most 2^29. A normal of a few units has at least 30 bits after the rotation. */
    bits = (uint8_t)(bits - 29);
    for (j = 0; j < 3; j++) placed[i].normal[j] = (int32_t)fc_floor_shift64(rotated[j] + (INT64_C(1) << (bits - 1)), bits);
    /* normal was scaled by 2^(30 - bits), the grid by 2^-shift */
    scale = (int16_t)(30 - bits - view->shift);
    k = offset_from_eye(view, &p);
    fc_i128_move(&k, scale);
    placed[i].k = fc_i128_to_i64(k); /* distance below 2^30 times |normal| below 2^30 */
  }
}

static FC_COLD void fetch(const fc_group *group, uint16_t index, fc_form *form) {
  fc_plane p;
  read_item(&group->shapes, index, &p);
  form->material = p.material;
  form->object = p.object;
  if (group->memory != NULL) {
    const fc_placed_plane *placed = (const fc_placed_plane *)group->memory + index;
    form->u.plane.normal[0] = placed->normal[0];
    form->u.plane.normal[1] = placed->normal[1];
    form->u.plane.normal[2] = placed->normal[2];
    form->u.plane.k = placed->k;
    form->u.plane.unit[0] = placed->unit[0];
    form->u.plane.unit[1] = placed->unit[1];
    form->u.plane.unit[2] = placed->unit[2];
  } else {
    normal_of(&p, form->u.plane.normal);
    form->u.plane.k = -p.d * (INT64_C(1) << p.d_exponent); /* 30 + 32 bits */
  }
}

static FC_COLD void prepare(const fc_form *form, const int64_t origin[3], fc_prepared *prepared) {
  /* k 62 bits, the product 30 + 62 + 2: below 2^95 */
  const int64_t *n = form->u.plane.normal;
  fc_i128 along = fc_i128_dot(n, origin);
  prepared->u.plane.normal[0] = n[0];
  prepared->u.plane.normal[1] = n[1];
  prepared->u.plane.normal[2] = n[2];
  prepared->u.plane.side = fc_i128_from(form->u.plane.k);
  fc_i128_minus(&prepared->u.plane.side, &along);
}

static FC_COLD uint8_t test(const fc_prepared *prepared, const int64_t direction[3], fc_root *root) {
  /* t = side / (normal . direction): 30 + 30 + 2 bits below */
  int64_t along = fc_dot(prepared->u.plane.normal, direction);
  if (fc_i128_sign(prepared->u.plane.side) * fc_sign64(along) <= 0) return 0;
  root->p = fc_i128_abs(prepared->u.plane.side);
  root->m = fc_i128_from_u64(fc_abs64(along));
  root->d = root->c = fc_i128_from(0);
  root->q = 0;
  return 1;
}

static FC_COLD int8_t side(const fc_form *form, const int64_t point[3]) {
  fc_i128 along = fc_i128_dot(form->u.plane.normal, point), k = fc_i128_from(form->u.plane.k);
  fc_i128_minus(&along, &k);
  return fc_i128_sign(along);
}

static FC_COLD bool blocked(const fc_form *form, fc_segment *segment) {
  int8_t light = side(form, segment->light);
  return light != 0 && fc_side_of_point(segment, form->u.plane.normal, fc_i128_from(form->u.plane.k)) == light;
}

static FC_COLD bool facing(const fc_form *form, fc_segment *segment) {
  return side(form, fc_eye) * side(form, segment->light) > 0;
}

static FC_COLD void normal(const fc_form *form, const int64_t point[3], int64_t n[3]) {
  uint8_t i;
  (void)point;
  for (i = 0; i < 3; i++) n[i] = form->u.plane.normal[i];
}

/* |k| F / along, which is z; within 2^-24. */
static FC_COLD uint64_t z_at(const fc_frame *frame, int64_t k, int64_t along) {
  fc_quick z = fc_quick_mul(fc_quick_from(fc_abs64(k), 0), fc_quick_recip(fc_quick_from((uint64_t)along, 0)));
  z = fc_quick_mul(z, fc_quick_from((uint64_t)frame->view.focal, 0));
  return z.e > 30 ? UINT64_MAX / 2 : fc_quick_to_u64(z);
}

static FC_COLD void depth_range(const fc_frame *frame, const fc_group *group, uint64_t *near, uint64_t *far) {
  uint16_t i;
  for (i = 0; i < group->shapes.count; i++) {
    /* 1/z is affine in the pixel, so the corner pixels (+-x, +-y, F) hold its extremes; a corner that misses means the horizon is in
     * view, and z has no bound. */
    int64_t reach, middle;
    uint64_t z;
    fc_form form;
    fetch(group, i, &form);
    middle = form.u.plane.normal[2] * frame->view.focal;
    if (form.u.plane.k < 0) middle = -middle;
    reach = (int64_t)(fc_abs64(form.u.plane.normal[0]) * (uint16_t)(frame->width - 1) +
                      fc_abs64(form.u.plane.normal[1]) * (uint16_t)(frame->height - 1)) *
            (INT64_C(1) << frame->view.pixel_shift);
    if (form.u.plane.k == 0 || middle + reach <= 0) continue;
    z = z_at(frame, form.u.plane.k, middle + reach);
    z -= z >> 22;
    if (z > 0) z--; /* cut */
    if (z < *near) *near = z;
    z = UINT64_MAX;
    if (middle > reach) {
      z = z_at(frame, form.u.plane.k, middle - reach);
      z += (z >> 22) + 1;
    }
    if (z > *far) *far = z;
  }
}

const fc_kind fc_kind_plane FC_ROM = {
    check, memory, extent, place, fetch, prepare, test, blocked, facing, normal,
    side, NULL, depth_range, fc_plane_project, fc_plane_window, fc_plane_draw, fc_plane_shadow, fc_plane_between,
    fc_plane_hides,
    fc_scan_each, NULL, NULL, NULL, NULL};
