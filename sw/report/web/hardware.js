// SPDX-License-Identifier: Apache-2.0
// The hardware's side: what the simulation of the RTL counted, and what that means at a clock rate.
'use strict';

const kDefaultMhz = 100;

/// Clocks from a view's first pixel to its last: one each where the input never waits.
const frameClocks = (view) => view.pixels + view.input_stalls + view.input_idles;

function atClock(scene, megahertz) {
  const {views} = scene.hardware;
  const slowest = Math.max(...views.map(frameClocks));
  const latency = Math.max(...views.map((view) => view.latency_clocks));
  return cards(
    card(`${fixed(1e6 * megahertz / slowest, 0)}`, 'frames per second',
      'frames back to back, all views at once'),
    card(`${fixed(megahertz * Math.min(...views.map((v) => v.pixels / frameClocks(v))), 1)}`,
      'million pixels per second and view'),
    card(`${fixed(latency / megahertz, 1)} \u00b5s`, 'latency to the contour stream',
      'first pixel in to its contour beat out'),
    card(`${fixed(slowest / megahertz / 1e3, 2)} ms`, 'to take one frame in'));
}

function buildHardware(scene) {
  if (!scene.hardware) {
    section('hardware', 'Hardware', `Clocks, stalls and latency: not available. The features of ` +
      `this page came from the ${scene.front_end} front end, which has no clock; "--frontend rtl" ` +
      'simulates the hardware and counts. The features themselves are the same, bit for bit.');
    return;
  }
  const {views, clocks} = scene.hardware;
  const rate = Math.min(...views.map((view) => view.pixels / frameClocks(view)));
  const sum = (name) => views.reduce((total, view) => total + view[name], 0);
  const lines = (view, v) => view.latency_clocks / scene.views[v].width;
  const box = element('div', {});
  const input = element('input', {type: 'number', id: 'clock', min: '1', max: '2000', step: '1',
    value: String(kDefaultMhz), oninput: () => {
      const value = Number(input.value);
      if (value > 0) box.replaceChildren(atClock(scene, value));
    }});
  box.append(atClock(scene, kDefaultMhz));
  const number = (head, title) => ({head, number: true, title});
  const columns = [{head: 'View'}, number('Pixels'), number('Input stalls',
    'Clocks with a pixel offered but not taken'), number('Input idles',
    'Clocks without a pixel offered'), number('Pixels per clock'), number('Contour beats'),
  number('Output stalls', 'Clocks with a beat offered but not taken'),
  number('Latency, clocks'), number('Latency, lines'), number('Vertices'), number('Lost'),
  number('Stream errors')];
  const rows = views.map((view, v) => [scene.views[v].name, grouped(view.pixels),
    grouped(view.input_stalls), grouped(view.input_idles), fixed(view.pixels / frameClocks(view), 3),
    grouped(view.contour_beats), grouped(view.contour_stalls), grouped(view.latency_clocks),
    fixed(lines(view, v), 2), grouped(view.vertices), grouped(view.vertices_lost),
    grouped(view.stream_errors)]);
  section('hardware', 'Hardware', 'Counted in the simulation of the RTL while it worked on these ' +
    'images: three view pipelines side by side, all from one clock.',
  cards(card(fixed(rate, 3), 'pixels per clock and view'),
    card(grouped(sum('input_stalls')), 'clocks that a pixel had to wait'),
    card(grouped(Math.max(...views.map((view) => view.latency_clocks))), 'clocks of latency',
      `${fixed(Math.max(...views.map(lines)), 2)} lines`),
    card(grouped(sum('vertices')), 'vertices', `${grouped(sum('vertices_lost'))} lost`),
    card(grouped(clocks), 'clocks in all', 'reset to last record')),
  table(columns, rows), element('p', {class: 'clock'}, element('label', {for: 'clock'},
    'At a clock of '), input, ' MHz (the rate that a device or a cell library allows is its own matter):'),
  box);
}
