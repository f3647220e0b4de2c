% The control loop of GraspIt!'s paper with prehend's own server of its protocol.
graspit_connect ('127.0.0.1', str2double (getenv ('PREHEND_TEST_PORT')));
robots = getRobotName ();
bodies = getBodyName ();
assert (numel (robots) >= 1 && numel (bodies) >= 2);
hand = numel (robots) - 1;
tips = numel (bodies) - [1; 2];
for step = 1:20
  h = moveDynamicBodies (0.0025);
  assert (h > 0 && h <= 0.0025);
  assert (computeNewVelocities (h), 0);
  [F, P] = getAverageContacts (tips);
  assert (size (F), [2, 6]);
  assert (size (P), [2, 3]);
  assert (all (isfinite ([F(:); P(:)])));
  values = getDOFVals (hand);
  forces = setDOFForces (zeros (size (values)), hand);
  assert (forces, zeros (size (values)));
end
disp ('all passed');
