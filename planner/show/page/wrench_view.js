// The space of wrenches in sections side by side: forces without torque, torques without force, and
// where somebody has chosen one, another. They turn together with the scene.

const contactEdges = 24;  // of the polygon that a friction cone is drawn with

// Drawn without a depth test, since the weakest wrench lies inside the hull and would be hidden.
const weakestOverlay = new THREE.MeshBasicMaterial(
    {color: data.palette.weakest.color, depthTest: false, transparent: true});

// The edges of a contact's friction cone at a unit normal force: forces, and torques about the
// origin of the wrench frame divided by its radius. A soft finger adds a torque about the normal
// (poles).
function coneWrenches(contact) {
  const n = vectorOf(contact.n).normalize();
  const across = new THREE.Vector3(Math.abs(n.x) < 0.9 ? 1 : 0, Math.abs(n.x) < 0.9 ? 0 : 1, 0);
  const t1 = n.clone().cross(across).normalize();
  const t2 = n.clone().cross(t1);
  const arm = vectorOf(contact.p).sub(vectorOf(data.frame.origin)).divideScalar(radius);
  // A suction cup that is pressed on by as much as its vacuum does bears twice that.
  const pressed = contact.model === 'suction' ? 2 : 1;
  const mu = contact.model === 'frictionless' ? 0 : pressed * contact.mu;
  const forces = [];
  for (let k = 0; k < contactEdges; ++k) {
    const angle = 2 * Math.PI * k / contactEdges;
    forces.push(n.clone()
                    .addScaledVector(t1, mu * Math.cos(angle))
                    .addScaledVector(t2, mu * Math.sin(angle)));
  }
  const torques = forces.map((force) => arm.clone().cross(force));
  const spin = (contact.torsion || 0) * mu / radius;
  const middle = arm.clone().cross(n);
  const poles = spin > 0 ?
      [middle.clone().addScaledVector(n, spin), middle.clone().addScaledVector(n, -spin)] :
      [];
  return {forces, torques, poles};
}

// Triangles from the origin to a closed curve, and arrows from the origin to the points `spikes`.
function fan(curve, spikes) {
  const group = new THREE.Group();
  const positions = [];
  curve.forEach((p, k) => {
    const next = curve[(k + 1) % curve.length];
    positions.push(0, 0, 0, ...p.toArray(), ...next.toArray());
  });
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(positions, 3));
  group.add(new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({
    color: data.palette.contribution.color,
    side: THREE.DoubleSide,
    transparent: true,
    opacity: data.palette.contribution.opacity,
    depthTest: false
  })));
  const material =
      new THREE.MeshBasicMaterial({color: data.palette.contribution.color, depthTest: false});
  for (const spike of spikes) group.add(arrow(new THREE.Vector3(), spike, 0.008, material));
  group.traverse((node) => {
    node.renderOrder = 20;
  });
  return group;
}

class WrenchSection {
  constructor(kind) {
    this.kind = kind;  // 'forces', 'torques' or 'chosen'
    this.scene = new THREE.Scene();
    this.scene.background = new THREE.Color('#ffffff');
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x9a9aa4, 1));
    this.turned = new THREE.Group();
    this.scene.add(this.turned);
    this.content = new THREE.Group();
    this.contribution = new THREE.Group();
    this.turned.add(this.content, this.contribution);
    this.size = 1;
  }

  show(grasp) {
    this.highlight(null);
    // The axes of the two that are always there are those of the object.
    if (this.kind !== 'chosen') {
      this.turned.quaternion.setFromRotationMatrix(new THREE.Matrix4().extractRotation(X_WO));
    }
    dispose(this.content);
    this.content.remove(...this.content.children);
    this.size = Math.max(0.05, 2 * grasp.epsilon[1]);
    const slice = grasp.detail ? grasp.detail[this.kind] : {vertices: []};
    for (const x of slice.vertices) this.size = Math.max(this.size, Math.abs(x));
    if (slice.vertices.length > 0) {
      const geometry = creasedGeometry(slice.vertices, slice.triangles, 1);
      const look = data.palette.wrench_space;
      this.content.add(outlined(geometry, solid(geometry, look), look, 2));
    }
    const ballRadius = this.ballRadius(grasp);
    if (ballRadius > 0) {
      const ball = new THREE.SphereBufferGeometry(ballRadius, 32, 20);
      this.content.add(solid(ball, data.palette.epsilon_ball));
    }
    const axes = this.kind === 'chosen' ? grasp.detail.chosen.axes : undefined;
    this.content.add(frameAxes(0.55 * this.size, '', axes));
    const weakest = this.weakestOf(grasp);
    const pointer = arrow(new THREE.Vector3(), weakest, 0.022 * this.size, weakestOverlay);
    pointer.traverse((node) => {
      node.renderOrder = 18;
    });
    this.content.add(pointer);
  }

  // Of the part of the ball around the origin that the section shows. Where it fixes coordinates
  // beside the origin it cuts less of it, or nothing.
  ballRadius({epsilon: [lower], fixed}) {
    const aside = this.kind === 'chosen' ? Math.hypot(...fixed) : 0;
    return Math.sqrt(Math.max(lower * lower - aside * aside, 0));
  }

  weakestOf({weakest_force, weakest_torque, detail}) {
    if (this.kind !== 'chosen') {
      return vectorOf(this.kind === 'forces' ? weakest_force : weakest_torque);
    }
    const all = [...weakest_force, ...weakest_torque];
    return vectorOf(
        detail.chosen.axes.map((name) => all[['fx', 'fy', 'fz', 'tx', 'ty', 'tz'].indexOf(name)]));
  }

  // Overlays the forces or torques that one contact can exert by itself; null for none.
  highlight(contact) {
    dispose(this.contribution);
    this.contribution.remove(...this.contribution.children);
    if (!contact || this.kind === 'chosen') return;
    const wrenches = coneWrenches(contact);
    this.contribution.add(
        this.kind === 'forces' ? fan(wrenches.forces, []) : fan(wrenches.torques, wrenches.poles));
  }
}

class WrenchView {
  constructor(canvas, view) {
    this.canvas = canvas;
    this.view = view;
    this.renderer = new THREE.WebGLRenderer({canvas, antialias: true});
    this.renderer.setScissorTest(true);
    this.sections = [new WrenchSection('forces'), new WrenchSection('torques')];
    this.camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.01, 100);
    this.camera.up.set(0, 0, 1);
    this.controls = new THREE.OrbitControls(this.camera, canvas);
    this.controls.enablePan = false;
    this.controls.enableZoom = false;
    this.controls.enableKeys = false;
    this.camera.position.set(1, -1, 1);
    this.controls.addEventListener('change', () => this.turnScene());
    view.listeners.push(() => this.follow());
    new ResizeObserver(() => this.draw()).observe(canvas.parentElement);
  }

  // Those of these kinds, in this order.
  setSections(kinds) {
    if (kinds.join() === this.sections.map(({kind}) => kind).join()) return;
    const {background} = this.sections[0].scene;
    this.sections = kinds.map(
        (kind) => this.sections.find((known) => known.kind === kind) || new WrenchSection(kind));
    for (const {scene} of this.sections) scene.background = background;
  }

  show(grasp) {
    for (const section of this.sections) section.show(grasp);
    this.draw();
  }

  highlight(contact) {
    for (const section of this.sections) section.highlight(contact);
    this.draw();
  }

  setBackground(color) {
    for (const section of this.sections) section.scene.background = new THREE.Color(color);
    this.draw();
  }

  // Turns the camera to the same direction as in the scene.
  follow() {
    const direction = this.view.direction();
    const turned = this.camera.position.clone().normalize().distanceTo(direction) > 1e-6;
    const finer = this.view.renderer.getPixelRatio() !== this.renderer.getPixelRatio();
    if (!turned && !finer) return;
    this.camera.position.copy(direction).multiplyScalar(10);
    this.camera.lookAt(0, 0, 0);
    this.draw();
  }

  turnScene() {
    const direction = this.camera.position.clone().normalize();
    if (this.view.direction().distanceTo(direction) < 1e-6) return;
    const {camera, controls} = this.view;
    const distance = camera.position.distanceTo(controls.target);
    camera.position.copy(controls.target).addScaledVector(direction, distance);
    controls.update();
    this.view.moved = true;
    this.draw();
  }

  draw() {
    const box = this.canvas.parentElement.getBoundingClientRect();
    if (!(box.width > 0)) return;
    const ratio = this.view.renderer.getPixelRatio();
    if (ratio !== this.renderer.getPixelRatio()) this.renderer.setPixelRatio(ratio);
    const drawn = this.renderer.getSize(new THREE.Vector2());
    if (drawn.x !== box.width || drawn.y !== box.height) {
      this.renderer.setSize(box.width, box.height, false);
    }
    const width = box.width / this.sections.length;
    this.sections.forEach((section, i) => {
      const half = 1.15 * section.size;
      const aspect = width / box.height;
      this.camera.left = -half * Math.max(1, aspect);
      this.camera.right = -this.camera.left;
      this.camera.top = half * Math.max(1, 1 / aspect);
      this.camera.bottom = -this.camera.top;
      this.camera.updateProjectionMatrix();
      this.renderer.setViewport(i * width, 0, width, box.height);
      // The next one draws over what is too much; parts of a pixel would stay black.
      this.renderer.setScissor(i * width, 0, box.width - i * width, box.height);
      this.renderer.render(section.scene, this.camera);
    });
  }
}
