function link = open_link (host, port, timeout)
% A connection of lines. What has come and was not asked for yet is kept in its UserData.
  if exist ('OCTAVE_VERSION', 'builtin')
    pkg ('load', 'instrument-control');
  end
  try
    link = tcpclient (host, port, 'Timeout', timeout);
  catch problem
    error ('prehend:connect', 'no server at %s port %d: %s', host, port, problem.message);
  end
  link.UserData = struct ('unread', uint8 (zeros (1, 0)), 'events', {{}}, 'next_id', 1);
end
