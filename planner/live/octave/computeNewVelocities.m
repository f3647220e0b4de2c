function status = computeNewVelocities (h)
% COMPUTENEWVELOCITIES  Gives the bodies their velocities after forces and contacts of a step.
%   status = COMPUTENEWVELOCITIES (H) does so for a step of H seconds, as MOVEDYNAMICBODIES has
%   returned it. status is 0, or -1 where no contact forces were found.
%
%   See also MOVEDYNAMICBODIES, GRASPIT_CONNECT.
  status = graspit_numbers (graspit_send ('computeNewVelocities', h), 1);
end
