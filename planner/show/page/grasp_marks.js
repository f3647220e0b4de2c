// The marks of one grasp in the object's frame: contacts, weakest disturbance.

const coneLength = 0.22;  // of the radius
const arrowLength = 1.1;

const contactMaterial = new THREE.MeshPhongMaterial({
  color: data.palette.contact.color,
  side: THREE.DoubleSide,
  specular: 0x111111,
});
const litMaterial =
    new THREE.MeshBasicMaterial({color: data.palette.pointed_at.color, side: THREE.DoubleSide});
const weakestMaterial = new THREE.MeshPhongMaterial({color: data.palette.weakest.color});
const forceMaterial = new THREE.MeshPhongMaterial({color: data.palette.force.color});

function contactMarks(grasp) {
  const group = new THREE.Group();
  grasp.contacts.forEach((contact, i) => {
    const slope = Math.max(0.05, contact.mu);  // a frictionless cone would not show
    const length = coneLength * radius / Math.sqrt(1 + slope * slope);
    const tip = vectorOf(contact.p);
    const cone = coneAt(tip, vectorOf(contact.n), slope, length, contactMaterial);
    cone.userData.contact = i;
    const point =
        new THREE.Mesh(new THREE.SphereBufferGeometry(0.022 * radius, 12, 8), contactMaterial);
    point.position.copy(tip);
    point.userData.contact = i;
    group.add(cone, point);
  });
  return group;
}

function weakestMarks(grasp) {
  const group = new THREE.Group();
  const force = vectorOf(grasp.weakest_force);
  const torque = vectorOf(grasp.weakest_torque);
  const size = Math.hypot(force.length(), torque.length());
  if (!(size > 0)) return group;
  const origin = vectorOf(data.frame.origin);
  const along = force.clone().multiplyScalar(arrowLength * radius / size);
  if (along.length() > 0.03 * radius) {
    group.add(arrow(origin, along, 0.035 * radius, weakestMaterial));
  }
  const turn = 1.6 * Math.PI * torque.length() / size;
  if (turn > 0.1) {
    group.add(twist(origin, torque, 0.5 * radius, turn, 0.02 * radius, weakestMaterial));
  }
  return group;
}
