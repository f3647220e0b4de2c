function forces = setDOFForces (f, robot)
% SETDOFFORCES  Sets the forces of the drives of a robot.
%   forces = SETDOFFORCES (F, ROBOT) sets one for each degree of freedom, and returns those that it
%   has now, which the drives' limits may have made smaller.
%
%   See also GETDOFVALS, GRASPIT_CONNECT.
  link = graspit_send ('setDOFForces', [1; robot; numel(f); f(:)]);
  forces = graspit_numbers (link, numel (f));
end
