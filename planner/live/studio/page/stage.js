// The scene in three dimensions: its bodies where the session has them, and what lies under a point
// of the screen.

const blockedColor = data.palette.outcomes.hand_blocked;  // of what overlaps something
const faintest = 0.2;  // opacity of what stands in the way of sight

// The scene has changed meanwhile.
class Superseded extends Error {}

// Those meshes of the group that are `blocked`, by what they say of themselves.
function paintMeshes(group, blocked) {
  group.traverse((node) => {
    if (!node.isMesh) return;
    if (node.userData.color === undefined) node.userData.color = node.material.color.getHex();
    node.material.color.set(blocked(node.userData) ? blockedColor : node.userData.color);
  });
}

class Stage extends CameraView {
  constructor(canvas, live) {
    super(canvas);
    this.live = live;
    this.surfaces = new Map();  // geometries by the surface's name
    this.bodies = new Map();    // "object" or "obstacle NAME" to Body
    this.hand = null;
    this.arm = null;
    this.robots = '';
    this.opacities = {object: 1, obstacle: 1};
    this.blocked = new Set();  // names of links and bodies that overlap something
    this.objectFrame = new THREE.Group();
    this.marks = new THREE.Group();   // in the frame of the object
    this.solids = new THREE.Group();  // its primitives, in the same frame
    this.objectFrame.add(this.marks, this.solids);
    this.free = new THREE.Group();  // in the world
    this.scene.add(this.objectFrame, this.free);
    this.sync = new Coalescer((state) => this.follow(state));
    this.looked = '';    // the surface of the object that the camera was turned to; '': look anew
    this.replaced = [];  // called when other robots have come in place of the old ones
    this.followSize();
  }

  // The headlight only brightens what the lamp above leaves dark.
  light() {
    this.lamp = new THREE.DirectionalLight(0xffffff, 0.32);
    this.scene.add(this.lamp);
    this.ground = new Ground(this.scene, this.renderer);
  }

  setTheme(dark) {
    this.scene.background = new THREE.Color(dark ? '#1d2026' : '#e9ecf0');
    this.ground.setDark(dark);
    this.requestDraw();
  }

  // Something has moved, and with it its shadow.
  requestAll() {
    const groups = this.bodies.has('object') ? [this.bodies.get('object').group] : [];
    if (this.hand) groups.push(this.hand.root);
    this.scene.updateMatrixWorld(true);
    this.ground.lightOn(groups.flatMap((group) => cornersOf(group)));
    this.requestDraw();
  }

  // Under everything but the hand, which may be anywhere. It stays there while bodies are moved.
  placeGround() {
    const groups = [...this.bodies.values()].map(({group}) => group);
    if (this.arm) groups.push(this.arm.root);
    if (groups.length === 0 && this.hand) groups.push(this.hand.root);
    this.scene.updateMatrixWorld(true);
    this.ground.place(groups.flatMap((group) => cornersOf(group)), radius);
    this.live.tell('grid', this.ground.cell);
  }

  // How much bodies of a kind, "object" or "obstacle", hide of what is behind them: 1 for all.
  setOpacity(kind, opacity) {
    this.opacities[kind] = opacity;
    for (const [key, body] of this.bodies) {
      if (kindOf(key) === kind) body.show(opacity);
    }
    this.paintBlocked();
    this.requestAll();
  }

  draw() {
    this.fadeWhatHides();
    super.draw();
  }

  // Obstacles between the eye and the object or the hand are seen through, be they ever so dense.
  fadeWhatHides() {
    const sights = this.sights();
    let built = false;
    for (const [key, body] of this.bodies) {
      if (kindOf(key) !== 'obstacle') continue;
      const own = this.opacities.obstacle;
      built = body.show(body.hides(sights) ? Math.min(own, faintest) : own) || built;
    }
    if (built) this.paintBlocked();
  }

  // Rays from the middle of the object and from the hand to the eye.
  sights() {
    this.scene.updateMatrixWorld();
    const ends = [];
    if (this.bodies.has('object')) {
      const corners = cornersOf(this.bodies.get('object').group);
      ends.push(new THREE.Box3().setFromPoints(corners).getCenter(new THREE.Vector3()));
    }
    if (this.hand) ends.push(this.hand.root.position);
    return this.raysToEye(ends);
  }

  // --- Bodies

  async surface(name) {
    if (!this.surfaces.has(name)) {
      const asked = this.live.connection.call('view.surface', {surface: name})
                        .then(({mesh}) => meshGeometry(mesh));
      this.surfaces.set(name, asked);
      asked.catch(() => this.surfaces.delete(name));
    }
    return this.surfaces.get(name);
  }

  // Fetches what is not known yet, then shows the state.
  async follow(state) {
    try {
      await this.fetch(state);
    } catch (error) {
      const superseded = [Refusal, Disconnected, Superseded].some((kind) => error instanceof kind);
      if (!superseded) throw error;
      return;  // another state is on its way
    }
    this.place(state);
    if (this.stands !== this.standing(state)) this.placeGround();
    this.stands = this.standing(state);
    this.requestAll();
    this.lookAtNew(state);
  }

  // Which bodies the ground is under.
  standing({object, obstacles, robots}) {
    return JSON.stringify([object && object.surface, obstacles.map(({name}) => name), robots]);
  }

  // Another scene or another object is looked at as a whole, and a scene from where one looks
  // first.
  lookAtNew({object}) {
    const surface = object ? object.surface : 'none';
    if (surface === this.looked) return;
    this.look(this.looked === '' ? firstView() : this.direction());
    this.looked = surface;
  }

  // The scene that the session has is another one.
  forgetView() {
    this.looked = '';
    this.stands = '';
    this.sync.ask(this.live.state);
  }

  async fetch(state) {
    if (state.robots !== this.robots) {
      const robots = await this.live.connection.call('view.robots');
      if (robots.robots !== state.robots) throw new Superseded();
      this.takeRobots(robots);
    }
    const wanted = new Map();
    if (state.object) wanted.set('object', state.object.surface);
    for (const {name, surface} of state.obstacles) wanted.set(`obstacle ${name}`, surface);
    for (const [key, {group, surface}] of this.bodies) {
      if (wanted.get(key) === surface) continue;
      this.scene.remove(group);
      this.bodies.delete(key);
    }
    for (const [key, surface] of wanted) {
      if (this.bodies.has(key)) continue;
      const geometry = await this.surface(surface);
      const body = new Body(key, surface, geometry);
      body.show(this.opacities[kindOf(key)]);
      this.bodies.set(key, body);
      this.scene.add(body.group);
      if (key === 'object') this.measureObject(geometry);
    }
  }

  measureObject(geometry) {
    geometry.computeBoundingSphere();
    radius = Math.max(1e-4, geometry.boundingSphere.radius);
    data.frame.radius = radius;
  }

  takeRobots({robots, hand, arm}) {
    this.robots = robots;
    for (const old of [this.hand, this.arm]) {
      if (!old) continue;
      this.scene.remove(old.root);
      dispose(old.root);
    }
    this.handData = hand;
    this.armData = arm;
    this.hand = new RobotModel(hand, lookOfLink);
    this.nameParts(this.hand, 'hand');
    this.scene.add(this.hand.root);
    this.arm = arm ? new RobotModel(arm, () => data.palette.arm) : null;
    if (this.arm) {
      this.nameParts(this.arm, 'arm');
      this.arm.setBase(matrixOf(arm.X));
      this.scene.add(this.arm.root);
    }
    for (const listener of this.replaced) listener();
    this.tell();
  }

  nameParts(model, body) {
    takesPartInShadows(model.root, body === 'hand');
    model.root.traverse((node) => {
      if (node.userData.link === undefined) return;
      const {link} = node.userData;
      node.traverse((part) => {
        part.userData = {body, link};
      });
    });
  }

  // Puts everything where the state has it.
  place(state) {
    if (state.object) {
      X_WO.copy(matrixOfPose(state.object.X_world_object));
      this.setPose(this.bodies.get('object'), X_WO);
    } else {
      X_WO.identity();
    }
    this.setPose({group: this.objectFrame}, X_WO);
    for (const {name, X_world_body} of state.obstacles) {
      this.setPose(this.bodies.get(`obstacle ${name}`), matrixOfPose(X_world_body));
    }
    this.placeHand(state);
  }

  setPose(body, matrix) {
    if (body) matrix.decompose(body.group.position, body.group.quaternion, body.group.scale);
  }

  placeHand(state) {
    if (!this.hand || state.robots !== this.robots) return;
    this.hand.setBase(matrixOfPose(state.hand.X_world_hand));
    this.hand.setJoints(state.hand.joints);
    if (this.arm) this.placeArm(state);
    this.requestAll();
  }

  // The values of all joints of the platform; those of the hand on it are not drawn.
  armJoints(state) {
    const {drives, dofs, start} = this.armData;
    const values = new Map(state.arm ? state.arm.joints.map(({name, value}) => [name, value]) : []);
    return drives.map(({dof, ratio, offset}, j) => {
      const value = values.get(dofs[dof]);
      return value === undefined ? start[j] : ratio * value + offset;
    });
  }

  placeArm(state) {
    this.arm.setJoints(this.armJoints(state));
    this.fade(this.arm, Boolean(state.arm) && !state.arm.reached);
  }

  // Robot and object at a moment of a motion, which the state does not know. `joints`: of the
  // platform, or of the hand alone, when the arm stays where it is.
  placeMoving({joints, hand, object}) {
    if (!this.hand) return;
    this.hand.setBase(hand);
    const ofArm = this.arm && joints.length > this.handData.joints.length;
    this.hand.setJoints(ofArm ? joints.slice(this.armData.first_hand_joint) : joints);
    if (ofArm) {
      this.fade(this.arm, false);
      this.arm.setJoints(joints);
    }
    this.setPose(this.bodies.get('object'), object);
    this.setPose({group: this.objectFrame}, object);
    this.requestAll();
  }

  // Shows these in place of those that were shown before.
  showSolids(solids) {
    dispose(this.solids);
    this.solids.remove(...this.solids.children);
    if (solids.length > 0) this.solids.add(...solids);
    this.requestDraw();
  }

  // What does not reach its place is seen through.
  fade(model, faded) {
    if (model.faded === faded) return;
    model.faded = faded;
    model.root.traverse(({material}) => {
      if (!material) return;
      material.transparent = Boolean(faded);
      material.opacity = faded ? 0.25 : 1;
    });
  }

  // Shows the links and bodies that overlap something in the colour of what is blocked.
  showBlocked(names) {
    this.blocked = names;
    this.paintBlocked();
    this.requestDraw();
  }

  paintBlocked() {
    for (const model of [this.hand, this.arm]) {
      if (model) paintMeshes(model.root, ({link}) => this.blocked.has(link));
    }
    for (const [key, {group}] of this.bodies) {
      const name = key === 'object' ? this.live.state.object && this.live.state.object.name :
                                      key.slice('obstacle '.length);
      paintMeshes(group, () => this.blocked.has(name));
    }
  }

  // So that object and hand, or with `everything` all bodies, fill the picture.
  look(direction = this.direction(), everything = false) {
    this.scene.updateMatrixWorld(true);
    const groups = everything || !this.bodies.has('object') ?
        [...this.bodies.values()].map(({group}) => group) :
        [this.bodies.get('object').group];
    if (this.hand) groups.push(this.hand.root);
    if (everything && this.arm) groups.push(this.arm.root);
    const corners = groups.flatMap((group) => cornersOf(group));
    this.lookAt(corners, direction);
  }

  // --- What is under the pointer

  // The nearest point of a body: {point, body, link}, or null.
  pick(event) {
    const groups = [...this.bodies.values()].map(({group}) => group);
    for (const model of [this.hand, this.arm]) {
      if (model) groups.push(model.root);
    }
    const hits = this.ray(event).intersectObjects(groups, true).filter(({object}) => object.isMesh);
    if (hits.length === 0) return null;
    const {point, object} = hits[0];
    return {point, ...object.userData};
  }

  // Draws a picture for `take`, in front of nothing, so that it suits pages light and dark.
  drawWithoutBackground(take) {
    const {background} = this.scene;
    this.scene.background = null;
    this.ground.group.visible = false;
    this.draw();
    take(this.canvas);
    this.scene.background = background;
    this.ground.group.visible = true;
    this.draw();
  }

  // The picture as a PNG file.
  picture() {
    this.draw();
    return new Promise((resolve) => this.canvas.toBlob(resolve, 'image/png'));
  }
}
