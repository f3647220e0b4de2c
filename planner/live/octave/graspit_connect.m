function graspit_connect (host, port, timeout)
% GRASPIT_CONNECT  Connects to a server that speaks GraspIt!'s text protocol.
%   GRASPIT_CONNECT () connects to 'prehend serve --graspit' on this machine, port 4765.
%   GRASPIT_CONNECT (HOST, PORT) connects to another one.
%   GRASPIT_CONNECT (HOST, PORT, TIMEOUT) waits TIMEOUT seconds for a reply, 60 if it is not given.
%
%   The functions of the protocol use the last connection, so that a control loop reads
%
%     graspit_connect ();
%     while true
%       h = moveDynamicBodies (0.0025);
%       computeNewVelocities (h);
%       [F, P] = getAverageContacts ([6; 9; 12]);
%       setDOFForces (f, 2);      % f: a force for each degree of freedom, from F, P, getDOFVals (2)
%     end
%
%   Bodies and robots are numbered from 0, as the server does; 'ALL' stands for all of them.
%   Lengths, angles and forces are in the server's units. Error ids: graspit:refused with what the
%   server says, graspit:connect, prehend:connect, prehend:timeout, prehend:closed. A command whose
%   form the server does not understand has no reply, which is prehend:timeout.
%
%   See also MOVEDYNAMICBODIES, COMPUTENEWVELOCITIES, GETAVERAGECONTACTS, GETCONTACTS, GETDOFVALS,
%   SETDOFFORCES, MOVEDOFS, MOVETOCONTACTS, GETBODYNAME, GETROBOTNAME, PREHEND_CONNECT.
  if nargin < 1
    host = '127.0.0.1';
  end
  if nargin < 2
    port = 4765;
  end
  if nargin < 3
    timeout = 60;
  end
  graspit_link (open_link (host, port, timeout));
end
