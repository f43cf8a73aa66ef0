/* Bounding volume hierarchies. */
#include "hierarchy.h"

#include <cstddef>
#include <cstdint>

namespace host {

void add_hierarchy(CoreScene &core, const std::string &choice) {
  constexpr std::size_t worth_it = 16;
  if (choice != "auto" && choice != "on" && choice != "off")
    throw UserError("--bvh takes auto, on or off, not \"" + choice + "\"");
  const std::size_t finite = core.spheres.size() + core.triangles.size();
  if (choice == "off" || (choice == "auto" && (finite <= worth_it || core.lights.empty()))) return;
  int error = FC_OK;
  const std::size_t bytes = fc_bvh_memory(&core.scene, &error);
  fc_bvh bvh{};
  core.bvh_memory.resize((bytes + sizeof(std::uint32_t) - 1) / sizeof(std::uint32_t));
  if (error == FC_OK) error = fc_bvh_build(&bvh, &core.scene, core.bvh_memory.data(), bytes);
  if (error != FC_OK) throw UserError(std::string("cannot build a hierarchy: ") + fc_error_text(error));
  core.bvh.assign(1, bvh);
  core.scene.bvh = core.bvh.data();
}

std::size_t hierarchy_bytes(const CoreScene &core) {
  return core.bvh.empty() ? 0 : fc_bvh_bytes(&core.bvh.front());
}

} // namespace host
