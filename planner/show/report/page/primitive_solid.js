// The primitives that grasps were made of.

// A rim or a bar: its curve as a tube, as wide as it is.
function tubeGeometry(curve) {
  const points = curve.points.map((point) => new THREE.Vector3(...point));
  const line = new THREE.CatmullRomCurve3(points, curve.closed);
  return new THREE.TubeBufferGeometry(line, 4 * points.length, 0.5 * curve.width, 12, curve.closed);
}

function primitiveSolid(primitive) {
  let geometry;
  if (primitive.shape === 'box') {
    geometry = new THREE.BoxBufferGeometry(...primitive.size);
  } else if (primitive.shape === 'sphere') {
    geometry = new THREE.SphereBufferGeometry(primitive.radius, 32, 20);
  } else if (primitive.points) {
    geometry = tubeGeometry(primitive);
  } else {
    const [high, low] = primitive.shape === 'cone' ? [primitive.radius_high, primitive.radius_low] :
                                                     [primitive.radius, primitive.radius];
    geometry = new THREE.CylinderBufferGeometry(high, low, primitive.height, 40);
    geometry.rotateX(Math.PI / 2);
  }
  const group = solid(geometry, data.palette.primitive);
  if (primitive.shape !== 'sphere' && !primitive.points)
    outlined(geometry, group, data.palette.primitive);
  group.applyMatrix(matrixOf(primitive.X));
  return group;
}
