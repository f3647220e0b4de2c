// Which body is selected, and how it is moved: by a gizmo, by handles on joints, by keys.

const nudge = 0.005;                  // m a key
const nudgeTurn = 5 * Math.PI / 180;  // rad

const nudges = {
  ArrowLeft: [-1, 0, 0],
  ArrowRight: [1, 0, 0],
  ArrowUp: [0, 1, 0],
  ArrowDown: [0, -1, 0],
  PageUp: [0, 0, 1],
  PageDown: [0, 0, -1],
};

class Handling {
  constructor(stage, live) {
    this.stage = stage;
    this.live = live;
    this.selected = '';  // "hand", "object", "obstacle NAME", "arm", or empty
    this.proxy = new THREE.Object3D();
    this.gizmo = new THREE.TransformControls(stage.camera, stage.canvas);
    stage.scene.add(this.proxy, this.gizmo);
    this.gizmo.addEventListener('change', () => stage.requestDraw());
    this.gizmo.addEventListener('objectChange', () => this.dragTo());
    this.gizmo.addEventListener('dragging-changed', ({value}) => this.holding(value));
    this.moves = new Coalescer((body, matrix) => this.move(body, matrix));
    this.turns = new Coalescer((joint, value) => this.turn(joint, value));
    this.handles = new JointHandles(stage, {
      begin: () => live.beginGesture(),
      move: (joint, value) => this.turns.ask(joint, value),
      end: () => live.endGesture(),
    });
    this.listeners = [];
    this.listenToClicks();
    stage.listeners.push(() => {
      if (this.gizmo.camera !== stage.camera) this.gizmo.camera = stage.camera;
    });
    stage.replaced.push(() => this.letGoOfRobots());
    live.on('state', () => this.check());
    live.on('hand', () => this.settle());
  }

  listenToClicks() {
    const {canvas} = this.stage;
    let from = null;
    canvas.addEventListener('pointerdown', (event) => {
      from = this.gizmo.axis || event.button !== 0 ? null : [event.clientX, event.clientY];
    });
    canvas.addEventListener('pointerup', (event) => {
      if (!from || this.gizmo.dragging) return;
      const moved = Math.hypot(event.clientX - from[0], event.clientY - from[1]);
      from = null;
      if (moved < 5 && !this.busy) this.click(event);
    });
  }

  click(event) {
    const hit = this.stage.pick(event);
    this.select(hit ? hit.body : '', hit ? hit.link : undefined);
  }

  // `link`: of a hand or an arm, what was taken hold of; without it the whole is meant.
  select(asked, link) {
    // A scene that cannot be used has no arm to turn.
    const body = asked === 'arm' && !this.stage.arm ? '' : asked;
    this.selected = body;
    this.link = link;
    this.gizmo.detach();
    this.handles.hide();
    const joints = this.jointsBehind(body, link);
    if (joints.length > 0) {
      const model = body === 'arm' ? this.stage.arm : this.stage.hand;
      this.handles.show(model, joints, (joint) => this.valueOf(joint));
    } else if (body === 'arm') {
      const {hand_joint} = this.stage.armData;
      this.handles.show(
          this.stage.arm, this.chainTo(this.stage.armData, hand_joint),
          (joint) => this.valueOf(joint));
    } else if (body !== '') {
      this.settle();
      this.gizmo.attach(this.proxy);
    }
    for (const listener of this.listeners) listener();
    this.stage.requestDraw();
  }

  chainTo(robot, joint) {
    const joints = [];
    for (let j = joint; j >= 0; j = robot.joints[j].parent) joints.push(j);
    return joints.reverse();
  }

  // The joints that move a link of the hand or the arm.
  jointsBehind(body, link) {
    const robot = body === 'hand' ? this.stage.handData :
        body === 'arm'            ? this.stage.armData :
                                    null;
    if (!robot || link === undefined) return [];
    const named = robot.links.find(({name}) => name === link);
    return named ? this.chainTo(robot, named.joint) : [];
  }

  valueOf(joint) {
    return this.selected === 'arm' ? this.stage.armJoints(this.live.state)[joint] :
                                     this.live.state.hand.joints[joint];
  }

  // The body's pose in the session; null where there is none.
  poseOf(body) {
    const {state} = this.live;
    if (body === 'hand') return matrixOfPose(state.hand.X_world_hand);
    if (body === 'object') return state.object ? matrixOfPose(state.object.X_world_object) : null;
    const obstacle = state.obstacles.find(({name}) => `obstacle ${name}` === body);
    return obstacle ? matrixOfPose(obstacle.X_world_body) : null;
  }

  // Links and joints that were taken hold of are gone with their robot.
  letGoOfRobots() {
    if (this.selected !== 'hand' && this.selected !== 'arm') return;
    this.select(this.selected);
  }

  // What was selected may be gone.
  check() {
    if (this.selected === '') return;
    const there =
        this.selected === 'arm' ? this.live.state.arm : this.poseOf(this.selected) !== null;
    if (there) {
      this.settle();
    } else {
      this.select('');
    }
  }

  // The gizmo goes where the body is, unless somebody holds it.
  settle() {
    if (this.gizmo.dragging || this.selected === '' || this.selected === 'arm') return;
    const pose = this.poseOf(this.selected);
    if (!pose) return;
    pose.decompose(this.proxy.position, this.proxy.quaternion, this.proxy.scale);
    this.stage.requestDraw();
  }

  holding(held) {
    this.stage.controls.enabled = !held;
    if (held) {
      this.busy = true;
      this.live.beginGesture();
      return;
    }
    setTimeout(() => {
      this.busy = false;
    });
    this.live.endGesture();
    this.settle();
  }

  dragTo() {
    if (!this.gizmo.dragging) return;
    this.proxy.updateMatrix();
    this.moves.ask(this.selected, this.proxy.matrix.clone());
  }

  async move(body, matrix) {
    const {live} = this;
    const pose = poseOf(matrix);
    const gesture = live.gestureField();
    let moved;
    if (body === 'hand') {
      moved = await live.ask('hand.move', {X_world_hand: pose, ...gesture});
    } else if (body === 'object') {
      moved = await live.ask('object.move', {X_world_object: pose, ...gesture});
    } else {
      const name = body.slice('obstacle '.length);
      moved = await live.ask('obstacle.move', {name, X_world_body: pose, ...gesture});
    }
    if (moved) live.tell('motion', moved);
    this.settle();
  }

  // Gives a joint the value by its degree of freedom.
  async turn(joint, value) {
    const {live} = this;
    const onArm = this.selected === 'arm';
    const {drives, dofs} = onArm ? this.stage.armData : this.stage.handData;
    const {dof, ratio, offset} = drives[joint];
    const wanted = (value - offset) / ratio;
    const gesture = live.gestureField();
    const moved = onArm ?
        await live.ask('arm.joints', {joint: dofs[dof], value: wanted, ...gesture}) :
        await live.ask('hand.dofs', {dof: dofs[dof], value: wanted, ...gesture});
    if (moved) live.tell('motion', moved);
  }

  // Whether the key was one that moves the selected body.
  key(event) {
    const along = nudges[event.key];
    if (!along || this.selected === '' || this.selected === 'arm') return false;
    const pose = this.poseOf(this.selected);
    if (!pose) return false;
    const axis = new THREE.Vector3(...along);
    const [position, turn, scale] =
        [new THREE.Vector3(), new THREE.Quaternion(), new THREE.Vector3()];
    pose.decompose(position, turn, scale);
    if (event.shiftKey) {
      turn.premultiply(new THREE.Quaternion().setFromAxisAngle(axis, nudgeTurn));
    } else {
      position.addScaledVector(axis, nudge);
    }
    this.moves.ask(this.selected, new THREE.Matrix4().compose(position, turn, scale));
    return true;
  }
}
