// SPDX-License-Identifier: GPL-3.0-or-later
// Camera, lights and drawing. Draws when something has changed only.
import {DirectionalLight, HemisphereLight, PerspectiveCamera, Scene, Vector3, WebGLRenderer} from 'three/build/three.module.js';
import {gamma, light} from './colours.js';
import {TrackballControls} from 'three/examples/jsm/controls/TrackballControls.js';

const fieldOfView = 30;
const drawing = {antialias: true, alpha: true, preserveDrawingBuffer: true};

// How far from a ball of this radius the camera sees it whole.
const distanceFor = (radius, aspect) =>
  radius / Math.sin(Math.min(1, aspect) * fieldOfView / 2 * Math.PI / 180) * 1.04;

export class Stage {
  constructor(canvas) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({canvas, context: canvas.getContext('webgl2', drawing) ?? undefined, ...drawing});
    this.renderer.physicallyCorrectLights = true;
    this.renderer.gammaFactor = gamma;
    this.renderer.gammaOutput = true;
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(fieldOfView, 1, 0.01, 100);
    this.camera.position.z = 4;
    this.controls = new TrackballControls(this.camera, canvas);
    this.controls.rotateSpeed = 3;
    this.controls.zoomSpeed = 1.4;
    this.controls.panSpeed = 0.5;
    this.controls.dynamicDampingFactor = 0.25;
    this.controls.minDistance = 0.05;
    this.controls.maxDistance = 30;
    this.controls.keys = ['', '', '']; // the page has its own
    this.controls.addEventListener('change', () => this.invalidate());
    this.controls.addEventListener('start', () => this.flight = null);

    this.light = new DirectionalLight(0xffffff, 2.2);
    this.scene.add(new HemisphereLight(0xffffff, light(0x8d8a86), 1.5), this.light, this.light.target);
    this.hiddenBelow = 0; // what is in front of the canvas at its lower end, in pixels
    this.isDirty = true;
    this.waiting = [];
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.resize();
    const frame = time => {
      this.step(time);
      requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }

  get aspect() { return this.camera.aspect; }

  invalidate() { this.isDirty = true; }

  resize() {
    const width = this.canvas.clientWidth || 1, height = this.canvas.clientHeight || 1;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.setViewOffset(width, height, 0, this.hiddenBelow / 2, width, height);
    this.controls.handleResize();
    this.invalidate();
  }

  step(time) {
    if (this.flight)
      this.fly(time);
    else
      this.controls.update();
    if (!this.isDirty)
      return;
    this.isDirty = false;
    this.draw();
    if (!this.flight)
      this.waiting.splice(0).forEach(done => done());
  }

  draw() {
    const {camera, light, controls} = this;
    const away = camera.position.distanceTo(controls.target);
    camera.near = Math.max(0.005, away - 2.5);
    camera.far = away + 4;
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    // over the left shoulder
    light.target.position.copy(controls.target);
    light.position.set(-0.5, 0.6, 1).transformDirection(camera.matrixWorld).multiplyScalar(5).add(controls.target);
    this.renderer.render(this.scene, camera);
  }

  // Resolves when what is to be drawn has been drawn and the camera has arrived.
  settled() {
    this.invalidate();
    return new Promise(done => this.waiting.push(done));
  }

  // The camera looks from `direction`, a unit vector, at `target`, such that a ball of that radius around it is seen.
  look({target = new Vector3(), direction, up, radius = 1}, milliseconds) {
    const end = {
      target: target.clone(),
      direction: direction.clone().normalize(),
      up: up.clone(),
      distance: distanceFor(radius, this.aspect) * this.canvas.clientHeight / (this.canvas.clientHeight - this.hiddenBelow),
    };
    if (Math.abs(end.up.clone().normalize().dot(end.direction)) > 0.99)
      end.up.set(end.direction.z, end.direction.x, end.direction.y);
    end.up.addScaledVector(end.direction, -end.up.dot(end.direction)).normalize();
    if (matchMedia('(prefers-reduced-motion: reduce)').matches)
      milliseconds = 0;
    const offset = this.camera.position.clone().sub(this.controls.target);
    this.flight = {
      begin: {target: this.controls.target.clone(), direction: offset.clone().normalize(), up: this.camera.up.clone(),
        distance: offset.length()},
      end, milliseconds, start: null,
    };
    if (milliseconds === 0)
      this.fly(0);
    this.invalidate();
  }

  fly(time) {
    const {begin, end, milliseconds} = this.flight;
    this.flight.start ??= time;
    const t = milliseconds > 0 ? Math.min(1, (time - this.flight.start) / milliseconds) : 1;
    const s = t * t * (3 - 2 * t);
    const {camera, controls} = this;
    const direction = begin.direction.clone().lerp(end.direction, s);
    if (direction.length() < 0.05) // from the opposite side
      direction.addScaledVector(end.up.clone().cross(end.direction), 0.3);
    direction.normalize();
    controls.target.lerpVectors(begin.target, end.target, s);
    // along the way the camera backs off, so as not to fly through the surface
    const turn = 1 - begin.direction.dot(end.direction);
    const distance = begin.distance * Math.pow(end.distance / begin.distance, s) * (1 + 0.4 * turn * s * (1 - s));
    camera.position.copy(controls.target).addScaledVector(direction, distance);
    camera.up.lerpVectors(begin.up, end.up, s).normalize();
    camera.lookAt(controls.target);
    this.invalidate();
    if (t === 1) {
      this.flight = null;
      controls.update(); // forgets the way that it was dragged before
      this.invalidate();
    }
  }

  // Turns the camera around its target: angles in radians.
  turn(right, up) {
    const {camera, controls} = this;
    const offset = camera.position.clone().sub(controls.target);
    const side = camera.up.clone().cross(offset).normalize();
    offset.applyAxisAngle(camera.up, right).applyAxisAngle(side, up);
    camera.up.applyAxisAngle(side, up);
    camera.position.copy(controls.target).add(offset);
    camera.lookAt(controls.target);
    this.invalidate();
  }

  zoom(factor) {
    const {camera, controls} = this;
    camera.position.sub(controls.target).multiplyScalar(factor).add(controls.target);
    this.invalidate();
  }
}
