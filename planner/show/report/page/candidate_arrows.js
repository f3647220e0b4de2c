// All candidates as slender cones that point along their approach, coloured by outcome. They are
// one mesh: thousands of separate objects would draw too slowly.

class CandidateArrows {
  constructor() {
    this.group = new THREE.Group();
    this.material =
        new THREE.MeshBasicMaterial({vertexColors: THREE.VertexColors, side: THREE.DoubleSide});
    this.shown = [];
  }

  // Shows the candidates whose outcome (an index) is in the set.
  show(outcomes) {
    dispose(this.group);
    this.group.remove(...this.group.children);
    this.shown = data.candidates.rows.filter((row) => outcomes.has(row[6]));
    const positions = [];
    const colors = [];
    for (const row of this.shown) {
      const color = new THREE.Color(data.palette.outcomes[data.outcomes[row[6]].name]);
      this.addArrow(row, positions);
      for (let i = 0; i < 9; ++i) colors.push(color.r, color.g, color.b);
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute(positions, 3));
    geometry.setAttribute('color', new THREE.Float32BufferAttribute(colors, 3));
    this.group.add(new THREE.Mesh(geometry, this.material));
  }

  // A cone of three sides, with its tip where the hand was aimed. Rows are described in
  // report_json.cpp.
  addArrow(row, positions) {
    const tip = vectorOf(row);
    const along = new THREE.Vector3(row[3], row[4], row[5]);
    const back = tip.clone().addScaledVector(along, -0.16 * radius);
    const aside = new THREE.Vector3(0, 0, 1).cross(along);
    if (aside.length() < 0.1) aside.set(1, 0, 0).cross(along);
    aside.setLength(0.02 * radius);
    const other = along.clone().cross(aside).setLength(0.02 * radius);
    const corners = [0, 1, 2].map(
        (k) => back.clone()
                   .addScaledVector(aside, Math.cos(k * 2.0944))
                   .addScaledVector(other, Math.sin(k * 2.0944)));
    for (let k = 0; k < 3; ++k) {
      for (const p of [tip, corners[k], corners[(k + 1) % 3]]) positions.push(p.x, p.y, p.z);
    }
  }

  // Outcome and blame of the candidate whose arrow has this triangle; each arrow has three.
  words(triangle) {
    const row = this.shown[Math.floor(triangle / 3)];
    const blame = data.candidates.blames[row[7]];
    return data.outcomes[row[6]].name + (blame ? ': ' + blame : '');
  }
}
