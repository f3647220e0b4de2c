// The scene in three dimensions: its bodies where the session has them, the camera, and what lies
// under a point of the screen.

const standardViews = {
  front: [0, -1, 0],
  back: [0, 1, 0],
  left: [-1, 0, 0],
  right: [1, 0, 0],
  above: [0, 0, 1],
  below: [0, 0, -1],
  aslant: [1, -1, 0.8],
};

const blockedColor = data.palette.outcomes.hand_blocked;  // of what overlaps something

function firstView() {
  return vectorOf(standardViews.aslant).normalize();
}

// The scene has changed meanwhile.
class Superseded extends Error {}

function bodyGroup(geometry, look) {
  return outlined(geometry, solid(geometry, look), look);
}

class Stage extends View3d {
  constructor(canvas, live) {
    super(canvas, {alpha: true});
    this.live = live;
    this.orthographic = new THREE.OrthographicCamera(-1, 1, 1, -1, -100, 100);
    this.orthographic.up.set(0, 0, 1);
    this.controls.screenSpacePanning = true;
    this.surfaces = new Map();  // geometries by the surface's name
    this.bodies = new Map();    // "object" or "obstacle NAME" to {group, surface}
    this.hand = null;
    this.arm = null;
    this.robots = '';
    this.marks = new THREE.Group();  // in the frame of the object
    this.free = new THREE.Group();   // in the world
    this.scene.add(this.marks, this.free);
    this.sync = new Coalescer((state) => this.follow(state));
    this.looked = '';    // the surface of the object that the camera was turned to; '': look anew
    this.replaced = [];  // called when other robots have come in place of the old ones
    this.orthoSize = 0.3;
    this.framing = new Framing(canvas, byId('free'), () => this.reframe());
    this.followSize();
  }

  setBackground(color) {
    this.scene.background = new THREE.Color(color);
    this.requestDraw();
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
    this.lookAtNew(state);
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
      const look = key === 'object' ? data.palette.object : data.palette.obstacle;
      const geometry = await this.surface(surface);
      const group = bodyGroup(geometry, look);
      group.traverse((node) => {
        node.userData.body = key;
      });
      this.bodies.set(key, {group, surface});
      this.scene.add(group);
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
    X_WO.decompose(this.marks.position, this.marks.quaternion, this.marks.scale);
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
    this.requestDraw();
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
    object.decompose(this.marks.position, this.marks.quaternion, this.marks.scale);
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

  // Shows the links that overlap something in the colour of what is blocked.
  showBlocked(names) {
    if (!this.hand) return;
    for (const model of [this.hand, this.arm]) {
      if (!model) continue;
      model.root.traverse((node) => {
        if (!node.isMesh || node.userData.link === undefined) return;
        if (!node.userData.color) node.userData.color = node.material.color.getHex();
        const blocked = names.has(node.userData.link);
        node.material.color.set(blocked ? blockedColor : node.userData.color);
      });
    }
    for (const [key, {group}] of this.bodies) {
      const name = key === 'object' ? this.live.state.object && this.live.state.object.name :
                                      key.slice('obstacle '.length);
      group.traverse((node) => {
        if (!node.isMesh) return;
        if (!node.userData.color) node.userData.color = node.material.color.getHex();
        node.material.color.set(names.has(name) ? blockedColor : node.userData.color);
      });
    }
    this.requestDraw();
  }

  // --- The camera

  resized() {
    this.sizeOrthographic();
    this.framing.shift([this.perspective, this.orthographic]);
  }

  // Panels cover another part of the stage than before.
  reframe() {
    this.resized();
    this.requestDraw();
  }

  sizeOrthographic() {
    const camera = this.orthographic;
    const {aspect} = this.perspective;
    camera.left = -this.orthoSize * aspect;
    camera.right = this.orthoSize * aspect;
    camera.top = this.orthoSize;
    camera.bottom = -this.orthoSize;
    camera.updateProjectionMatrix();
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
    if (corners.length === 0) return;
    // The camera must not look along its own up direction.
    const from = direction.clone();
    if (Math.abs(from.z) > 0.9999) from.set(0, -1e-3, Math.sign(from.z)).normalize();
    const target = this.framing.aim(this.perspective, corners, from);
    const distance = this.perspective.position.distanceTo(target);
    this.perspective.near = distance / 300;
    this.perspective.updateProjectionMatrix();
    this.orthographic.position.copy(this.perspective.position);
    this.orthographic.zoom = 1;
    this.orthoSize = distance * Math.tan(this.perspective.fov / 2 * Math.PI / 180);
    this.sizeOrthographic();
    this.controls.target.copy(target);
    this.controls.update();
    this.requestDraw();
  }

  setOrthographic(flat) {
    const next = flat ? this.orthographic : this.perspective;
    if (next === this.camera) return;
    next.position.copy(this.camera.position);
    next.quaternion.copy(this.camera.quaternion);
    if (flat) {
      const distance = this.camera.position.distanceTo(this.controls.target);
      this.orthoSize = distance * Math.tan(this.perspective.fov / 2 * Math.PI / 180);
      next.zoom = 1;
      this.sizeOrthographic();
    }
    this.camera = next;
    this.controls.object = next;
    this.controls.update();
    this.tell();
    this.requestDraw();
  }

  // Turns about a point from now on, seen from half as far.
  seek(point) {
    const offset = this.camera.position.clone().sub(this.controls.target).multiplyScalar(0.5);
    this.controls.target.copy(point);
    this.camera.position.copy(point).add(offset);
    if (this.camera.isOrthographicCamera) {
      this.camera.zoom *= 2;
      this.camera.updateProjectionMatrix();
    }
    this.controls.update();
    this.requestDraw();
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
    this.draw();
    take(this.canvas);
    this.scene.background = background;
    this.draw();
  }

  // The picture as a PNG file.
  picture() {
    this.draw();
    return new Promise((resolve) => this.canvas.toBlob(resolve, 'image/png'));
  }
}
