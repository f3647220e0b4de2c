// A tape from one point of a surface to another.

class Measure {
  constructor(stage, tell) {
    this.stage = stage;
    this.tell = tell;
    this.active = false;
    this.points = [];
    this.group = new THREE.Group();
    stage.scene.add(this.group);
    stage.canvas.parentElement.addEventListener('pointerdown', (event) => this.take(event), true);
  }

  setActive(active) {
    this.active = active;
    this.points = [];
    this.draw();
    this.tell(active ? 'click two points' : '');
  }

  clear() {
    this.points = [];
    this.draw();
  }

  take(event) {
    if (!this.active || event.button !== 0) return;
    const hit = this.stage.pick(event);
    if (!hit) return;
    event.preventDefault();
    event.stopPropagation();
    if (this.points.length === 2) this.points = [];
    this.points.push(hit.point);
    this.draw();
    if (this.points.length === 2) {
      this.tell(`${numberText(1000 * this.points[0].distanceTo(this.points[1]), 4)} mm`);
    }
  }

  draw() {
    dispose(this.group);
    this.group.remove(...this.group.children);
    const material = new THREE.MeshBasicMaterial(
        {color: data.palette.pointed_at.color, depthTest: false, transparent: true});
    const thickness = 0.012 * radius;
    for (const point of this.points) {
      const ball = new THREE.Mesh(new THREE.SphereBufferGeometry(3 * thickness, 12, 8), material);
      ball.position.copy(point);
      this.group.add(ball);
    }
    if (this.points.length === 2) {
      const along = this.points[1].clone().sub(this.points[0]);
      this.group.add(arrow(this.points[0], along, thickness, material));
    }
    this.group.traverse((node) => {
      node.renderOrder = 35;
    });
    this.stage.requestDraw();
  }
}
