// Where a camera has to be to see what it should.

// Corners, in the world, of the bounding boxes of all meshes of the group; each box has the axes of
// its mesh.
function cornersOf(group) {
  const corners = [];
  group.traverse((node) => {
    if (!node.isMesh) return;
    if (!node.geometry.boundingBox) node.geometry.computeBoundingBox();
    const {min, max} = node.geometry.boundingBox;
    for (let k = 0; k < 8; ++k) {
      const corner =
          new THREE.Vector3(k & 1 ? max.x : min.x, k & 2 ? max.y : min.y, k & 4 ? max.z : min.z);
      corners.push(corner.applyMatrix4(node.matrixWorld));
    }
  });
  return corners;
}

// Moves the camera to the least distance at which all points are visible from the direction;
// returns the point that it looks at. The points are taken in the camera's axes: the target is the
// middle of their ranges, and each point at depth p[2] needs the distance at which it lies inside
// the field of view, reduced to 93 % for a margin.
function aim(camera, points, direction) {
  camera.position.copy(direction);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld(true);
  const axes = [0, 1, 2].map((i) => new THREE.Vector3().setFromMatrixColumn(camera.matrixWorld, i));
  const seen = points.map((p) => axes.map((axis) => p.dot(axis)));
  const middle = axes.map((_, i) => {
    const values = seen.map((p) => p[i]);
    return (Math.min(...values) + Math.max(...values)) / 2;
  });
  const tall = 0.93 * Math.tan(camera.fov / 2 * Math.PI / 180);
  let distance = 0;
  for (const p of seen) {
    const aside = Math.max(Math.abs(p[0] - middle[0]) / camera.aspect, Math.abs(p[1] - middle[1]));
    distance = Math.max(distance, p[2] - middle[2] + aside / tall);
  }
  const target = new THREE.Vector3();
  axes.forEach((axis, i) => target.addScaledVector(axis, middle[i]));
  camera.position.copy(target).addScaledVector(direction, distance);
  camera.near = distance / 100;
  camera.far = distance * 30;
  camera.updateProjectionMatrix();
  return target;
}
