% GraspIt!'s protocol with the world of graspit_server.py.
1;
source (fullfile (fileparts (mfilename ('fullpath')), 'error_id_of.m'));

port = str2double (getenv ('PREHEND_TEST_PORT'));
assert (error_id_of (@() moveDynamicBodies (0.1)), 'graspit:connect');
graspit_connect ('127.0.0.1', port);

% The control loop of the paper.
for step = 1:3
  h = moveDynamicBodies (0.0025);
  assert (h, 0.0025);
  assert (computeNewVelocities (h), 0);
  [F, P] = getAverageContacts ([6; 9; 12]);
  assert (F, [6, 0.5, -1e-7, 2, 0, 0; 9, 0.5, -1e-7, 2, 0, 0; 12, 0.5, -1e-7, 2, 0, 0], 1e-12);
  assert (P, [0.006, 2, -2; 0.009, 2, -2; 0.012, 2, -2], 1e-12);
  assert (setDOFForces ([1; -2; 30; -1 / 3], 2), [1; -2; 5; -1 / 3], 1e-9);
end
assert (moveDynamicBodies (), 0.01);
assert (computeNewVelocities (0), -1);

% All bodies: the count comes first.
[F, P] = getAverageContacts ();
assert (size (F), [14, 6]);
assert (size (P), [14, 3]);
assert (F([1, 14], :), zeros (2, 6));
[F, P] = getContacts ();
assert (numel (F), 14);
assert (size (F{1}), [0, 6]);
assert (size (P{1}), [0, 3]);
assert (F{13}, [12, 0.5, -1e-7, 1, 0, 0; 12, 0.5, -1e-7, 3, 0, 0], 1e-12);
assert (P{13}, [0.012, 1, -1; 0.012, 3, -3], 1e-12);

% Names and degrees of freedom of one, several and all.
assert (getBodyName (1), 'table top');
assert (getBodyName ([0; 6]), {'glass'; 'link 6'});
assert (getRobotName (), {'Puma560'; 'table robot'; 'Barrett'});
assert (getDOFVals (2), [0; 0.125; 0.25; 0.375]);
assert (getDOFVals ([1, 2]), {0; [0; 0.125; 0.25; 0.375]});
assert (numel (getDOFVals ()), 3);
moveToContacts ();
assert (moveDOFs ([0.5, 0.25, 1, 0], [0.5, 0.5, 0.5, 0.5], 2), [0.5; 0.25; 1; 0]);
assert (moveDOFs ([0, 0, 7, 0], 0.1 * ones (1, 4), 2), [0; 0; 1; 0]);

% Refusals, after each of which the next command has its own reply.
[id, words] = error_id_of (@() getAverageContacts ([6; 99]));
assert (id, 'graspit:refused');
assert (words, 'Cannot find body 99');
assert (getBodyName (0), 'glass');
[~, words] = error_id_of (@() setDOFForces ([1; 2], 2));
assert (words, 'robot has 4 DOF.');
[~, words] = error_id_of (@() moveDynamicBodies (2));
assert (words, 'Timestep failsafe reached.');
[~, words] = error_id_of (@() moveDOFs (0, 0, 7));
assert (words, 'Robot does not exist.');
assert (error_id_of (@() moveDOFs ([0, 0], 0, 2)), 'graspit:size');
assert (computeNewVelocities (0.0025), 0);

% This server has no reply to what it does not understand.
c = prehend_connect ('127.0.0.1', port, '', 0.05);
assert (error_id_of (@() prehend_call (c, 'hello')), 'prehend:timeout');

% It ends a connection at "end", which is no word of the protocol.
c = prehend_connect ('127.0.0.1', port, 'end');
assert (error_id_of (@() prehend_call (c, 'hello')), 'prehend:closed');
disp ('all passed');
