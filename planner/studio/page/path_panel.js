// The grasp in hand improved, and the robot's way to it played.

class PathPanel {
  constructor(stage, live) {
    this.stage = stage;
    this.live = live;
    this.path = null;
    this.playing = false;
    byId('refine').addEventListener('click', () => this.refine());
    byId('path').addEventListener('click', () => this.plan());
    byId('path-play').addEventListener('click', () => this.toggle());
    byId('path-time').addEventListener('input', () => {
      this.stop();
      this.show(Number(byId('path-time').value));
    });
    live.on('state', () => this.forget());
    live.on('hand', () => this.forget());
  }

  async refine() {
    this.live.tell('said', 'refining…');
    const done = await this.live.ask('grasp.refine');
    if (!done) return;
    const words = done.improved ?
        `ε from ${numberText(done.epsilon_before)} to ${numberText(done.epsilon)}` :
        'nothing better nearby';
    this.live.tell('said', `${words} (${done.trials} trials)`);
  }

  async plan() {
    this.live.tell('said', 'looking for a path…');
    const found = await this.live.ask('path.plan');
    if (!found) return;
    this.live.tell('said', found.problem || `a path of ${this.endOf(found).toFixed(1)} s`);
    if (found.status !== 'found' || found.samples.length === 0) return;
    this.path = found;
    byId('path-player').hidden = false;
    byId('path-time').max = this.endOf(found);
    this.play();
  }

  endOf({samples}) {
    return samples.length > 0 ? samples[samples.length - 1].time : 0;
  }

  // A path is about the grasp that it was planned for.
  forget() {
    if (!this.path) return;
    this.stop();
    this.path = null;
    byId('path-player').hidden = true;
  }

  toggle() {
    if (this.playing) {
      this.stop();
    } else {
      this.play();
    }
  }

  stop() {
    this.playing = false;
    byId('path-play').textContent = 'play';
  }

  play() {
    this.playing = true;
    byId('path-play').textContent = 'pause';
    const end = this.endOf(this.path);
    let time = Number(byId('path-time').value);
    if (time >= end) time = 0;
    let last = null;
    const step = (now) => {
      if (!this.playing) return;
      time = Math.min(end, time + (last === null ? 0 : (now - last) / 1000));
      last = now;
      this.show(time);
      if (time >= end) {
        this.stop();
      } else {
        requestAnimationFrame(step);
      }
    };
    requestAnimationFrame(step);
  }

  // Draws the robot as it is at a time of the path; the session stays where it is.
  show(time) {
    const {samples, segments} = this.path;
    byId('path-time').value = time;
    let i = samples.findIndex((sample) => sample.time >= time);
    if (i < 0) i = samples.length - 1;
    const [a, b] = [samples[Math.max(0, i - 1)], samples[i]];
    const span = b.time - a.time;
    const part = span > 0 ? (time - a.time) / span : 1;
    const joints = b.joints.map((value, j) => a.joints[j] + part * (value - a.joints[j]));
    const between = (from, to) => matrixBetween(listOfPose(from), listOfPose(to), part);
    this.stage.placeMoving({
      joints,
      hand: between(a.X_world_hand, b.X_world_hand),
      object: between(a.X_world_object, b.X_world_object),
    });
    const segment = segments.find(({last}) => i <= last);
    byId('path-moment').textContent = `${segment ? segment.name + ', ' : ''}${time.toFixed(2)} s`;
  }
}
