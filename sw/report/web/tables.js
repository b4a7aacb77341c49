// SPDX-License-Identifier: Apache-2.0
// What was found, what was not accepted and why, surfaces, time per stage.
'use strict';

const pose = (object) => object.world_from_model;

function matrix(values, columns, digits) {
  const rows = [];
  for (let i = 0; i < values.length; i += columns)
    rows.push(values.slice(i, i + columns).map((v) => digits < 0 ? v.toExponential(2)
      : v.toFixed(digits)).join('  '));
  return element('pre', {class: 'matrix'}, rows.join('\n'));
}

/// Which surfaces of a model were seen, view by view.
function seenSurfaces(scene, object) {
  return scene.views.map((view, v) => {
    const list = object.surfaces.filter((match) => match.view === v).map((m) => m.model_surface);
    return `${view.name}: ${list.length ? list.join(', ') : 'none'}`;
  }).join('; ');
}

/// Root mean square and count of an object's measured residuals, per view.
function residualText(scene, index) {
  return scene.views.map((view) => {
    const all = view.objects[index].residuals;
    const measured = all.filter((sample) => sample.length > 2);
    const square = measured.reduce((sum, s) => sum + s[2] * s[2] + s[3] * s[3], 0);
    const rms = measured.length ? Math.sqrt(square / measured.length).toFixed(2) : '-';
    return `${view.name}: ${measured.length} of ${all.length} points measured, ${rms} px rms`;
  }).join('; ');
}

function objectDetails(scene, object, index) {
  const {R, t_mm: t} = pose(object);
  const rows = [0, 1, 2].flatMap((r) => [...R.slice(3 * r, 3 * r + 3), t[r]]);
  return element('details', {}, element('summary', {}, swatch(index), ` ${object.name}: pose, ` +
    'covariance, surfaces seen, residuals'),
  element('div', {class: 'pair'},
    element('div', {}, element('h4', {}, 'World from model: rotation and translation (mm)'),
      matrix(rows, 4, 4)),
    element('div', {}, element('h4', {}, 'Covariance of rotation vector (rad) and position (mm)'),
      matrix(object.covariance, 6, -1))),
  element('p', {}, `Surfaces seen. ${seenSurfaces(scene, object)}.`),
  element('p', {}, `Edges. ${residualText(scene, index)}.`));
}

function objectRow(scene, object, index) {
  const {R, t_mm: t} = pose(object);
  const turn = rotationVector(R);
  const seen = new Set(object.surfaces.map((match) => match.model_surface)).size;
  const all = new Set(scene.space.models[index].surfaces).size;
  const degrees = 180 / Math.PI;
  const known = object.covariance.some((value) => value !== 0);
  return [element('span', {class: 'named'}, swatch(index), ` ${object.name}`),
    fixed(object.score, 3), ...t.map((v) => fixed(v, 2)), ...turn.map((v) => fixed(v, 1)),
    known ? fixed(largestSigma(object.covariance, 3), 3) : '-',
    known ? fixed(degrees * largestSigma(object.covariance, 0), 2) : '-',
    fixed(object.reprojection_rms_px, 2), `${seen} of ${all}`,
    ...(scene.truth ? [fixed(object.truth_error_mm, 3)] : []),
    object.runner_up ? `${object.runner_up.name} (${fixed(object.runner_up.score, 3)})` : 'none'];
}

function buildObjects(scene) {
  const number = (head, title) => ({head, number: true, title});
  const columns = [{head: 'Object'}, number('Score', 'From 0 to 1'),
    number('x mm', 'Position in the world frame'), number('y mm'), number('z mm'),
    number('rx \u00b0', 'Rotation vector'), number('ry \u00b0'), number('rz \u00b0'),
    number('\u03c3 mm', 'Standard deviation of the position in its worst direction'),
    number('\u03c3 \u00b0', 'Standard deviation of the rotation about its worst axis'),
    number('rms px', 'Between predicted and measured edges'), number('Seen', 'Surfaces that a view shows, of all'),
    ...(scene.truth ? [number('Error mm', 'Mean distance of the vertices from the truth')] : []),
    {head: 'Next best', title: 'The model that fits here second best'}];
  const caption = scene.objects.length
    ? 'Position and rotation of each model in the world frame, whose z = 0 is the table top, with ' +
      'the standard deviations that its measured edges leave. The score ' +
      (scene.method === 'full' ? 'is the share of its visible edges that the views confirm.'
        : 'grows with the number of surfaces that were found.')
    : 'No model of the library explains what the views show, so nothing is reported.';
  section('objects', 'Objects', caption, ...(scene.objects.length
    ? [table(columns, scene.objects.map((object, i) => objectRow(scene, object, i))),
      ...scene.objects.map((object, i) => objectDetails(scene, object, i))] : []),
  ...missedObjects(scene));
}

/// True objects that were not found, where the truth is known.
function missedObjects(scene) {
  if (!scene.truth) return [];
  const missed = scene.truth.objects.filter((object) => object.known && !object.right);
  if (!missed.length) return [];
  return [element('p', {class: 'notice'},
    `In the scene but not found: ${missed.map((object) => object.name).join(', ')}.`)];
}

function buildRejections(scene) {
  const kFirst = 10;
  let pinned = null;
  const row = (rejection, i) => {
    const button = element('button', {type: 'button', 'aria-pressed': 'false', onclick: () => {
      byId('rejections').querySelectorAll('button[aria-pressed]').forEach((other) =>
        other.setAttribute('aria-pressed', 'false'));
      pinned = pinned === i ? null : i;
      button.setAttribute('aria-pressed', pinned === i);
      showRejected(pinned === i ? rejection.views : null);
    }}, 'Show');
    return {attributes: i < kFirst ? {} : {class: 'more', hidden: true},
      cells: [rejection.name, fixed(rejection.score, 3), rejection.reason, button]};
  };
  showRejected(null);
  if (!scene.rejections.length) {
    section('rejections', 'Rejected hypotheses', 'No other placement of a model came close enough ' +
      'to be looked at.');
    return;
  }
  const all = scene.rejections.length;
  const box = table([{head: 'Model'}, {head: 'Score', number: true}, {head: 'Why not'},
    {head: 'In the views'}], scene.rejections.map(row));
  const more = element('button', {type: 'button', class: 'more-button', onclick: () => {
    box.querySelectorAll('tr.more').forEach((line) => { line.hidden = false; });
    more.remove();
  }}, `Show all ${all}`);
  section('rejections', `Rejected hypotheses (${all})`,
    'Placements of models that were fitted to the views and then turned down, with the reason. ' +
    '"Show" draws one into the views above as a dashed line.', box, ...(all > kFirst ? [more] : []));
}

/// Per surface of a placed model: area, unit normal outwards and centre, from its triangles.
function faces(model) {
  const point = (t, k) => model.vertices.slice(3 * model.triangles[3 * t + k],
    3 * model.triangles[3 * t + k] + 3);
  const list = [];
  model.surfaces.forEach((surface, t) => {
    const [a, b, c] = [0, 1, 2].map((k) => point(t, k));
    const [u, v] = [b, c].map((p) => p.map((x, i) => x - a[i]));
    const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
      u[0] * v[1] - u[1] * v[0]].map((x) => x / 2);
    const area = Math.hypot(...normal);
    const face = list[surface] = list[surface] || {area: 0, normal: [0, 0, 0], centre: [0, 0, 0]};
    face.area += area;
    for (let i = 0; i < 3; ++i) {
      face.normal[i] += normal[i];
      face.centre[i] += area * (a[i] + b[i] + c[i]) / 3;
    }
  });
  return list.map(({area, normal, centre}) => ({area, normal: normal.map((x) => x / area),
    centre: centre.map((x) => x / area)}));
}

const triple = (x, digits) => x.map((v) => fixed(v, digits)).join('  ');

/// The surfaces of the recognised objects that a view shows.
function seenTable(scene) {
  const number = (head) => ({head, number: true});
  const rows = scene.objects.flatMap((object, o) => faces(scene.space.models[o]).flatMap(
    (face, s) => {
      const views = [...new Set(object.surfaces.filter((m) => m.model_surface === s)
        .map((m) => scene.views[m.view].name))];
      return views.length ? [[element('span', {class: 'named'}, swatch(o), ` ${object.name}`),
        String(s), views.join(', '), fixed(face.area, 1), triple(face.normal, 3),
        triple(face.centre, 1)]] : [];
    }));
  return table([{head: 'Object'}, number('Surface'), {head: 'Seen from'}, number('Area mm\u00b2'),
    number('Normal'), number('Centre mm')], rows, {class: 'seen'});
}

/// Surfaces that were put together before any model was tried.
function crossedTable(scene) {
  const number = (head) => ({head, number: true});
  const rows = scene.surfaces.map((surface, i) => [String(i), scene.views[surface.view].name,
    String(surface.vertices_mm.length), surface.complete ? 'yes' : 'no',
    fixed(surface.area_mm2, 1), fixed(surface.perimeter_mm, 1),
    triple(surface.normal, 3), triple(surface.centroid_mm, 1),
    scene.objects.flatMap((object, o) => object.surfaces.filter((m) => m.scene_surface === i)
      .map((m) => `${object.name}, surface ${m.model_surface}`)).join('; ') || '-']);
  return table([number('No.'), {head: 'From view'}, number('Corners'), {head: 'Every corner found'},
    number('Area mm\u00b2'), number('Perimeter mm'), number('Normal'), number('Centre mm'),
    {head: 'Taken for'}], rows);
}

function buildSurfaces(scene) {
  const parts = [];
  if (scene.objects.length) parts.push(element('p', {class: 'caption'},
    'Faces of the recognised objects, where they lie in the world, and the views that show them.'),
  seenTable(scene));
  if (scene.surfaces.length) parts.push(element('h3', {}, 'Reconstructed'), element('p',
    {class: 'caption'}, 'Faces put together from regions of one view and the corners that other ' +
    'views agree on, before any model was tried.'), crossedTable(scene));
  if (!parts.length) byId('surfaces').replaceChildren();
  else byId('surfaces').replaceChildren(element('h2', {id: 'surfaces-head'}, 'Surfaces'), ...parts);
}

/// One sentence for each stage of either method, by its name in the statistics.
const kStageNotes = {
  segments: 'straight lines fitted to the contours of all views',
  crossing: 'edges in space on which two or three views agree',
  hypotheses: 'models at places where they explain part of what was seen',
  poses: 'objects left after refinement and verification',
  regions: 'areas closed off by contours, all views',
  surfaces: 'faces put together in space',
};

function buildTimes(scene) {
  const total = scene.stages.reduce((sum, stage) => sum + stage.seconds, 0);
  const rows = scene.stages.map((stage) => [stage.stage, grouped(stage.count),
    kStageNotes[stage.stage] || '', fixed(1e3 * stage.seconds, 2),
    bar(total ? stage.seconds / total : 0)]);
  rows.push([element('strong', {}, 'software'), '', 'all stages, one processor core',
    element('strong', {}, fixed(1e3 * total, 2)), '']);
  section('times', 'Software: counts and time', 'What each stage of the software produced and the ' +
    'time it took on the machine that wrote this page.', table([{head: 'Stage'},
    {head: 'Count', number: true}, {head: 'What is counted'}, {head: 'ms', number: true},
    {head: 'Share'}], rows));
}
