// The interactive page of a report: face before, target and predicted, bones on their way, distance
// map. Rests on three.js, which stands before it in the same file; loads nothing. Where there is no
// WebGL the page stays hidden, and the report's pictures tell the same.
(function () {
  'use strict';

  const degree = Math.PI / 180;
  const data = JSON.parse(document.getElementById('viewer-data').textContent);
  const element = (id) => document.getElementById('viewer-' + id);
  const canvas = element('canvas');

  function webglContext() {
    try {
      const options = { antialias: true, preserveDrawingBuffer: true };
      return canvas.getContext('webgl2', options) || canvas.getContext('webgl', options);
    } catch (error) {
      return null;
    }
  }

  const context = typeof THREE === 'undefined' ? null : webglContext();
  if (!context) {
    return;
  }

  function bytes(text) {
    return Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  }

  // Positions in mm about the common centre, RAS.
  function positions(text) {
    return Float32Array.from(new Int16Array(bytes(text).buffer), (q) => q * data.unit);
  }

  function geometryOf(index, position) {
    const geometry = new THREE.BufferGeometry();
    geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(bytes(index).buffer), 1));
    geometry.setAttribute('position', new THREE.BufferAttribute(position, 3));
    geometry.computeVertexNormals();
    return geometry;
  }

  function meshOf(geometry, colour) {
    const material = new THREE.MeshPhongMaterial({
      color: new THREE.Color(colour[0], colour[1], colour[2]),
      specular: 0x222222,
      shininess: 20,
      side: THREE.DoubleSide,
    });
    return new THREE.Mesh(geometry, material);
  }

  const renderer = new THREE.WebGLRenderer({ canvas: canvas, context: context, antialias: true });
  renderer.setClearColor(0xeef1f4);
  const scene = new THREE.Scene();
  const camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 1, 4000);
  camera.up.set(0, 0, 1);
  scene.add(camera);
  scene.add(new THREE.AmbientLight(0xffffff, 0.35));
  const lamp = new THREE.DirectionalLight(0xffffff, 0.7);
  lamp.position.set(-0.4, 0.6, 1);
  camera.add(lamp);
  camera.add(lamp.target);
  lamp.target.position.set(0, 0, -1);

  // The skin has one geometry; its states are told by the slider.
  const states = [data.skin.before, data.skin.target, data.skin.predicted].map(
    (text) => positions(text || data.skin.before));
  const skinGeometry = geometryOf(data.skin.index, Float32Array.from(states[0]));
  const skin = meshOf(skinGeometry, data.skin.colour);
  skin.renderOrder = 1;
  scene.add(skin);

  if (data.skin.distance) {
    const map = bytes(data.skin.map);
    const colours = new Float32Array(states[0].length);
    bytes(data.skin.distance).forEach((value, vertex) => {
      for (let c = 0; c < 3; ++c) {
        colours[3 * vertex + c] = value === 0
          ? data.skin.unknown[c]
          : map[3 * Math.round((value - 1) / 254 * (map.length / 3 - 1)) + c] / 255;
      }
    });
    skinGeometry.setAttribute('color', new THREE.BufferAttribute(colours, 3));
  }

  const bones = new THREE.Group();
  scene.add(bones);
  const fragments = [];
  data.bones.forEach((bone) => {
    const mesh = meshOf(geometryOf(bone.index, positions(bone.position)), bone.colour);
    bones.add(mesh);
    if (bone.matrix) {
      fragments.push(fragmentOf(mesh, bone));
    }
  });

  // A movement x' = R (x - c) + c + t, told about the common centre of the page's positions.
  function fragmentOf(mesh, bone) {
    const matrix = new THREE.Matrix4().fromArray(bone.matrix).transpose();
    const turn = new THREE.Quaternion().setFromRotationMatrix(matrix);
    const rest = new THREE.Vector3().fromArray(bone.centre);
    const shift = rest.clone().applyMatrix4(matrix).sub(rest);
    rest.sub(new THREE.Vector3().fromArray(data.centre));
    return { mesh, turn, shift, rest };
  }

  function moveFragment(fragment, share) {
    const turn = new THREE.Quaternion().slerp(fragment.turn, share);
    fragment.mesh.quaternion.copy(turn);
    fragment.mesh.position
      .copy(fragment.rest.clone().negate().applyQuaternion(turn))
      .add(fragment.rest)
      .addScaledVector(fragment.shift, share);
  }

  const eye = { azimuth: 42, elevation: 8, zoom: 1 };
  skinGeometry.computeBoundingSphere();
  const radius = skinGeometry.boundingSphere.radius;
  const middle = skinGeometry.boundingSphere.center.clone();

  function placeCamera() {
    const width = canvas.clientWidth || 800, height = canvas.clientHeight || 500;
    renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    renderer.setSize(width, height, false);
    const half = 1.05 * radius / eye.zoom * Math.max(1, height / width);
    camera.top = half;
    camera.bottom = -half;
    camera.right = half * width / height;
    camera.left = -camera.right;
    camera.updateProjectionMatrix();
    const a = eye.azimuth * degree, e = eye.elevation * degree;
    camera.position.set(Math.sin(a) * Math.cos(e), Math.cos(a) * Math.cos(e), Math.sin(e))
      .multiplyScalar(4 * radius).add(middle);
    // from straight above or below the forehead is up or down
    const steep = Math.abs(eye.elevation) > 89;
    camera.up.set(steep ? -Math.sin(a) * Math.sign(e) : 0, steep ? -Math.cos(a) * Math.sign(e) : 0,
      steep ? 0 : 1);
    camera.lookAt(middle);
  }

  let waiting = false;
  function draw() {
    if (!waiting) {
      waiting = true;
      window.requestAnimationFrame(() => {
        waiting = false;
        placeCamera();
        renderer.render(scene, camera);
        canvas.dataset.drawn = String(Number(canvas.dataset.drawn || 0) + 1);
      });
    }
  }

  function stateText(value) {
    const names = [data.texts.before, data.texts.target, data.texts.predicted];
    const low = Math.floor(value), share = Math.round(100 * (value - low));
    return share === 0 ? names[low]
      : data.texts.between.replace('{from}', names[low]).replace('{to}', names[low + 1])
        .replace('{percent}', String(share));
  }

  function showState() {
    const value = Number(element('state').value);
    const low = Math.min(Math.floor(value), 1), share = value - low;
    const from = states[low], to = states[low + 1];
    const position = skinGeometry.attributes.position;
    for (let i = 0; i < from.length; ++i) {
      position.array[i] = from[i] + share * (to[i] - from[i]);
    }
    position.needsUpdate = true;
    skinGeometry.computeVertexNormals();
    fragments.forEach((fragment) => moveFragment(fragment, Math.min(value, 1)));
    element('state-text').textContent = stateText(value);
    element('state').setAttribute('aria-valuetext', stateText(value));
    draw();
  }

  function showFace() {
    const how = element('face').value;
    const map = element('map') && element('map').checked;
    skin.visible = how !== 'none';
    skin.material.transparent = how === 'veil';
    skin.material.opacity = how === 'veil' ? 0.4 : 1;
    skin.material.depthWrite = how !== 'veil';
    skin.material.vertexColors = map ? THREE.VertexColors : THREE.NoColors;
    skin.material.color.setRGB(...(map ? [1, 1, 1] : data.skin.colour));
    skin.material.specular.setHex(map ? 0x000000 : 0x222222); // gloss would hide the map
    skin.material.needsUpdate = true;
    element('scale').hidden = !map;
    draw();
  }

  function showScale() {
    if (!data.skin.distance) {
      return;
    }
    const map = bytes(data.skin.map), stops = [];
    for (let i = 0; i <= 16; ++i) {
      const at = 3 * Math.round(i / 16 * (map.length / 3 - 1));
      stops.push('rgb(' + map[at] + ',' + map[at + 1] + ',' + map[at + 2] + ')');
    }
    element('scale').querySelector('i').style.background =
      'linear-gradient(to right,' + stops.join(',') + ')';
    element('low').textContent = '-' + data.skin.range + ' mm';
    element('high').textContent = '+' + data.skin.range + ' mm';
  }

  function turn(azimuth, elevation) {
    eye.azimuth = (eye.azimuth + azimuth) % 360;
    eye.elevation = Math.max(-90, Math.min(90, eye.elevation + elevation));
    element('view').value = '';
    draw();
  }

  function zoom(factor) {
    eye.zoom = Math.max(0.4, Math.min(12, eye.zoom * factor));
    draw();
  }

  function look(number) {
    const view = data.views[number];
    if (view) {
      eye.azimuth = view.azimuth;
      eye.elevation = view.elevation;
      element('view').value = String(number);
      draw();
    }
  }

  const keys = {
    ArrowLeft: () => turn(-5, 0),
    ArrowRight: () => turn(5, 0),
    ArrowUp: () => turn(0, -5),
    ArrowDown: () => turn(0, 5),
    '+': () => zoom(1.15),
    '=': () => zoom(1.15),
    '-': () => zoom(1 / 1.15),
    Home: () => { eye.zoom = 1; look(3); },
  };
  canvas.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) {
      return;
    }
    const number = Number(event.key) - 1;
    if (keys[event.key]) {
      keys[event.key]();
    } else if (event.key.trim() !== '' && number in data.views) {
      look(number);
    } else {
      return;
    }
    event.preventDefault();
  });

  let grip = null;
  canvas.addEventListener('pointerdown', (event) => {
    grip = { x: event.clientX, y: event.clientY };
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener('pointermove', (event) => {
    if (grip) {
      turn(0.4 * (event.clientX - grip.x), 0.4 * (event.clientY - grip.y));
      grip = { x: event.clientX, y: event.clientY };
    }
  });
  ['pointerup', 'pointercancel'].forEach((name) =>
    canvas.addEventListener(name, () => { grip = null; }));
  canvas.addEventListener('wheel', (event) => {
    if (document.activeElement === canvas) { // else the page scrolls
      zoom(Math.exp(-0.0015 * event.deltaY));
      event.preventDefault();
    }
  }, { passive: false });

  let playing = 0;
  function step() {
    const slider = element('state');
    const value = Number(slider.value) + 0.02;
    slider.value = String(value);
    showState();
    playing = value < 2 ? window.setTimeout(step, 40) : 0;
  }
  element('play').addEventListener('click', () => {
    if (playing) {
      window.clearTimeout(playing);
      playing = 0;
      return;
    }
    if (Number(element('state').value) >= 2) {
      element('state').value = '0';
    }
    step();
  });

  data.views.forEach((view, number) => {
    const option = document.createElement('option');
    option.value = String(number);
    option.textContent = view.title;
    element('view').appendChild(option);
  });
  element('view').addEventListener('change', () => look(Number(element('view').value)));
  element('state').addEventListener('input', showState);
  element('face').addEventListener('change', showFace);
  if (element('map')) {
    element('map').addEventListener('change', showFace);
  }
  element('bones').addEventListener('change', () => {
    bones.visible = element('bones').checked;
    draw();
  });
  window.addEventListener('resize', draw);
  canvas.addEventListener('webglcontextlost', () => {
    document.getElementById('viewer').hidden = true;
    element('none').hidden = false;
  });

  document.getElementById('viewer').hidden = false;
  element('none').hidden = true;
  showScale();
  look(3);
  showFace();
  showState();
})();
