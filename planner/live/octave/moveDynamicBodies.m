function h = moveDynamicBodies (dt)
% MOVEDYNAMICBODIES  Moves all bodies with their velocities.
%   h = MOVEDYNAMICBODIES (DT) moves them for DT seconds, or for less where they would overlap.
%   h = MOVEDYNAMICBODIES () takes the server's own step.
%   h is the time by which they were moved.
%
%   See also COMPUTENEWVELOCITIES, GRASPIT_CONNECT.
  if nargin < 1
    dt = [];
  end
  h = graspit_numbers (graspit_send ('moveDynamicBodies', dt), 1);
end
