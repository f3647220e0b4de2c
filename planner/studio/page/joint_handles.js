// Handles on the joints of a robot: a disc that turns a revolute joint, an arrow that slides a
// prismatic one.

const handleSize = 0.07;  // of the distance from the eye

const handleColors = {
  still: new THREE.Color(data.palette.axes[2]),
  held: new THREE.Color(data.palette.pointed_at.color),
};

function handleMaterial(opacity) {
  return new THREE.MeshBasicMaterial({
    color: handleColors.still,
    depthTest: false,
    transparent: true,
    opacity,
    side: THREE.DoubleSide,
  });
}

// Of size 1, about or along z.
function handleGroup(turns) {
  const group = new THREE.Group();
  if (turns) {
    const ring = new THREE.Mesh(new THREE.TorusBufferGeometry(1, 0.07, 8, 48), handleMaterial(0.9));
    const disc = new THREE.Mesh(new THREE.CircleBufferGeometry(1, 48), handleMaterial(0.18));
    group.add(ring, disc);
  } else {
    const along = new THREE.Vector3(0, 0, 1.3);
    group.add(
        arrow(new THREE.Vector3(), along, 0.09, handleMaterial(0.9)),
        arrow(new THREE.Vector3(), along.clone().negate(), 0.09, handleMaterial(0.9)));
  }
  group.traverse((node) => {
    node.renderOrder = 40;
  });
  return group;
}

class JointHandles {
  // `move(joint, value)` is called while a handle is dragged, with the value that the joint should
  // have; `begin` and `end` around that.
  constructor(stage, {begin, move, end}) {
    this.stage = stage;
    this.on = {begin, move, end};
    this.group = new THREE.Group();
    this.handles = [];
    this.dragged = null;
    stage.scene.add(this.group);
    stage.listeners.push(() => this.follow());
    const area = stage.canvas.parentElement;
    area.addEventListener('pointerdown', (event) => this.take(event), true);
    window.addEventListener('pointermove', (event) => this.drag(event));
    window.addEventListener('pointerup', () => this.letGo());
    window.addEventListener('pointercancel', () => this.letGo());
  }

  // Handles on these joints of a model; `valueOf` answers the present value of one.
  show(model, joints, valueOf) {
    this.hide();
    this.model = model;
    this.valueOf = valueOf;
    for (const joint of joints) {
      const {turns} = model.motions[joint];
      const group = handleGroup(turns);
      group.traverse((node) => {
        node.userData.joint = joint;
      });
      this.handles.push({joint, turns, group});
      this.group.add(group);
    }
    this.follow();
    this.stage.draw();
  }

  hide() {
    dispose(this.group);
    this.group.remove(...this.group.children);
    this.handles = [];
    this.model = null;
    this.stage.draw();
  }

  // The joint's origin and axis in the world.
  lineOf(joint) {
    const {node, axis} = this.model.motions[joint];
    const frame = node.parent;
    frame.updateWorldMatrix(true, false);
    const origin = new THREE.Vector3().setFromMatrixPosition(frame.matrixWorld);
    return {origin, axis: axis.clone().transformDirection(frame.matrixWorld)};
  }

  // The handles stay at their joints, and of one size on the screen.
  follow() {
    if (!this.model) return;
    const {camera} = this.stage;
    for (const {joint, group} of this.handles) {
      const {origin, axis} = this.lineOf(joint);
      const size = camera.isOrthographicCamera ?
          3.5 * handleSize * this.stage.orthoSize / camera.zoom :
          handleSize * camera.position.distanceTo(origin);
      group.position.copy(origin);
      group.scale.setScalar(Math.max(size, 1e-6));
      group.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), axis);
    }
  }

  take(event) {
    if (event.button !== 0 || this.handles.length === 0) return;
    const [hit] = this.stage.ray(event).intersectObject(this.group, true);
    if (!hit) return;
    // Neither the camera nor the gizmo shall hear of it: without its default, a pointer event is
    // not followed by those of a mouse.
    event.preventDefault();
    event.stopPropagation();
    this.stage.controls.enabled = false;
    const {joint} = hit.object.userData;
    const handle = this.handles.find((one) => one.joint === joint);
    const line = this.lineOf(joint);
    this.dragged = {...handle, line, value: this.valueOf(joint), at: null};
    this.dragged.at = this.along(event);
    this.color(joint, handleColors.held);
    this.on.begin();
  }

  // How far the pointer is around or along the joint's axis [rad or m]; null where that cannot be
  // said.
  along(event) {
    const {line: {origin, axis}, turns} = this.dragged;
    const {ray} = this.stage.ray(event);
    if (turns) return this.around(ray, origin, axis);
    // The point of the axis that is nearest to the ray.
    const slope = ray.direction.dot(axis);
    const across = 1 - slope * slope;
    if (across < 1e-4) return null;
    const between = origin.clone().sub(ray.origin);
    return (slope * between.dot(ray.direction) - between.dot(axis)) / across;
  }

  around(ray, origin, axis) {
    const plane = new THREE.Plane().setFromNormalAndCoplanarPoint(axis, origin);
    const steep = Math.abs(ray.direction.dot(axis));
    // A disc that is seen from its edge is turned by the pointer's way across its axis.
    const point = steep > 0.15 ? ray.intersectPlane(plane, new THREE.Vector3()) : null;
    const arm = point ? point.sub(origin) :
                        ray.closestPointToPoint(origin, new THREE.Vector3()).sub(origin);
    const zero =
        new THREE.Vector3(Math.abs(axis.x) < 0.9 ? 1 : 0, Math.abs(axis.x) < 0.9 ? 0 : 1, 0)
            .cross(axis)
            .normalize();
    const right = axis.clone().cross(zero);
    return arm.lengthSq() > 0 ? Math.atan2(arm.dot(right), arm.dot(zero)) : null;
  }

  drag(event) {
    if (!this.dragged) return;
    const at = this.along(event);
    if (at === null) return;
    const {dragged} = this;
    if (dragged.at !== null) {
      let step = at - dragged.at;
      if (dragged.turns) step -= 2 * Math.PI * Math.round(step / (2 * Math.PI));
      dragged.value += step;
      this.on.move(dragged.joint, dragged.value);
    }
    dragged.at = at;
  }

  letGo() {
    if (!this.dragged) return;
    this.color(this.dragged.joint, handleColors.still);
    this.dragged = null;
    this.stage.controls.enabled = true;
    this.on.end();
  }

  color(joint, color) {
    for (const {joint: own, group} of this.handles) {
      if (own !== joint) continue;
      group.traverse(({material}) => {
        if (material) material.color.copy(color);
      });
    }
    this.stage.draw();
  }
}
