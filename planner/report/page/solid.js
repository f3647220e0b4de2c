// Surfaces as three.js draws them.

const creaseCosine = Math.cos(0.6);

// Corners of triangles get the mean normal of the faces around them that lean little, so that round
// surfaces look round and edges sharp; `least` is the cosine of how much they may lean.
function creasedGeometry(positions, indices, least = creaseCosine) {
  const count = indices.length / 3;
  const normals = [];
  const around = Array.from({length: positions.length / 3}, () => []);
  const corner = (i) => new THREE.Vector3().fromArray(positions, 3 * i);
  for (let t = 0; t < count; ++t) {
    const a = corner(indices[3 * t]);
    const normal = corner(indices[3 * t + 1]).sub(a).cross(corner(indices[3 * t + 2]).sub(a));
    normals.push({sum: normal, unit: normal.clone().normalize()});
    for (let k = 0; k < 3; ++k) around[indices[3 * t + k]].push(t);
  }
  const out = new Float32Array(9 * count);
  const outNormals = new Float32Array(9 * count);
  const mean = new THREE.Vector3();
  for (let t = 0; t < count; ++t) {
    for (let k = 0; k < 3; ++k) {
      const vertex = indices[3 * t + k];
      mean.set(0, 0, 0);
      for (const other of around[vertex]) {
        if (other === t || normals[other].unit.dot(normals[t].unit) > least) {
          mean.add(normals[other].sum);
        }
      }
      mean.normalize();
      mean.toArray(outNormals, 9 * t + 3 * k);
      for (let i = 0; i < 3; ++i) out[9 * t + 3 * k + i] = positions[3 * vertex + i];
    }
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(out, 3));
  geometry.setAttribute('normal', new THREE.BufferAttribute(outNormals, 3));
  return geometry;
}

function meshGeometry(mesh) {
  return creasedGeometry(
      new Float32Array(bytesOf(mesh.positions)), new Uint32Array(bytesOf(mesh.indices)));
}

// A surface that can be seen through shows its far side first, then its near side.
function solid(geometry, color, opacity = 1) {
  const sides = opacity < 1 ? [THREE.BackSide, THREE.FrontSide] : [THREE.DoubleSide];
  const group = new THREE.Group();
  sides.forEach((side, i) => {
    const material = new THREE.MeshPhongMaterial({
      color,
      side,
      specular: 0x222222,
      shininess: 25,
      transparent: opacity < 1,
      opacity: opacity < 1 && i === 0 ? opacity / 2 : opacity,
      depthWrite: opacity >= 1,
    });
    const part = new THREE.Mesh(geometry, material);
    part.renderOrder = opacity < 1 ? 10 + i : 0;
    group.add(part);
  });
  return group;
}

function outlined(geometry, group, color, opacity, leastAngle = 32) {
  const edges = new THREE.EdgesGeometry(geometry, leastAngle);
  const lines = new THREE.LineSegments(
      edges, new THREE.LineBasicMaterial({color, transparent: opacity < 1, opacity}));
  lines.renderOrder = 12;
  group.add(lines);
  return group;
}

// Frees what the graphics card holds of a group that is not shown again.
function dispose(group) {
  group.traverse((node) => {
    if (node.geometry) node.geometry.dispose();
    if (node.material) node.material.dispose();
  });
}
