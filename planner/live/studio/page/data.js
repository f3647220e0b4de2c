// What the page was made with, and the frame in which the marks of a grasp are drawn.

const data = JSON.parse(document.getElementById('data').textContent);

// Of the wrench space: torques are about `origin`, in the frame of the object, and divided by
// `radius`.
data.frame = {
  origin: [0, 0, 0],
  radius: 0.05
};

// Length by which marks are sized [m].
let radius = 0.05;

// Pose of the object in the world.
const X_WO = new THREE.Matrix4();
