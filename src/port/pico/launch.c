/* See launch.h. */
#include "launch.h"

#include <stddef.h>

#include "core1.h"

void fcp_launch(uint32_t vectors, uint32_t stack_end, uint32_t code) {
  const uint32_t words[6] = {0, 0, 1, vectors, stack_end, code};
  size_t i = 0;
  /* Each word comes back; after one that does not, from the start. Before a 0 the ROM empties its FIFO; so is ours here. */
  while (i < 6) {
    if (words[i] == 0) fcp_core_drop();
    fcp_core_give(words[i]);
    i = fcp_core_take() == words[i] ? i + 1 : 0;
  }
}
