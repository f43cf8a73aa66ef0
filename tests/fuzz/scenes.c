/* The scenes for strips: S1, and a small mesh: an octahedron over a square floor, seen so that edges and vertices fall on
 * pixel centres. In C, as S1 is. */
#include "scenes.h"

#include "s1.h"

static const fc_vec3 mesh_vertices[] = {
    FC_VEC3(1, 0, 0), FC_VEC3(-1, 0, 0), FC_VEC3(0, 1, 0), FC_VEC3(0, -1, 0), FC_VEC3(0, 0, 1),
    FC_VEC3(0, 0, -1), FC_VEC3(-4, -1, 4), FC_VEC3(4, -1, 4), FC_VEC3(4, -1, -4), FC_VEC3(-4, -1, -4)};
static const fc_triangle mesh_triangles[] = {
    /* clang-format off */
    {{0, 2, 4}, 0, 1}, {{2, 1, 4}, 0, 1}, {{1, 3, 4}, 0, 1}, {{3, 0, 4}, 0, 1}, {{2, 0, 5}, 0, 1},
    {{1, 2, 5}, 0, 1}, {{3, 1, 5}, 0, 1}, {{0, 3, 5}, 0, 1}, {{6, 7, 8}, 1, 2}, {{6, 8, 9}, 1, 2}};
/* clang-format on */
static const fc_material mesh_materials[] = {FC_MATTE(FC_RGB8(200, 120, 40)), FC_MATTE(FC_RGB8(160, 160, 170))};
static const fc_light mesh_lights[] = {{FC_VEC3(0, 5, 0), FC_GREY(0.5), 0, 0, 0, 0},
                                       {FC_VEC3(-3, 2, 4), FC_GREY(0.5), 0, 4, 1, 0}};
static const fc_shapes mesh_shapes[] = {FC_TRIANGLES(mesh_vertices, mesh_triangles)};
static const fc_scene mesh = {.shapes = mesh_shapes,
                              .materials = mesh_materials,
                              .lights = mesh_lights,
                              .shape_count = 1,
                              .material_count = 2,
                              .light_count = 2,
                              .ambient = FC_GREY(0.125),
                              .background = FC_RGB8(0, 0, 64)};
static const fc_camera mesh_camera = {FC_VEC3(0, 0, 4), FC_VEC3(0, 0, 0), {0, 1, 0}, 0, FC_FOV_EDGES, 1, 2};

const struct fixed_scene fixed_s1 = {&s1, &s1_camera}, fixed_mesh = {&mesh, &mesh_camera};
