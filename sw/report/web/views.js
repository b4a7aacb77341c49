// SPDX-License-Identifier: Apache-2.0
// The three views: layers, zoom, the bar of steps, the mixer.
'use strict';

const kMaxZoom = 40;

/// A view that zooms: the drawing's viewBox moves over the picture. Positions are px of the image.
class Figure {
  constructor(view, index) {
    this.view = view;
    this.box = [-0.5, -0.5, view.width, view.height];  // pixel centres have whole coordinates
    this.svg = drawing('svg', {class: 'view', tabindex: 0, role: 'img', 'aria-label':
      `View ${view.name}`, viewBox: this.box.join(' '), preserveAspectRatio: 'xMidYMid meet'});
    for (const [name, layer] of Object.entries(kLayers)) {
      const shift = view.pictures[name] ? {transform: 'translate(-0.5 -0.5)'} : {};
      this.svg.append(drawing('g', {class: 'layer', 'data-layer': name},
        drawing('g', {id: `v${index}-${name}`, ...shift}, ...layer.draw(view))));
    }
    this.rejected = drawing('path', {class: 'rejected'});
    this.svg.append(this.rejected);
    this.node = this.frame();
    this.listen();
  }

  frame() {
    const button = (label, what, act) => element('button', {type: 'button', title: what,
      'aria-label': `${what}: ${this.view.name}`, onclick: act}, label);
    const {vertices, contour_px: contour, vertices_lost: lost} = this.view;
    return element('figure', {}, element('figcaption', {},
      element('span', {}, element('strong', {}, this.view.name),
        `: ${grouped(contour)} contour px, ${plural(vertices.length, 'vertex', 'vertices')}` +
        (lost ? `, ${lost} lost` : '')),
      element('span', {class: 'zoom'},
        button('\u2212', 'Zoom out', () => this.zoom(1 / 1.5)),
        button('+', 'Zoom in', () => this.zoom(1.5)),
        button('1:1', 'Whole picture', () => this.reset()),
        button('\u2922', 'Wide or narrow', () => this.widen()))), this.svg);
  }

  get scale() { return this.view.width / this.box[2]; }

  /// Px of the image per px of the screen: glyphs keep their size on the screen.
  update() {
    this.svg.setAttribute('viewBox', this.box.map((v) => v.toFixed(3)).join(' '));
    const width = this.svg.clientWidth || this.view.width;
    this.svg.style.setProperty('--unit', this.box[2] / width);
  }

  /// Zooms by `factor` about a point of the image, its middle without one.
  zoom(factor, at) {
    const [x, y, width, height] = this.box;
    const [cx, cy] = at || [x + width / 2, y + height / 2];
    const scale = Math.max(1, Math.min(kMaxZoom, this.scale * factor));
    const next = this.view.width / scale, ratio = next / width;
    this.box = [cx - (cx - x) * ratio, cy - (cy - y) * ratio, next, height * ratio];
    this.move(0, 0);
  }

  move(dx, dy) {
    const clamp = (value, size, whole) => Math.max(-0.5, Math.min(whole - 0.5 - size, value));
    this.box[0] = clamp(this.box[0] + dx, this.box[2], this.view.width);
    this.box[1] = clamp(this.box[1] + dy, this.box[3], this.view.height);
    this.update();
  }

  reset() {
    this.box = [-0.5, -0.5, this.view.width, this.view.height];
    this.update();
  }

  widen() {
    this.node.classList.toggle('wide');
    figures.forEach((figure) => figure.update());
  }

  pointAt(event) {
    const place = this.svg.getBoundingClientRect();
    return [this.box[0] + (event.clientX - place.left) / place.width * this.box[2],
      this.box[1] + (event.clientY - place.top) / place.height * this.box[3]];
  }

  listen() {
    this.svg.addEventListener('wheel', (event) => {
      // The page scrolls past a view that nobody has taken hold of.
      if (!event.ctrlKey && document.activeElement !== this.svg) return;
      event.preventDefault();
      this.zoom(Math.exp(-event.deltaY / 300), this.pointAt(event));
    }, {passive: false});
    this.svg.addEventListener('pointerdown', () => this.svg.focus({preventScroll: true}));
    this.svg.addEventListener('pointermove', (event) => {
      if (event.buttons !== 1) return;
      const unit = this.box[2] / this.svg.clientWidth;
      this.move(-event.movementX * unit, -event.movementY * unit);
    });
    this.svg.addEventListener('dblclick', (event) => this.zoom(2, this.pointAt(event)));
    this.svg.addEventListener('keydown', (event) => {
      const step = this.box[2] / 10;
      const act = {'+': () => this.zoom(1.5), '=': () => this.zoom(1.5), '-': () => this.zoom(1 / 1.5),
        '0': () => this.reset(), ArrowLeft: () => this.move(-step, 0),
        ArrowRight: () => this.move(step, 0), ArrowUp: () => this.move(0, -step),
        ArrowDown: () => this.move(0, step)}[event.key];
      if (!act) return;
      event.preventDefault();
      event.stopPropagation();
      act();
    });
  }
}

let figures = [];
const shown = {layers: new Set(), dim: false, stage: 0};

function showLayers() {
  for (const figure of figures) {
    figure.svg.classList.toggle('dim', shown.dim);
    for (const layer of figure.svg.querySelectorAll('.layer'))
      layer.classList.toggle('off', !shown.layers.has(layer.dataset.layer));
  }
  for (const box of document.querySelectorAll('#mixer input'))
    box.checked = box.name === 'dim' ? shown.dim : shown.layers.has(box.name);
}

function showStage(index) {
  shown.stage = index;
  const stage = kStages[index];
  shown.layers = new Set(stage.layers);
  shown.dim = stage.dim === true;
  byId('stages').querySelectorAll('[role=tab]').forEach((tab, i) => {
    tab.setAttribute('aria-selected', i === index);
    tab.tabIndex = i === index ? 0 : -1;
  });
  byId('stage-text').replaceChildren(
    element('p', {class: 'caption'}, element('strong', {}, `${stage.name}. `), stage.text),
    element('p', {class: 'legends'}, ...(stage.legend ? stage.legend() : [])));
  showLayers();
}

function stageTab(stage, index) {
  return element('button', {type: 'button', role: 'tab', 'aria-controls': 'stage-text',
    title: `Key ${index + 1}`, onclick: () => showStage(index)}, stage.name);
}

function buildStages() {
  const tabs = kStages.map(stageTab);
  const group = (side, note) => element('div', {class: `side ${side}`, role: 'presentation'},
    element('span', {class: 'side-name'}, note),
    element('div', {class: 'tabs', role: 'presentation'},
      ...tabs.filter((_, i) => kStages[i].side === side)));
  byId('stages').replaceChildren(group('hardware', 'hardware'),
    group('software', 'software: sees the contour and vertex streams only'));
  byId('stages').onkeydown = (event) => {
    const step = {ArrowRight: 1, ArrowLeft: -1}[event.key];
    if (!step) return;
    const next = (shown.stage + step + kStages.length) % kStages.length;
    showStage(next);
    tabs[next].focus();
  };
}

function buildMixer() {
  const box = (name, text, change) => element('label', {}, element('input',
    {type: 'checkbox', name, onchange: change}), ` ${text}`);
  const layers = Object.entries(kLayers).map(([name, layer]) => box(name, layer.name, (event) => {
    if (event.target.checked) shown.layers.add(name);
    else shown.layers.delete(name);
    showLayers();
  }));
  const dim = box('dim', 'darken the image', (event) => {
    shown.dim = event.target.checked;
    showLayers();
  });
  byId('mixer').replaceChildren(element('summary', {}, 'Mix layers, keys and mouse'),
    element('div', {class: 'options'}, ...layers, dim), element('p', {class: 'caption'},
      'Keys 1 to 9 choose a step. In a view: double click or + and - zoom, drag or arrow keys ' +
      'move, 0 shows all; the wheel zooms once the view has been clicked, or with Ctrl. Resting on ' +
      'a vertex or a region tells what it is.'));
}

function buildViews(scene) {
  scene.views.forEach((view) => { view.labels = scene.objects.map((object) => object.name); });
  figures = scene.views.map((view, i) => new Figure(view, i));
  byId('figures').replaceChildren(...figures.map((figure) => figure.node));
  buildStages();
  buildMixer();
  figures.forEach((figure) => figure.update());
}

/// Draws where a rejected hypothesis would stand; nothing for null.
function showRejected(edgesPerView) {
  figures.forEach((figure, i) => figure.rejected.setAttribute('d',
    edgesPerView ? edgesPerView[i].map((edge) => pathOf(edge.line)).join('') : ''));
}

/// All steps of all views for the printed page; made of references to the figures' layers.
function buildSheet() {
  const rows = kStages.map((stage) => element('div', {class: 'sheet-row'},
    element('p', {}, element('strong', {}, `${stage.name} `), `(${stage.side}). `, stage.text,
      ' ', ...(stage.legend ? stage.legend() : [])),
    element('div', {class: 'sheet-views'}, ...figures.map((figure, v) => drawing('svg',
      {class: `view${stage.dim ? ' dim' : ''}`, style: `--unit:${figure.view.width / 230}`,
        viewBox: `-0.5 -0.5 ${figure.view.width} ${figure.view.height}`},
      ...stage.layers.map((layer) => drawing('g', {class: 'layer', 'data-layer': layer},
        drawing('use', {href: `#v${v}-${layer}`}))))))));
  byId('sheet').replaceChildren(element('h2', {}, 'What was seen, step by step'), ...rows);
}
