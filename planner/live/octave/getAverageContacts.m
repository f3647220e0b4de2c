function [F, P] = getAverageContacts (bodies)
% GETAVERAGECONTACTS  The mean of the contacts of bodies.
%   [F, P] = GETAVERAGECONTACTS (BODIES) has a row for each body: F its mean contact wrench (force,
%   torque), P the mean place of its contacts in its own frame. Both are 0 without contact.
%   [F, P] = GETAVERAGECONTACTS () tells of all bodies.
%
%   See also GETCONTACTS, GRASPIT_CONNECT.
  if nargin < 1
    bodies = 'ALL';
  end
  [link, count] = graspit_ask ('getAverageContacts', bodies);
  F = zeros (count, 6);
  P = zeros (count, 3);
  for b = 1:count
    F(b, :) = graspit_numbers (link, 6);
    P(b, :) = graspit_numbers (link, 3);
  end
end
