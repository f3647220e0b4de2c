// The report's data, unpacked.

const data = JSON.parse(document.getElementById('data').textContent);

const identityPose = [0, 0, 0, 0, 0, 0, 1];

// Pose of the object in the world; in a report on contacts alone both frames are the same.
const X_WO = matrixOf(data.scene ? data.scene.object.X : identityPose);

// Length by which marks are sized [m].
const radius = data.frame.radius;

// Whether a grasp is better than another: those that were closed on a free object come before
// others, by the epsilon where it ends; the others by that of an object that stands still.
function isBetter(grasp, other) {
  const tried = (one) => one.free_epsilon !== null;
  if (tried(grasp) !== tried(other)) return tried(grasp);
  return tried(grasp) ? grasp.free_epsilon > other.free_epsilon :
                        grasp.epsilon[0] > other.epsilon[0];
}

// The best grasp; -1 where none holds.
function bestGrasp() {
  let best = -1;
  data.grasps.forEach((grasp, i) => {
    if (grasp.epsilon[0] > 0 && (best < 0 || isBetter(grasp, data.grasps[best]))) best = i;
  });
  return best;
}
