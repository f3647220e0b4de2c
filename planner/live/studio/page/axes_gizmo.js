// The axes of the world in a corner of the stage, as the camera sees them: a click on the end of
// one looks from there.

const axisEnds = [
  ['x', 'right', [1, 0, 0]],
  ['y', 'back', [0, 1, 0]],
  ['z', 'above', [0, 0, 1]],
  ['−x', 'left', [-1, 0, 0]],
  ['−y', 'front', [0, -1, 0]],
  ['−z', 'below', [0, 0, -1]],
];

class AxesGizmo {
  constructor(box, stage) {
    this.stage = stage;
    this.lines = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
    this.lines.setAttribute('viewBox', '-1 -1 2 2');
    this.ends = axisEnds.map(([name, from, direction], i) => {
      const color = data.palette.axes[i % 3];
      const plain = name.length === 1;
      const node = button(plain ? name : '', () => stage.turnTo(vectorOf(direction)), {
        title: `from ${from} (${name})`,
        'aria-label': `look from ${from}`,
        'data-from': from,
      });
      node.style.borderColor = color;
      if (plain) paint(node, color);
      return {node, direction: vectorOf(direction), line: plain ? this.lineOf(color) : null};
    });
    box.replaceChildren(this.lines, ...this.ends.map(({node}) => node));
    stage.listeners.push(() => this.follow());
  }

  lineOf(color) {
    const line = document.createElementNS('http://www.w3.org/2000/svg', 'line');
    line.setAttribute('stroke', color);
    line.setAttribute('stroke-width', 0.05);
    this.lines.append(line);
    return line;
  }

  // The nearest end lies on top.
  follow() {
    const turn = this.stage.camera.quaternion;
    if (this.turn && this.turn.equals(turn)) return;
    this.turn = turn.clone();
    for (const {node, direction, line} of this.ends) {
      const {x, y, z} = direction.clone().applyQuaternion(turn.clone().inverse());
      node.style.left = `${50 + 39 * x}%`;
      node.style.top = `${50 - 39 * y}%`;
      node.style.zIndex = Math.round(10 + 9 * z);
      if (!line) continue;
      line.setAttribute('x2', 0.78 * x);
      line.setAttribute('y2', -0.78 * y);
    }
  }
}
