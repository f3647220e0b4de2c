// Handles on the joints of a robot: a disc that turns a revolute joint, an arrow that slides a
// prismatic one.

// Radii on the screen, as shares of the distance from the eye: at most so large, smaller where
// other joints are close, and of those at the same place each so many times the one inside it.
const handleSizes = {
  most: 0.06,
  least: 0.025,
  nested: 1.4
};
const handleReach = 8;  // pixels from a rim or an arrow that still take it

const handleColors = {
  still: data.palette.axes.map((color) => new THREE.Color(color)),  // in turn
  held: new THREE.Color(data.palette.pointed_at.color),
};

function handleMaterial(color, opacity) {
  return new THREE.MeshBasicMaterial(
      {color, depthTest: false, transparent: true, opacity, side: THREE.DoubleSide});
}

// Of size 1, about or along z.
function handleGroup(turns, color) {
  const group = new THREE.Group();
  if (turns) {
    const ring =
        new THREE.Mesh(new THREE.TorusBufferGeometry(1, 0.045, 8, 64), handleMaterial(color, 0.9));
    const disc = new THREE.Mesh(new THREE.CircleBufferGeometry(1, 48), handleMaterial(color, 0.12));
    disc.userData.filling = true;
    group.add(ring, disc);
  } else {
    const along = new THREE.Vector3(0, 0, 1.3);
    group.add(
        arrow(new THREE.Vector3(), along, 0.09, handleMaterial(color, 0.9)),
        arrow(new THREE.Vector3(), along.clone().negate(), 0.09, handleMaterial(color, 0.9)));
  }
  group.traverse((node) => {
    node.renderOrder = 40;
  });
  return group;
}

// Corners of the line that a pointer takes a handle by, of size 1.
function handleLine(turns) {
  if (!turns) return [new THREE.Vector3(0, 0, -1.3), new THREE.Vector3(0, 0, 1.3)];
  return [...Array(49).keys()].map((k) => {
    const angle = k * Math.PI / 24;
    return new THREE.Vector3(Math.cos(angle), Math.sin(angle), 0);
  });
}

// Of a point from a line between two others, in the plane.
function distanceFromLine(point, from, to) {
  const way = to.clone().sub(from);
  const share = way.lengthSq() > 0 ? point.clone().sub(from).dot(way) / way.lengthSq() : 0;
  return from.clone().addScaledVector(way, Math.min(Math.max(share, 0), 1)).distanceTo(point);
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
    this.hovered = null;  // the joint whose handle is under the pointer
    stage.scene.add(this.group);
    stage.listeners.push(() => this.follow());
    const area = stage.canvas.parentElement;
    area.addEventListener('pointerdown', (event) => this.take(event), true);
    area.addEventListener('pointermove', (event) => this.hover(event));
    window.addEventListener('pointermove', (event) => this.drag(event));
    window.addEventListener('pointerup', () => this.letGo());
    window.addEventListener('pointercancel', () => this.letGo());
  }

  // Handles on these joints of a model; `valueOf` answers the present value of one.
  show(model, joints, valueOf) {
    this.hide();
    this.model = model;
    this.valueOf = valueOf;
    for (const [i, joint] of joints.entries()) {
      const {turns} = model.motions[joint];
      const still = handleColors.still[i % handleColors.still.length];
      const group = handleGroup(turns, still);
      group.traverse((node) => {
        node.userData.joint = joint;
      });
      this.handles.push({joint, turns, group, still, line: handleLine(turns)});
      this.group.add(group);
    }
    this.follow();
    this.stage.requestDraw();
  }

  hide() {
    dispose(this.group);
    this.group.remove(...this.group.children);
    this.handles = [];
    this.hovered = null;
    this.model = null;
    this.stage.requestDraw();
  }

  // The joint's origin and axis in the world.
  lineOf(joint) {
    const {node, axis} = this.model.motions[joint];
    const frame = node.parent;
    frame.updateWorldMatrix(true, false);
    const origin = new THREE.Vector3().setFromMatrixPosition(frame.matrixWorld);
    return {origin, axis: axis.clone().transformDirection(frame.matrixWorld)};
  }

  // The handles stay at their joints, and of much the same size on the screen.
  follow() {
    if (!this.model) return;
    const lines = this.handles.map(({joint}) => this.lineOf(joint));
    const sizes = [];
    this.handles.forEach(({group}, i) => {
      const {origin, axis} = lines[i];
      const ways = lines.map((other) => this.acrossView(origin, other.origin));
      const distance = this.distanceTo(origin);
      const least = handleSizes.least * distance;
      const beside = ways.filter((way) => way > least).map((way) => way / 2);
      let size = Math.max(Math.min(handleSizes.most * distance, ...beside), least);
      for (let k = 0; k < i; ++k) {
        if (ways[k] <= least) size = Math.max(size, handleSizes.nested * sizes[k]);
      }
      sizes.push(size);
      group.position.copy(origin);
      group.scale.setScalar(Math.max(size, 1e-6));
      group.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), axis);
    });
  }

  // From the eye, or as far as an eye would be that sees as much as an orthographic camera.
  distanceTo(origin) {
    const {camera} = this.stage;
    return camera.isOrthographicCamera ? 3.5 * this.stage.orthoSize / camera.zoom :
                                         camera.position.distanceTo(origin);
  }

  // How far two points are from each other across the line of sight [m].
  acrossView(a, b) {
    const {camera} = this.stage;
    const sight = camera.isOrthographicCamera ? camera.getWorldDirection(new THREE.Vector3()) :
                                                a.clone().sub(camera.position).normalize();
    return b.clone().sub(a).projectOnPlane(sight).length();
  }

  // The joint whose handle is under the pointer, or null. The rim or arrow that is nearest counts
  // before the filling of a disc, which others are seen through, and of fillings the smallest.
  pick(event) {
    const near = this.handles.map((handle) => this.pixelsFrom(handle, event));
    const least = Math.min(...near);
    if (least < handleReach) return this.handles[near.indexOf(least)].joint;
    const [hit] = this.stage.ray(event)
                      .intersectObject(this.group, true)
                      .filter(({object}) => object.userData.filling)
                      .sort((a, b) => a.object.parent.scale.x - b.object.parent.scale.x);
    return hit ? hit.object.userData.joint : null;
  }

  // Of the pointer from the line of a handle.
  pixelsFrom({group, line}, {clientX, clientY}) {
    const {camera, canvas} = this.stage;
    const box = canvas.getBoundingClientRect();
    camera.updateMatrixWorld();
    group.updateMatrixWorld(true);
    const corners = line.map((corner) => {
      const at = corner.clone().applyMatrix4(group.matrixWorld).project(camera);
      return new THREE.Vector2((at.x + 1) / 2 * box.width, (1 - at.y) / 2 * box.height);
    });
    const pointer = new THREE.Vector2(clientX - box.left, clientY - box.top);
    const ways = corners.slice(1).map((to, k) => distanceFromLine(pointer, corners[k], to));
    return Math.min(...ways);
  }

  // The handle that a press would take is seen before.
  hover(event) {
    if (this.dragged || this.handles.length === 0) return;
    const joint = event.buttons === 0 ? this.pick(event) : null;
    if (joint === this.hovered) return;
    this.color(this.hovered, false);
    this.color(joint, true);
    this.hovered = joint;
  }

  take(event) {
    if (event.button !== 0 || this.handles.length === 0) return;
    const joint = this.pick(event);
    if (joint === null) return;
    // Neither the camera nor the gizmo shall hear of it: without its default, a pointer event is
    // not followed by those of a mouse.
    event.preventDefault();
    event.stopPropagation();
    this.stage.controls.enabled = false;
    const handle = this.handles.find((one) => one.joint === joint);
    const line = this.lineOf(joint);
    this.dragged = {...handle, line, value: this.valueOf(joint), at: null};
    this.dragged.at = this.along(event);
    this.color(joint, true);
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
    this.color(this.dragged.joint, false);
    this.hovered = null;
    this.dragged = null;
    this.stage.controls.enabled = true;
    this.on.end();
  }

  color(joint, held) {
    for (const {joint: own, group, still} of this.handles) {
      if (own !== joint) continue;
      group.traverse(({material}) => {
        if (material) material.color.copy(held ? handleColors.held : still);
      });
    }
    this.stage.requestDraw();
  }
}
