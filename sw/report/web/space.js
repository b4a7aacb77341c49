// SPDX-License-Identifier: Apache-2.0
// The drawing in space: renderer, camera, what can be switched.
'use strict';

/// What can be switched: title, whether it is shown at first.
const kParts = {models: ['recognised models', true], cameras: ['cameras', true],
  pictures: ['their pictures', true], table: ['table', true],
  edges: ['edges that two or three views agree on', false],
  surfaces: ['surfaces reconstructed before recognition', true],
  truth: ['truth (outline)', false]};

/// The drawing: one renderer for the page, a new content per scene.
class Space {
  constructor(box) {
    this.box = box;
    this.renderer = new THREE.WebGLRenderer({antialias: true, alpha: true,
      preserveDrawingBuffer: true});  // the printed page shows the last drawing
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.camera = new THREE.PerspectiveCamera(32, 16 / 9, 1, 20000);
    this.camera.up.set(0, 0, 1);
    this.controls = new THREE.OrbitControls(this.camera, this.renderer.domElement);
    this.controls.enableKeys = false;
    this.controls.addEventListener('change', () => this.draw());
    box.replaceChildren(this.renderer.domElement);
    box.addEventListener('keydown', (event) => this.key(event));
    new ResizeObserver(() => this.fit()).observe(box);
  }

  show(scene) {
    this.scene = new THREE.Scene();
    this.scene.add(new THREE.HemisphereLight('#ffffff', '#8890a0', 0.75), this.light());
    this.focus = new THREE.Vector3(...scene.space.focus);
    this.cameras = scene.space.cameras;
    this.reach = reachOf(scene.space, this.focus);
    this.parts = {};
    for (const name of Object.keys(kParts)) this.scene.add(this.parts[name] = new THREE.Group());
    this.parts.table.add(this.grid());
    fillParts(scene, this.reach, this.parts, () => this.draw());
    this.options(scene);
    this.home();
    this.fit();
  }

  light() {
    const light = new THREE.DirectionalLight('#ffffff', 0.55);
    light.position.set(0.4, -0.5, 1);
    return light;
  }

  /// The table as lines, 10 mm or a round multiple apart.
  grid() {
    const step = 10 ** Math.ceil(Math.log10(this.reach / 12));
    const half = Math.ceil(2.2 * this.reach / step) * step;
    const grid = new THREE.GridHelper(2 * half, 2 * half / step, '#7d8791', '#7d8791');
    grid.material.transparent = true;
    grid.material.opacity = 0.35;
    grid.rotation.x = Math.PI / 2;  // three.js lays grids into y = 0
    grid.position.set(Math.round(this.focus.x / step) * step,
      Math.round(this.focus.y / step) * step, 0);
    return grid;
  }

  options(scene) {
    const count = {truth: scene.space.truth.length, surfaces: scene.surfaces.length,
      edges: scene.space.edges.length, models: scene.space.models.length};
    const boxes = Object.entries(kParts).filter(([name]) => count[name] !== 0).map(
      ([name, [title, on]]) => {
        this.parts[name].visible = on;
        return element('label', {}, element('input', {type: 'checkbox', name, checked: on,
          onchange: (event) => {
            this.parts[name].visible = event.target.checked;
            this.draw();
          }}), ` ${title}`);
      });
    byId('space-options').replaceChildren(...boxes,
      element('button', {type: 'button', onclick: () => this.home()}, 'Start view'),
      element('button', {type: 'button', onclick: () => this.home(1.9)}, 'With the cameras'));
  }

  /// The first look: from between the cameras, so that their pictures stand behind the scene.
  home(away = 1) {
    const towards = new THREE.Vector3();
    for (const camera of this.cameras) towards.sub(axisOf(camera));
    if (towards.length() < 0.5) towards.set(1, -1, 1);
    this.look(towards.setZ(0.75 * towards.z), away * 6.6 * this.reach);
  }

  look(towards, distance) {
    this.controls.target.copy(this.focus);
    this.camera.position.copy(this.focus).addScaledVector(towards.clone().normalize(), distance);
    this.controls.update();
    this.draw();
  }

  key(event) {
    const turn = {ArrowLeft: [0.1, 0], ArrowRight: [-0.1, 0], ArrowUp: [0, -0.1],
      ArrowDown: [0, 0.1]}[event.key];
    const zoom = {'+': 0.87, '=': 0.87, '-': 1.15}[event.key];
    if (!turn && !zoom) return;
    event.preventDefault();
    event.stopPropagation();
    const away = this.camera.position.clone().sub(this.controls.target);
    const place = new THREE.Spherical().setFromVector3(new THREE.Vector3(away.x, away.z, -away.y));
    place.radius *= zoom || 1;
    if (turn) {
      place.theta += turn[0];
      place.phi = Math.max(0.05, Math.min(3.1, place.phi + turn[1]));
    }
    const next = new THREE.Vector3().setFromSpherical(place);
    this.camera.position.copy(this.controls.target).add(new THREE.Vector3(next.x, -next.z, next.y));
    this.controls.update();
    this.draw();
  }

  fit() {
    const width = this.box.clientWidth, height = this.box.clientHeight;
    if (!width || !height) return;
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  draw() {
    if (this.scene) this.renderer.render(this.scene, this.camera);
  }
}

let space = null;

/// Whether this browser draws in three dimensions.
function hasWebGl() {
  try {
    const canvas = document.createElement('canvas');
    return !!(canvas.getContext('webgl2') || canvas.getContext('webgl'));
  } catch (error) {
    return false;
  }
}

function buildSpace(scene) {
  if (!space && !hasWebGl()) {
    byId('space-options').replaceChildren();
    byId('space-view').replaceChildren(element('p', {class: 'notice', id: 'no-webgl'},
      'This browser has no WebGL, so the drawing in space is left out. Everything else on the ' +
      'page is complete; another browser, or this one with graphics acceleration, shows it.'));
    return;
  }
  if (!space) space = new Space(byId('space-view'));
  space.show(scene);
}
