// Lets time run as fast as it does, from frame to frame.

class Player {
  // `show(time)` draws a moment; `changed(playing)` is told when playing begins and ends.
  constructor(show, changed) {
    this.show = show;
    this.changed = changed;
    this.playing = false;
  }

  stop() {
    this.playing = false;
    this.changed(false);
  }

  play(begin, end) {
    this.playing = true;
    this.changed(true);
    let time = begin;
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
}
