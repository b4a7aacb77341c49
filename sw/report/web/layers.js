// SPDX-License-Identifier: Apache-2.0
// The layers of a view and the steps that show them.
'use strict';

/// How much longer residuals are drawn than they are.
const kResidualScale = 10;

/// Ring positions 0 .. 15 of the 5x5 window's outer pixels, from the right towards below.
const kRing = [[2, 0], [2, 1], [2, 2], [1, 2], [0, 2], [-1, 2], [-2, 2], [-2, 1],
  [-2, 0], [-2, -1], [-2, -2], [-1, -2], [0, -2], [1, -2], [2, -2], [2, -1]];

const pathOf = (flat, close) => flat.reduce((text, value, i) => text +
  (i === 0 ? 'M' : i % 2 === 0 ? 'L' : ' ') + value, '') + (close ? 'Z' : '');

const picture = (view, name) => drawing('image',
  {href: view.pictures[name], width: view.width, height: view.height});

/// A vertex: a circle where a contour bends, a diamond where contours meet; strokes along the
/// branches that its pattern names. Drawn in screen px around the origin.
function vertexGlyph([x, y, branches, pattern, strength]) {
  const junction = branches >= 3;
  const strokes = [pattern >> 4, pattern & 15].map((position) => {
    const [dx, dy] = kRing[position];
    const length = 9 / Math.hypot(dx, dy);
    return `M0 0L${(dx * length).toFixed(1)} ${(dy * length).toFixed(1)}`;
  }).join('');
  const shape = junction ? 'M0-4.5L4.5 0L0 4.5L-4.5 0Z' : 'M-3.5 0a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0-7 0Z';
  return drawing('g', {transform: `translate(${x} ${y})`},
    drawing('g', {class: `glyph ${junction ? 'junction' : 'corner'}`},
      drawing('title', {}, `${junction ? `junction of ${branches} branches` : 'corner'} at ` +
        `(${x}, ${y}), pattern ${pattern >> 4}-${pattern & 15}, strength ${strength}`),
      drawing('path', {class: 'halo', d: strokes}), drawing('path', {class: 'stroke', d: strokes}),
      drawing('path', {class: 'shape', d: shape})));
}

function regionShape(boundaries, index) {
  const d = boundaries.map((boundary) => pathOf(boundary, true)).join('');
  return drawing('path', {class: 'region', d, style: `fill:${colourOf(index)}`, stroke: colourOf(index)},
    drawing('title', {}, `region ${index + 1}: ${boundaries[0].length / 2} corners` +
      (boundaries.length > 1 ? `, ${plural(boundaries.length - 1, 'hole', 'holes')}` : '')));
}

function modelShape(object, index) {
  const lines = (crease) => object.edges.filter((e) => e.crease === crease)
    .map((e) => pathOf(e.line)).join('');
  return drawing('g', {class: 'model', 'data-object': index},
    drawing('path', {class: 'halo', d: lines(false) + lines(true)}),
    drawing('path', {class: 'crease', d: lines(true), stroke: colourOf(index)}),
    drawing('path', {class: 'outline', d: lines(false), stroke: colourOf(index)}));
}

/// The objects' names at their middles; one that would lie on another moves below it. Sizes are
/// those of a view a third of the page wide.
function nameShapes(view) {
  const pxPerScreenPx = view.width / 420;
  const taken = [];
  return view.objects.map((object, i) => {
    const width = 7 * view.labels[i].length;
    const [x, top] = object.label.map((value) => value / pxPerScreenPx);
    let y = top;
    while (taken.some((other) => Math.abs(other.y - y) < 14 &&
      Math.abs(other.x - x) < (other.width + width) / 2)) y += 7;
    taken.push({x, y, width});
    return drawing('g', {transform: `translate(${x * pxPerScreenPx} ${y * pxPerScreenPx})`},
      drawing('text', {class: 'glyph label', y: 4}, view.labels[i]));
  });
}

/// 0: the prediction is right to a quarter of a pixel, 1: to a pixel, 2: worse.
const residualClass = (sample) => {
  const size = Math.hypot(sample[2], sample[3]);
  return size <= 0.25 ? 0 : size <= 1 ? 1 : 2;
};

function residualShape(object, index) {
  const paths = ['', '', ''];
  let unseen = '';
  for (const sample of object.residuals) {
    const [x, y, dx, dy] = sample;
    if (sample.length === 2) unseen += `M${x} ${y}h0.01`;
    else paths[residualClass(sample)] +=
      `M${x} ${y}h0.01M${x} ${y}l${(kResidualScale * dx).toFixed(2)} ${(kResidualScale * dy).toFixed(2)}`;
  }
  return drawing('g', {class: 'residuals', 'data-object': index},
    drawing('path', {class: 'predicted', d: object.edges.map((e) => pathOf(e.line)).join('')}),
    drawing('path', {class: 'unseen', d: unseen}),
    ...paths.map((d, i) => drawing('path', {class: `residual r${i}`, d})));
}

/// Every layer: how to draw it from a view, and its name in the mixer.
const kLayers = {
  image: {name: 'image', draw: (view) => [picture(view, 'image')]},
  gradient: {name: 'gradient magnitude', draw: (view) => [picture(view, 'gradient')]},
  first_contour: {name: 'first contour', draw: (view) => [picture(view, 'first_contour')]},
  second_contour: {name: 'second contour', draw: (view) => [picture(view, 'second_contour')]},
  regions: {name: 'regions', draw: (view) => view.regions.map(regionShape)},
  segments: {name: 'straight lines', draw: (view) => [drawing('path', {class: 'segment',
    d: view.segments.map((s) => pathOf(s)).join('')}), drawing('path', {class: 'ends',
    d: view.segments.map(([a, b, c, d]) => `M${a} ${b}h0.01M${c} ${d}h0.01`).join('')})]},
  vertices: {name: 'vertices', draw: (view) => view.vertices.map(vertexGlyph)},
  models: {name: 'recognised models',
    draw: (view) => view.objects.map(modelShape)},
  names: {name: 'their names', draw: nameShapes},
  residuals: {name: 'residuals', draw: (view) => view.objects.map(residualShape)},
};

const mark = (kind, text) => element('span', {class: 'legend'},
  element('span', {class: `mark ${kind}`, 'aria-hidden': 'true'}), text);

/// The steps of the flow. `side`: which side of the hardware's ports; `dim`: darkens the image.
const kStages = [
  {name: 'Pixels', side: 'hardware', layers: ['image'],
    text: 'What the cameras deliver: one grey value per pixel. The pixels stream into the hardware ' +
      'row by row, one per clock; no stage keeps more than a few rows.'},
  {name: 'Gradient', side: 'hardware', layers: ['gradient'],
    text: 'How steeply the grey level changes around each pixel, from its 5 \u00d7 5 neighbours. ' +
      'Bright means steep: an edge of an object, but also the border of a shadow, or grain.'},
  {name: 'First contour', side: 'hardware', layers: ['image', 'first_contour'], dim: true,
    legend: () => [mark('first', 'first contour')],
    text: 'Pixels that lie on the crest of the gradient and continue as a path. Lines may still be ' +
      'several pixels wide.'},
  {name: 'Second contour', side: 'hardware', layers: ['image', 'second_contour'], dim: true,
    legend: () => [mark('second', 'second contour')],
    text: 'The first contour thinned to lines one pixel wide. It leaves the hardware as one beat ' +
      'per pixel, with the gradient.'},
  {name: 'Vertices', side: 'hardware', layers: ['image', 'second_contour', 'vertices'], dim: true,
    legend: () => [mark('corner', 'corner: the contour bends'),
      mark('junction', 'junction: contours meet'), mark('second', 'second contour')],
    text: 'Where the contour bends or branches, found by 5 \u00d7 5 patterns; the strokes show where ' +
      'the branches leave. With this list the hardware is done: from here on software sees the ' +
      'contour stream and the vertices, never the image.'},
  {name: 'Straight lines', side: 'software', layers: ['image', 'segments'], dim: true,
    legend: () => [mark('segment', 'fitted line and its ends')],
    text: 'Straight lines fitted to the contour and its gradient, to a fraction of a pixel. Lines ' +
      'of two views that meet in space make the edges of the drawing in space below.'},
  {name: 'Regions', side: 'software', layers: ['image', 'regions'], dim: true,
    legend: () => [mark('region', 'closed region, colours only tell neighbours apart')],
    text: 'Areas that the contour closes off on all sides: each may be a face of an object, or a ' +
      'shadow. The background, which reaches the border, is none.'},
  {name: 'Models', side: 'software', layers: ['image', 'models', 'names'],
    legend: () => [mark('outline', 'outline'), mark('crease', 'edge inside the outline')],
    text: 'The recognised models drawn back into each view, without the lines that they or other ' +
      'objects hide. Nothing in this drawing comes from the image.'},
  {name: 'Residuals', side: 'software', layers: ['image', 'residuals'], dim: true,
    legend: () => [mark('r0', 'up to 0.25 px'), mark('r1', 'up to 1 px'), mark('r2', 'more'),
      mark('predicted', 'predicted edge'), mark('unseen', 'no edge measured there')],
    text: `How far the measured edges lie from the predicted ones, drawn ${kResidualScale} times as ` +
      'long. Along a dotted stretch the gradient shows no edge: too little contrast.'},
];
