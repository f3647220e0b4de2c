// The report's data, unpacked.

const data = JSON.parse(document.getElementById('data').textContent);

const identityPose = [0, 0, 0, 0, 0, 0, 1];

// Pose of the object in the world; in a report on contacts alone both frames are the same.
const X_WO = matrixOf(data.scene ? data.scene.object.X : identityPose);

// Length by which marks are sized [m].
const radius = data.frame.radius;

// The grasp of the largest epsilon; -1 where none holds.
function bestGrasp() {
  let best = -1;
  data.grasps.forEach((grasp, i) => {
    if (grasp.epsilon[0] > (best < 0 ? 0 : data.grasps[best].epsilon[0])) best = i;
  });
  return best;
}
