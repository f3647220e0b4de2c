function names = getRobotName (robots)
% GETROBOTNAME  The names of robots.
%   names = GETROBOTNAME (ROBOT) is the name of a robot.
%   names = GETROBOTNAME (ROBOTS) is a cell array with the names of several.
%   names = GETROBOTNAME () is that of all robots.
%
%   See also GRASPIT_CONNECT.
  if nargin < 1
    robots = 'ALL';
  end
  names = graspit_names ('getRobotName', robots);
end
