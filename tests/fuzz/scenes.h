/* Fixed scenes for strips; scenes.c says which. */
#ifndef FIXCAST_FUZZ_SCENES_H
#define FIXCAST_FUZZ_SCENES_H

#include "fixcast/fixcast.h"

#ifdef __cplusplus
extern "C" {
#endif

struct fixed_scene {
  const fc_scene *scene;
  const fc_camera *camera;
};

extern const struct fixed_scene fixed_s1, fixed_mesh;

#ifdef __cplusplus
}
#endif

#endif
