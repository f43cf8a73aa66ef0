/* A program that uses every unit which a firmware links only by name: it shows that checks/linked.py would notice them. */
#include "fixcast/fixcast.h"
#include "fixcast/volume_extra.h"

/* What a scene and its frame name. */
const fc_layer_kind *const every_layer[] = {&fc_layer_phong, &fc_layer_mirror, &fc_layer_emission, &fc_layer_smooth, &fc_layer_texture};
const fc_texture_kind *const every_texture[] = {&fc_texture_checker, &fc_texture_image, &fc_texture_palette};
const fc_mapping_kind *const every_mapping[] = {&fc_mapping_planar, &fc_mapping_spherical, &fc_mapping_vertices};
const fc_kind *const every_triangle[] = {&fc_kind_triangle_short, &fc_kind_convex};
const fc_sky_kind *const every_sky[] = {&fc_sky_gradient};
const fc_transfer *const every_transfer[] = {&fc_transfer_srgb, &fc_transfer_gamma22};
const fc_pattern *const every_pattern[] = {&fc_pattern_one, &fc_pattern_regular, &fc_pattern_random, &fc_pattern_jittered, &fc_pattern_quincunx};
const fc_lens_kind *const every_lens[] = {&fc_lens_pinhole, &fc_lens_orthographic, &fc_lens_fisheye, &fc_lens_panorama};

int main(void) {
  const void *const *const named[] = {(const void *const *)every_layer, (const void *const *)every_texture, (const void *const *)every_mapping,
                                      (const void *const *)every_sky, (const void *const *)every_transfer, (const void *const *)every_pattern,
                                      (const void *const *)every_lens, (const void *const *)every_triangle};
  const fc_sampling how = {0};
  const fc_vec3 origin = {0, 0, 0}, along = {1, 2, 3};
  const fc_aabb box = {{-1, -1, -1}, {1, 1, 1}};
  const fc_sphere ball = {{0, 0, 0}, 1, 0, 0};
  const fc_plane plane = {{0, 1, 0}, 0, 0, 0, 0};
  const fc_vec3 triangle[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const uint16_t faces[1][3] = {{0, 1, 2}}, edges[3][2] = {{0, 1}, {1, 2}, {2, 0}};
  const fc_polytope flat = {triangle, faces, edges, 3, 1, 3};
  const fc_slab slab = {{1, 1, 1}, -1, 1};
  fc_vec3 point;
  fc_rotation rotation;
  fc_matrix matrix;
  int met = fc_ray_aabb(&origin, &along, &box, NULL) + fc_aabb_aabb(&box, &box) + fc_triangle_aabb(triangle, &box) +
            (fc_sphere_plane(&ball, &plane) == FC_SIDE_ON) + fc_convex_convex(&flat, &flat) +
            fc_ray_slabs(&origin, &along, &slab, 1, NULL) + fc_sweep_sphere_plane(&ball, &along, &plane, NULL) +
            fc_sweep_sphere_triangle(&ball, &along, triangle, NULL);
  int error = fc_reflect(&point, &along, &along);
  if (error == FC_OK) error = fc_trackball_drag(&rotation, 1, 2, 3, 4, 5);
  if (error != FC_OK) return 1;
  if (fc_sample_scratch(NULL, &how, &error) != 0 || named[met % 8][0] == NULL) return 1;
  error = FC_OK;
  if (error == FC_OK) error = fc_rotation_about(&rotation, &along, 1);
  if (error == FC_OK) error = fc_rotation_matrix(&matrix, &rotation);
  return met == 8 && error == FC_OK ? 0 : 1;
}
