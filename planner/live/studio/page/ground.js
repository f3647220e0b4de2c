// What the scene stands on and is lit by: a grid at its lowest point, and a lamp above that throws
// soft shadows onto it and onto the bodies.

const keyDirection = new THREE.Vector3(0.35, -0.3, 1).normalize();  // towards the lamp
const shadowPixels = 1024;
const fewestCells = 12;  // of a large grid, from its middle to its edge: up to 2.5 times as many

// The size of a cell [m]: 1, 2 or 5 times a power of ten, at most as large as said.
function cellSize(most) {
  const ten = 10 ** Math.floor(Math.log10(most));
  return ten * (most >= 5 * ten ? 5 : most >= 2 * ten ? 2 : 1);
}

// Lines fade towards the edge, at which their distance from the middle is 1.
function gridMaterial() {
  return new THREE.ShaderMaterial({
    uniforms: {color: {value: new THREE.Color()}, opacity: {value: 1}},
    vertexShader: 'varying vec2 at; void main() { at = position.xy;' +
        'gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }',
    fragmentShader: 'uniform vec3 color; uniform float opacity; varying vec2 at; void main() {' +
        'gl_FragColor = vec4(color, opacity * (1.0 - smoothstep(0.1, 1.0, length(at)))); }',
    transparent: true,
    depthWrite: false,
  });
}

function gridLines(cells) {
  const points = [];
  for (let k = -cells; k <= cells; ++k) {
    const aside = k / cells;
    const end = Math.sqrt(1 - aside * aside);
    // In two halves, so that each point of a line knows how far it is from the middle.
    points.push(aside, -end, 0, aside, 0, 0, aside, 0, 0, aside, end, 0);
    points.push(-end, aside, 0, 0, aside, 0, 0, aside, 0, end, aside, 0);
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(points, 3));
  return geometry;
}

class Ground {
  constructor(scene, renderer) {
    this.renderer = renderer;
    renderer.shadowMap.enabled = true;
    renderer.shadowMap.type = THREE.PCFShadowMap;
    renderer.shadowMap.autoUpdate = false;  // turning the camera changes no shadow
    this.key = new THREE.DirectionalLight(0xffffff);
    this.key.castShadow = true;
    this.key.shadow.mapSize.set(shadowPixels, shadowPixels);
    this.key.shadow.radius = 3;
    this.sky = new THREE.HemisphereLight(0xffffff, 0xaeaaa6);
    this.sky.position.set(0, 0, 1);
    this.group = new THREE.Group();  // what is no body
    this.grid = new THREE.LineSegments(gridLines(10), gridMaterial());
    this.shade = new THREE.Mesh(
        new THREE.CircleBufferGeometry(1, 48),
        new THREE.ShadowMaterial({opacity: 0.22, depthWrite: false}));
    this.shade.receiveShadow = true;
    // What is seen through is drawn after them.
    this.shade.renderOrder = 1;
    this.grid.renderOrder = 2;
    this.group.add(this.grid, this.shade);
    scene.add(this.key, this.key.target, this.sky, this.group);
  }

  setDark(dark) {
    this.grid.material.uniforms.color.value.set(dark ? '#9aa3b2' : '#4a5260');
    this.grid.material.uniforms.opacity.value = dark ? 0.4 : 0.45;
    this.shade.material.opacity = dark ? 0.45 : 0.22;
    this.key.intensity = dark ? 0.28 : 0.32;
    this.sky.intensity = dark ? 0.4 : 0.46;
  }

  // Under all of the points, and some way beyond them; `size`: of what is looked at [m].
  place(points, size) {
    if (points.length === 0) return;
    const box = new THREE.Box3().setFromPoints(points);
    const middle = box.getCenter(new THREE.Vector3());
    const {x, y} = box.getSize(new THREE.Vector3());
    const wanted = 0.9 * Math.hypot(x, y) + 6 * size;
    const cell = cellSize(Math.max(size, wanted / fewestCells));
    this.cell = cell;
    const cells = Math.ceil(wanted / cell);
    this.grid.geometry.dispose();
    this.grid.geometry = gridLines(cells);
    const reach = cells * cell;
    this.group.scale.set(reach, reach, 1);
    // On lines of the world; a little below what stands there, whose faces would flicker with it.
    this.group.position.set(
        cell * Math.round(middle.x / cell), cell * Math.round(middle.y / cell),
        box.min.z - 0.002 * size);
  }

  // The lamp reaches as far as these points and their shadow do.
  lightOn(points) {
    if (points.length === 0) return;
    const {center, radius: size} =
        new THREE.Box3().setFromPoints(points).getBoundingSphere(new THREE.Sphere());
    const drop = Math.max(0, center.z - this.group.position.z) / keyDirection.z;
    const {camera} = this.key.shadow;
    Object.assign(camera, {left: -size, right: size, top: size, bottom: -size});
    camera.near = 0;
    camera.far = 3 * size + drop;
    camera.updateProjectionMatrix();
    this.key.shadow.bias = -size / shadowPixels / camera.far;  // half a pixel
    this.key.target.position.copy(center);
    this.key.position.copy(center).addScaledVector(keyDirection, 2 * size);
    this.key.target.updateMatrixWorld();
    this.renderer.shadowMap.needsUpdate = true;
  }
}

function takesPartInShadows(group, casts = true) {
  group.traverse((node) => {
    if (!node.isMesh) return;
    node.castShadow = casts;
    node.receiveShadow = true;
    // Far sides throw it, or near ones would lie in their own wherever a pixel is coarse.
    node.material.shadowSide = THREE.BackSide;
  });
}
