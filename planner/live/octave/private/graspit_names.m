function names = graspit_names (command, list)
% The names of bodies or robots: a text where the list is one number, else a cell array.
  [link, count] = graspit_ask (command, list);
  names = cell (count, 1);
  for n = 1:count
    names{n} = graspit_line (link);
  end
  if isnumeric (list) && count == 1
    names = names{1};
  end
end
