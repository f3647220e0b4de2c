// Motions as they are drawn: `times`, and for each of them a row of joint values, and poses.

// Joint values and poses at a time: linear interpolation between the two rows around it.
function motionRow(motion, time) {
  const {times, rows} = motion;
  let i = times.findIndex((t) => t >= time);
  if (i < 0) i = times.length - 1;
  if (i === 0) return rows[0];
  const span = times[i] - times[i - 1];
  const part = span > 0 ? (time - times[i - 1]) / span : 1;
  return rows[i].map((value, k) => rows[i - 1][k] + part * (value - rows[i - 1][k]));
}

function rowBefore(times, time) {
  const next = times.findIndex((t) => t > time);
  return next < 0 ? times.length - 1 : Math.max(0, next - 1);
}

function poseAt(times, poses, time) {
  const i = rowBefore(times, time);
  const next = Math.min(i + 1, times.length - 1);
  const span = times[next] - times[i];
  return matrixBetween(poses[i], poses[next], span > 0 ? (time - times[i]) / span : 0);
}
