// Poses and packed arrays as they come in JSON.

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes.buffer;
}

// A pose is a position and a quaternion (x, y, z, w).
function matrixOf(pose) {
  const [x, y, z, qx, qy, qz, qw] = pose;
  return new THREE.Matrix4().compose(
      new THREE.Vector3(x, y, z), new THREE.Quaternion(qx, qy, qz, qw).normalize(),
      new THREE.Vector3(1, 1, 1));
}

function vectorOf(numbers) {
  return new THREE.Vector3(numbers[0], numbers[1], numbers[2]);
}

// Between two poses: straight, and turned the short way.
function matrixBetween(a, b, part) {
  const [from, to] = [a, b].map(
      ([x, y, z, qx, qy, qz,
        qw]) => [new THREE.Vector3(x, y, z), new THREE.Quaternion(qx, qy, qz, qw).normalize()]);
  return new THREE.Matrix4().compose(
      from[0].lerp(to[0], part), from[1].slerp(to[1], part), new THREE.Vector3(1, 1, 1));
}
