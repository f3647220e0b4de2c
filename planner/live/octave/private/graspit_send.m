function link = graspit_send (command, numbers)
% Sends a command with numbers behind it, as many digits as they have. What an earlier command left
% unread, because it failed, is dropped.
  link = graspit_link ();
  if link.NumBytesAvailable > 0
    read (link, link.NumBytesAvailable);
  end
  state = link.UserData;
  state.unread = state.unread([]);
  link.UserData = state;
  if ~ isempty (numbers)  % sprintf would print a blank for none
    command = [command, sprintf(' %.17g', numbers)];
  end
  send_line (link, command);
end
