/* SPDX-License-Identifier: Apache-2.0 */
/* A driver's register accesses, in the order that the hardware wants; see docs/integration.md. */
#include "trihedron.h"

static uint32_t field(uint32_t word, uint32_t mask, unsigned lsb) { return (word & mask) >> lsb; }

int trihedron_open(struct trihedron_core *core, volatile uint32_t *registers) {
  core->registers = registers;
  if (trihedron_read(core, TRIHEDRON_ID) != TRIHEDRON_ID_VALUE) return -1;
  const uint32_t version = trihedron_read(core, TRIHEDRON_VERSION);
  if (field(version, TRIHEDRON_VERSION_MAJOR_MASK, TRIHEDRON_VERSION_MAJOR_LSB) != TRIHEDRON_MAJOR) {
    return -1;
  }
  const uint32_t limits = trihedron_read(core, TRIHEDRON_LIMITS);
  core->views = field(limits, TRIHEDRON_LIMITS_VIEWS_MASK, TRIHEDRON_LIMITS_VIEWS_LSB);
  core->max_width = field(limits, TRIHEDRON_LIMITS_MAX_WIDTH_MASK, TRIHEDRON_LIMITS_MAX_WIDTH_LSB);
  core->max_height = field(limits, TRIHEDRON_LIMITS_MAX_HEIGHT_MASK, TRIHEDRON_LIMITS_MAX_HEIGHT_LSB);
  return 0;
}

void trihedron_start(const struct trihedron_core *core, uint32_t lines, uint32_t vertex_limit) {
  /* No frame begins while it is set up; one under way comes out whole, with the settings it began with. */
  trihedron_write(core, TRIHEDRON_CONTROL, 0);
  trihedron_write(core, TRIHEDRON_FRAME_HEIGHT, lines);
  trihedron_write(core, TRIHEDRON_VERTEX_LIMIT, vertex_limit);
  for (unsigned view = 0; view < core->views; ++view) {
    const uint32_t status = TRIHEDRON_VIEW(TRIHEDRON_STATUS, view);
    trihedron_write(core, status, trihedron_read(core, status)); /* clear what is set */
  }
  trihedron_write(core, TRIHEDRON_CONTROL, TRIHEDRON_CONTROL_ENABLE_MASK);
}

void trihedron_set_thresholds(const struct trihedron_core *core, const struct trihedron_thresholds *to) {
  const uint32_t control = trihedron_read(core, TRIHEDRON_CONTROL);
  /* A frame that starts in between keeps the old ones, all of them. */
  trihedron_write(core, TRIHEDRON_CONTROL, control | TRIHEDRON_CONTROL_HOLD_MASK);
  trihedron_write(core, TRIHEDRON_NOISE_FLOOR, to->noise_floor);
  trihedron_write(core, TRIHEDRON_MEAN_LIMIT, to->mean_limit);
  trihedron_write(core, TRIHEDRON_SUPPORT, to->support);
  trihedron_write(core, TRIHEDRON_BRANCH_FLOOR, to->branch_floor);
  trihedron_write(core, TRIHEDRON_MIN_TURN, to->min_turn);
  trihedron_write(core, TRIHEDRON_CONTROL, control & ~TRIHEDRON_CONTROL_HOLD_MASK);
}

struct trihedron_counts trihedron_counts(const struct trihedron_core *core, unsigned view) {
  struct trihedron_counts counts;
  uint32_t frames;
  do { /* counts of one and the same frame */
    frames = trihedron_read(core, TRIHEDRON_VIEW(TRIHEDRON_FRAMES, view));
    counts.last_frame = trihedron_read(core, TRIHEDRON_VIEW(TRIHEDRON_LAST_FRAME, view));
    counts.frames = trihedron_read(core, TRIHEDRON_VIEW(TRIHEDRON_FRAMES, view));
  } while (counts.frames != frames);
  return counts;
}

uint32_t trihedron_take_status(const struct trihedron_core *core, unsigned view) {
  const uint32_t address = TRIHEDRON_VIEW(TRIHEDRON_STATUS, view);
  const uint32_t seen = trihedron_read(core, address);
  if (seen != 0) trihedron_write(core, address, seen); /* only what was seen: a new event stays */
  return seen;
}
