/* The error of each pixel, by the oracle. */
#include "error_layer.h"

#include "compare.h"
#include "oracle.h"

namespace host {

std::vector<float> error_layer(const LoadedScene &scene, const CoreFrame &frame, const Picture &rgb888) {
  const Oracle oracle(scene.file, scene.width, scene.height);
  return compare(scene.file, oracle, frame, rgb888).error;
}

} // namespace host
