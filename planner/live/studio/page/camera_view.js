// A view whose camera is perspective or orthographic, and sees what it is turned to beside the
// panels.

const standardViews = {
  front: [0, -1, 0],
  back: [0, 1, 0],
  left: [-1, 0, 0],
  right: [1, 0, 0],
  above: [0, 0, 1],
  below: [0, 0, -1],
  aslant: [1, -1, 0.8],
};

function firstView() {
  return vectorOf(standardViews.aslant).normalize();
}

// The camera must not look along its own up direction.
function besideUp(direction) {
  const from = direction.clone();
  if (Math.abs(from.z) > 0.9999) from.set(0, -1e-3, Math.sign(from.z)).normalize();
  return from;
}

class CameraView extends View3d {
  constructor(canvas) {
    super(canvas, {alpha: true});
    this.orthographic = new THREE.OrthographicCamera(-1, 1, 1, -1, -100, 100);
    this.orthographic.up.set(0, 0, 1);
    this.orthoSize = 0.3;
    this.controls.screenSpacePanning = true;
    this.framing = new Framing(canvas, byId('free'), () => this.reframe());
  }

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

  // So that the points fill the part of the picture that no panel covers.
  lookAt(corners, direction) {
    if (corners.length === 0) return;
    const from = besideUp(direction);
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

  // Looks at the same point from another side, from as far as before.
  turnTo(direction) {
    const {target} = this.controls;
    const distance = this.camera.position.distanceTo(target);
    const from = besideUp(direction);
    this.camera.position.copy(target).addScaledVector(from, distance);
    this.controls.update();
    this.requestDraw();
  }

  raysToEye(points) {
    const flat = this.camera.isOrthographicCamera;
    return points.map((point) => {
      const way = this.camera.position.clone().sub(point);
      const far = flat ? Infinity : way.length();
      return new THREE.Raycaster(point.clone(), flat ? this.direction() : way.normalize(), 0, far);
    });
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
}
