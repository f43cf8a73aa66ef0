/*
 * The bench scene S1 as firmware would hold it: const tables to paste. The same picture as s1.nff, bit for bit.
 */
#ifndef FIXCAST_S1_H
#define FIXCAST_S1_H

#include "fixcast/fixcast.h"

static const fc_material s1_materials[] FC_ROM = {
    FC_MATTE(FC_RGB8(224, 64, 48)), FC_MATTE(FC_RGB8(48, 192, 80)), FC_MATTE(FC_RGB8(64, 96, 224)), FC_MATTE(FC_RGB8(192, 192, 176))};
static const fc_sphere s1_spheres[] FC_ROM = {/* centre, radius, material, object */
                                              {FC_VEC3(0, 1, -6), FC_Q16(1), 0, 1},
                                              {FC_VEC3(-1.75, 0.75, -4.5), FC_Q16(0.75), 1, 2},
                                              {FC_VEC3(1.25, 0.5, -3), FC_Q16(0.5), 2, 3}};
static const fc_plane s1_planes[] FC_ROM = {{.normal = {0, 1, 0}, .material = 3, .object = 4}}; /* y = 0 */
static const fc_light s1_lights[] FC_ROM = {{.position = FC_VEC3(-3, 5, -1), .intensity = FC_GREY(0.875)}};
static const fc_shapes s1_shapes[] FC_ROM = {FC_SPHERES(s1_spheres), FC_PLANES(s1_planes)};
static const fc_scene s1 FC_ROM = {.shapes = s1_shapes,
                                   .shape_count = FC_COUNT_OF(s1_shapes),
                                   .materials = s1_materials,
                                   .material_count = FC_COUNT_OF(s1_materials),
                                   .lights = s1_lights,
                                   .light_count = FC_COUNT_OF(s1_lights),
                                   .far_limit = FC_Q16(100),
                                   .ambient = FC_GREY(0.125),
                                   .background = FC_RGB8(96, 144, 208)};
static const fc_camera s1_camera FC_ROM = {.eye = FC_VEC3(0, 1.5, 1),
                                           .target = FC_VEC3(0, 1.5, 0),
                                           .up = {0, 1, 0},
                                           .tan_half_fov_numerator = 1,
                                           .tan_half_fov_denominator = 2};

#endif
