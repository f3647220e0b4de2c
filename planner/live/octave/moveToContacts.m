function moveToContacts ()
% MOVETOCONTACTS  Moves the hand's fingers until they touch something.
%   The server does not reply to this; the next command that it replies to comes after it.
%
%   See also MOVEDOFS, GRASPIT_CONNECT.
  graspit_send ('moveToContacts', []);
end
