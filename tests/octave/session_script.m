% A session of prehend, as docs/reference/protocol.md describes it.
1;
source (fullfile (fileparts (mfilename ('fullpath')), 'error_id_of.m'));

port = str2double (getenv ('PREHEND_TEST_PORT'));
c = prehend_connect ('127.0.0.1', port);
hello = prehend_call (c, 'hello');
assert (hello.version, 1);
assert (any (strcmp (hello.hands, 'barrett')));

% Commands with and without fields, text that is not ASCII, and a large reply.
prehend_call (c, 'object.set', struct ('generate', 'mug', 'name', 'grüner Becher'));
state = prehend_call (c, 'state');
assert (state.object.name, 'grüner Becher');
surface = prehend_call (c, 'view.surface', struct ('surface', state.object.surface));
assert (numel (surface.mesh.positions) > 10000);

% Where the hand is told to go, it is, to the last digit.
turn = [0.3; -0.5; 0.1; 0.8];
pose = struct ('position', [0.1; -0.2; 0.7 / 3], 'quaternion_wxyz', turn / norm (turn));
moved = prehend_call (c, 'hand.move', struct ('X_world_hand', pose));
assert (moved.xEnd, 'arrived');
assert (moved.hand.X_world_hand.position, pose.position, 1e-15);
assert (abs (pose.quaternion_wxyz' * moved.hand.X_world_hand.quaternion_wxyz), 1, 1e-14);
prehend_call (c, 'undo');

% Refusals.
assert (error_id_of (@() prehend_call (c, 'fly')), 'prehend:refused:command');
assert (error_id_of (@() prehend_call (c, 'hand.dofs', struct ('dofs', [1; 2]))), ...
        'prehend:refused:dofs');
assert (error_id_of (@() prehend_call (c, 'hand.dofs', struct ('dofs', NaN))), ...
        'prehend:refused:dofs');
pose.position = {'a'};
[id, words] = error_id_of (@() prehend_call (c, 'hand.move', struct ('X_world_hand', pose)));
assert (id, 'prehend:refused:X_world_hand_position');
assert (strncmp (words, 'X_world_hand.position: ', 23), words);
assert (error_id_of (@() prehend_call (c, 'state', struct ('a', {1, 2}))), 'prehend:fields');

% A grasp.
grasp = prehend_call (c, 'hand.auto_grasp');
assert (ischar (grasp.outcome));
assert (isfield (grasp.contacts, 'link') || isempty (grasp.contacts));

% Events were kept in their order, and are given once. The last one is on its way when the hand has
% closed; it comes before the reply to the next command.
state = prehend_call (c, 'state');
events = prehend_events (c);
assert (all (cellfun (@(e) strcmp (e.event, 'state'), events)));
revisions = cellfun (@(e) e.state.revision, events);
assert (numel (revisions) >= 4 && issorted (revisions));
assert (revisions(end), state.revision);
assert (isempty (prehend_events (c)));

% A plan is waited for by its events.
started = prehend_call (c, 'plan.start', struct ('trials', 20, 'accuracy', 'draft'));
assert (started.trials, 20);
ended = {};
while isempty (ended)
  events = prehend_events (c, 1);
  ended = events(cellfun (@(e) strcmp (e.event, 'plan'), events));
end
results = prehend_call (c, 'plan.results');
assert (results.size, ended{1}.size);
assert (results.status, ended{1}.status);

assert (error_id_of (@() prehend_connect ('127.0.0.1', 1)), 'prehend:connect');
disp ('all passed');
