// Small pictures of grasps, drawn with the main scene when they scroll into view.

class Thumbnails {
  constructor(view) {
    this.view = view;
    this.waiting = [];
    this.camera = view.camera.clone();
    this.renderer = new THREE.WebGLRenderer({antialias: true, preserveDrawingBuffer: true});
    this.watcher = new IntersectionObserver((entries) => {
      for (const entry of entries) {
        if (!entry.isIntersecting) continue;
        this.watcher.unobserve(entry.target);
        this.waiting.push(entry.target);
      }
      this.drawSome();
    }, {rootMargin: '150px'});
  }

  watch(canvas) {
    this.watcher.observe(canvas);
  }

  // One a frame, so that the page stays responsive.
  drawSome() {
    if (this.scheduled || this.waiting.length === 0) return;
    this.scheduled = true;
    requestAnimationFrame(() => {
      this.scheduled = false;
      this.draw(this.waiting.shift());
      this.drawSome();
    });
  }

  draw(canvas) {
    const {view} = this;
    const hidden = ['candidates', 'frames'].map((name) => view.layers[name]);
    const visible = hidden.map((layer) => layer.visible);
    hidden.forEach((layer) => {
      layer.visible = false;
    });
    view.borrow(() => this.drawGrasp(data.grasps[Number(canvas.dataset.grasp)], canvas));
    hidden.forEach((layer, i) => {
      layer.visible = visible[i];
    });
  }

  // Poses the scene for the picture and does not put it back.
  drawGrasp(grasp, canvas) {
    const {view} = this;
    view.show(grasp);
    this.renderer.setSize(canvas.width, canvas.height, false);
    this.camera.aspect = canvas.width / canvas.height;
    aim(this.camera, view.corners(false), view.telling());
    view.lightFrom(this.camera);
    this.renderer.render(view.scene, this.camera);
    canvas.getContext('2d').drawImage(this.renderer.domElement, 0, 0);
    canvas.dataset.drawn = 'fine';
  }
}
