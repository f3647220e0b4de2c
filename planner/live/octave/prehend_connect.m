function c = prehend_connect (host, port, token, timeout)
% PREHEND_CONNECT  Connects to a live session of prehend.
%   c = PREHEND_CONNECT () connects to 'prehend serve' on this machine, port 4700.
%   c = PREHEND_CONNECT (HOST, PORT) connects to another one.
%   c = PREHEND_CONNECT (HOST, PORT, TOKEN) shows the token that a server wants which other
%   machines can reach; '' for none.
%   c = PREHEND_CONNECT (HOST, PORT, TOKEN, TIMEOUT) waits TIMEOUT seconds for an answer, 60 if
%   it is not given.
%
%   c is a tcpclient; 'clear c' ends the connection. Its UserData belong to these functions.
%   Octave needs its package instrument-control, which is loaded. Error id: prehend:connect.
%
%   See also PREHEND_CALL, PREHEND_EVENTS, GRASPIT_CONNECT.
  if nargin < 1
    host = '127.0.0.1';
  end
  if nargin < 2
    port = 4700;
  end
  if nargin < 3
    token = '';
  end
  if nargin < 4
    timeout = 60;
  end
  c = open_link (host, port, timeout);
  if ~ isempty (token)
    send_line (c, token);
  end
end
