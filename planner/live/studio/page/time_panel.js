// The scene in motion: played, paused, made step by step, with the forces of contacts, curves over
// time, and a spring that pulls the object where the pointer drags it.

const longestStep = 0.05;    // s that one request asks for
const pullStiffness = 60;    // N/m of the spring of the pointer
const momentsOfCurves = 30;  // ms between samples of curves

class TimePanel {
  constructor(stage, live, measure) {
    this.stage = stage;
    this.live = live;
    this.measure = measure;
    this.running = false;
    this.pulled = null;
    this.forces = new THREE.Group();
    stage.scene.add(this.forces);
    this.plots = [
      {name: 'height of the object', unit: 'm', of: ({object}) => object.position[2]},
      {name: 'speed of the object', unit: 'm/s', of: ({velocity}) => Math.hypot(...velocity)},
      {name: 'sum of contact forces on the object', unit: 'N', of: ({force}) => force},
    ];
    for (const plot of this.plots) {
      plot.canvas = element('canvas', {class: 'plot', 'aria-label': plot.name, role: 'img'});
      plot.curve = new Plot(plot.canvas);
    }
    byId('plots').replaceChildren(...this.plots.map(
        ({name, canvas}) => element('figure', {}, element('figcaption', {}, name), canvas)));
    byId('time-play').addEventListener('click', () => this.toggle());
    byId('time-step').addEventListener('click', () => this.single());
    byId('time-reset').addEventListener('click', () => this.reset());
    byId('time-stop').addEventListener('click', () => this.end(false));
    byId('time-keep').addEventListener('click', () => this.end(true));
    live.on('state', (state) => this.follow(state));
    this.listenToPulls();
  }

  follow({time}) {
    const there = Boolean(time);
    for (const id of ['time-reset', 'time-stop', 'time-keep']) byId(id).disabled = !there;
    if (!there && this.there) this.clear();
    this.there = there;
  }

  clear() {
    this.running = false;
    byId('time-play').textContent = 'play';
    byId('time-now').textContent = '';
    for (const {curve, unit} of this.plots) {
      curve.clear();
      curve.draw(unit);
    }
    this.clearForces();
  }

  clearForces() {
    dispose(this.forces);
    this.forces.remove(...this.forces.children);
  }

  // Answers whether there is a moving world.
  async begin() {
    if (this.there) return true;
    const begun = await this.live.ask('time.start', {gravity: byId('time-gravity').checked});
    this.there = begun !== null;
    return this.there;
  }

  async toggle() {
    if (this.running) {
      this.running = false;
      byId('time-play').textContent = 'play';
      return;
    }
    if (!await this.begin()) return;
    this.running = true;
    byId('time-play').textContent = 'pause';
    let last = performance.now();
    while (this.running) {
      const now = await new Promise((done) => requestAnimationFrame(done));
      const seconds = Number(byId('time-speed').value) * (now - last) / 1000;
      last = now;
      // The first frame may have begun before the clock was read.
      if (!(seconds > 0)) continue;
      if (!await this.advance(Math.min(seconds, longestStep))) this.running = false;
    }
    byId('time-play').textContent = 'play';
  }

  async single() {
    if (await this.begin()) await this.advance(0.0025);
  }

  async advance(seconds) {
    const done = await this.live.ask('time.step', {seconds});
    if (!done) return false;
    await this.show(done);
    return true;
  }

  async reset() {
    const done = await this.live.ask('time.reset');
    if (!done) return;
    for (const {curve} of this.plots) curve.clear();
    await this.show(done);
  }

  async end(keep) {
    this.running = false;
    await this.live.ask('time.stop', {keep});
    this.clear();
  }

  async show(moment) {
    const {time, X_world_object, X_world_hand, joints, velocity} = moment;
    byId('time-now').textContent = `${time.toFixed(3)} s`;
    this.stage.placeMoving({
      joints,
      hand: matrixOfPose(X_world_hand),
      object: matrixOfPose(X_world_object),
    });
    const sum = await this.showForces();
    const now = performance.now();
    if (this.drawn !== undefined && now - this.drawn < momentsOfCurves) return;
    this.drawn = now;
    for (const {curve, of, unit} of this.plots) {
      curve.add(time, of({object: X_world_object, velocity: velocity || [0, 0, 0], force: sum}));
      curve.draw(unit);
    }
  }

  // Arrows of the forces on the object; answers the sum of their sizes.
  async showForces() {
    this.clearForces();
    if (!byId('time-forces').checked) return 0;
    const found = await this.live.ask('time.contacts');
    if (!found) return 0;
    const {name} = this.live.state.object;
    const onObject = found.contacts.filter(({bodies}) => bodies[0] === name);
    const forces = onObject.map(
        (contact) =>
            ({at: vectorOf(contact.position_world), force: vectorOf(contact.force_world)}));
    const sizes = forces.map(({force}) => force.length());
    const scale = forceScale * radius / Math.max(...sizes, 1e-9);
    for (const {at, force} of forces) {
      const along = force.multiplyScalar(scale);
      if (along.length() < 0.02 * radius) continue;
      this.forces.add(arrow(at.sub(along), along, 0.025 * radius, forceMaterial));
    }
    this.stage.requestDraw();
    return sizes.reduce((sum, size) => sum + size, 0);
  }

  // A drag that begins on the object pulls at that point while time runs.
  listenToPulls() {
    const area = this.stage.canvas.parentElement;
    const pull = new Coalescer((to) => this.pull(to));
    area.addEventListener('pointerdown', (event) => {
      if (!this.running || event.button !== 0 || this.measure.active) return;
      const hit = this.stage.pick(event);
      if (!hit || hit.body !== 'object') return;
      event.preventDefault();
      event.stopPropagation();
      this.stage.controls.enabled = false;
      const {group} = this.stage.bodies.get('object');
      const own = group.worldToLocal(hit.point.clone());
      const plane =
          new THREE.Plane().setFromNormalAndCoplanarPoint(this.stage.direction(), hit.point);
      this.pulled = {own, plane};
    }, true);
    window.addEventListener('pointermove', (event) => {
      if (!this.pulled) return;
      const to = this.stage.ray(event).ray.intersectPlane(this.pulled.plane, new THREE.Vector3());
      if (to) pull.ask(to);
    });
    window.addEventListener('pointerup', () => {
      if (!this.pulled) return;
      this.pulled = null;
      this.stage.controls.enabled = true;
      pull.ask(null);
    });
  }

  async pull(to) {
    if (!this.there) return;
    if (to === null || !this.pulled) {
      await this.live.ask('time.pull');
      return;
    }
    await this.live.ask('time.pull', {
      point_object: this.pulled.own.toArray(),
      to_world: to.toArray(),
      stiffness: pullStiffness,
    });
  }
}
