// The grasp in hand improved, and the robot's way to it played.

class PathPanel {
  constructor(stage, live) {
    this.stage = stage;
    this.live = live;
    this.path = null;
    this.asked = false;  // this page has asked for the path that is looked for
    this.player = new Player((time) => this.show(time), (playing) => {
      byId('path-play').textContent = playing ? 'pause' : 'play';
    });
    byId('refine').addEventListener('click', () => this.refine());
    byId('path').addEventListener('click', () => this.plan());
    byId('path-play').addEventListener('click', () => this.toggle());
    byId('path-time').addEventListener('input', () => {
      if (!this.path) return;
      this.player.stop();
      this.show(Number(byId('path-time').value));
    });
    live.on('path', (event) => this.end(event));
    live.on('play', (grasp) => this.take(grasp));
    live.on('state', (state) => {
      byId('path').disabled = state.planning || state.finding_path;
      if (this.path && state.revision !== this.path.revision) this.forget();
    });
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
    this.asked = await this.live.ask('path.plan') !== null;
    if (this.asked) this.live.tell('said', 'looking for a path…');
  }

  async end({status, problem}) {
    if (!this.asked) return;
    this.asked = false;
    if (status === 'cancelled' || status === 'failed') {
      this.live.tell('said', `no path: ${problem || status}`);
    } else {
      await this.take();
    }
  }

  // Plays the path that was found, or that of a result.
  async take(grasp) {
    const found = await this.live.ask('path.result', grasp === undefined ? {} : {grasp});
    if (!found) return;
    this.live.tell('said', found.problem || `a path of ${this.endOf(found).toFixed(1)} s`);
    if (found.status !== 'found' || found.samples.length === 0) return;
    this.forget();
    this.path = {...found, motion: this.motionOf(found), revision: this.live.state.revision};
    byId('path-player').hidden = false;
    byId('path-time').max = this.endOf(found);
    this.play();
  }

  endOf({samples}) {
    return samples.length > 0 ? samples[samples.length - 1].time : 0;
  }

  motionOf({samples}) {
    return {
      times: samples.map(({time}) => time),
      rows: samples.map(({joints}) => joints),
      hands: samples.map(({X_world_hand}) => listOfPose(X_world_hand)),
      objects: samples.map(({X_world_object}) => listOfPose(X_world_object)),
    };
  }

  // A path is about the grasp that it was planned for.
  forget() {
    if (!this.path) return;
    this.player.stop();
    this.path = null;
    byId('path-player').hidden = true;
  }

  toggle() {
    if (this.player.playing) {
      this.player.stop();
    } else {
      this.play();
    }
  }

  play() {
    if (!this.path) return;
    const time = Number(byId('path-time').value);
    const end = this.endOf(this.path);
    this.player.play(time >= end ? 0 : time, end);
  }

  // Draws the robot as it is at a time of the path; the session stays where it is.
  show(time) {
    if (!this.path) return;
    const {motion, segments} = this.path;
    byId('path-time').value = time;
    this.stage.placeMoving({
      joints: motionRow(motion, time),
      hand: poseAt(motion.times, motion.hands, time),
      object: poseAt(motion.times, motion.objects, time),
    });
    const segment = segments.find(({last}) => time <= motion.times[last]);
    byId('path-moment').textContent = `${segment ? segment.name + ', ' : ''}${time.toFixed(2)} s`;
  }
}
