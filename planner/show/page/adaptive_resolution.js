// Adapts the resolution: on a machine that draws slowly, coarser pictures while something moves,
// and full resolution at rest.

const slowFrame = 45;    // ms between pictures; above this the resolution is lowered
const restAfter = 250;   // ms without a new picture
const longPause = 1500;  // ms; pictures farther apart are not part of one motion
const coarsest = 0.35;   // lowest fraction of the resolution

class AdaptiveResolution {
  // `onRest` is called when nothing moves any more and the last picture was coarse.
  constructor(onRest) {
    this.onRest = onRest;
    this.part = 1;  // of the resolution, while something moves
    this.moving = false;
    this.last = -longPause;
  }

  // Whether a finer picture will follow the last one.
  coarse() {
    return this.moving && this.part < 1;
  }

  // To be called for each picture; answers the pixel ratio to draw it with.
  next(now) {
    const gap = now - this.last;
    this.last = now;
    const wasMoving = this.moving;
    this.moving = gap < longPause;
    if (wasMoving && this.moving && gap > slowFrame) {
      this.part = Math.max(coarsest, this.part * (gap > 2 * slowFrame ? 0.5 : 0.8));
    }
    clearTimeout(this.timer);
    if (this.coarse()) {
      this.timer = setTimeout(() => this.rest(), Math.max(restAfter, 2 * gap));
    }
    return Math.min(window.devicePixelRatio, 1.5) * (this.moving ? this.part : 1);
  }

  rest() {
    this.moving = false;
    this.last = -longPause;
    this.onRest();
  }
}
