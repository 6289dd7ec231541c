// SPDX-License-Identifier: GPL-3.0-or-later
// Puts the page together: what is shown follows from `state`.
import {Vector3} from 'three/build/three.module.js';
import {Curves} from './curves.js';
import {List, SideFilter, counted} from './list.js';
import {Playback} from './playback.js';
import {Stage} from './stage.js';
import {Surface} from './surface.js';
import {Theme} from './theme.js';
import {Threshold} from './threshold.js';
import {colourParts, joinedParts} from './parts.js';
import {listenToKeys} from './keys.js';
import {readAddress} from './address.js';
import {readData} from './data.js';
import {scheme} from './colours.js';
import {showLegend} from './legend.js';
import {viewOfCurve} from './view_of_curve.js';

const data = readData(document);
const {arrays, curves} = data;

const state = {selected: -1, showsParts: true, showsEdges: null, width: null};
const isShown = c => curves[c].prominence >= threshold.value && !filter.hidden.has(curves[c].side);

const list = new List(data, select);
const theme = new Theme(refresh);
const threshold = new Threshold(curves, data.prominence, choose);
const filter = new SideFilter(curves, choose);
const playback = new Playback(data, isShown, showFrame);
const surface = new Surface(data.mesh.holes > 0);
const drawn = new Curves(data, data.is_simplified ? 0.003 : 0.0015);
let stage = null;
try {
  stage = new Stage(document.getElementById('canvas'));
  stage.scene.add(surface.group, drawn.group, playback.group);
} catch (error) {
  const failure = document.getElementById('failure');
  failure.textContent = `The surface cannot be drawn: ${error.message}`;
  failure.hidden = false;
}

const finest = data.is_simplified
  ? {points: arrays.levels_points, faces: arrays.levels_faces, parts: arrays.levels_parts}
  : {points: arrays.surface_points, faces: arrays.surface_faces, parts: arrays.surface_parts};
const extent = greatestNorm(finest.points);
const home = firstView(finest.points);
const sizes = new Array(data.number_of_parts).fill(0);
for (const p of finest.parts)
  ++sizes[p];

if (data.is_simplified)
  list.note(`Drawn with ${counted(finest.faces.length / 3, 'face')}, simplified. `
    + 'The curves are exact, on the surface of the file.');

// A little from above and from the right; what is flat is seen from its broad side.
function firstView(points) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  points.forEach((x, i) => {
    low[i % 3] = Math.min(low[i % 3], x);
    high[i % 3] = Math.max(high[i % 3], x);
  });
  const [x, y, z] = high.map((h, i) => h - low[i]);
  if (y < 0.8 * Math.min(x, z))
    return {direction: new Vector3(0.25, 1, 0.5), up: new Vector3(0, 0, -1)};
  if (x < 0.8 * Math.min(y, z) || z > 1.2 * Math.max(x, y))
    return {direction: new Vector3(1, 0.25, 0.4), up: new Vector3(0, 1, 0)};
  return {direction: new Vector3(0.4, 0.25, 1), up: new Vector3(0, 1, 0)};
}

function greatestNorm(points) {
  let greatest = 0;
  for (let i = 0; i < points.length; i += 3)
    greatest = Math.max(greatest, Math.hypot(points[i], points[i + 1], points[i + 2]));
  return greatest;
}

// Of how many that are not shown a curve is the representative.
function represented() {
  const result = new Array(curves.length).fill(0);
  curves.forEach((_, c) => {
    if (isShown(c))
      return;
    let r = c;
    while (r !== null && !isShown(r))
      r = curves[r].dominated_by;
    if (r !== null)
      ++result[r];
  });
  return result;
}

// A curve that is hidden is not selected.
function choose() {
  if (state.selected >= 0 && !isShown(state.selected))
    state.selected = -1;
  refresh();
}

let surfaceShown = null; // what surface.set() was last called for

function refresh() {
  list.update(isShown, represented(), state.selected);
  for (const [name, isOn] of [['parts', state.showsParts], ['edges', edgesAreShown()]])
    document.getElementById(name).setAttribute('aria-pressed', String(isOn));
  showLegend(document.getElementById('colours'), theme.name);
  if (!stage)
    return;
  const colours = scheme(theme.name);
  const wanted = playback.isOn && !playback.isAtEnd ? playback.shownLevel(playback.frame) : -1;
  if (surfaceShown !== wanted) {
    surfaceShown = wanted;
    const shown = wanted < 0 ? finest : playback.surface(playback.frame);
    surface.set(shown, wanted >= 0 && isCoarse(shown.faces));
  }
  if (wanted < 0 && state.showsParts && data.number_of_parts > 1) {
    const cuts = c => isShown(c) && curves[c].cuts;
    const joined = joinedParts(data.number_of_parts, curves, cuts);
    const colourOf = colourParts(joined, curves, cuts, sizes, colours.parts.length);
    const isWhole = new Set(joined).size === 1;
    surface.colour(f => isWhole ? colours.surface : colours.parts[colourOf[finest.parts[f]]]);
  } else
    surface.colour(() => colours.surface);
  surface.showEdges(edgesAreShown(), colours.edges);
  drawn.group.visible = !playback.isOn || playback.isAtEnd;
  const width = state.width ?? Math.min(3, Math.max(1.8, stage.canvas.clientHeight / 230));
  drawn.update(isShown, state.selected, colours, width);
  playback.update(colours, width, state.selected);
  stage.invalidate();
}

// Whether triangles can be told apart.
function isCoarse(faces) {
  return faces.length < 3 * 6000;
}

// Unless the user chooses, edges are drawn on coarse levels.
function edgesAreShown() {
  return state.showsEdges ?? (playback.isOn && !playback.isAtEnd && surface.faces !== undefined && isCoarse(surface.faces));
}

function select(c) {
  if (playback.isOn && !playback.isAtEnd)
    playback.leave();
  state.selected = c === state.selected ? -1 : c;
  refresh();
  if (state.selected < 0 || !stage)
    return;
  list.reveal(c);
  const {camera, controls} = stage;
  const view = viewOfCurve(drawn.points[c], drawn.normals[c], surface, camera, controls.target, home.up);
  stage.look({...view, radius: Math.min(extent, Math.max(2.8 * view.radius, 0.12)), up: camera.up}, 800);
}

function showFrame() {
  if (playback.isOn)
    state.selected = -1;
  refresh();
}

function selectNext(step) {
  const shown = curves.map((_, c) => c).filter(isShown), i = shown.indexOf(state.selected);
  if (shown.length > 0) {
    const next = i < 0 ? (step > 0 ? 0 : shown.length - 1) : (i + step + shown.length) % shown.length;
    if (shown[next] !== state.selected)
      select(shown[next]);
  }
}

const actions = {
  selectNext,
  play: () => playback.toggle(),
  frame: step => {
    playback.stop();
    playback.show((playback.isOn ? playback.frame : playback.frames.length) + step);
  },
  back: () => {
    if (playback.isOn)
      playback.leave();
    else {
      state.selected = -1;
      refresh();
    }
  },
  parts: () => { state.showsParts = !state.showsParts; refresh(); },
  edges: () => { state.showsEdges = !edgesAreShown(); refresh(); },
  theme: () => theme.toggle(),
  whole: () => stage?.look({...home, radius: extent}, 600),
  turn: (right, up) => stage?.turn(right, up),
  zoom: factor => stage?.zoom(factor),
};
for (const name of ['parts', 'edges', 'theme', 'whole'])
  document.getElementById(name).addEventListener('click', actions[name]);
listenToKeys(document, actions);

// A click, not the end of a drag.
let pressed = null;
const canvas = document.getElementById('canvas');
canvas.addEventListener('pointerdown', event => pressed = [event.clientX, event.clientY]);
canvas.addEventListener('pointerup', event => {
  if (!stage || !pressed || Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4)
    return;
  if (playback.isOn && !playback.isAtEnd)
    return;
  const box = canvas.getBoundingClientRect();
  const reach = event.pointerType === 'touch' ? 24 : 10;
  const c = drawn.at(event.clientX - box.left, event.clientY - box.top, reach, stage.camera, box.width, box.height,
    isShown);
  if (c >= 0 && c !== state.selected)
    select(c);
});

// What the address asks for, after a #; see address.js.
function follow() {
  const asked = readAddress(location.hash);
  document.body.classList.toggle('bare', asked.panel === false);
  Object.assign(state, {showsParts: asked.parts ?? state.showsParts, showsEdges: asked.edges ?? state.showsEdges,
    width: asked.width ?? state.width});
  if (asked.view)
    home.direction.fromArray(asked.view).normalize();
  if (asked.up)
    home.up.fromArray(asked.up).normalize();
  if (asked.prominence !== undefined)
    threshold.set(asked.prominence);
  if (asked.theme)
    theme.chosen = asked.theme;
  if (asked.side)
    filter.only(asked.side);
  if (stage) {
    stage.hiddenBelow = asked.panel === false ? 0 : document.getElementById('player').offsetHeight + 16;
    stage.resize();
    stage.look({...home, radius: extent / (asked.zoom ?? 1)}, 0);
  }
  theme.apply();
  if (asked.frame !== undefined)
    playback.show(asked.frame);
  if (curves[asked.select] && isShown(asked.select))
    select(asked.select);
}

follow();
window.addEventListener('hashchange', follow);

// For scripts that take pictures and for tests.
window.viewer = {
  data,
  playback,
  settled: () => stage ? stage.settled() : Promise.resolve(),
  state: () => ({
    selected: state.selected,
    shown: curves.map((_, c) => c).filter(isShown),
    prominence: threshold.value,
    frame: playback.frame,
    faces: surface.faces ? surface.faces.length / 3 : 0,
    position: stage?.camera.position.toArray(),
    theme: theme.name,
  }),
};
