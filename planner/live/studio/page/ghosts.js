// Marks of a grasp lie inside of the object, or behind the hand: there they are seen faintly.

const ghosts = new Map();  // materials by those that they stand for

function ghostOf(material) {
  if (!ghosts.has(material)) {
    const ghost = material.clone();
    Object.assign(
        ghost, {transparent: true, opacity: 0.4, depthFunc: THREE.GreaterDepth, depthWrite: false});
    ghosts.set(material, ghost);
  }
  return ghosts.get(material);
}

// Draws each mesh of the group a second time, where something hides it.
function addGhosts(group) {
  const meshes = [];
  group.traverse((node) => {
    if (node.isMesh) meshes.push(node);
  });
  for (const mesh of meshes) {
    const ghost = new THREE.Mesh(mesh.geometry, ghostOf(mesh.material));
    ghost.renderOrder = 5;
    mesh.add(ghost);
  }
}
