// SPDX-License-Identifier: Apache-2.0
// The page of an evaluation: figures per set, a line per scene, a way to those shown in full.
'use strict';

/// Whether a scene came out as its truth says: right, wrong (false or missing results), unknown.
function verdictOf(line) {
  if (!line.truth) return line.found.length ? 'unknown' : 'empty';
  return line.truth.wrong || line.truth.objects.some((object) => object.known && !object.right) ? 'failed' : 'right';
}

const kVerdicts = {right: '\u2713 right', failed: '\u2717 not right', unknown: '? no truth',
  empty: '\u2205 nothing found'};

const verdictMark = (verdict) => element('span', {class: `verdict ${verdict}`}, kVerdicts[verdict]);

const median = (values) => {
  const sorted = [...values].sort((a, b) => a - b), half = sorted.length >> 1;
  return sorted.length % 2 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
};

function setRow(name, list) {
  const all = list.flatMap((line) => (line.truth ? line.truth.objects : []));
  const objects = all.filter((object) => object.known);
  const right = objects.filter((object) => object.right);
  const wrong = list.reduce((sum, line) => sum + (line.truth ? line.truth.wrong : 0), 0);
  const time = list.reduce((sum, line) => sum + line.milliseconds, 0) / list.length;
  return [name, grouped(list.length), grouped(objects.length) +
      (all.length > objects.length ? ` + ${all.length - objects.length} unknown` : ''), grouped(right.length),
    objects.length ? `${fixed(100 * right.length / objects.length, 1)} %` : '-',
    objects.length ? bar(right.length / objects.length) : '',
    all.length ? grouped(wrong) : '-',
    right.length ? fixed(median(right.map((object) => object.vertex_mm)), 3) : '-', fixed(time, 1)];
}

/// The first view in small, the models drawn in.
const thumbnail = ({width, height, picture, objects}) => drawing('svg',
  {class: 'thumbnail', viewBox: `0 0 ${width} ${height}`, 'aria-hidden': 'true'},
  drawing('image', {href: picture, width, height}),
  drawing('g', {transform: 'translate(0.5 0.5)'}, ...objects.map((edges, i) => drawing('path',
    {stroke: colourOf(i), d: edges.map((edge) => pathOf(edge.line)).join('')}))));

function sceneRow(line) {
  const verdict = verdictOf(line);
  const missed = line.truth ? line.truth.objects.filter((object) => object.known && !object.right)
    : [];
  const found = line.found.join(', ') || 'nothing';
  return {attributes: {'data-verdict': verdict, 'data-full': String(line.full >= 0)},
    cells: [thumbnail(line.thumbnail), line.scene,
      line.kind || '-', verdictMark(verdict), found, missed.map((object) => object.name).join(', '),
      line.truth ? String(line.truth.wrong) : '-', fixed(line.milliseconds, 1),
      line.full < 0 ? '' : element('button', {type: 'button', class: 'open', onclick: () => {
        showScene(line.full);
        byId('scene').scrollIntoView();
      }}, 'Open')]};
}

function filterBox(rows) {
  const choices = {all: 'all scenes', failed: 'not right', full: 'shown in full'};
  const select = element('select', {id: 'filter', onchange: () => {
    for (const row of rows.querySelectorAll('tbody tr')) {
      row.hidden = select.value === 'failed' ? row.dataset.verdict !== 'failed'
        : select.value === 'full' ? row.dataset.full !== 'true' : false;
    }
  }}, ...Object.entries(choices).map(([value, text]) => element('option', {value}, text)));
  return element('p', {class: 'options'}, element('label', {for: 'filter'}, 'Show '), select);
}

function buildOverview(overview) {
  const {lines, note} = overview;
  const kinds = [...new Set(lines.map((line) => line.kind))];
  const number = (head) => ({head, number: true});
  const sets = kinds.map((kind) => setRow(kind || 'scenes', lines.filter((l) => l.kind === kind)));
  if (kinds.length > 1) sets.push(setRow('all', lines));
  byId('overview-sets').replaceChildren(
    element('p', {class: 'caption'}, 'Right: the right model, every vertex within 20 % of the ' +
      'object\u2019s diameter of its true place. Wrong: results that match no true object. ' +
      'Unknown: objects that are not in the library and must not be reported. The error is that ' +
      'of the right ones, the time that of the software per scene.'),
    table([{head: 'Set'}, number('Scenes'), number('Objects'), number('Right'), number('Share'),
      {head: ''}, number('Wrong'), number('Median error mm'), number('ms')], sets));
  const rows = table([{head: 'First view'}, {head: 'Scene'}, {head: 'Set'}, {head: 'Verdict'},
    {head: 'Found'}, {head: 'Missed'}, number('Wrong'), number('ms'), {head: 'In full'}],
  lines.map(sceneRow), {class: 'scenes'});
  byId('overview-scenes').replaceChildren(element('p', {class: 'caption'}, note), filterBox(rows),
    rows);
  byId('overview').hidden = false;
}
