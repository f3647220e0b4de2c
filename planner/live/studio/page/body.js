// The object or an obstacle as it is drawn: opaque, or seen through.

const mostKept = 3;  // opacities that a body is kept ready in

// "object" or "obstacle".
function kindOf(key) {
  return key.split(' ')[0];
}

class Body {
  // `key`: by which the stage knows the body; `surface`: the name of its surface in the session.
  constructor(key, surface, geometry) {
    this.key = key;
    this.surface = surface;
    this.geometry = geometry;
    this.group = new THREE.Group();
    this.opacity = null;
    this.drawn = new Map();  // by opacity
  }

  // Answers whether anything has been made that was not there before.
  show(opacity) {
    if (opacity === this.opacity) return false;
    this.opacity = opacity;
    this.group.remove(...this.group.children);
    const known = this.drawn.get(opacity);
    if (!known) this.make(opacity);
    this.group.add(this.drawn.get(opacity));
    this.group.updateMatrixWorld(true);
    return !known;
  }

  make(opacity) {
    if (this.drawn.size >= mostKept) {
      for (const old of this.drawn.values()) {
        old.traverse(({material}) => material && material.dispose());
      }
      this.drawn.clear();
    }
    const kind = kindOf(this.key);
    const look = {...data.palette[kind], opacity};
    const drawn = outlined(this.geometry, solid(this.geometry, look), look);
    drawn.traverse((node) => {
      node.userData.body = this.key;
    });
    // Obstacles reach too far for a shadow that is fine enough for fingers.
    takesPartInShadows(drawn, kind === 'object');
    this.drawn.set(opacity, drawn);
  }

  // Whether it crosses one of the rays.
  hides(rays) {
    return rays.some(
        (ray) => ray.intersectObject(this.group, true).some(({object}) => object.isMesh));
  }
}
