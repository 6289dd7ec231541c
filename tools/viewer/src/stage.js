// SPDX-License-Identifier: GPL-3.0-or-later
// Camera, lights and drawing. Draws when something has changed only.
import {DirectionalLight, HemisphereLight, PerspectiveCamera, Scene, Vector3, WebGLRenderer} from 'three/build/three.module.js';
import {gamma, light} from './colours.js';
import {TrackballControls} from 'three/examples/jsm/controls/TrackballControls.js';

const fieldOfView = 30;

// How far from a ball of this radius the camera sees it whole.
const distanceFor = (radius, aspect) =>
  radius / Math.sin(Math.min(1, aspect) * fieldOfView / 2 * Math.PI / 180) * 1.04;

// The whole in a corner, when the camera is near, with a ring around what it sees.
class Inset {
  constructor() {
    this.frame = document.getElementById('inset');
    this.ring = document.getElementById('inset-ring');
    this.camera = new PerspectiveCamera(fieldOfView, 1, 0.01, 100);
    this.isAllowed = true;
  }

  draw(stage) {
    const {camera, frame, ring} = this, {renderer, radius} = stage, distance = distanceFor(radius, 1);
    const isShown = this.isAllowed && stage.zoomFactor > 1.6;
    frame.hidden = !isShown;
    if (!isShown)
      return;
    camera.position.copy(stage.direction).multiplyScalar(distance);
    camera.up.copy(stage.camera.up);
    camera.lookAt(0, 0, 0);
    camera.near = Math.max(0.005, distance - 1.5 * radius);
    camera.far = distance + 1.5 * radius;
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    const {offsetLeft, offsetTop, clientLeft, clientWidth: size} = frame, {clientWidth, clientHeight} = stage.canvas;
    const box = [offsetLeft + clientLeft, clientHeight - offsetTop - clientLeft - size, size, size];
    renderer.setViewport(...box);
    renderer.setScissor(...box);
    renderer.setScissorTest(true);
    renderer.render(stage.scene, camera);
    renderer.setScissorTest(false);
    renderer.setViewport(0, 0, clientWidth, clientHeight);

    const p = stage.controls.target.clone().project(camera);
    const width = Math.max(8, size * stage.camera.position.distanceTo(stage.controls.target) / distance);
    ring.style.width = ring.style.height = `${width}px`;
    ring.style.left = `${(p.x + 1) / 2 * size - width / 2}px`;
    ring.style.top = `${(1 - p.y) / 2 * size - width / 2}px`;
  }
}

export class Stage {
  // `onDraw()` is called whenever something has been drawn.
  constructor(context, onDraw) {
    const {canvas} = context;
    this.canvas = canvas;
    this.onDraw = onDraw;
    this.inset = new Inset();
    this.radius = 1; // of the whole that is shown, around the origin
    this.renderer = new WebGLRenderer({canvas, context});
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
    this.hiddenBelow = this.hiddenAbove = 0; // what is in front of the canvas at its ends, in pixels
    this.isDirty = true;
    this.waiting = [];
    // A canvas is empty when its size has changed, and would be shown so, since the frame has been drawn before.
    new ResizeObserver(() => {
      this.resize();
      this.step(performance.now());
    }).observe(canvas);
    this.resize();
    const frame = time => {
      requestAnimationFrame(frame);
      this.step(time);
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
    this.camera.setViewOffset(width, height, 0, (this.hiddenBelow - this.hiddenAbove) / 2, width, height);
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
    // The event of a loss comes later than the loss, and three.js cannot draw then.
    if (!this.renderer.getContext().isContextLost())
      this.draw();
    if (!this.flight)
      this.waiting.splice(0).forEach(done => done());
  }

  draw() {
    const {camera, light, controls} = this;
    const away = camera.position.distanceTo(controls.target);
    camera.near = Math.max(0.005, away - 1.5 - this.radius);
    camera.far = away + 3 + this.radius;
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    // over the left shoulder
    light.target.position.copy(controls.target);
    light.position.set(-0.5, 0.6, 1).transformDirection(camera.matrixWorld).multiplyScalar(5).add(controls.target);
    this.renderer.render(this.scene, camera);
    this.inset.draw(this);
    this.onDraw();
  }

  // How many pixels a unit has at the depth of the centre of the view.
  get pixelsPerUnit() {
    return this.canvas.clientHeight / 2 / Math.tan(fieldOfView / 2 * Math.PI / 180)
      / this.camera.position.distanceTo(this.controls.target);
  }

  // How near the camera is: 1 when it sees the whole as it does at first, 2 at half of that distance.
  get zoomFactor() {
    return this.distanceOf(this.radius) / this.camera.position.distanceTo(this.controls.target);
  }

  // The direction that the camera looks from.
  get direction() { return this.camera.position.clone().sub(this.controls.target).normalize(); }

  // From how far away a ball of this radius is seen.
  distanceOf(radius) {
    const height = this.canvas.clientHeight, free = height - this.hiddenBelow - this.hiddenAbove;
    return distanceFor(radius, this.canvas.clientWidth / free) * height / free;
  }

  // The ray through a place of the canvas, in pixels.
  ray(x, y) {
    const {clientWidth, clientHeight} = this.canvas, origin = this.camera.position;
    const through = new Vector3(2 * x / clientWidth - 1, 1 - 2 * y / clientHeight, 0.5).unproject(this.camera);
    return {origin, direction: through.sub(origin).normalize()};
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
      distance: this.distanceOf(radius),
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
