// SPDX-License-Identifier: Apache-2.0
// Small figures in text: cards with a number, bars.
'use strict';

/// A number with what it is; `note` in small print.
const card = (value, what, note) => element('div', {class: 'card'},
  element('strong', {}, value), element('span', {}, what),
  ...(note ? [element('small', {}, note)] : []));

const cards = (...list) => element('div', {class: 'cards'}, ...list);

/// A bar as long as `share` (0 .. 1) of its box.
const bar = (share) => element('span', {class: 'bar', 'aria-hidden': 'true'},
  element('span', {style: `width:${(100 * Math.min(1, share)).toFixed(1)}%`}));

/// A rotation matrix (nine numbers, row major) as rotation vector in degrees.
function rotationVector(R) {
  const cosine = Math.max(-1, Math.min(1, (R[0] + R[4] + R[8] - 1) / 2));
  const angle = Math.acos(cosine);
  const degrees = 180 / Math.PI;
  if (Math.PI - angle < 1e-4) {  // half a turn: the axis is the eigenvector of (R + 1) / 2
    const columns = [0, 1, 2].map((c) => [0, 1, 2].map((r) => R[3 * r + c] + (r === c ? 1 : 0)));
    const axis = columns.reduce((a, b) => (Math.hypot(...b) > Math.hypot(...a) ? b : a));
    return axis.map((x) => angle * degrees * x / Math.hypot(...axis));
  }
  const scale = angle < 1e-9 ? 0.5 : angle / (2 * Math.sin(angle));
  return [R[7] - R[5], R[2] - R[6], R[3] - R[1]].map((x) => x * scale * degrees);
}

/// The largest standard deviation in any direction of a 3x3 block (from row and column `start`) of
/// a 6x6 covariance: the root of its largest eigenvalue, by power iteration.
function largestSigma(covariance, start) {
  const at = (r, c) => covariance[6 * (start + r) + start + c];
  let x = [1, 0.9, 0.8], size = 0;
  for (let i = 0; i < 60; ++i) {
    const y = [0, 1, 2].map((r) => at(r, 0) * x[0] + at(r, 1) * x[1] + at(r, 2) * x[2]);
    size = Math.hypot(...y);
    if (size === 0) return 0;
    x = y.map((v) => v / size);
  }
  return Math.sqrt(size);
}
