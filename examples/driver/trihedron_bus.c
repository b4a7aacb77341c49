/* SPDX-License-Identifier: Apache-2.0 */
/* Registers that are mapped into memory. */
#include "trihedron.h"

uint32_t trihedron_read(const struct trihedron_core *core, uint32_t address) {
  return core->registers[address / 4];
}

void trihedron_write(const struct trihedron_core *core, uint32_t address, uint32_t value) {
  core->registers[address / 4] = value;
}
