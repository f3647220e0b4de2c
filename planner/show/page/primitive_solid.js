// The primitives that an object is taken for, drawn and in words.

// A distance in mm, to a hundredth of one.
function millimetres(distance) {
  return String(Number((1000 * distance).toFixed(2)));
}

// How far the surface is from what describes it; `which`: that surface.
function distanceWords({median, percentile_95}, which) {
  return `half of ${which} within ${millimetres(median)} mm, 95 % within ${
      millimetres(percentile_95)} mm`;
}

// A rim or a bar: its curve as a tube, as wide as it is.
function tubeGeometry(curve) {
  const points = curve.points.map((point) => new THREE.Vector3(...point));
  const line = new THREE.CatmullRomCurve3(points, curve.closed);
  return new THREE.TubeBufferGeometry(line, 4 * points.length, 0.5 * curve.width, 12, curve.closed);
}

function primitiveSolid(primitive, look = data.palette.primitive) {
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
  const group = solid(geometry, look);
  if (primitive.shape !== 'sphere' && !primitive.points) outlined(geometry, group, look);
  group.applyMatrix(matrixOf(primitive.X));
  return group;
}
