// The 3-D view of the scene: its bodies, their poses at a time of the motion, and the camera.

class SceneView extends View3d {
  constructor(canvas) {
    super(canvas);
    this.layers = {};
    this.grasp = null;
    this.lit = -1;
    this.moved = false;  // by the person who looks
    this.build();
    this.controls.addEventListener('start', () => {
      this.moved = true;
    });
    this.followSize();
  }

  layer(name, parent, ...nodes) {
    const group = new THREE.Group();
    for (const node of nodes) group.add(node);
    parent.add(group);
    this.layers[name] = group;
    return group;
  }

  build() {
    this.objectFrame = new THREE.Group();
    this.objectFrame.applyMatrix(X_WO);
    this.scene.add(this.objectFrame);
    if (data.scene) this.buildBodies();
    const center = new THREE.Mesh(
        new THREE.SphereBufferGeometry(0.035 * radius, 20, 14),
        new THREE.MeshBasicMaterial({color: data.palette.center.color, depthTest: false}));
    center.renderOrder = 25;
    center.position.copy(vectorOf(data.frame.origin));
    this.layer('center', this.objectFrame, center);
    this.layer('contacts', this.objectFrame);
    this.layer('weakest', this.objectFrame);
    this.layer('primitive', this.objectFrame).visible = false;
    this.layer('frames', this.objectFrame, frameAxes(0.7 * radius, 'object')).visible = false;
    // Where there is no grasp, so much is seen around the centre.
    this.surroundings = new THREE.Mesh(new THREE.SphereBufferGeometry(1.5 * radius, 8, 6));
    this.surroundings.visible = false;
    this.surroundings.position.copy(center.position);
    this.objectFrame.add(this.surroundings);
    this.arrows = new CandidateArrows();
    this.layer('candidates', this.objectFrame, this.arrows.group).visible = false;
  }

  buildBodies() {
    const {object, hand, arm, obstacles} = data.scene;
    const surface = meshGeometry(object.mesh);
    this.layer(
        'object', this.objectFrame,
        outlined(surface, solid(surface, data.palette.object), data.palette.object));
    this.hand = new RobotModel(hand, lookOfLink);
    this.handAxes = frameAxes(0.5 * radius, 'hand');
    this.handAxes.visible = false;
    this.hand.root.add(this.handAxes);
    this.layer('hand', this.scene, this.hand.root);
    if (data.grasps.some((grasp) => grasp.motion && grasp.motion.forces)) {
      this.layer('forces', this.scene).applyMatrix(X_WO);
    }
    if (arm) {
      this.arm = new RobotModel(arm, () => data.palette.arm);
      this.arm.setBase(matrixOf(arm.X));
      this.handMount = fixedFrame(arm.X_hand);
      this.arm.frameOf(arm.hand_joint).add(this.handMount);
      this.layer('arm', this.scene, this.arm.root);
    }
    if (obstacles.length > 0) {
      this.layer('obstacles', this.scene, ...obstacles.map((body) => {
        const geometry = meshGeometry(body.mesh);
        const part =
            outlined(geometry, solid(geometry, data.palette.obstacle), data.palette.obstacle);
        part.applyMatrix(matrixOf(body.X));
        return part;
      }));
    }
  }

  // Shows a grasp with its marks, as it holds the object; null shows the scene without a grasp.
  show(grasp) {
    this.grasp = grasp;
    for (const name of ['contacts', 'weakest', 'primitive']) {
      const group = this.layers[name];
      group.traverse((node) => {
        if (node.geometry) node.geometry.dispose();
      });
      group.remove(...group.children);
    }
    if (grasp) {
      this.layers.contacts.add(contactMarks(grasp));
      this.layers.weakest.add(weakestMarks(grasp));
      if (grasp.primitive >= 0) {
        this.layers.primitive.add(primitiveSolid(data.primitives[grasp.primitive]));
      }
    } else {
      data.primitives.forEach((p) => this.layers.primitive.add(primitiveSolid(p)));
    }
    this.highlight(-1);
    this.pose(grasp && grasp.motion ? grasp.motion.times[grasp.motion.grasp] : 0);
  }

  // Poses hand and arm as at a time [s] of the grasp's motion, and the object, where it is carried.
  pose(time) {
    this.time = time;
    if (data.scene) {
      const motion = this.grasp ? this.grasp.motion : null;
      this.hand.root.visible = motion !== null;
      const row = motion ? motionRow(motion, time) : null;
      if (this.arm) this.arm.setJoints(motion && motion.on_arm ? row : data.scene.arm.start);
      if (row) this.poseHand(motion, row, time);
      this.poseObject(motion, time);
      if (this.layers.forces) this.showForces(motion, time);
    }
    this.requestDraw();
  }

  poseHand(motion, row, time) {
    if (motion.on_arm) {
      const first = data.scene.arm.first_hand_joint;
      this.scene.updateMatrixWorld(true);
      this.hand.setBase(this.handMount.matrixWorld);
      this.hand.setJoints(row.slice(first));
    } else {
      const X_OH = motion.hands ? poseAt(motion.times, motion.hands, time) :
                                  matrixOf([...row.slice(0, 3), ...motion.X_OH.slice(3)]);
      this.hand.setBase(X_WO.clone().multiply(X_OH));
      this.hand.setJoints(row.slice(3));
    }
  }

  // Where it stands, or as a simulation says, or in the hand as it was grasped.
  poseObject(motion, time) {
    const X = X_WO.clone();
    if (motion && motion.objects) {
      X.multiply(poseAt(motion.times, motion.objects, time));
      // Contacts and the weakest disturbance are those of the grasp, not of the way there.
      const held = time >= motion.times[motion.grasp];
      for (const name of ['contacts', 'weakest']) {
        this.layers[name].children.forEach((mark) => {
          mark.visible = held;
        });
      }
    } else if (motion && motion.on_arm && time > motion.times[motion.grasp]) {
      const X_HO = new THREE.Matrix4().getInverse(matrixOf(motion.X_OH));
      X.copy(this.handMount.matrixWorld).multiply(X_HO);
    }
    X.decompose(this.objectFrame.position, this.objectFrame.quaternion, this.objectFrame.scale);
  }

  // The forces on the object in the last step before the time, the largest of the motion as long as
  // the object's radius.
  showForces(motion, time) {
    const group = this.layers.forces;
    group.traverse((node) => {
      if (node.geometry) node.geometry.dispose();
    });
    group.remove(...group.children);
    if (!motion || !motion.forces) return;
    const numbers = motion.forces[rowBefore(motion.times, time)];
    const scale = 1.2 * radius / largestForce(motion);
    for (let i = 0; i + 5 < numbers.length; i += 6) {
      const force = vectorOf(numbers.slice(i + 3)).multiplyScalar(scale);
      const along = force.clone().setLength(Math.max(force.length(), 0.15 * radius));
      const from = vectorOf(numbers.slice(i)).sub(along);  // its tip is where it acts
      group.add(arrow(from, along, 0.02 * radius, forceMaterial));
    }
  }

  // Highlights the contact with this index; -1 for none.
  highlight(i) {
    this.lit = i;
    this.layers.contacts.traverse((node) => {
      if (node.isMesh) node.material = node.userData.contact === i ? litMaterial : contactMaterial;
    });
    this.requestDraw();
  }

  setVisible(name, visible) {
    if (name === 'frames' && this.handAxes) this.handAxes.visible = visible;
    this.layers[name].visible = visible;
    this.requestDraw();
  }

  // Points that the camera has to show: of hand and object, or with `everything` also of the arm
  // and the obstacles.
  corners(everything) {
    this.scene.updateMatrixWorld(true);
    const parts = [this.layers.object, this.layers.contacts];
    if (data.scene && this.hand.root.visible) parts.push(this.layers.hand);
    if (everything) parts.push(this.layers.arm, this.layers.obstacles);
    if (!data.scene) parts.push(this.layers.weakest);
    if (!this.grasp) parts.push(this.layers.primitive, this.surroundings);
    return parts.filter((part) => part).flatMap((part) => cornersOf(part));
  }

  // The viewing direction, unit, towards the eye: the one in the report, or where there is none
  // across the plane of approach and closing direction, a little from above.
  telling() {
    if (this.grasp && this.grasp.side) return vectorOf(this.grasp.side);
    const direction = new THREE.Vector3(1, -1, 0.8);
    if (data.scene && this.grasp && this.grasp.motion) {
      this.scene.updateMatrixWorld(true);
      const turn = new THREE.Quaternion().setFromRotationMatrix(
          new THREE.Matrix4().extractRotation(this.hand.root.matrixWorld));
      const approach = vectorOf(data.scene.hand.approach).applyQuaternion(turn);
      const closing = vectorOf(data.scene.hand.closing).applyQuaternion(turn);
      const aside = approach.clone().cross(closing);
      if (aside.z < 0) aside.negate();
      direction.copy(aside).addScaledVector(approach, -0.35);
      direction.addScaledVector(closing, 0.6 * Math.abs(aside.z));  // not straight from above
      direction.z += 0.5 * (1 - Math.abs(aside.z));
    }
    return direction.normalize();
  }

  // Moves the camera so that what is looked at fills the picture.
  look(direction, everything = false) {
    this.controls.target.copy(aim(this.camera, this.corners(everything), direction));
    this.controls.update();
    this.requestDraw();
  }

  // The contact or candidate under a point of the page, as a mesh that was hit.
  hit(event, name) {
    if (!this.layers[name].visible) return null;
    return this.ray(event).intersectObject(this.layers[name], true)[0] || null;
  }

  // Runs what poses the scene for a picture on another canvas, and puts it back as it was. The
  // picture on this canvas stays, as it would look the same again.
  borrow(pose) {
    const {grasp, time, lit, requested} = this;
    this.requested = true;
    pose();
    this.show(grasp);
    this.pose(time);
    this.highlight(lit);
    this.requested = requested;
  }
}

// Of all forces on the object in a motion [N].
function largestForce(motion) {
  let largest = 1e-9;
  for (const numbers of motion.forces) {
    for (let i = 0; i + 5 < numbers.length; i += 6) {
      largest = Math.max(largest, vectorOf(numbers.slice(i + 3)).length());
    }
  }
  return largest;
}
