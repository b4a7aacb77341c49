// SPDX-License-Identifier: Apache-2.0
// Puts the page together: one scene, or an overview and the scene chosen in it.
'use strict';

function verdictText(scene) {
  const count = scene.objects.length;
  const names = scene.objects.flatMap((object, i) =>
    [i ? ', ' : '', swatch(i), ` ${object.name}`]);
  return count === 0 ? [element('strong', {}, 'No object of the library was found.')]
    : [element('strong', {}, `${plural(count, 'object', 'objects')} found: `), ...names];
}

function truthText(scene) {
  if (!scene.truth) return 'The truth is not known.';
  const known = scene.truth.objects.filter((object) => object.known);
  const unknown = scene.truth.objects.length - known.length;
  const right = known.filter((object) => object.right).length;
  return `Held against the truth: ${right} of ${known.length} right, ${scene.truth.wrong} wrong.` +
    (unknown ? ` ${plural(unknown, 'object is', 'objects are')} not in the library.` : '');
}

function buildSummary(scene) {
  const vertices = scene.views.reduce((sum, view) => sum + view.vertices.length, 0);
  const contour = scene.views.reduce((sum, view) => sum + view.contour_px, 0);
  const pixels = scene.views.reduce((sum, view) => sum + view.width * view.height, 0);
  const time = 1e3 * scene.stages.reduce((sum, stage) => sum + stage.seconds, 0);
  const source = {rtl: 'the simulated hardware', golden: 'the golden model, which equals the ' +
    'hardware bit for bit'}[scene.front_end];
  byId('summary').replaceChildren(
    ...(data.overview ? [element('h2', {}, `Scene ${scene.scene}`)] : []),
    element('p', {class: 'result'}, ...verdictText(scene)),
    element('p', {class: 'caption'}, `Scene ${scene.scene}, ${plural(scene.views.length, 'view',
      'views')}; features from ${source}; method ${scene.method}; library of ` +
      `${plural(scene.library, 'model', 'models')}. ${truthText(scene)}`),
    cards(card(grouped(pixels), 'pixels went in'), card(grouped(contour), 'lie on the contour',
      `${fixed(100 * contour / pixels, 1)} % of the pixels`),
    card(grouped(vertices), 'vertices'), card(String(scene.objects.length), 'objects came out'),
    card(`${fixed(time, 1)} ms`, 'of software')));
}

function showScene(index) {
  const scene = data.scenes[index];
  buildSummary(scene);
  buildViews(scene);
  buildObjects(scene);
  buildRejections(scene);
  buildSurfaces(scene);
  buildHardware(scene);
  buildTimes(scene);
  buildSpace(scene);
  showStage(kStages.findIndex((stage) => stage.name === 'Models'));
}

function setTheme(dark) {
  document.documentElement.dataset.theme = dark ? 'dark' : 'light';
  byId('theme').setAttribute('aria-pressed', dark);
}

function listen() {
  setTheme(window.matchMedia('(prefers-color-scheme: dark)').matches);
  byId('theme').addEventListener('click', () =>
    setTheme(document.documentElement.dataset.theme !== 'dark'));
  byId('print').addEventListener('click', () => window.print());
  window.addEventListener('beforeprint', () => { if (figures.length) buildSheet(); });
  window.addEventListener('afterprint', () => byId('sheet').replaceChildren());
  window.addEventListener('resize', () => figures.forEach((figure) => figure.update()));
  document.addEventListener('keydown', (event) => {
    if (event.target.matches('input, select') || event.ctrlKey || event.altKey || event.metaKey)
      return;
    const stage = Number(event.key) - 1;
    if (figures.length && kStages[stage]) showStage(stage);
  });
}

listen();
byId('program').textContent = `Written by ${data.program}. This page is one file and needs no network.`;
if (data.overview) buildOverview(data.overview);
if (data.scenes.length) showScene(0);
else byId('scene').hidden = true;
document.documentElement.dataset.ready = 'true';
