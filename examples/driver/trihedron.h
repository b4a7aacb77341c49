/* SPDX-License-Identifier: Apache-2.0 */
#ifndef TRIHEDRON_H
#define TRIHEDRON_H

#include <stdint.h>

#include "trihedron_registers.h"

#define TRIHEDRON_ID_VALUE 0x54524948u /* "TRIH" */
#define TRIHEDRON_MAJOR 0u             /* of the map that this driver knows */

struct trihedron_core {
  volatile uint32_t *registers; /* the core's 4 KiB, mapped; only trihedron_bus.c looks at it */
  unsigned views;
  uint32_t max_width, max_height; /* px */
};

struct trihedron_thresholds {
  uint32_t noise_floor, mean_limit, support, branch_floor, min_turn;
};

struct trihedron_counts {
  uint32_t frames;     /* that have left, modulo 2^32 */
  uint32_t last_frame; /* of the last of them: vertices sent, lost << 16 */
};

/* How a register is reached: trihedron_bus.c, which a system without mapped registers replaces. */
uint32_t trihedron_read(const struct trihedron_core *core, uint32_t address);
void trihedron_write(const struct trihedron_core *core, uint32_t address, uint32_t value);

/* Returns 0 when the core at `registers` is one that this driver knows, else -1. */
int trihedron_open(struct trihedron_core *core, volatile uint32_t *registers);
/* Lets the views run: frames of `lines` lines (0: not known), at most `vertex_limit` vertices each. DMA must be ready. */
void trihedron_start(const struct trihedron_core *core, uint32_t lines, uint32_t vertex_limit);
/* In force from each view's next frame on, all together. */
void trihedron_set_thresholds(const struct trihedron_core *core, const struct trihedron_thresholds *to);
struct trihedron_counts trihedron_counts(const struct trihedron_core *core, unsigned view);
/* STATUS of `view`, cleared as far as it is returned: no event is lost. */
uint32_t trihedron_take_status(const struct trihedron_core *core, unsigned view);

#endif
