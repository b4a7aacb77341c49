// SPDX-License-Identifier: Apache-2.0
// What stands in space, as three.js groups: models, cameras, surfaces, names. World frame, mm: z
// up, table top z = 0.
'use strict';

const pointsOf = (flat) => flat.reduce((list, _, i) => (i % 3 ? list :
  [...list, new THREE.Vector3(flat[i], flat[i + 1], flat[i + 2])]), []);

function geometryOf(positions, indices) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(positions, 3));
  if (indices) geometry.setIndex(indices);
  return geometry;
}

const lineMaterial = (colour, opacity = 1) => new THREE.LineBasicMaterial(
  {color: colour, transparent: opacity < 1, opacity});

function lines(points, material) {
  const geometry = geometryOf(points.reduce((list, p) => list.concat(p.toArray()), []));
  return new THREE.LineSegments(geometry, material);
}

/// A name that always faces the reader.
function nameSprite(text, colour, heightMm) {
  const canvas = element('canvas');
  const pen = canvas.getContext('2d');
  const font = '600 44px system-ui, sans-serif';
  pen.font = font;
  canvas.width = Math.ceil(pen.measureText(text).width) + 32;
  canvas.height = 64;
  pen.font = font;
  pen.fillStyle = 'rgba(15, 18, 22, 0.78)';
  pen.fillRect(0, 0, canvas.width, canvas.height);
  pen.fillStyle = colour;
  pen.textBaseline = 'middle';
  pen.fillText(text, 16, 34);
  const texture = new THREE.CanvasTexture(canvas);
  texture.minFilter = THREE.LinearFilter;
  const sprite = new THREE.Sprite(new THREE.SpriteMaterial({map: texture, depthTest: false}));
  sprite.scale.set(heightMm * canvas.width / canvas.height, heightMm, 1);
  sprite.renderOrder = 10;
  return sprite;
}

/// A model where it stands: the surfaces in `seen` solid, the others pale. Without `seen`, edges
/// only.
function modelGroup(model, colour, seen) {
  const group = new THREE.Group();
  const points = pointsOf(model.vertices);
  const part = (wanted, opacity) => {
    const positions = [];
    model.surfaces.forEach((surface, t) => {
      if (seen.has(surface) !== wanted) return;
      for (let k = 0; k < 3; ++k) positions.push(...points[model.triangles[3 * t + k]].toArray());
    });
    if (!positions.length) return;
    const geometry = geometryOf(positions);
    geometry.computeVertexNormals();
    group.add(new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({color: colour,
      transparent: !wanted, opacity, side: THREE.DoubleSide, depthWrite: wanted,
      polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1})));
  };
  if (seen) {
    part(true, 1);
    part(false, 0.25);
  }
  group.add(lines(model.edges.map((v) => points[v]), lineMaterial(seen ? '#10141a' : colour)));
  return group;
}

/// How far what matters reaches from `focus`, mm.
function reachOf(space, focus) {
  const points = [...space.models, ...space.truth].reduce((all, m) => all.concat(pointsOf(m.vertices)), []);
  const far = Math.max(0, ...points.map((p) => p.distanceTo(focus)));
  const views = space.cameras.map((c) => 0.5 * widthSeen(c));
  return Math.max(far, Math.min(...views) * 0.5);
}

/// Width in mm of what a camera sees at the focus.
function widthSeen(camera) {
  const at = cornersAt(camera, camera.distance);
  return at[0].distanceTo(at[1]);
}

/// The corners of a camera's picture at a depth.
const cornersAt = (camera, depth) => pointsOf(camera.origins).map((origin, i) =>
  origin.addScaledVector(pointsOf(camera.directions)[i], depth));

const axisOf = (camera) =>
  pointsOf(camera.directions).reduce((sum, p) => sum.add(p)).normalize();

/// A camera: lines from it to its picture, which stands behind the scene.
function cameraGroup(camera, view, reach, parts, redraw) {
  const axis = axisOf(camera);
  const down = axis.z < -0.8 && camera.position[2] > 0;
  // The picture of a camera that looks down lies on the table.
  const depth = down ? -camera.position[2] / axis.z + 1 : camera.distance + 1.35 * reach;
  const far = cornersAt(camera, depth);
  const near = cornersAt(camera, camera.orthographic ? camera.distance - 3 * reach : 0);
  const frame = [];
  for (let i = 0; i < 4; ++i) frame.push(near[i], far[i], far[i], far[(i + 1) % 4]);
  parts.cameras.add(lines(frame, lineMaterial('#8a949e', 0.35)));
  // The housing: a small pyramid, or for parallel rays the frame they leave through.
  const tip = cornersAt(camera, camera.orthographic ? camera.distance - 3 * reach : 0.25 * reach);
  const body = [];
  for (let i = 0; i < 4; ++i) body.push(near[i], tip[i], tip[i], tip[(i + 1) % 4]);
  parts.cameras.add(lines(body, lineMaterial('#0072b2')));
  const label = nameSprite(camera.name, '#ffffff', 0.2 * reach);
  label.position.copy(near.reduce((a, b) => a.clone().add(b), new THREE.Vector3()).divideScalar(4));
  label.position.addScaledVector(axis, -0.15 * reach);
  parts.cameras.add(label);

  const positions = far.reduce((list, p) => list.concat(p.toArray()), []);
  const geometry = geometryOf(positions, [0, 3, 2, 0, 2, 1]);
  geometry.setAttribute('uv', new THREE.Float32BufferAttribute([0, 1, 1, 1, 1, 0, 0, 0], 2));
  const texture = new THREE.TextureLoader().load(view.pictures.image, redraw);
  texture.minFilter = THREE.LinearFilter;  // sizes are not powers of two
  texture.generateMipmaps = false;
  parts.pictures.add(new THREE.Mesh(geometry, new THREE.MeshBasicMaterial(
    {map: texture, color: '#d8d8d8'})));
}

function surfaceMesh(surface) {
  const points = surface.vertices_mm.map((p) => new THREE.Vector3(...p));
  const group = new THREE.Group();
  const outline = [];
  points.forEach((p, i) => outline.push(p, points[(i + 1) % points.length]));
  group.add(lines(outline, lineMaterial('#009e73')));
  // Drawn flat along the axis that the normal is nearest to, cut into triangles there.
  const n = surface.normal.map(Math.abs);
  const drop = n.indexOf(Math.max(...n));
  const flat = points.map((p) => new THREE.Vector2(...p.toArray().filter((_, i) => i !== drop)));
  const triangles = THREE.ShapeUtils.triangulateShape(flat, []);
  const positions = triangles.flat().reduce((list, v) => list.concat(points[v].toArray()), []);
  group.add(new THREE.Mesh(geometryOf(positions), new THREE.MeshBasicMaterial(
    {color: '#009e73', transparent: true, opacity: 0.35, side: THREE.DoubleSide,
      depthWrite: false})));
  return group;
}

function fillParts(scene, reach, parts, redraw) {
  const {space} = scene;
  space.cameras.forEach((camera, i) => cameraGroup(camera, scene.views[i], reach, parts, redraw));
  space.models.forEach((model, i) => {
    const seen = new Set(scene.objects[i].surfaces.map((match) => match.model_surface));
    const group = modelGroup(model, colourOf(i), seen);
    const label = nameSprite(model.name, colourOf(i), 0.15 * reach);
    const box = new THREE.Box3().setFromPoints(pointsOf(model.vertices));
    label.position.set((box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2,
      box.max.z + 0.13 * reach);
    group.add(label);
    parts.models.add(group);
  });
  for (const model of space.truth) parts.truth.add(modelGroup(model, '#ffffff', null));
  const confirmed = (edge) => edge.views > 2 || edge.ends > 1;
  const material = {true: lineMaterial('#d55e00'), false: lineMaterial('#d55e00', 0.3)};
  for (const edge of space.edges)
    parts.edges.add(lines(pointsOf(edge.line), material[confirmed(edge)]));
  for (const surface of scene.surfaces) parts.surfaces.add(surfaceMesh(surface));
}
