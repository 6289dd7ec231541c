// SPDX-License-Identifier: GPL-3.0-or-later
// Puts the page together: what is shown follows from `state`.
import {Vector3} from 'three/build/three.module.js';
import {Curves} from './curves.js';
import {Graphics} from './graphics.js';
import {Lids} from './lids.js';
import {List, SideFilter, counted, rounded} from './list.js';
import {Marks} from './marks.js';
import {PartList, sizeOf} from './part_list.js';
import {Placement} from './placement.js';
import {Playback} from './playback.js';
import {Pointer} from './pointer.js';
import {SaveMenu, curvesAsCsv, partsAsCsv, pictureOf} from './save.js';
import {Section} from './section.js';
import {Stage} from './stage.js';
import {Surface} from './surface.js';
import {Tabs} from './tabs.js';
import {Theme} from './theme.js';
import {Threshold} from './threshold.js';
import {viewOfCurve} from './view_of_curve.js';
import {colourParts, divide, numbersOfParts, placesOfParts} from './parts.js';
import {css, scheme, sides} from './colours.js';
import {firstView, usualView} from './first_view.js';
import {listenToKeys} from './keys.js';
import {readAddress, writeAddress} from './address.js';
import {readData} from './data.js';
import {showLegend} from './legend.js';

const data = readData(document);
const {arrays, curves} = data;

// `first` is how many curves are shown at most, the most prominent; `part` is that of the surface cut along all curves
// which belongs to the part that is shown alone, or -1; `apart` is how far apart the parts are drawn, from 0 to 1.
const state = {selected: -1, hovered: -1, first: Infinity, part: -1, apart: 0, showsParts: true, showsEdges: null,
  width: null};
const isEligible = c => curves[c].prominence >= threshold.value && c < state.first;
const isShown = c => isEligible(c) && !filter.hidden.has(curves[c].side);

const finest = data.is_simplified
  ? {points: arrays.levels_points, faces: arrays.levels_faces, parts: arrays.levels_parts}
  : {points: arrays.surface_points, faces: arrays.surface_faces, parts: arrays.surface_parts};
const extent = greatestNorm(finest.points);
const places = placesOfParts(data.number_of_parts, finest);
const home = usualView(finest.points);

const list = new List(data, select, hover);
const partList = new PartList({onNumber: cutInto, onApart: drawApart, onIsolate: isolate});
const tabs = new Tabs();
const theme = new Theme(refresh);
const threshold = new Threshold(curves, data.prominence, () => {
  state.first = Infinity;
  choose();
});
const filter = new SideFilter(curves, choose);
const playback = new Playback(data, isShown, showFrame);
const section = new Section(data, finest.points, refresh);
const surface = new Surface(data.mesh.holes > 0);
const drawn = new Curves(data, data.is_simplified ? 0.003 : 0.0015, data.is_simplified ? finest : null);
const lids = new Lids();
const placement = new Placement(data, finest, extent, {surface, drawn, lids});
const marks = new Marks(document.getElementById('marks'), data.radius);
let division = null;
let stage = null; // as long as the browser has no graphics

if (data.is_simplified)
  list.note(`Drawn with ${counted(finest.faces.length / 3, 'face')}, simplified. `
    + 'The curves are exact, on the surface of the file.');

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

// The curves in the order of their prominence, of the sides that are chosen, cut until there are `number` parts.
function cutInto(number) {
  const [chosen, numbers] = cuttable();
  const reached = Math.max(...numbers.filter(n => n <= number), numbers[0]);
  const k = numbers.indexOf(reached);
  state.first = k > 0 ? chosen[k - 1] + 1 : 0;
  threshold.set(k > 0 ? curves[chosen[k - 1]].prominence : Infinity);
  choose();
}

// The curves of the sides that are chosen, and how many parts the first k of them give, for each k.
function cuttable() {
  const chosen = curves.map((_, c) => c).filter(c => !filter.hidden.has(curves[c].side));
  return [chosen, numbersOfParts(data.number_of_parts, curves, chosen)];
}

const isolated = () => state.part < 0 ? -1 : division.of[state.part];
const isDrawn = c => isShown(c) && (state.part < 0 || division.between[c].flat().includes(isolated()));

function isolate(p) {
  const first = division.of.indexOf(p), wasIsolated = p === isolated();
  state.part = wasIsolated ? -1 : first;
  if (state.selected >= 0 && !isDrawn(state.selected))
    state.selected = -1;
  refresh();
  if (!stage)
    return;
  if (wasIsolated)
    actions.whole();
  else {
    const {middle, radius} = division.parts[p];
    stage.look({target: middle.clone().add(placement.moveOfPart(p)), direction: stage.direction, up: stage.camera.up,
      radius: Math.max(radius, 0.02)}, 600);
  }
}

function drawApart(x) {
  const showedWhole = stage && Math.abs(Math.log(stage.zoomFactor)) < 0.05;
  state.apart = x;
  refresh();
  if (showedWhole && state.part < 0)
    stage.look({direction: stage.direction, up: stage.camera.up, radius: stage.radius}, 0);
}

let surfaceShown = null; // what surface.set() was last called for

function refresh() {
  division = divide(data, places, c => isShown(c) && curves[c].cuts);
  const colours = scheme(theme.name), isWhole = division.parts.length === 1;
  const colourOf = isWhole ? [colours.surface]
    : colourParts(division, colours.parts.length).map(i => colours.parts[i]);
  list.update(isShown, represented(), division.between, state.selected);
  filter.count(isEligible);
  const {1: numbers} = cuttable();
  partList.update(division, colourOf.map(css), {isolated: isolated(), apart: state.apart},
    [numbers[0], numbers[numbers.length - 1]]);
  tabs.count(curves.filter((_, c) => isShown(c)).length, division.parts.length);
  for (const [name, isOn] of [['parts', state.showsParts], ['edges', edgesAreShown()], ['section', section.isOn]])
    document.getElementById(name).setAttribute('aria-pressed', String(isOn));
  showLegend(document.getElementById('colours'), theme.name);
  if (!stage)
    return;
  const wanted = playback.isOn && !playback.isAtEnd ? playback.shownLevel(playback.frame) : -1;
  if (surfaceShown !== wanted) {
    surfaceShown = wanted;
    const shown = wanted < 0 ? finest : playback.surface(playback.frame);
    surface.set(shown, wanted >= 0 && isCoarse(shown.faces));
  }
  const shownColour = p => wanted < 0 && state.showsParts ? colourOf[p] : colours.surface;
  const isOpen = placement.update(division, {apart: state.apart, alone: isolated()}, wanted < 0, shownColour,
    colours.inside);
  surface.showInside(isOpen || section.isOn, colours.inside);
  stage.radius = placement.radius;
  surface.colour(wanted < 0 ? f => shownColour(division.of[finest.parts[f]]) : () => colours.surface);
  surface.showEdges(edgesAreShown(), colours.edges);
  stage.renderer.clippingPlanes = section.planes;
  drawn.group.visible = !playback.isOn || playback.isAtEnd;
  playback.update(colours, lineWidth(), state.selected);
  drawCurves();
}

const lineWidth = () => state.width ?? Math.min(3, Math.max(1.8, stage.canvas.clientHeight / 230));

function drawCurves() {
  drawn.update(isDrawn, state, scheme(theme.name), lineWidth());
  stage.invalidate();
}

function hover(c) {
  state.hovered = c;
  if (stage)
    drawCurves();
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
  if (state.selected >= 0 && !isDrawn(c))
    state.part = -1;
  refresh();
  if (state.selected < 0 || !stage)
    return;
  list.reveal(c);
  fly(c);
}

function fly(c) {
  const {camera, controls} = stage;
  const view = viewOfCurve(drawn.points(c), drawn.normals[c], surface, camera, controls.target, home.up);
  view.target.add(drawn.moveOf(c));
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
    const legend = document.getElementById('legend');
    if (save.close())
      return;
    if (legend.open)
      legend.open = false;
    else if (playback.isOn)
      playback.leave();
    else if (state.selected < 0 && state.part >= 0)
      isolate(isolated());
    else {
      state.selected = -1;
      refresh();
    }
  },
  parts: () => { state.showsParts = !state.showsParts; refresh(); },
  edges: () => { state.showsEdges = !edgesAreShown(); refresh(); },
  theme: () => theme.toggle(),
  whole: () => stage?.look({...home, radius: stage.radius}, 600),
  section: () => stage && section.toggle(stage.direction),
  apart: () => drawApart(state.apart > 0 ? 0 : 0.5),
  turn: (right, up) => stage?.turn(right, up),
  zoom: factor => stage?.zoom(factor),
};
for (const name of ['parts', 'edges', 'section', 'theme', 'whole'])
  document.getElementById(name).addEventListener('click', actions[name]);
document.getElementById('inset').addEventListener('click', actions.whole);
listenToKeys(document, actions);

// What is drawn at a place of the canvas.
function find(x, y, reach) {
  if (!stage || (playback.isOn && !playback.isAtEnd))
    return {curve: -1, part: -1};
  const ray = stage.ray(x, y), [plane] = section.planes, p = new Vector3();
  const isCut = (...place) => plane !== undefined && plane.distanceToPoint(p.set(...place)) < 0;
  const {face, distance} = surface.at(ray, isCut);
  const {clientWidth, clientHeight} = stage.canvas;
  const curve = drawn.at(x, y, reach, stage.camera, clientWidth, clientHeight, isDrawn,
    q => q.distanceTo(ray.origin) < distance + 0.05 && !isCut(q.x, q.y, q.z));
  return {curve, part: face < 0 ? -1 : division.of[finest.parts[face]]};
}

function nameOf({curve, part}) {
  if (curve >= 0) {
    const {length, prominence, side} = curves[curve];
    return `Constriction ${curve} · ${sides[side].words} · length ${rounded(length)} · `
      + `prominence ${rounded(prominence)}`;
  }
  return part < 0 || division.parts.length === 1 ? '' : `Part ${part} · ${sizeOf(division.parts[part])}`;
}

new Pointer(document.getElementById('canvas'), {find, nameOf, onHover: hover, onClick: c => {
  if (c !== state.selected)
    select(c);
}});

const save = new SaveMenu(data.mesh.file, {
  picture: () => pictureOf(stage, marks),
  curves: () => curvesAsCsv(curves, curves.map((_, c) => c).filter(isShown), division.between),
  parts: () => partsAsCsv(division),
  link: () => writeAddress(address()),
});

const inFile = p => p.toArray().map((x, i) => data.centre[i] + data.radius * x);
const onPage = x => new Vector3().fromArray(x.map((x, i) => (x - data.centre[i]) / data.radius));

// The address of what is shown.
function address() {
  return {
    ...stage && {view: stage.direction.toArray(), up: stage.camera.up.toArray(), zoom: stage.zoomFactor,
      target: inFile(stage.controls.target)},
    select: state.selected >= 0 ? state.selected : undefined,
    prominence: threshold.value,
    first: state.first < curves.length ? state.first : undefined,
    side: filter.hidden.size > 0 ? Object.keys(sides).filter(side => !filter.hidden.has(side)).join(',') : undefined,
    list: tabs.shown,
    part: state.part >= 0 ? isolated() : undefined,
    apart: state.apart > 0 ? state.apart : undefined,
    section: section.isOn ? {...section, at: data.centre[section.axis] + data.radius * section.place} : undefined,
    frame: playback.isOn ? playback.frame : undefined,
    theme: theme.name,
    parts: Number(state.showsParts),
    edges: state.showsEdges === null ? undefined : Number(state.showsEdges),
  };
}

// What the address asks for, after a #; see address.js.
function follow() {
  const asked = readAddress(location.hash), isBare = asked.panel === false;
  document.body.classList.toggle('bare', isBare);
  Object.assign(state, {showsParts: asked.parts ?? state.showsParts, showsEdges: asked.edges ?? state.showsEdges,
    width: asked.width ?? state.width, apart: Math.max(0, Math.min(1, asked.apart ?? state.apart)),
    first: asked.first ?? (asked.prominence === undefined ? state.first : Infinity)});
  if (asked.prominence !== undefined)
    threshold.set(asked.prominence);
  if (asked.theme)
    theme.chosen = asked.theme;
  if (asked.side)
    filter.only(asked.side);
  if (asked.list)
    tabs.open(asked.list);
  if (asked.section) {
    section.set({...asked.section, isOn: true});
    section.moveTo((asked.section.at - data.centre[section.axis]) / data.radius);
  }
  if (asked.view)
    home.direction.fromArray(asked.view).normalize();
  else if (!division)
    home.direction = firstView(data, isShown, home);
  if (asked.up)
    home.up.fromArray(asked.up).normalize();
  theme.apply();
  if (division.parts[asked.part]) {
    state.part = division.of.indexOf(asked.part);
    refresh();
  }
  if (stage) {
    stage.hiddenBelow = isBare ? 0 : document.getElementById('player').offsetHeight + 16;
    stage.hiddenAbove = isBare ? 0 : document.getElementById('tools').offsetHeight;
    stage.inset.isAllowed = !isBare;
    stage.resize();
    const target = asked.target && onPage(asked.target);
    stage.look({...home, target, radius: stage.radius / (asked.zoom ?? 1)}, 0);
  }
  if (asked.frame !== undefined)
    playback.show(asked.frame);
  if (curves[asked.select] && isShown(asked.select)) {
    if (!asked.target)
      select(asked.select);
    else {
      state.selected = asked.select;
      refresh();
      list.reveal(asked.select);
    }
  }
}

// The marks and the inset stay above the player, which grows and shrinks with its text.
const player = document.getElementById('player');
new ResizeObserver(() =>
  document.getElementById('stage').style.setProperty('--above-player', `${player.offsetHeight + 16}px`)).observe(player);

new Graphics(document.getElementById('canvas'), context => {
  stage = new Stage(context, () => marks.update(stage.camera, stage.pixelsPerUnit));
  stage.scene.add(surface.group, lids.mesh, drawn.group, playback.group);
  follow();
}, () => stage.invalidate());
if (!stage)
  follow();
window.addEventListener('hashchange', follow);

// For scripts that take pictures and for tests.
window.viewer = {
  data,
  drawn,
  playback,
  settled: () => stage ? stage.settled() : Promise.resolve(),
  state: () => ({
    selected: state.selected,
    hovered: state.hovered,
    shown: curves.map((_, c) => c).filter(isShown),
    prominence: threshold.value,
    frame: playback.frame,
    faces: surface.faces ? surface.faces.length / 3 : 0,
    parts: division.parts.length,
    isolated: isolated(),
    apart: state.apart,
    position: stage?.camera.position.toArray(),
    target: stage?.controls.target.toArray(),
    theme: theme.name,
  }),
};
