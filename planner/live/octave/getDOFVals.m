function values = getDOFVals (robots)
% GETDOFVALS  The degrees of freedom of robots.
%   values = GETDOFVALS (ROBOT) is a column with the values of a robot.
%   values = GETDOFVALS (ROBOTS) is a cell array with such a column for each of several.
%   values = GETDOFVALS () is that of all robots.
%
%   See also SETDOFFORCES, MOVEDOFS, GRASPIT_CONNECT.
  if nargin < 1
    robots = 'ALL';
  end
  [link, count] = graspit_ask ('getDOFVals', robots);
  values = cell (count, 1);
  for r = 1:count
    values{r} = graspit_numbers (link, graspit_numbers (link, 1));
  end
  if isnumeric (robots) && count == 1
    values = values{1};
  end
end
