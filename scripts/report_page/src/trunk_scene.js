// The trunk in three dimensions: what is drawn, apart from the page around it. Lengths in mm; x right, y forward, z up.

import * as three from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { edgesOf, fibreCourses, parts, surfaces } from './anatomy.js';
import { sizeColour, signColour } from './colours.js';
import { positionsMm, sampleAt, curveNamed } from './data.js';
import { colour } from './theme.js';

export const directions = { front: [0, 1, 0.12], oblique: [0.55, 1, 0.28], side: [1, 0, 0.12], top: [0, 0.02, 1] };

/** How far particles move from the first frame at most: [distance, rise or fall], mm. */
function largestMoves(positions, width) {
  let distance = 0;
  let rise = 0;
  for (let i = width; i < positions.length; i += 3) {
    const k = i % width;
    const [x, y, z] = [0, 1, 2].map((c) => positions[i + c] - positions[k + c]);
    distance = Math.max(distance, Math.hypot(x, y, z));
    rise = Math.max(rise, Math.abs(z));
  }
  return { distance, rise };
}

/** What makes points round. */
function disc() {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 32;
  const context = canvas.getContext('2d');
  context.fillStyle = '#ffffff';
  context.arc(16, 16, 15, 0, 2 * Math.PI);
  context.fill();
  return new three.CanvasTexture(canvas);
}

/** Of parts that are seen through, by what is coloured; beside a measured surface they only stand in the way. */
const throughOpacity = { anatomy: 0.3, side: 0.08 };

export class TrunkScene {
  constructor(run) {
    const { trajectory } = run;
    Object.assign(this, { run, trajectory, width: 3 * trajectory.particles, colouring: 'anatomy' });
    this.all = positionsMm(trajectory);
    this.places = Float64Array.from(trajectory.time, (_, i) => i);
    this.rest = this.all.slice(0, this.width);
    this.moves = largestMoves(this.all, this.width);
    this.limits = { ...this.moves };
    this.now = new three.BufferAttribute(this.rest.slice(), 3);
    this.colours = new three.BufferAttribute(new Float32Array(this.width), 3);
    this.scene = new three.Scene();
    this.shown = {};
    this.addSurfaces();
    this.addFibres();
    this.addContact();
    this.addTarget();
    this.addCamera();
    this.time = 0;
  }

  addSurfaces() {
    const rest = new three.BufferAttribute(this.rest, 3);
    this.surfaces = [];
    const faint = Math.min(1, Math.sqrt(200 / this.trajectory.particles)); // fine meshes are not to be black
    for (const part of parts) {
      const corners = surfaces(this.trajectory).get(part.key);
      if (corners.length === 0) continue;
      const geometry = new three.BufferGeometry();
      geometry.setIndex(corners);
      geometry.setAttribute('position', this.now);
      geometry.setAttribute('color', this.colours);
      const material = new three.MeshLambertMaterial({ side: three.DoubleSide, transparent: Boolean(part.through), opacity: part.through ? 0.3 : 1, depthWrite: !part.through, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
      const mesh = new three.Mesh(geometry, material);
      mesh.renderOrder = part.through ? 2 : 0;
      const lines = (position, opacity) => {
        const edges = new three.BufferGeometry();
        edges.setIndex(edgesOf(corners));
        edges.setAttribute('position', position);
        return new three.LineSegments(edges, new three.LineBasicMaterial({ transparent: true, opacity }));
      };
      const edges = lines(this.now, faint * (part.through ? 0.35 : 0.5));
      const ghost = lines(rest, faint * 0.45);
      for (const object of [mesh, edges, ghost]) object.frustumCulled = false;
      this.scene.add(mesh, edges, ghost);
      this.surfaces.push({ ...part, mesh, edges, ghost });
      this.shown[part.key] = true;
    }
    this.shown.ghost = true;
  }

  addFibres() {
    this.courses = fibreCourses(this.trajectory);
    if (this.courses.length === 0) return;
    this.segments = this.courses.flatMap(({ course, activity }) => course.slice(1).map((to, i) => ({ from: course[i], to, activity })));
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(new Float32Array(6 * this.segments.length));
    geometry.setColors(new Float32Array(6 * this.segments.length));
    this.fibres = new LineSegments2(geometry, new LineMaterial({ linewidth: 4, vertexColors: true }));
    this.fibres.frustumCulled = false;
    this.scene.add(this.fibres);
    this.shown.fibres = true;
  }

  addContact() {
    const { contact } = this.trajectory;
    if (!contact || contact.particles.length === 0) return;
    const geometry = new three.BufferGeometry();
    geometry.setAttribute('position', new three.BufferAttribute(new Float32Array(3 * contact.particles.length), 3));
    this.contact = new three.Points(geometry, new three.PointsMaterial({ size: 10, sizeAttenuation: false, map: disc(), alphaTest: 0.5 }));
    this.contact.frustumCulled = false;
    this.contact.renderOrder = 3;
    this.scene.add(this.contact);
    this.shown.contact = true;
  }

  /** The measured surface that the run was held against. */
  addTarget() {
    const { surface } = this.run;
    if (!surface) return;
    const geometry = new three.BufferGeometry();
    geometry.setAttribute('position', new three.BufferAttribute(surface.points_mm, 3));
    geometry.setIndex(new three.BufferAttribute(new Uint32Array(surface.corners), 1));
    geometry.computeVertexNormals();
    this.target = new three.Mesh(geometry, new three.MeshLambertMaterial({ side: three.DoubleSide, transparent: true, opacity: 0.35, depthWrite: false }));
    this.target.frustumCulled = false;
    this.target.renderOrder = 1;
    this.scene.add(this.target);
    this.shown.target = true;
    this.limits.side = this.moves.side = surface.side_mm.reduce((most, d) => (Number.isFinite(d) ? Math.max(most, Math.abs(d)) : most), 0);
  }

  addCamera() {
    const sphere = new three.Sphere().setFromPoints(Array.from({ length: this.width / 3 }, (_, i) => new three.Vector3().fromArray(this.rest, 3 * i)));
    this.centre = sphere.center;
    this.radius = Math.max(sphere.radius, 1);
    this.camera = new three.OrthographicCamera(-1, 1, 1, -1, 1, 20 * this.radius);
    this.camera.up.set(0, 0, 1);
    const lamp = new three.DirectionalLight(0xffffff, 1.6);
    lamp.position.set(-0.5, 0.7, 1);
    this.camera.add(lamp);
    this.scene.add(this.camera, new three.HemisphereLight(0xffffff, 0x999999, 1.9));
  }

  /** Throws where the browser has no WebGL. */
  attach(canvas, onView) {
    this.renderer = new three.WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.target.copy(this.centre);
    this.controls.addEventListener('change', () => {
      this.render();
      onView(this);
    });
    this.look('oblique');
    this.paint();
  }

  resize(width, height) {
    this.size = [width, height];
    const across = (0.98 * this.radius) / Math.min(1, width / height);
    Object.assign(this.camera, { left: (-across * width) / height, right: (across * width) / height, top: across, bottom: -across });
    this.camera.updateProjectionMatrix();
    this.renderer.setSize(width, height, false);
    this.render();
  }

  look(name) {
    this.place(new three.Vector3(...directions[name]));
  }

  place(direction) {
    this.camera.position.copy(direction.normalize()).multiplyScalar(8 * this.radius).add(this.controls.target);
    this.controls.update();
    this.render();
  }

  /** Turns the camera around the trunk: to the right, and up; rad. */
  turn(right, up) {
    const from = this.camera.position.clone().sub(this.controls.target).normalize();
    const azimuth = Math.atan2(from.y, from.x) + right;
    const height = Math.min(Math.max(Math.asin(from.z) + up, -1.55), 1.55);
    this.place(new three.Vector3(Math.cos(height) * Math.cos(azimuth), Math.cos(height) * Math.sin(azimuth), Math.sin(height)));
  }

  zoom(factor) {
    this.camera.zoom = Math.min(Math.max(this.camera.zoom * factor, 0.3), 12);
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.render();
  }

  /** Takes over the view of another scene. */
  follow(other) {
    this.camera.zoom = other.camera.zoom;
    this.camera.position.copy(other.camera.position).sub(other.controls.target).add(this.controls.target);
    this.camera.updateProjectionMatrix();
    this.camera.lookAt(this.controls.target);
    this.render();
  }

  /** mm on the screen for so many pixels. */
  mmPerPixel() {
    return (this.camera.right - this.camera.left) / this.camera.zoom / this.size[0];
  }

  /** Where a point is drawn, pixels. */
  pixel(point) {
    const p = new three.Vector3(...point).project(this.camera);
    return [((p.x + 1) / 2) * this.size[0], ((1 - p.y) / 2) * this.size[1]];
  }

  /** Colours of the theme. */
  paint() {
    const edge = new three.Color(colour('edge'));
    for (const s of this.surfaces) {
      const plain = this.colouring === 'anatomy';
      s.mesh.material.vertexColors = !plain;
      s.mesh.material.color.set(plain ? colour(s.colour) : '#ffffff');
      s.mesh.material.opacity = s.through ? (throughOpacity[this.colouring] ?? 0.55) : 1;
      s.mesh.material.needsUpdate = true;
      s.edges.material.color.copy(edge);
      s.ghost.material.color.set(colour('ghost'));
    }
    this.contact?.material.color.set(colour('contact'));
    this.target?.material.color.set(colour('target'));
    this.show(this.time);
  }

  setColouring(name) {
    this.colouring = name;
    this.paint();
  }

  setShown(key, shown) {
    this.shown[key] = shown;
    this.render();
  }

  show(time) {
    this.time = time;
    this.movePositions(time);
    this.moveColours();
    this.moveFibres(time);
    this.moveContact(time);
    for (const { mesh } of this.surfaces) mesh.geometry.computeVertexNormals();
    this.render();
  }

  movePositions(time) {
    const times = this.trajectory.time;
    const place = sampleAt(times, this.places, time);
    const first = Math.min(Math.floor(place), Math.max(times.length - 2, 0));
    const share = place - first;
    const [a, b] = [first, Math.min(first + 1, times.length - 1)].map((frame) => this.width * frame);
    for (let i = 0; i < this.width; ++i) this.now.array[i] = this.all[a + i] + share * (this.all[b + i] - this.all[a + i]);
    this.now.needsUpdate = true;
  }

  moveColours() {
    if (this.colouring === 'anatomy') return;
    if (this.colouring === 'side') return this.sideColours();
    const now = this.now.array;
    const shade = new three.Color();
    for (let i = 0; i < this.width; i += 3) {
      const [x, y, z] = [0, 1, 2].map((k) => now[i + k] - this.rest[i + k]);
      const rgb = this.colouring === 'distance'
        ? sizeColour(Math.hypot(x, y, z) / (this.limits.distance || 1))
        : signColour(0.5 + z / (2 * this.limits.rise || 1));
      shade.setRGB(rgb[0] / 255, rgb[1] / 255, rgb[2] / 255, three.SRGBColorSpace).toArray(this.colours.array, i);
    }
    this.colours.needsUpdate = true;
  }

  /** Particles that were not compared, or are beyond the border of the surface, are grey. */
  sideColours() {
    const shade = new three.Color();
    this.run.surface.side_mm.forEach((side, i) => {
      const rgb = Number.isFinite(side) ? signColour(0.5 + side / (2 * this.limits.side || 1)) : [150, 150, 150];
      shade.setRGB(rgb[0] / 255, rgb[1] / 255, rgb[2] / 255, three.SRGBColorSpace).toArray(this.colours.array, 3 * i);
    });
    this.colours.needsUpdate = true;
  }

  moveFibres(time) {
    if (!this.fibres) return;
    const curve = curveNamed(this.run, 'activation');
    const activation = curve ? sampleAt(this.run.curves.time, curve.values, time) : 1;
    const [calm, active, off] = ['fibre-rest', 'fibre', 'fibre-off'].map((name) => new three.Color(colour(name)));
    const { instanceStart, instanceColorStart } = this.fibres.geometry.attributes;
    const shade = new three.Color();
    this.segments.forEach(({ from, to, activity }, s) => {
      for (const [end, i] of [[0, from], [3, to]])
        for (let k = 0; k < 3; ++k) instanceStart.data.array[6 * s + end + k] = this.now.array[3 * i + k];
      if (activity < 0.01) shade.copy(off);
      else shade.lerpColors(calm, active, Math.min(1, activation * activity));
      for (const end of [0, 3]) shade.toArray(instanceColorStart.data.array, 6 * s + end);
    });
    instanceStart.data.needsUpdate = true;
    instanceColorStart.data.needsUpdate = true;
  }

  /** Particles against the ribs at the nearest frame; at the first no step has been taken that could tell. */
  touching(time) {
    if (!this.contact) return [];
    const { particles, touching } = this.trajectory.contact;
    const frame = Math.max(Math.round(sampleAt(this.trajectory.time, this.places, time)), this.places.length > 1 ? 1 : 0);
    return Array.from(particles).filter((_, s) => touching[frame * particles.length + s]);
  }

  moveContact(time) {
    if (!this.contact) return;
    const { position } = this.contact.geometry.attributes;
    const touching = this.touching(time);
    touching.forEach((i, at) => {
      for (let k = 0; k < 3; ++k) position.array[3 * at + k] = this.now.array[3 * i + k];
    });
    this.contact.geometry.setDrawRange(0, touching.length);
    position.needsUpdate = true;
  }

  render() {
    if (!this.renderer || !this.size) return;
    for (const { key, mesh, edges, ghost } of this.surfaces) {
      mesh.visible = edges.visible = this.shown[key];
      ghost.visible = this.shown.ghost && this.shown[key];
    }
    if (this.fibres) {
      this.fibres.visible = this.shown.fibres;
      this.fibres.material.resolution.set(...this.size);
    }
    if (this.contact) this.contact.visible = this.shown.contact;
    if (this.target) this.target.visible = this.shown.target;
    this.renderer.render(this.scene, this.camera);
  }
}
