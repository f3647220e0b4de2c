// The stage lies under the panels: cameras look so that what they aim at is in the middle of the
// part that none of them covers.

class Framing {
  // `free`: an empty element where the page has its uncovered part.
  constructor(canvas, free, changed) {
    this.canvas = canvas;
    this.free = free;
    new ResizeObserver(changed).observe(free);
  }

  // The uncovered part on the canvas [pixels of the page]; all of it where panels leave nothing.
  box() {
    const all = this.canvas.getBoundingClientRect();
    const {left, top, width, height} = this.free.getBoundingClientRect();
    if (width < 50 || height < 50) return {x: 0, y: 0, width: all.width, height: all.height};
    return {x: left - all.left, y: top - all.top, width, height};
  }

  // Shifts pictures, without turning them: also what is off the middle is seen as before.
  shift(cameras) {
    const {width, height} = this.canvas.getBoundingClientRect();
    if (!(width > 0 && height > 0)) return;
    const box = this.box();
    const aside = width / 2 - (box.x + box.width / 2);
    const above = height / 2 - (box.y + box.height / 2);
    for (const camera of cameras) camera.setViewOffset(width, height, aside, above, width, height);
  }

  // Moves the camera to where the points fill the uncovered part, as aim() does for the whole
  // picture; answers what it looks at.
  aim(camera, points, direction) {
    const {height} = this.canvas.getBoundingClientRect();
    const box = this.box();
    const part = height > 0 ? box.height / height : 1;
    const tall = Math.tan(camera.fov / 2 * Math.PI / 180) * part;
    const own = new THREE.PerspectiveCamera(
        2 * Math.atan(tall) * 180 / Math.PI, box.width / Math.max(box.height, 1));
    own.up.copy(camera.up);
    const target = aim(own, points, direction);
    camera.position.copy(own.position);
    camera.far = own.far;
    return target;
  }
}

// The direction from which a grasp tells most: across the plane in which the hand moves on and
// closes, so that neither hides the other. Of its two sides the one that is nearer to where one
// looks from, and not from below, where something may stand under the object; a little from where
// the hand goes to, as the arm is on the other side.
function tellingSide({approach, closing}, X_WH, from) {
  const along = vectorOf(approach).transformDirection(X_WH);
  const side = vectorOf(closing).transformDirection(X_WH).cross(along);
  const upright = Math.abs(side.z) > Math.hypot(side.x, side.y);
  if (upright ? side.z < 0 : side.dot(from) < 0) side.negate();
  side.addScaledVector(along, 0.3);
  side.z = Math.max(side.z, 0.35 * Math.hypot(side.x, side.y));
  return side.normalize();
}
