function names = getBodyName (bodies)
% GETBODYNAME  The names of bodies.
%   names = GETBODYNAME (BODY) is the name of a body.
%   names = GETBODYNAME (BODIES) is a cell array with the names of several.
%   names = GETBODYNAME () is that of all bodies.
%
%   See also GRASPIT_CONNECT.
  if nargin < 1
    bodies = 'ALL';
  end
  names = graspit_names ('getBodyName', bodies);
end
