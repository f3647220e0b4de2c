function numbers = graspit_numbers (link, count)
% The next count numbers of a reply, a column, on however many lines they come.
  numbers = zeros (0, 1);
  while numel (numbers) < count
    numbers = [numbers; sscanf(graspit_line (link), '%g')];
  end
end
