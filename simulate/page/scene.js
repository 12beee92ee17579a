// SPDX-License-Identifier: GPL-3.0-or-later
// The scene in 3D. Frame W, metres, z upwards.
"use strict";

// Viridis: lightness grows evenly, and it reads the same for the colour-blind.
const kColourStops = ["440154", "482878", "3e4989", "31688e", "26828e", "1f9e89", "35b779", "6ece58", "b5de2b", "fde725"]
  .map(hex => [0, 2, 4].map(i => parseInt(hex.slice(i, i + 2), 16) / 255));
/// The colour of a fraction of the colour bar.
const barColour = fraction => {
  const place = Math.max(0, Math.min(1, fraction)) * (kColourStops.length - 1);
  const i = Math.min(Math.floor(place), kColourStops.length - 2);
  return kColourStops[i].map((c, k) => c + (place - i) * (kColourStops[i + 1][k] - c));
};

const hasWebGL = () => {
  try {
    return document.createElement("canvas").getContext("webgl") !== null;
  } catch (error) {
    return false;
  }
};

/// A surface as triangles that share no vertices, so that faces look flat.
const makeSurfaceMesh = surface => {
  const positions = new Float32Array(surface.faces.length * 3);
  surface.faces.forEach((vertex, corner) =>
    positions.set(surface.vertices.subarray(3 * vertex, 3 * vertex + 3), 3 * corner));
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
  geometry.computeVertexNormals();
  geometry.computeBoundingBox();
  const [r, g, b] = surface.colour.map(c => c / 255);
  return new THREE.Mesh(
    geometry, new THREE.MeshLambertMaterial({color: new THREE.Color(r, g, b), side: THREE.DoubleSide}));
};

/// The faces that carry elements, in W, coloured by pressure and not shaded, so that the colours are those of the bar.
/// Where a face carries several elements, the greatest pressure counts. Tension is drawn as zero.
const makeElements = (recording, surfaces) => {
  const {element_runs, firstRun, firstElement} = recording.frames;
  let most = 1;
  for (let frame = 0; frame < element_runs.length; ++frame)
    most = Math.max(most, firstElement[firstRun[frame + 1]] - firstElement[firstRun[frame]]);
  const geometry = new THREE.BufferGeometry();
  const positions = new THREE.BufferAttribute(new Float32Array(9 * most), 3).setUsage(THREE.DynamicDrawUsage);
  const colours = new THREE.BufferAttribute(new Float32Array(9 * most), 3).setUsage(THREE.DynamicDrawUsage);
  geometry.setAttribute("position", positions);
  geometry.setAttribute("color", colours);
  const material = new THREE.MeshBasicMaterial({
    vertexColors: THREE.VertexColors, side: THREE.DoubleSide,
    polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -1,
  });
  const mesh = new THREE.Mesh(geometry, material);
  mesh.frustumCulled = false;
  const corner = new THREE.Vector3();
  const show = (frame, limit) => {
    const pressures = surfaces.map(() => new Map());
    forEachElement(recording, frame, (surface, face, pressure) => {
      if (surfaces[surface].visible)
        pressures[surface].set(face, Math.max(pressure, pressures[surface].get(face) || 0));
    });
    let filled = 0;
    pressures.forEach((faces, surface) => {
      const {geometry: {attributes}, matrixWorld} = surfaces[surface];
      for (const [face, pressure] of faces) {
        const colour = barColour(pressure / limit);
        for (let k = 0; k < 3; ++k, ++filled) {
          corner.fromBufferAttribute(attributes.position, 3 * face + k).applyMatrix4(matrixWorld);
          positions.setXYZ(filled, corner.x, corner.y, corner.z);
          colours.setXYZ(filled, ...colour);
        }
      }
    });
    geometry.setDrawRange(0, filled);
    positions.needsUpdate = colours.needsUpdate = true;
  };
  const seeThrough = on => {
    material.depthTest = !on;
    mesh.renderOrder = on ? 1 : 0;
    material.transparent = on;  // drawn after all that is opaque
  };
  return {mesh, show, seeThrough};
};

const kArrowColour = 0xc2006b;

/// Arrows that begin where the forces act, seen through bodies.
const makeArrows = (recording, size) => {
  const group = new THREE.Group();
  const material = new THREE.MeshBasicMaterial({color: kArrowColour, depthTest: false, transparent: true});
  const shaft = new THREE.CylinderBufferGeometry(1, 1, 1, 12).translate(0, 0.5, 0);
  const head = new THREE.ConeBufferGeometry(1, 1, 16).translate(0, -0.5, 0);
  const up = new THREE.Vector3(0, 1, 0), force = new THREE.Vector3();
  const width = 0.0032 * size;
  const arrow = i => {
    if (i < group.children.length) return group.children[i];
    const made = new THREE.Group();
    made.add(new THREE.Mesh(shaft, material), new THREE.Mesh(head, material));
    made.children.forEach(part => { part.renderOrder = 2; part.frustumCulled = false; });
    group.add(made);
    return made;
  };
  const show = (frame, metresPerNewton) => {
    group.children.forEach(made => { made.visible = false; });
    const {firstContact, contact} = recording.frames;
    for (let i = firstContact[frame]; i < firstContact[frame + 1]; ++i) {
      const made = arrow(i - firstContact[frame]);
      force.set(contact[6 * i + 3], contact[6 * i + 4], contact[6 * i + 5]);
      const length = force.length() * metresPerNewton;
      if (!(length > 1e-4 * size)) continue;
      const headLength = Math.min(6 * width, 0.6 * length);
      const slim = headLength / (6 * width);
      made.visible = true;
      made.position.set(contact[6 * i], contact[6 * i + 1], contact[6 * i + 2]);
      made.quaternion.setFromUnitVectors(up, force.normalize());
      made.children[0].scale.set(slim * width, length - headLength, slim * width);
      made.children[1].scale.set(2.2 * slim * width, headLength, 2.2 * slim * width);
      made.children[1].position.y = length;
    }
  };
  return {group, show};
};

/// W's axes, for the corner.
const makeTriad = () => {
  const scene = new THREE.Scene();
  [["x", 0xc0392b, [1, 0, 0]], ["y", 0x1e8449, [0, 1, 0]], ["z", 0x2455b5, [0, 0, 1]]].forEach(([name, colour, axis]) => {
    const direction = new THREE.Vector3(...axis);
    scene.add(new THREE.ArrowHelper(direction, new THREE.Vector3(), 1, colour, 0.28, 0.16));
    const canvas = element("canvas", {width: 64, height: 64});
    const context = canvas.getContext("2d");
    context.font = "bold 48px sans-serif";
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillStyle = "#" + colour.toString(16).padStart(6, "0");
    context.fillText(name, 32, 32);
    const label = new THREE.Sprite(new THREE.SpriteMaterial({map: new THREE.CanvasTexture(canvas), depthTest: false}));
    label.position.copy(direction).multiplyScalar(1.3);
    label.scale.setScalar(0.55);
    scene.add(label);
  });
  return {scene, camera: new THREE.OrthographicCamera(-1.6, 1.6, 1.6, -1.6, 0.1, 10)};
};

/// The scene within `view`, whose right part is covered by `panel`; null where the browser has no WebGL.
const makeScene = (recording, view, panel) => {
  if (typeof THREE === "undefined" || !hasWebGL()) return null;
  const renderer = new THREE.WebGLRenderer({antialias: true});
  renderer.setPixelRatio(window.devicePixelRatio);
  renderer.setClearColor(0xf3f5f7);
  renderer.autoClear = false;
  view.prepend(renderer.domElement);

  const scene = new THREE.Scene();
  const camera = new THREE.PerspectiveCamera(30, 1, 0.1, 100);
  camera.up.set(0, 0, 1);
  const sky = new THREE.HemisphereLight(0xffffff, 0xb4bcc6, 0.66);
  sky.position.set(0, 0, 1);
  scene.add(camera, sky);
  const light = new THREE.DirectionalLight(0xffffff, 0.42);
  light.position.set(-0.6, 0.5, 1);  // over the viewer's left shoulder
  light.target = camera;
  camera.add(light);

  const surfaces = recording.surfaces.map(makeSurfaceMesh);
  scene.add(...surfaces);
  const place = frame => surfaces.forEach((mesh, i) => {
    const at = 7 * (frame * surfaces.length + i);
    mesh.quaternion.fromArray(recording.frames.poses, at);
    mesh.position.fromArray(recording.frames.poses, at + 4);
    mesh.updateMatrixWorld();
  });
  const boxOfFrames = (first, last) => {
    const box = new THREE.Box3(), one = new THREE.Box3();
    for (let frame = first; frame <= last; ++frame) {
      place(frame);
      surfaces.forEach(mesh => {
        if (mesh.visible) box.union(one.copy(mesh.geometry.boundingBox).applyMatrix4(mesh.matrixWorld));
      });
    }
    return box;
  };
  const whole = boxOfFrames(0, recording.frames.t.length - 1);
  const size = whole.getSize(new THREE.Vector3()).length() || 1;
  const elements = makeElements(recording, surfaces);
  elements.seeThrough(true);
  const arrows = makeArrows(recording, size);
  scene.add(elements.mesh, arrows.group);
  const triad = makeTriad();

  const controls = new THREE.OrbitControls(camera, renderer.domElement);
  controls.enableKeys = false;  // arrow keys move the time

  const draw = () => {
    const distance = camera.position.distanceTo(controls.target);
    camera.near = 0.01 * distance;
    camera.far = 2 * distance + 4 * size;
    camera.updateProjectionMatrix();
    const {x: width, y: height} = renderer.getSize(new THREE.Vector2());
    renderer.setViewport(0, 0, width, height);
    renderer.clear();
    renderer.render(scene, camera);
    triad.camera.position.copy(camera.position).sub(controls.target).setLength(5);
    triad.camera.up.copy(camera.up);
    triad.camera.lookAt(0, 0, 0);
    renderer.setViewport(4, 4, 84, 84);
    renderer.clearDepth();
    renderer.render(triad.scene, triad.camera);
  };

  let freeAspect = 1;  // of what the panel leaves free
  /// As near as the box with some room fits, in the middle, seen from this direction.
  const look = (box, direction) => {
    const centre = box.getCenter(new THREE.Vector3());
    camera.position.copy(centre).add(direction);
    camera.lookAt(centre);
    const toCamera = camera.quaternion.clone().inverse();
    const corners = [...Array(8).keys()].map(i => new THREE.Vector3(
      i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z)
      .sub(centre).applyQuaternion(toCamera));
    const tan = 0.88 * Math.tan(camera.fov * Math.PI / 360);
    // What is near looks greater, so that the middle of the box is not the middle of its picture.
    const shift = new THREE.Vector2();
    let distance = 0;
    for (let round = 0; round < 8; ++round) {
      distance = Math.max(...corners.map(({x, y, z}) =>
        z + Math.max(Math.abs(x - shift.x) / freeAspect, Math.abs(y - shift.y)) / tan)) || 1;
      for (const axis of ["x", "y"]) {
        const seen = corners.map(corner => (corner[axis] - shift[axis]) / (distance - corner.z));
        shift[axis] += distance * (Math.max(...seen) + Math.min(...seen)) / 2;
      }
    }
    centre.add(new THREE.Vector3(shift.x, shift.y, 0).applyQuaternion(camera.quaternion));
    camera.position.copy(centre).addScaledVector(direction.normalize(), distance);
    controls.target.copy(centre);
    controls.update();
  };
  const kDirections = {x: [1, 0, 0], y: [0, -1, 0], z: [0, -1e-4, 1], run: [0.55, -1, 0.5]};
  const self = {
    surfaces, elements, draw, size,
    whole: true,  // the camera has not been moved by hand
    show(frame, limit, metresPerNewton) {
      place(frame);
      elements.show(frame, limit);
      arrows.show(frame, metresPerNewton);
      draw();
    },
    /// The camera on everything: over the run, in one frame, or along an axis.
    aim(how, frame) {
      const now = how === "now";
      const box = now ? boxOfFrames(frame, frame) : boxOfFrames(0, recording.frames.t.length - 1);
      if (box.isEmpty()) return;
      look(box, now ? camera.position.clone().sub(controls.target).normalize() : new THREE.Vector3(...kDirections[how]));
      self.whole = how === "run";
    },
    resize() {
      const width = Math.max(1, view.clientWidth), height = Math.max(1, view.clientHeight);
      renderer.setSize(width, height);
      const covered = Math.min(panel.offsetWidth + 10, width / 2);
      camera.aspect = width / height;
      freeAspect = (width - covered) / height;
      camera.setViewOffset(width, height, covered / 2, 0, width, height);
      if (self.whole) look(whole.clone(), new THREE.Vector3(...kDirections.run));
    },
    /// Where a point of W lies in the window, px.
    project(point) {
      const {x, y} = new THREE.Vector3(...point).project(camera);
      const canvas = renderer.domElement.getBoundingClientRect();
      return [canvas.left + (x + 1) / 2 * canvas.width, canvas.top + (1 - y) / 2 * canvas.height];
    },
  };
  controls.addEventListener("start", () => { self.whole = false; });
  controls.addEventListener("change", draw);
  return self;
};
