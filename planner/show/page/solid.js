// Surfaces as three.js draws them.

const creaseCosine = Math.cos(0.6);

// A geometry shaded smoothly but for sharp edges: each corner of a triangle gets the mean normal of
// the faces around its vertex that lean less than a crease angle from the triangle, weighted by
// area (the length of their cross products). `least` is the cosine of that angle.
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

// A thin shell is denser where it is seen at an angle: as in pictures
// (planner/show/picture/tile.cpp), its opacity is that of its look where it faces the viewer.
function drawAsShell(material) {
  const plain = 'gl_FragColor = vec4( outgoingLight, diffuseColor.a );';
  const dense = 'float facing = max(0.3, abs(dot(normal, normalize(vViewPosition))));' +
      'gl_FragColor = vec4(outgoingLight, 1.0 - pow(1.0 - diffuseColor.a, 1.0 / facing));';
  material.onBeforeCompile = (shader) => {
    shader.fragmentShader = shader.fragmentShader.replace(plain, dense);
  };
}

// A surface in a look of the palette. One that can be seen through shows its far side first, half
// as dense, then its near side.
function solid(geometry, {color, opacity}) {
  const translucent = opacity < 1;
  const sides = translucent ? [THREE.BackSide, THREE.FrontSide] : [THREE.DoubleSide];
  const group = new THREE.Group();
  sides.forEach((side, i) => {
    const material = new THREE.MeshPhongMaterial({
      color,
      side,
      specular: 0x222222,
      shininess: 25,
      transparent: translucent,
      opacity: translucent && i === 0 ? opacity / 2 : opacity,
      depthWrite: !translucent,
    });
    if (translucent) drawAsShell(material);
    const part = new THREE.Mesh(geometry, material);
    part.renderOrder = translucent ? 10 + i : 0;
    group.add(part);
  });
  return group;
}

const lineBrightness = 0.12;  // of the light from the surface, as in planner/show/picture/draw.cpp

// Adds dark lines along the edges at which faces meet at more than `leastAngle` (degrees); on what
// can be seen through they are faint as well.
function outlined(geometry, group, {color, opacity}, leastAngle = 32) {
  const dark = new THREE.Color(color).convertSRGBToLinear().multiplyScalar(lineBrightness);
  const material = new THREE.LineBasicMaterial(
      {color: dark.convertLinearToSRGB(), transparent: opacity < 1, opacity: Math.sqrt(opacity)});
  const lines = new THREE.LineSegments(new THREE.EdgesGeometry(geometry, leastAngle), material);
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
