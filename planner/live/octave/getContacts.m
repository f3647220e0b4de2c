function [F, P] = getContacts (bodies)
% GETCONTACTS  The contacts of bodies.
%   [F, P] = GETCONTACTS (BODIES) has a cell for each body, with a row for each of its contacts: in
%   F the contact wrench (force, torque), in P its place in the body's frame.
%   [F, P] = GETCONTACTS () tells of all bodies.
%
%   See also GETAVERAGECONTACTS, GRASPIT_CONNECT.
  if nargin < 1
    bodies = 'ALL';
  end
  [link, count] = graspit_ask ('getContacts 2', bodies);
  F = cell (count, 1);
  P = cell (count, 1);
  for b = 1:count
    contacts = graspit_numbers (link, 1);
    F{b} = zeros (contacts, 6);
    P{b} = zeros (contacts, 3);
    for k = 1:contacts
      F{b}(k, :) = graspit_numbers (link, 6);
      P{b}(k, :) = graspit_numbers (link, 3);
    end
  end
end
