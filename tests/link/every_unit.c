/* A program that uses every unit which a firmware links only by name: it shows that checks/linked.py would notice them. */
#include "fixcast/fixcast.h"
#include "fixcast/volume_extra.h"

int main(void) {
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
  if (error == FC_OK) error = fc_rotation_about(&rotation, &along, 1);
  if (error == FC_OK) error = fc_rotation_matrix(&matrix, &rotation);
  return met == 8 && error == FC_OK ? 0 : 1;
}
