function send_line (link, text)
% Sends a line; text is without its end.
  bytes = [reshape(unicode2native (text, 'UTF-8'), 1, []), uint8(10)];
  try
    sent = true;
    write (link, bytes);
  catch
    sent = false;
  end
  if ~ sent
    error ('prehend:closed', 'the server has ended the connection');
  end
end
