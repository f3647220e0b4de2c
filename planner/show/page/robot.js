// A robot as a tree of frames that its joints move.

function lookOfLink(link) {
  return link.material === 'rubber' ? data.palette.rubber : data.palette.hard;
}

function fixedFrame(pose) {
  const frame = new THREE.Group();
  if (pose) {
    frame.applyMatrix(matrixOf(pose));
  }
  return frame;
}

class RobotModel {
  constructor(robot, lookOf) {
    this.root = new THREE.Group();
    this.motions = [];
    this.frames = [];  // for each joint, the frame that moves with it
    for (const joint of robot.joints) {
      const before = fixedFrame(joint.before);
      const motion = new THREE.Group();
      const after = fixedFrame(joint.after);
      this.frameOf(joint.parent).add(before);
      before.add(motion);
      motion.add(after);
      const axis = new THREE.Vector3(...(joint.axis || [0, 0, 1]));
      this.motions.push({node: motion, turns: joint.type === 'r', axis});
      this.frames.push(after);
    }
    for (const link of robot.links) {
      const geometry = meshGeometry(link.mesh);
      const part = outlined(geometry, solid(geometry, lookOf(link)), lookOf(link));
      part.userData.link = link.name;
      this.frameOf(link.joint).add(part);
    }
  }

  // The frame that moves with a joint; for -1 that of the base.
  frameOf(joint) {
    return joint < 0 ? this.root : this.frames[joint];
  }

  setJoints(values) {
    this.motions.forEach(({node, turns, axis}, j) => {
      if (turns) {
        node.quaternion.setFromAxisAngle(axis, values[j]);
      } else {
        node.position.copy(axis).multiplyScalar(values[j]);
      }
    });
  }

  setBase(matrix) {
    matrix.decompose(this.root.position, this.root.quaternion, this.root.scale);
  }
}
