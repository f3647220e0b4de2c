// A view in three dimensions on a canvas: renderer, lights, camera, controls, and when it draws.
// Pages derive from it what they show.

const lampDirection = new THREE.Vector3(-0.4, 0.7, 1);  // towards it, in the camera's axes

class View3d {
  // `alpha`: whether pictures without a background can be made.
  constructor(canvas, {alpha = false} = {}) {
    this.canvas = canvas;
    this.renderer = new THREE.WebGLRenderer({canvas, antialias: true, alpha});
    this.resolution = new AdaptiveResolution(() => this.requestDraw());
    this.scene = new THREE.Scene();
    this.scene.background = new THREE.Color('#ffffff');
    this.perspective = new THREE.PerspectiveCamera(34, 1, 0.005, 100);
    this.perspective.up.set(0, 0, 1);
    this.camera = this.perspective;
    this.light();
    this.controls = new THREE.OrbitControls(this.camera, canvas);
    this.controls.enableKeys = false;
    this.controls.addEventListener('change', () => this.requestDraw());
    this.listeners = [];  // called after each picture
    this.requested = false;
  }

  light() {
    this.lamp = new THREE.DirectionalLight(0xffffff, 0.42);
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x8a8a94, 0.62), this.lamp);
  }

  // From behind the viewer, so that what is looked at is lit.
  lightFrom(camera) {
    this.lamp.position.copy(lampDirection).applyQuaternion(camera.quaternion);
  }

  // To be called by the derived class once it has what it draws.
  followSize() {
    new ResizeObserver(() => this.resize()).observe(this.canvas.parentElement);
    this.resize();
  }

  resize() {
    const box = this.canvas.parentElement.getBoundingClientRect();
    if (!(box.width > 0 && box.height > 0)) return;
    this.renderer.setSize(box.width, box.height, false);
    this.perspective.aspect = box.width / box.height;
    this.perspective.updateProjectionMatrix();
    this.resized();
    this.draw();  // at once: a new size leaves the canvas empty
  }

  // For derived classes with more to adapt.
  resized() {}

  // Unit, from what is looked at to the eye.
  direction() {
    return this.camera.position.clone().sub(this.controls.target).normalize();
  }

  // The ray of sight through the point of the page where an event is.
  ray(event) {
    const box = this.canvas.getBoundingClientRect();
    const at = new THREE.Vector2(
        (event.clientX - box.left) / box.width * 2 - 1,
        1 - (event.clientY - box.top) / box.height * 2);
    const caster = new THREE.Raycaster();
    this.camera.updateMatrixWorld();
    caster.setFromCamera(at, this.camera);
    return caster;
  }

  // Draws once before the next repaint, however often it is asked.
  requestDraw() {
    if (this.requested) return;
    this.requested = true;
    this.tellState();
    requestAnimationFrame((now) => {
      this.requested = false;
      const ratio = this.resolution.next(now);
      if (ratio !== this.renderer.getPixelRatio()) this.renderer.setPixelRatio(ratio);
      this.draw();
    });
  }

  draw() {
    this.lightFrom(this.camera);
    this.renderer.render(this.scene, this.camera);
    this.tell();
    this.tellState();
  }

  tell() {
    for (const listener of this.listeners) listener();
  }

  // The attribute data-drawn of the canvas: "stale" while what it shows is older than what was
  // asked for, "coarse" while a finer picture is to come, else "fine". Tests wait for it.
  tellState() {
    this.canvas.dataset.drawn = this.requested ? 'stale' :
        this.resolution.coarse()               ? 'coarse' :
                                                 'fine';
  }
}
