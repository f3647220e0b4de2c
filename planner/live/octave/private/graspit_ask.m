function [link, count] = graspit_ask (command, list)
% Sends a command that ends in a list of bodies or robots: numbers from 0, or 'ALL'. count is how
% many there are.
  if ischar (list)
    link = graspit_send ([command, ' ', list], []);
    count = graspit_numbers (link, 1);
  else
    count = numel (list);
    link = graspit_send (command, [count; list(:)]);
  end
end
