// Cones, arrows and frames that are laid over the scene.

function towards(direction) {
  return new THREE.Quaternion().setFromUnitVectors(
      new THREE.Vector3(0, 1, 0), direction.clone().normalize());
}

// From its tip at the origin along +y, as wide as the slope says.
function coneAt(tip, axis, slope, length, material) {
  const geometry = new THREE.ConeBufferGeometry(slope * length, length, 24, 1, true);
  geometry.rotateX(Math.PI);
  geometry.translate(0, length / 2, 0);
  const cone = new THREE.Mesh(geometry, material);
  cone.position.copy(tip);
  cone.quaternion.copy(towards(axis));
  return cone;
}

function arrow(from, along, thickness, material) {
  const group = new THREE.Group();
  const length = along.length();
  if (!(length > 0)) return group;
  const head = Math.min(0.45 * length, 5 * thickness);
  const shaft = new THREE.CylinderBufferGeometry(thickness, thickness, length - head, 16);
  shaft.translate(0, (length - head) / 2, 0);
  const tip = new THREE.ConeBufferGeometry(2.4 * thickness, head, 20);
  tip.translate(0, length - head / 2, 0);
  group.add(new THREE.Mesh(shaft, material), new THREE.Mesh(tip, material));
  group.position.copy(from);
  group.quaternion.copy(towards(along));
  return group;
}

// Part of a ring about the axis, with a head that shows which way it turns (right hand).
function twist(center, axis, ringRadius, angle, thickness, material) {
  const group = new THREE.Group();
  if (!(angle > 0)) return group;
  const ring = new THREE.TorusBufferGeometry(ringRadius, thickness, 10, 40, angle);
  const head = new THREE.ConeBufferGeometry(2.8 * thickness, 7 * thickness, 16);
  head.translate(0, 3 * thickness, 0);
  head.rotateZ(angle);
  head.translate(ringRadius * Math.cos(angle), ringRadius * Math.sin(angle), 0);
  group.add(new THREE.Mesh(ring, material), new THREE.Mesh(head, material));
  group.position.copy(center);
  group.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), axis.clone().normalize());
  return group;
}

// A word that always faces the viewer.
function wordSprite(text, height, color) {
  const canvas = document.createElement('canvas');
  canvas.width = 128;
  canvas.height = 64;
  const pen = canvas.getContext('2d');
  pen.font = '600 44px sans-serif';
  pen.textAlign = 'center';
  pen.textBaseline = 'middle';
  pen.fillStyle = color;
  pen.fillText(text, 64, 32);
  const texture = new THREE.CanvasTexture(canvas);
  const sprite = new THREE.Sprite(
      new THREE.SpriteMaterial({map: texture, transparent: true, depthTest: false}));
  sprite.scale.set(2 * height, height, 1);
  sprite.renderOrder = 30;
  return sprite;
}

function frameAxes(length, name, axes = ['x', 'y', 'z']) {
  const group = new THREE.Group();
  axes.forEach((axis, i) => {
    const color = data.palette.axes[i];
    const along = new THREE.Vector3().setComponent(i, length);
    const material = new THREE.MeshBasicMaterial({color});
    group.add(arrow(new THREE.Vector3(), along, 0.02 * length, material));
    const word = wordSprite(axis, 0.22 * length, color);
    word.position.copy(along.multiplyScalar(1.15));
    group.add(word);
  });
  const word = wordSprite(name, 0.24 * length, '#444444');
  word.position.set(-0.1 * length, -0.1 * length, -0.1 * length);
  group.add(word);
  return group;
}
