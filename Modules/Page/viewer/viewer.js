// SPDX-License-Identifier: BSD-3-Clause
// The viewer of a page: layers that are always there, and steps of which a slider shows one.
import '@kitware/vtk.js/Rendering/OpenGL/Profiles/Geometry';
import vtkActor from '@kitware/vtk.js/Rendering/Core/Actor';
import vtkColorTransferFunction from '@kitware/vtk.js/Rendering/Core/ColorTransferFunction';
import vtkDataArray from '@kitware/vtk.js/Common/Core/DataArray';
import vtkGenericRenderWindow from '@kitware/vtk.js/Rendering/Misc/GenericRenderWindow';
import vtkMapper from '@kitware/vtk.js/Rendering/Core/Mapper';
import vtkPolyData from '@kitware/vtk.js/Common/DataModel/PolyData';

const element = (id) => document.getElementById(id);
const scene = JSON.parse(element('scene').textContent);

function decode(text, Type) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  return new Type(bytes.buffer);
}

// Dark to light, even in lightness, alike for every kind of colour vision (Nunez, Anderton and Renslow 2018, cividis).
const CIVIDIS = [
  [0, 34, 78], [18, 53, 112], [59, 73, 108], [87, 93, 109], [112, 113, 115],
  [138, 134, 120], [165, 156, 116], [195, 179, 105], [225, 204, 85], [254, 232, 56],
];

function colours(range) {
  const map = vtkColorTransferFunction.newInstance();
  CIVIDIS.forEach(([red, green, blue], index) => map.addRGBPoint(
    range[0] + ((range[1] - range[0]) * index) / (CIVIDIS.length - 1), red / 255, green / 255, blue / 255));
  return map;
}

function actorOf(layer) {
  const data = vtkPolyData.newInstance();
  data.getPoints().setData(decode(layer.points, Float32Array), 3);
  if (layer.triangles) data.getPolys().setData(decode(layer.triangles, Uint32Array));
  if (layer.lines) data.getLines().setData(decode(layer.lines, Uint32Array));
  if (layer.vertices) data.getVerts().setData(decode(layer.vertices, Uint32Array));

  const mapper = vtkMapper.newInstance();
  mapper.setInputData(data);
  const actor = vtkActor.newInstance();
  actor.setMapper(mapper);
  const property = actor.getProperty();
  property.setOpacity(layer.opacity);
  property.setPointSize(5);
  property.setColor(...layer.color);
  if (layer.values) {
    const values = vtkDataArray.newInstance({ name: layer.name, values: decode(layer.values, Float32Array) });
    (layer.association === 'cells' ? data.getCellData() : data.getPointData()).setScalars(values);
    mapper.setLookupTable(colours(scene.range));
    mapper.setScalarRange(...scene.range);
    mapper.setUseLookupTableScalarRange(true);
    property.setLighting(false);
  } else {
    mapper.setScalarVisibility(false);
  }
  return actor;
}

const view = vtkGenericRenderWindow.newInstance({ background: [1, 1, 1], listenWindowResize: true });
view.setContainer(element('view'));
view.resize();
const renderer = view.getRenderer();
const draw = () => view.getRenderWindow().render();

function addSwitch(name, actors) {
  const label = document.createElement('label');
  const box = document.createElement('input');
  box.type = 'checkbox';
  box.checked = true;
  box.addEventListener('change', () => {
    actors.forEach((actor) => actor.setVisibility(box.checked));
    draw();
  });
  label.append(box, ` ${name}`);
  element('layers').append(label);
}

scene.layers.forEach((layer) => {
  const actor = actorOf(layer);
  renderer.addActor(actor);
  addSwitch(layer.name, [actor]);
});

const steps = scene.steps.map((step) => actorOf(step));
steps.forEach((actor) => renderer.addActor(actor));
function show(index) {
  steps.forEach((actor, at) => actor.setVisibility(at === index));
  if (steps.length) element('step').textContent = scene.steps[index].name;
  draw();
}

if (steps.length > 1) {
  const slider = element('slider');
  slider.max = steps.length - 1;
  slider.addEventListener('input', () => show(Number(slider.value)));
} else {
  element('slider').hidden = true;
}
if (scene.range) {
  const stops = CIVIDIS.map((colour) => `rgb(${colour.join(',')})`).join(',');
  element('ramp').style.background = `linear-gradient(to right, ${stops})`;
  element('low').textContent = scene.range[0].toPrecision(3) * 1;
  element('high').textContent = scene.range[1].toPrecision(3) * 1;
  element('quantity').textContent = scene.quantity;
} else {
  element('legend').hidden = true;
}

function reset() {
  const camera = renderer.getActiveCamera();
  camera.setFocalPoint(0, 0, 0);
  camera.setPosition(...scene.from);
  camera.setViewUp(...scene.up);
  renderer.resetCamera();
  camera.zoom(1.25);
  renderer.resetCameraClippingRange();
  draw();
}
element('reset').addEventListener('click', reset);
show(0);
reset();
document.body.dataset.ready = 'yes';
