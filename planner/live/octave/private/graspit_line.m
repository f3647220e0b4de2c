function line = graspit_line (link)
% The next line of a reply. Error graspit:refused, with what the server says.
  line = strtrim (next_line (link));
  if strncmp (line, 'Error:', 6)
    error ('graspit:refused', '%s', strtrim (line(7:end)));
  end
end
