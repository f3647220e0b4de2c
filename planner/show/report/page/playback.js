// Plays the motion to a grasp: approach and closing, and the arm's path where there is one, which
// may go on with the object in the hand.

class Playback {
  constructor(view) {
    this.view = view;
    this.time = 0;
    this.player = new Player((time) => this.seek(time, true), (playing) => {
      this.button.textContent = playing ? '❚❚ pause' : '▶ play';
    });
    this.button = element('button', {type: 'button', onclick: () => this.toggle()}, '▶ play');
    this.slider = element('input', {
      type: 'range',
      min: 0,
      max: 1000,
      value: 1000,
      id: 'slider',
      'aria-label': 'time',
      oninput: () => this.seek(this.slider.value / 1000 * this.end()),
    });
    this.output = element('output', {id: 'moment'});
    fill('playback', this.button, this.slider, this.output);
  }

  motion() {
    return this.view.grasp ? this.view.grasp.motion : null;
  }

  end() {
    const {times} = this.motion();
    return times[times.length - 1];
  }

  // When the object is grasped; from there on the hand carries it.
  graspTime() {
    const {times, grasp} = this.motion();
    return times[grasp];
  }

  // A new grasp starts as a grasp.
  reset() {
    this.stop();
    const motion = this.motion();
    byId('playback').hidden = !motion || motion.times.length < 2;
    if (!byId('playback').hidden) this.seek(this.graspTime(), true);
  }

  seek(time, fromOutside = false) {
    if (!fromOutside) this.stop();
    this.time = time;
    this.view.pose(time);
    const end = this.end();
    this.slider.value = end > 0 ? Math.round(1000 * time / end) : 1000;
    this.output.textContent = `${this.segment(time)}, ${time.toFixed(2)} s of ${end.toFixed(2)} s`;
  }

  segment(time) {
    const {times, segments} = this.motion();
    if (time === this.graspTime() && !this.motion().objects) return 'grasp';
    const current = segments.find((s) => time <= times[s.last]);
    return current ? current.name : '';
  }

  toggle() {
    if (this.player.playing) {
      this.stop();
    } else {
      this.play();
    }
  }

  stop() {
    this.player.stop();
  }

  play() {
    if (!this.motion()) return;
    const again = this.time >= this.end() || this.time === this.graspTime();
    this.player.play(again ? 0 : this.time, this.end());
  }
}
