function line = next_line (link)
% The next line that the server sends, without its end. Errors: prehend:timeout when no part of it
% comes for as long as the connection's Timeout, prehend:closed at the end of the connection.
  state = link.UserData;
  looked = 0;
  while true
    last = find (state.unread(looked + 1:end) == 10, 1);
    if ~ isempty (last)
      break;
    end
    looked = numel (state.unread);
    state.unread = [state.unread, wait_for_bytes(link)];
    link.UserData = state;
  end
  last = looked + last;
  line = native2unicode (state.unread(1:last - 1), 'UTF-8');
  state.unread = state.unread(last + 1:end);
  link.UserData = state;
end

function bytes = wait_for_bytes (link)
  try
    closed = false;
    bytes = reshape (uint8 (read (link, max (1, link.NumBytesAvailable))), 1, []);
  catch
    closed = true;
  end
  if closed
    error ('prehend:closed', 'the server has ended the connection');
  end
  if isempty (bytes)
    error ('prehend:timeout', 'the server has not answered within %g s', link.Timeout);
  end
end
