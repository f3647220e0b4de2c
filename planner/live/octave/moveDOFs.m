function values = moveDOFs (v, steps, robot)
% MOVEDOFS  Moves the degrees of freedom of a robot until it touches something.
%   values = MOVEDOFS (V, STEPS, ROBOT) moves them to V, each in steps of STEPS, and returns the
%   values that they have reached.
%
%   See also GETDOFVALS, MOVETOCONTACTS, GRASPIT_CONNECT.
  if numel (v) ~= numel (steps)
    error ('graspit:size', 'there must be as many steps as values');
  end
  link = graspit_send ('moveDOFs', [robot; numel(v); v(:); steps(:)]);
  values = graspit_numbers (link, numel (v));
end
